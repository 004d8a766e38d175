//! Compares a cell on its own, without network and control block, under random steps, or under a program with
//! its waiting clocks.

use photoncube_model::{CellInputs, CellRules, CellState};
use photoncube_spec::{ControlWord, Machine, Microprogram, SEQUENTIAL, Step, encode};
use rand::RngExt;
use rand_pcg::Pcg64;

use super::{Trace, field_named};
use crate::compare::Activity;
use crate::stimulus::corner;

/// The inputs of a cell in a clock.
struct Asked {
    step: Step,
    word: ControlWord,
    /// The step waits for a stream: no register is written, and the rest of the control word is unchanged.
    waits: bool,
}

impl Trace {
    /// A cell under a program of random steps.
    pub(super) fn cell(&mut self, machine: &Machine, vectors: usize, rng: &mut Pcg64) {
        let rules = CellRules::of(machine);
        let axes: Vec<_> = machine.hypercube().axes().collect();
        let mut cell = CellState::default();
        for _ in 0..vectors {
            let row = &SEQUENTIAL.ops[rng.random_range(0..SEQUENTIAL.ops.len())];
            let any_axis = |_| axes[rng.random_range(0..axes.len())];
            let axis = row.link.map(any_axis);
            let step = Step { op: row.op, axis };
            let asked = Asked {
                step,
                word: encode(step, false),
                waits: false,
            };
            self.cell_clock(machine, &rules, &mut cell, &asked, rng);
        }
    }

    /// A cell under the control words of a program, iterations and queries of any number.
    pub(super) fn program_cell(
        &mut self,
        machine: &Machine,
        program: &Microprogram,
        vectors: usize,
        rng: &mut Pcg64,
    ) {
        let rules = CellRules::of(machine);
        let (steps, words) = (program.steps(), program.control_words());
        let iteration = program.query_clocks() as usize;
        let mut cell = CellState::default();
        let mut address = 0;
        for _ in 0..vectors {
            let asked = Asked {
                step: steps[address],
                word: words[address],
                waits: rng.random_ratio(1, 4),
            };
            self.cell_clock(machine, &rules, &mut cell, &asked, rng);
            address = match address + 1 == steps.len() {
                _ if asked.waits => address,
                false => address + 1,
                true if rng.random_ratio(1, 3) => 0,
                true => iteration,
            };
        }
    }

    /// One clock. The link is 0 where a step names no axis, as the network makes it.
    fn cell_clock(
        &mut self,
        machine: &Machine,
        rules: &CellRules,
        cell: &mut CellState,
        asked: &Asked,
        rng: &mut Pcg64,
    ) {
        let widths = rules.widths();
        let mut any = |bits| corner(rng, bits);
        let inputs = CellInputs {
            query: any(widths.coordinate),
            radius_sq: any(widths.radius_sq),
            photon: any(widths.photon),
            present: any(2) != 0,
            power: any(widths.power),
            link: asked.step.axis.map_or(0, |_| any(widths.work)),
        };
        let fields = |name: &str| match name {
            "query_in" => inputs.query,
            "radius_sq_in" => inputs.radius_sq,
            "photon_in" => inputs.photon,
            "present_in" => u64::from(inputs.present),
            "power_in" => inputs.power,
            "link_in" => inputs.link,
            write if asked.waits && write.starts_with("write_") => 0,
            field => {
                let field = field_named(field);
                u64::from(SEQUENTIAL.field(field, asked.word, machine.dimension))
            }
        };
        let mut expected = vec![cell.work, cell.sum];
        expected.extend(cell.registers());
        let activity = match asked.waits {
            true => Activity::WaitsFor(asked.step),
            false => Activity::Step(asked.step),
        };
        self.push(activity, fields, &expected);
        if !asked.waits {
            cell.execute(asked.step.op, &inputs, rules);
        }
    }
}
