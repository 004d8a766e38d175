//! Units on their own, so narrow that every pair of their inputs can be tried.
//!
//! A machine has its units at its own widths; these units are the same blocks at other widths. An exhaustive
//! check of them proves the narrow units, and not the wider ones of a machine.

use std::fmt;

use photoncube_spec::{Cut, Cuts, Pins, Squarer, Unit as CellUnit};

use crate::build::NotBuiltIn;
use crate::pinned::{Pinned, block_pins};
use crate::sequential;
use crate::spatial::SquarePair;

/// A unit that is built on its own.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Unit {
    /// `A+B`.
    Add,
    /// `(A-B)^2`, with a squarer from digits.
    SquareDigits,
    /// `(A-B)^2`, with a squarer that is one product.
    SquareProduct,
    /// `if A>B, output 0`.
    Gate,
    /// A spatial machine's squares of two differences, from digits, with a register at every place of the
    /// pipeline.
    PairDigits,
    /// A spatial machine's squares of two differences, as products, with a register at every place of the
    /// pipeline.
    PairProduct,
    /// A spatial machine's squares of two differences, from a table, with a register at every place of the
    /// pipeline.
    PairTable,
}

impl Unit {
    /// Every unit that is built on its own.
    pub const ALL: [Self; 7] = [
        Self::Add,
        Self::SquareDigits,
        Self::SquareProduct,
        Self::Gate,
        Self::PairDigits,
        Self::PairProduct,
        Self::PairTable,
    ];

    /// The operand widths, in bits, that the units are built at.
    pub const BITS: [u32; 2] = [6, 8];

    /// The unit's name in reports. The name of its top module ends with it and the width.
    pub fn name(self) -> &'static str {
        match self {
            Self::Add => "add",
            Self::SquareDigits => "square_digits",
            Self::SquareProduct => "square_product",
            Self::Gate => "gate",
            Self::PairDigits => "square_pair_digits",
            Self::PairProduct => "square_pair_product",
            Self::PairTable => "square_pair_table",
        }
    }

    /// The unit of a cell that this is; `None` for a pair of squares.
    pub fn of_cell(self) -> Option<CellUnit> {
        match self {
            Self::Add => Some(CellUnit::Add),
            Self::SquareDigits | Self::SquareProduct => Some(CellUnit::Square),
            Self::Gate => Some(CellUnit::Gate),
            Self::PairDigits | Self::PairProduct | Self::PairTable => None,
        }
    }

    /// The implementation of the unit's squares; `None` for a unit without squares.
    pub fn squarer(self) -> Option<Squarer> {
        match self {
            Self::Add | Self::Gate => None,
            Self::SquareDigits | Self::PairDigits => Some(Squarer::Digits),
            Self::SquareProduct | Self::PairProduct => Some(Squarer::Product),
            Self::PairTable => Some(Squarer::Table),
        }
    }

    /// Whether the unit has a clock. A clocked unit has a register at each place of the pipeline of its
    /// squares.
    pub fn is_clocked(self) -> bool {
        matches!(self, Self::PairDigits | Self::PairProduct | Self::PairTable)
    }

    /// The pipeline registers of a pair of squares: one at every place of a squarer. The place `SquareDelay` is behind it.
    pub const PAIR_CUTS: Cuts = Cuts::of(&[
        Cut::Difference,
        Cut::Magnitude,
        Cut::Products,
        Cut::Cross,
        Cut::Square,
    ]);

    /// The bits of a difference that a pair of squares with operands of `bits` bits uses; a larger difference
    /// is far. As in every spatial machine, they are fewer than the operands' bits.
    pub fn radius_bits(bits: u32) -> u32 {
        bits - 1
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

macro_rules! pair {
    ($squarer:expr, $c:literal $d:literal $r:literal $q:literal $l:literal $lp:literal $hp:literal $pr:literal) => {
        Box::new(SquarePair::<$c, $c, $d, $r, $q, $l, $lp, $hp, $pr>::new(
            Unit::PAIR_CUTS,
            $squarer,
        ))
    };
}

/// The block of a unit with operands of `bits` bits; `None` if it is not built. A pair's high digit has 4
/// bits and its low digit at least 3, so no pair from digits has 6-bit operands.
fn find(unit: Unit, bits: u32) -> Option<Box<dyn Pinned>> {
    use Squarer::{Digits, Product, Table};
    if let Some(of_cell) = unit.of_cell() {
        let squarer = unit.squarer().unwrap_or(Digits);
        return match bits {
            6 => sequential::build_unit::<6, 6, 6, 12, 6, 6, 6, 6>(of_cell, squarer),
            8 => sequential::build_unit::<8, 8, 8, 16, 8, 8, 8, 8>(of_cell, squarer),
            _ => None,
        };
    }
    Some(match (unit, bits) {
        (Unit::PairDigits, 8) => pair!(Digits, 8 9 7 14 15 6 4 16),
        (Unit::PairProduct, 6) => pair!(Product, 6 7 5 10 11 4 4 12),
        (Unit::PairProduct, 8) => pair!(Product, 8 9 7 14 15 6 4 16),
        (Unit::PairTable, 6) => pair!(Table, 6 7 5 10 11 4 4 12),
        (Unit::PairTable, 8) => pair!(Table, 8 9 7 14 15 6 4 16),
        _ => return None,
    })
}

/// Whether a unit is built at an operand width of `bits` bits.
pub fn has_unit(unit: Unit, bits: u32) -> bool {
    find(unit, bits).is_some()
}

/// Builds the block of a unit, with all signals claimed.
pub(crate) fn build_unit(unit: Unit, bits: u32) -> Result<Box<dyn Pinned>, NotBuiltIn> {
    let mut block = find(unit, bits).ok_or_else(|| NotBuiltIn {
        machine: label(unit, bits),
        needed: format!("the unit {unit} of {bits} bits"),
        built_in: format!("{:?} bits, `square_pair_digits` of 8 alone", Unit::BITS),
    })?;
    block.connect_all();
    Ok(block)
}

/// The unit's name in messages and in the name of its top module.
pub(crate) fn label(unit: Unit, bits: u32) -> String {
    format!("{unit}_{bits}")
}

/// Lists the pins of a unit, in the order of its rows.
///
/// # Errors
/// The unit is not built at that width.
pub fn unit_pins(unit: Unit, bits: u32) -> Result<Pins, NotBuiltIn> {
    Ok(block_pins(build_unit(unit, bits)?.as_ref()))
}
