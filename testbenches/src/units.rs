//! The expected outputs of the units: by the golden model's ops, or for a spatial machine's squares by the spec's
//! formula.

use std::collections::VecDeque;

use photoncube_model::{CellInputs, CellRules, CellState};
use photoncube_spec::{Op, Squarer};

/// `A+B`: the sum register after an accumulation.
pub(crate) fn add(rules: &CellRules, sum: u64, work: u64) -> u64 {
    let state = CellState {
        sum,
        work,
        ..CellState::default()
    };
    after(rules, state, Op::Accumulate).sum
}

/// `(A-B)^2`: the work register after a squared difference.
pub(crate) fn square(rules: &CellRules, query: u32, photon: u32) -> u64 {
    let state = CellState {
        query,
        photon,
        ..CellState::default()
    };
    after(rules, state, Op::SquareDifference).work
}

/// `if A>B, output 0`: the work register after a gate.
pub(crate) fn gate(rules: &CellRules, work: u64, radius_sq: u32, power: u64) -> u64 {
    let state = CellState {
        work,
        radius_sq,
        power,
        ..CellState::default()
    };
    after(rules, state, Op::Gate).work
}

fn after(rules: &CellRules, mut state: CellState, op: Op) -> CellState {
    state.execute(op, &CellInputs::default(), rules);
    state
}

/// Two squares of a spatial machine, with their pipeline registers, which start as 0.
pub(crate) struct SquarePair {
    radius_bits: u32,
    squarer: Squarer,
    registers: VecDeque<[u64; 4]>,
}

impl SquarePair {
    /// Squares whose outputs appear `latency` clocks after their operands.
    pub fn new(latency: usize, radius_bits: u32, squarer: Squarer) -> Self {
        Self {
            radius_bits,
            squarer,
            registers: VecDeque::from(vec![[0; 4]; latency]),
        }
    }

    /// The outputs in a clock with these operands: both squares, and whether each is far.
    pub fn clock(&mut self, query: u64, [photon_a, photon_b]: [u64; 2]) -> [u64; 4] {
        let square = |photon| square_of(query, photon, self.radius_bits, self.squarer);
        let ((square_a, far_a), (square_b, far_b)) = (square(photon_a), square(photon_b));
        self.registers.push_back([square_a, square_b, far_a, far_b]);
        self.registers.pop_front().expect("one was pushed")
    }
}

/// The expected `Square` and `SquareFar` of a spatial machine, by the spec.
fn square_of(query: u64, photon: u64, radius_bits: u32, squarer: Squarer) -> (u64, u64) {
    let distance = query.abs_diff(photon);
    let modulus = 1 << radius_bits;
    let squared = match squarer {
        Squarer::Digits => distance % modulus,
        Squarer::Product | Squarer::Table => distance,
    };
    let square = squared * squared % (modulus * modulus);
    (square, u64::from(distance >= modulus))
}
