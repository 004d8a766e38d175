//! Every pair of operands of a unit, with the expected outputs.

use photoncube_hdl::Unit;
use photoncube_model::CellRules;
use photoncube_spec::{Numbers, PlainFormat, Squarer, Unit as CellUnit, Widths};

use crate::levels::{op_of, result};
use crate::squares::SquarePair;

/// Rows of inputs and of expected outputs.
#[derive(Default)]
pub(super) struct Rows {
    pub inputs: Vec<u64>,
    pub expected: Vec<u64>,
    /// The number of different pairs of operands in the rows.
    pub pairs: u64,
    /// The clocks from operands to their outputs.
    pub latency: usize,
}

/// The largest number of bits at which every power is combined with every pair.
const EVERY_POWER_BITS: u32 = 6;

pub(super) fn rows(unit: Unit, bits: u32) -> Rows {
    match (unit.of_cell(), unit.squarer()) {
        (Some(unit), _) => of_cell(unit, bits),
        (None, squarer) => square_pair(bits, squarer.expect("a pair of squares has squarers")),
    }
}

/// Every pair of operands, in order.
fn pairs(bits: u32) -> impl Iterator<Item = (u64, u64)> {
    let all = move || 0..1_u64 << bits;
    all().flat_map(move |a| all().map(move |b| (a, b)))
}

/// The widths of a cell whose units have operands of `bits` bits.
fn narrow(bits: u32) -> Widths {
    Widths {
        radius_sq: bits,
        work: bits,
        sum: bits,
        ..Widths::of_numbers(&Numbers::Plain(PlainFormat {
            coordinate_bits: bits,
            power_bits: bits,
            max_photons: 1,
        }))
    }
}

/// Every pair of a unit's first two operands; with each, if there is a third operand, every power.
fn of_cell(unit: CellUnit, bits: u32) -> Rows {
    let op = op_of(unit);
    let rules = CellRules::plain(narrow(bits));
    let powers = match op.reads.len() {
        2 => vec![vec![]],
        _ => powers(bits).into_iter().map(|power| vec![power]).collect(),
    };
    let mut rows = Rows::default();
    for (a, b) in pairs(bits) {
        for (index, power) in powers.iter().enumerate() {
            let operands = [&[a, b], &power[..]].concat();
            rows.push(&operands, &[result(op, &operands, &rules)]);
            rows.pairs -= u64::from(index > 0);
        }
    }
    rows
}

/// Every power; or at larger widths 0, all ones, every other bit, and a walking bit.
fn powers(bits: u32) -> Vec<u64> {
    let all = (1 << bits) - 1;
    if bits <= EVERY_POWER_BITS {
        return (0..=all).collect();
    }
    let alternating = 0x5555_5555_5555_5555 & all;
    let corners = [0, all, alternating, alternating ^ all];
    corners
        .into_iter()
        .chain((0..bits).map(|bit| 1 << bit))
        .collect()
}

/// Rows for two squares at once. The second photon takes the pairs in another order, so that both squares see
/// all pairs.
fn square_pair(bits: u32, squarer: Squarer) -> Rows {
    let half = (1 << (bits - 1)) - 1;
    let radius = Unit::radius_bits(bits);
    let mut rows = Rows {
        latency: Unit::PAIR_CUTS.latency() as usize,
        ..Rows::default()
    };
    // The last squares appear after the last operands.
    let mut squares = SquarePair::new(rows.latency, radius, 0, squarer);
    let flush = std::iter::repeat_n((0, 0), rows.latency);
    for (query, photon) in pairs(bits).chain(flush) {
        let out = squares.clock(query, [photon, photon ^ half]);
        rows.push(&[query, photon, photon ^ half], &out);
    }
    rows.pairs -= rows.latency as u64;
    rows
}

impl Rows {
    /// Appends a row of a new pair.
    fn push(&mut self, inputs: &[u64], expected: &[u64]) {
        self.inputs.extend(inputs);
        self.expected.extend(expected);
        self.pairs += 1;
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use photoncube_hdl::{has_unit, unit_pins};

    use super::*;

    /// The code counts pairs as it makes them; this test finds each pair in the rows.
    #[test]
    fn every_pair_is_there_and_counted_once() {
        for unit in Unit::ALL {
            for bits in Unit::BITS.into_iter().filter(|&bits| has_unit(unit, bits)) {
                let columns = unit_pins(unit, bits).unwrap().inputs.len();
                let rows = rows(unit, bits);
                let chunks = || rows.inputs.chunks_exact(columns);
                let first: BTreeSet<_> = chunks().map(|row| (row[0], row[1])).collect();
                assert_eq!(first.len(), 1 << (2 * bits), "{unit}");
                assert_eq!(rows.pairs, first.len() as u64, "{unit}");
                if unit.is_clocked() {
                    let second: BTreeSet<_> = chunks().map(|row| (row[0], row[2])).collect();
                    assert_eq!(second.len(), first.len(), "{unit}");
                }
            }
        }
    }

    /// Compares the golden model's ops with the paper's arithmetic.
    #[test]
    fn the_expected_values_are_the_papers_arithmetic() {
        for row in pairs(6).zip(of_cell(CellUnit::Add, 6).expected) {
            let ((a, b), sum) = row;
            assert_eq!(sum, (a + b) % 64);
        }
        for ((a, b), square) in pairs(8).zip(of_cell(CellUnit::Square, 8).expected) {
            assert_eq!(square, a.abs_diff(b).pow(2));
        }
        let gated = of_cell(CellUnit::Gate, 6);
        for (inputs, &out) in gated.inputs.chunks_exact(3).zip(&gated.expected) {
            assert_eq!(out, if inputs[0] > inputs[1] { 0 } else { inputs[2] });
        }
    }
}
