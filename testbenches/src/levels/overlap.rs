//! Compares an overlapped machine's cell, whose units work at the same time, on random ops.

use photoncube_model::{CellPorts, OverlapCell};
use photoncube_spec::overlap::asked_of;
use photoncube_spec::{Axis, Machine, Op, POWER_WORDS, Role, Step, Widths};
use rand::RngExt;
use rand::seq::IndexedRandom;
use rand_pcg::Pcg64;

use super::Trace;
use crate::compare::Activity;
use crate::stimulus::corner;

/// The role of the cell. All roles have equal hardware.
const ROLE: Role = Role::X;

impl Trace {
    /// Rows for a cell between random neighbours, with as many random ops in one clock as its units allow.
    pub(super) fn overlap_cell(&mut self, machine: &Machine, vectors: usize, rng: &mut Pcg64) {
        let widths = Widths::of(machine);
        let mut cell = OverlapCell::default();
        for _ in 0..vectors {
            let (own, heard) = (own_ops(rng), heard_ops(rng));
            let neighbours = [(); 4].map(|()| OverlapCell {
                square: corner(rng, widths.square),
                work: corner(rng, widths.work),
                distance: corner(rng, widths.work),
                sum: corner(rng, widths.sum),
                ..OverlapCell::default()
            });
            let neighbour = |axis: Axis| &neighbours[axis.bit() as usize];
            let ports = CellPorts {
                query: corner(rng, widths.coordinate) as u32,
                radius_sq: corner(rng, widths.radius_sq) as u32,
                photon: corner(rng, widths.photon) as u32,
                power: corner(rng, widths.power),
                present: rng.random(),
            };
            let write_query = rng.random_ratio(1, 16);
            let of_own = own.iter().map(|&step| asked_of(step, ROLE, ROLE));
            let of_heard = heard.iter().map(|&step| asked_of(step, across(step), ROLE));
            let word = of_own.chain(of_heard).fold(0, |word, fields| word | fields);
            let value = |name: &str| match name {
                "word" => word.into(),
                "write_query" => write_query.into(),
                "query_in" => ports.query.into(),
                "radius_sq_in" => ports.radius_sq.into(),
                "photon_in" => ports.photon.into(),
                "present_in" => ports.present.into(),
                "power_in" => ports.power,
                "link_x" => neighbour(Axis::X).sum,
                "link_y" => neighbour(Axis::Y).sum,
                "link_z" => word_on_z(neighbour(Axis::Z), &own),
                "link_w" => word_on_w(neighbour(Axis::W), &own),
                other => panic!("a cell whose units overlap has no pin {other}"),
            };
            let (z, w) = (word_on_z(&cell, &heard), word_on_w(&cell, &heard));
            let mut expected = vec![cell.sum, z, w];
            expected.extend(cell.registers());
            self.push(Activity::Flows, value, &expected);
            cell.clock(&own, &ports, neighbour, &widths);
            if write_query {
                cell.take_query(&ports);
            }
        }
    }
}

/// Random steps that write in one clock: at most one for each register, and one word for each axis.
fn own_ops(rng: &mut Pcg64) -> Vec<Step> {
    use Op::*;
    let mut steps = Vec::new();
    let alone = [LoadPhoton, LoadPower, SquareDifference];
    for op in alone.into_iter().chain((1..POWER_WORDS).map(MovePower)) {
        steps.extend(rng.random::<bool>().then_some(Step::new(op)));
    }
    let gate = Some(Step::new(Gate));
    let receives =
        [Axis::X, Axis::Y, Axis::Z, Axis::W].map(|axis| Some(Step::across(Receive, axis)));
    let operands = [&receives[..], &[gate, gate, None]].concat();
    let operand = *operands.choose(rng).expect("a choice");
    let adds = [Some(Step::new(Add)), Some(Step::new(Accumulate)), None];
    let keeps = [Step::new(Keep), KEEP_Z, Step::across(Keep, Axis::W)];
    let mut distances = [&keeps.map(Some)[..], &[Some(RELAY), None]].concat();
    // A neighbour sends one word on an axis.
    distances.retain(|&distance| {
        let pair = (operand, distance);
        pair != (Some(Step::across(Receive, Axis::Z)), Some(KEEP_Z))
            && pair != (Some(Step::across(Receive, Axis::W)), Some(RELAY))
    });
    steps.extend(operand);
    steps.extend(*adds.choose(rng).expect("a choice"));
    steps.extend(*distances.choose(rng).expect("a choice"));
    steps
}

/// The steps of a neighbour in which it receives another word than the cell sends otherwise.
const KEEP_Z: Step = Step::across(Op::Keep, Axis::Z);
const RELAY: Step = Step::across(Op::Relay, Axis::W);

/// Random steps of neighbours that select the word which the cell sends.
fn heard_ops(rng: &mut Pcg64) -> Vec<Step> {
    let mut steps = vec![KEEP_Z, RELAY];
    steps.retain(|_| rng.random());
    steps
}

/// The role of the neighbour that receives the cell's word in a step.
fn across(step: Step) -> Role {
    ROLE.across(step.axis.expect("a step that hears"))
}

/// The word that the cell sends on z for its neighbours' steps.
fn word_on_z(cell: &OverlapCell, heard: &[Step]) -> u64 {
    match heard.contains(&KEEP_Z) {
        true => cell.work,
        false => cell.square,
    }
}

/// The word that the cell sends on w.
fn word_on_w(cell: &OverlapCell, heard: &[Step]) -> u64 {
    match heard.contains(&RELAY) {
        true => cell.distance,
        false => cell.work,
    }
}
