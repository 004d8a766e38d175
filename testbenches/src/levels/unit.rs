//! Compares a unit of a cell on its own with the op that the unit does.

use photoncube_model::{CellInputs, CellRules, CellState};
use photoncube_spec::{Machine, OpRow, SEQUENTIAL, Step, Unit};
use rand::RngExt;
use rand_pcg::Pcg64;

use super::{EXHAUSTIVE_PAIRS, Trace};
use crate::compare::Activity;
use crate::stimulus::corner;

/// The op by which a unit is tested.
///
/// # Panics
/// For a port, which is no block.
pub(crate) fn op_of(unit: Unit) -> &'static OpRow {
    let row = SEQUENTIAL.op_of_unit(unit);
    row.unwrap_or_else(|| panic!("no op tests the unit {unit} on its own"))
}

/// The output of a unit on these operands, by the golden model's op: the operands are the registers that the op
/// reads, the output is the register that it writes.
pub(crate) fn result(row: &OpRow, operands: &[u64], rules: &CellRules) -> u64 {
    let operands = row.reads.iter().copied().zip(operands.iter().copied());
    let mut cell = CellState::with(operands);
    cell.execute(row.op, &CellInputs::default(), rules);
    cell.register(row.writes[0])
}

impl Trace {
    /// A unit on every pair of its first two operands where there are few. Otherwise on every value of one with
    /// the smallest and the largest of the other, where these are few, and on random operands.
    pub(super) fn unit(&mut self, machine: &Machine, unit: Unit, vectors: usize, rng: &mut Pcg64) {
        let row = op_of(unit);
        let rules = CellRules::of(machine);
        let bits: Vec<_> = self.pins.inputs.iter().map(|pin| pin.width).collect();
        let mut rows = first_pairs(bits[0], bits[1], vectors);
        while rows.len() < vectors {
            let second = corner(rng, bits[1]);
            rows.push([near(second, bits[0], rng), second]);
        }
        for pair in rows {
            let more = bits[2..].iter().map(|&bits| corner(rng, bits));
            let operands: Vec<_> = pair.into_iter().chain(more).collect();
            self.expected.push(result(row, &operands, &rules));
            self.inputs.extend(operands);
            self.activities.push(Activity::Step(Step::new(row.op)));
        }
    }
}

fn largest(bits: u32) -> u64 {
    u64::MAX >> (u64::BITS - bits)
}

fn first_pairs(first: u32, second: u32, vectors: usize) -> Vec<[u64; 2]> {
    let all = |bits| 0..=largest(bits);
    let few = |rows: u32| 1_u128 << rows <= vectors.max(EXHAUSTIVE_PAIRS) as u128;
    if few(first + second) {
        return all(first)
            .flat_map(|a| all(second).map(move |b| [a, b]))
            .collect();
    }
    // Twice as many rows as there are values of both operands.
    if !few(first.max(second) + 2) {
        return Vec::new();
    }
    let of_first = all(first).flat_map(|a| [[a, 0], [a, largest(second)]]);
    let of_second = all(second).flat_map(|b| [[0, b], [largest(first), b]]);
    of_first.chain(of_second).collect()
}

/// A random operand. It is often at the edge of a comparison with the other operand, or at the edge of a carry
/// out of their sum.
fn near(other: u64, bits: u32, rng: &mut Pcg64) -> u64 {
    let value = match rng.random_range(0..8) {
        0 | 1 => other,
        2 => other.wrapping_sub(1),
        3 => other.wrapping_add(1),
        4 => !other,
        5 => other.wrapping_neg(),
        _ => corner(rng, bits),
    };
    value & largest(bits)
}
