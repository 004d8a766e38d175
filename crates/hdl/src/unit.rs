//! Units for themselves, so narrow that every pair of their inputs can be tried.
//!
//! A machine has its units at its own widths; these have the same blocks at others. What is true of
//! every input at these widths is proven of them, not of the wider ones.

use std::fmt;

use photoncube_spec::{Cut, Cuts, Pins, Squarer};

use crate::build::NotBuiltIn;
use crate::pinned::{Pinned, block_pins};
use crate::spatial::SquarePair;
use crate::units::{AddUnit, GateUnit, SquareUnit};

/// A unit of a cell.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Unit {
    /// `A+B`.
    Add,
    /// `(A-B)^2` from digits.
    SquareDigits,
    /// `(A-B)^2` as a product.
    SquareProduct,
    /// `if A>B, output 0`.
    Gate,
    /// A spatial machine's two squares from digits, a register at every cut.
    PairDigits,
    /// The same as products.
    PairProduct,
    /// The same from a table.
    PairTable,
}

impl Unit {
    /// All units.
    pub const ALL: [Self; 7] = [
        Self::Add,
        Self::SquareDigits,
        Self::SquareProduct,
        Self::Gate,
        Self::PairDigits,
        Self::PairProduct,
        Self::PairTable,
    ];

    /// The widths that the units are built at.
    pub const BITS: [u32; 2] = [6, 8];

    /// Its name in reports, and the end of its top module's name before the width.
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

    /// What its squares are made of; none where there are none.
    pub fn squarer(self) -> Option<Squarer> {
        match self {
            Self::Add | Self::Gate => None,
            Self::SquareDigits | Self::PairDigits => Some(Squarer::Digits),
            Self::SquareProduct | Self::PairProduct => Some(Squarer::Product),
            Self::PairTable => Some(Squarer::Table),
        }
    }

    /// Whether it has a clock; it then has a register at each cut of its squares.
    pub fn is_clocked(self) -> bool {
        matches!(self, Self::PairDigits | Self::PairProduct | Self::PairTable)
    }

    /// Bits of the distance that a pair of operands of so many bits squares; a larger one is far. As in
    /// every spatial machine they are fewer than the operands'.
    pub fn radius_bits(bits: u32) -> u32 {
        bits - 1
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// All registers there can be.
const CUTS: Cuts = Cuts::of(&Cut::ALL);

macro_rules! pair {
    ($squarer:expr, $c:literal $d:literal $r:literal $q:literal $l:literal $lp:literal $hp:literal $pr:literal) => {
        Box::new(SquarePair::<$c, $d, $r, $q, $l, $lp, $hp, $pr>::new(
            CUTS, $squarer,
        ))
    };
}

/// The block of a unit with operands of so many bits. A pair's high digit has 4 bits and its low digit
/// 3 at least, so none from digits has 6-bit operands.
fn find(unit: Unit, bits: u32) -> Option<Box<dyn Pinned>> {
    use Squarer::{Digits, Product, Table};
    Some(match (unit, bits) {
        (Unit::Add, 6) => Box::new(AddUnit::<6>::default()),
        (Unit::Add, 8) => Box::new(AddUnit::<8>::default()),
        (Unit::SquareDigits, 6) => Box::new(SquareUnit::<6, 6, 6, 12>::new(Digits)),
        (Unit::SquareDigits, 8) => Box::new(SquareUnit::<8, 8, 8, 16>::new(Digits)),
        (Unit::SquareProduct, 6) => Box::new(SquareUnit::<6, 6, 6, 12>::new(Product)),
        (Unit::SquareProduct, 8) => Box::new(SquareUnit::<8, 8, 8, 16>::new(Product)),
        (Unit::Gate, 6) => Box::new(GateUnit::<6, 6, 6>::default()),
        (Unit::Gate, 8) => Box::new(GateUnit::<8, 8, 8>::default()),
        (Unit::PairDigits, 8) => pair!(Digits, 8 9 7 14 15 6 4 16),
        (Unit::PairProduct, 6) => pair!(Product, 6 7 5 10 11 4 4 12),
        (Unit::PairProduct, 8) => pair!(Product, 8 9 7 14 15 6 4 16),
        (Unit::PairTable, 6) => pair!(Table, 6 7 5 10 11 4 4 12),
        (Unit::PairTable, 8) => pair!(Table, 8 9 7 14 15 6 4 16),
        _ => return None,
    })
}

/// Whether a unit is built at a width.
pub fn has_unit(unit: Unit, bits: u32) -> bool {
    find(unit, bits).is_some()
}

/// The block with all its signals claimed.
pub(crate) fn build_unit(unit: Unit, bits: u32) -> Result<Box<dyn Pinned>, NotBuiltIn> {
    let mut block = find(unit, bits).ok_or_else(|| NotBuiltIn {
        machine: label(unit, bits),
        needed: format!("the unit {unit} of {bits} bits"),
        built_in: format!("{:?} bits, `square_pair_digits` of 8 alone", Unit::BITS),
    })?;
    block.connect_all();
    Ok(block)
}

/// What it is called in messages and in its top module's name.
pub(crate) fn label(unit: Unit, bits: u32) -> String {
    format!("{unit}_{bits}")
}

/// The pins of a unit, in the order of its rows.
///
/// # Errors
/// The unit is not built at that width.
pub fn unit_pins(unit: Unit, bits: u32) -> Result<Pins, NotBuiltIn> {
    Ok(block_pins(build_unit(unit, bits)?.as_ref()))
}
