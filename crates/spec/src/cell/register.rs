//! The registers of a cell.

use super::op::Op;
use crate::formats::Widths;

/// Words of an overlapped cell's power queue. A photon's power needs so many to reach the gate together with
/// the photon's distance. With fewer words, [`crate::overlap::recurrence_bound`] exceeds the kernel's interval.
pub const POWER_WORDS: u8 = 8;

/// A register of a cell.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Register {
    /// The query point's coordinate of this role. In a sequential D cell: the coordinate at zero distance from
    /// a photon at 0; that is 0, or 1 for quarter-step formats. In an overlapped D cell: z, as in Z.
    Query,
    /// The squared search radius.
    RadiusSq,
    /// The photon's coordinate of this role. In a D cell: 0, or z in an overlapped one.
    Photon,
    /// `|q - p|`, the first stage of a square unit in stages.
    Magnitude,
    /// The squares of the magnitude's two base-16 digits, side by side: the second stage of the square unit.
    DigitSquares,
    /// The product of the low digit and the lower half of the high one, also in the second stage.
    LowProduct,
    /// The product of the low digit and the upper half of the high one, also in the second stage.
    HighProduct,
    /// The square, where it has a register of its own.
    Square,
    /// The adder's first operand where that is not a sum; it holds the square of one clock ago.
    Addend,
    /// The adder's second operand. A word written here is added in the next clock.
    Operand,
    /// The running value of a sequential cell: a square, then a distance, then a gated power; the links carry
    /// this register. In an overlapped cell a sum of squares.
    Work,
    /// A photon's squared distance, which the gate compares.
    Distance,
    /// The in-range flag of the distance of one clock ago.
    InRange,
    /// The sum of the query so far.
    Sum,
    /// The photon's power in this role's channel. A sequential cell has place 0, an overlapped one a queue.
    Power(u8),
    /// Whether the power at that place of the queue has a photon. The flag moves with the power.
    Present(u8),
}

impl Register {
    /// The register that an op at a place of the queue reads or writes: its row names those of place 1.
    pub(super) fn at(self, op: Op) -> Self {
        match (self, op) {
            (Self::Power(row), Op::MovePower(place)) => Self::Power(row + place - 1),
            _ => self,
        }
    }
}

/// One row of a register table.
#[derive(Copy, Clone, Debug)]
pub struct RegisterRow {
    /// The register that the row describes.
    pub register: Register,
    /// The register's name in listings and formulas.
    pub mnemonic: &'static str,
    /// The register's name in the emitted Verilog.
    pub name: &'static str,
    /// The register's width in bits.
    pub width: fn(&Widths) -> u32,
}

const fn row(
    register: Register,
    mnemonic: &'static str,
    name: &'static str,
    width: fn(&Widths) -> u32,
) -> RegisterRow {
    RegisterRow {
        register,
        mnemonic,
        name,
        width,
    }
}

pub(super) const SEQUENTIAL: &[RegisterRow] = &[
    row(Register::Query, "q", "query", |w| w.coordinate),
    row(Register::RadiusSq, "r", "radius_sq", |w| w.radius_sq),
    row(Register::Photon, "p", "photon", |w| w.photon),
    row(Register::Power(0), "w", "power", |w| w.power),
    row(Register::Work, "v", "work", |w| w.work),
    row(Register::Sum, "s", "sum", |w| w.sum),
];

pub(super) const OVERLAPPED: &[RegisterRow] = &[
    row(Register::Query, "q", "query", |w| w.coordinate),
    row(Register::RadiusSq, "r", "radius_sq", |w| w.radius_sq),
    row(Register::Photon, "p", "photon", |w| w.photon),
    row(Register::Magnitude, "m", "magnitude", |w| w.difference),
    row(Register::DigitSquares, "dd", "digit_squares", |w| w.square),
    row(Register::LowProduct, "dl", "low_product", |_| PRODUCT),
    row(Register::HighProduct, "dh", "high_product", |_| PRODUCT),
    row(Register::Square, "v", "square", |w| w.square),
    row(Register::Addend, "c", "addend", |w| w.square),
    row(Register::Operand, "b", "operand", |w| w.sum),
    row(Register::Work, "a", "work", |w| w.work),
    row(Register::Distance, "t", "distance", |w| w.work),
    row(Register::InRange, "f", "in_range", |_| 1),
    row(Register::Sum, "s", "sum", |w| w.sum),
    row(Register::Power(0), "w0", "power_0", |w| w.power),
    row(Register::Present(0), "n0", "present_0", |_| 1),
    row(Register::Power(1), "w1", "power_1", |w| w.power),
    row(Register::Present(1), "n1", "present_1", |_| 1),
    row(Register::Power(2), "w2", "power_2", |w| w.power),
    row(Register::Present(2), "n2", "present_2", |_| 1),
    row(Register::Power(3), "w3", "power_3", |w| w.power),
    row(Register::Present(3), "n3", "present_3", |_| 1),
    row(Register::Power(4), "w4", "power_4", |w| w.power),
    row(Register::Present(4), "n4", "present_4", |_| 1),
    row(Register::Power(5), "w5", "power_5", |w| w.power),
    row(Register::Present(5), "n5", "present_5", |_| 1),
    row(Register::Power(6), "w6", "power_6", |w| w.power),
    row(Register::Present(6), "n6", "present_6", |_| 1),
    row(Register::Power(7), "w7", "power_7", |w| w.power),
    row(Register::Present(7), "n7", "present_7", |_| 1),
];

/// The width of a product of one digit of 4 bits and half a digit.
const PRODUCT: u32 = 6;
