//! The step-exact model of a sequential machine: all registers of all cells and of the control block, in
//! every clock.
//!
//! It executes decoded [`Step`]s and does not read control words. Thus the comparison with the HDL also tests
//! the encoding (spec) and the decoding (HDL) of control words.

use photoncube_spec::{
    Channels, Hypercube, Inputs, Machine, OpRow, Outputs, Photon, Pins, Role, SEQUENTIAL, Step,
    Sums,
};

use super::cell::{CellInputs, CellRules, CellState};
use crate::golden::GoldenMachine;

/// The registers of the control block.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
struct ControlState {
    /// The next step, as an index into the program: first the query phase, then the iteration.
    address: usize,
    /// The group at work is the query's last.
    last: bool,
    /// The result is complete and waits to be taken.
    done: bool,
}

/// A sequential machine with its state. It starts in the power-up state, in which all registers are 0.
#[derive(Clone, Debug)]
pub struct StepMachine {
    machine: Machine,
    cube: Hypercube,
    rules: CellRules,
    steps: Vec<Step>,
    /// The address of the iteration's first step.
    iteration: usize,
    /// The address of the last step that reads the group, which takes it; `None` where no step reads it.
    taker: Option<usize>,
    control: ControlState,
    cells: Vec<CellState>,
    /// The cells before the clock edge, whose work registers the neighbours receive.
    before: Vec<CellState>,
}

impl StepMachine {
    /// Makes a machine in its power-up state.
    ///
    /// # Panics
    /// Where the machine is not [`photoncube_spec::Organisation::Sequential`]; see
    /// [`crate::golden_machine`].
    pub fn new(machine: &Machine) -> Self {
        let program = machine
            .microprogram()
            .expect("a step machine is of a machine that runs a program");
        let steps = program.steps();
        let reads_group = |step: &Step| SEQUENTIAL.op(step.op).reads_group();
        let cells = vec![CellState::default(); machine.hypercube().nodes()];
        Self {
            machine: *machine,
            cube: machine.hypercube(),
            rules: CellRules::of(machine),
            iteration: program.query_clocks() as usize,
            taker: steps.iter().rposition(reads_group),
            steps,
            control: ControlState::default(),
            before: cells.clone(),
            cells,
        }
    }

    /// The step that this clock does, if it does not wait.
    pub fn step(&self) -> Step {
        self.steps[self.control.address]
    }

    fn row(&self) -> &'static OpRow {
        SEQUENTIAL.op(self.step().op)
    }

    /// Whether the step waits for no stream.
    fn has_words(&self, inputs: &Inputs) -> bool {
        let row = self.row();
        (!row.reads_query() || inputs.query_valid) && (!row.reads_group() || inputs.group_valid)
    }

    fn next_control(&self, runs: bool, inputs: &Inputs) -> ControlState {
        let mut next = self.control;
        if self.control.done {
            next.done = !inputs.result_ready;
            return next;
        }
        if !runs {
            return next;
        }
        if Some(self.control.address) == self.taker {
            next.last = inputs.group.last;
        }
        if self.control.address + 1 < self.steps.len() {
            next.address += 1;
        } else if self.control.last {
            next.address = 0;
            next.done = true;
        } else {
            next.address = self.iteration;
        }
        next
    }

    fn execute(&mut self, step: Step, inputs: &Inputs) {
        self.before.copy_from_slice(&self.cells);
        let lanes = &inputs.group.lanes;
        for (node, cell) in self.cells.iter_mut().enumerate() {
            let role = self.cube.role(node);
            let lane = lanes
                .get(self.cube.photon(node))
                .copied()
                .unwrap_or_default();
            let sent = |axis| self.before[self.cube.neighbour(node, axis)].work;
            let ports = CellInputs {
                query: role.coordinate().map_or(self.rules.idle_query(), |axis| {
                    inputs.query.position[axis].into()
                }),
                radius_sq: inputs.query.radius_sq.into(),
                photon: role
                    .coordinate()
                    .map_or(0, |axis| lane.photon.position[axis].into()),
                present: lane.present,
                power: power(role, &lane.photon),
                link: step.axis.map_or(0, sent),
            };
            cell.execute(step.op, &ports, &self.rules);
        }
    }
}

impl GoldenMachine for StepMachine {
    fn outputs(&self, _inputs: &Inputs) -> Outputs {
        let ready = |wanted| !self.control.done && wanted;
        let sum = |role| self.cells[self.cube.result_node(role)].sum;
        let power = match self.machine.channels() {
            Channels::Rgb => [sum(Role::X), sum(Role::Y), sum(Role::Z)],
            Channels::Mono => [sum(Role::X), 0, 0],
        };
        Outputs {
            query_ready: ready(self.row().reads_query()),
            group_ready: ready(Some(self.control.address) == self.taker),
            result_valid: self.control.done,
            result: Sums {
                power: power.map(u128::from),
                count: sum(Role::D),
            },
            ..Outputs::default()
        }
    }

    fn observe(&self, inputs: &Inputs, row: &mut Vec<u64>) {
        row.extend(Pins::output_row(&self.machine, &self.outputs(inputs)));
        row.push(self.control.address as u64);
        row.push(u64::from(self.control.last));
        row.push(u64::from(self.control.done));
        for cell in &self.cells {
            row.extend(cell.registers());
        }
    }

    fn clock(&mut self, inputs: &Inputs) {
        let step = self.step();
        let runs = !self.control.done && self.has_words(inputs);
        if runs {
            self.execute(step, inputs);
        }
        self.control = if inputs.reset {
            ControlState::default()
        } else {
            self.next_control(runs, inputs)
        };
    }

    fn works(&self, inputs: &Inputs) -> bool {
        if self.control.done {
            return inputs.result_ready;
        }
        self.has_words(inputs)
    }
}

/// The power in the role's channel; a distance cell counts the photon. With one channel, only the first word
/// has a power, and the others are 0.
fn power(role: Role, photon: &Photon) -> u64 {
    role.coordinate()
        .map_or(1, |index| u64::from(photon.power[index]) << photon.exponent)
}
