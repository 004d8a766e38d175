//! The register file of an overlapped machine's cell.

use crate::formats::Widths;

/// Words of the power queue. A photon's power needs so many to reach the gate together with the photon's
/// distance. With fewer words, [`super::recurrence_bound`] exceeds the kernel's interval.
pub const POWER_WORDS: u8 = 8;

/// A register of an overlapped machine's cell.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Register {
    /// `q`: the query's coordinate. D holds z, as Z does.
    Query,
    /// `r`: the squared search radius.
    RadiusSq,
    /// `p`: the photon's coordinate. D holds z, as Z does.
    Photon,
    /// `|q - p|`, the first stage of the square unit.
    Magnitude,
    /// The squares of the magnitude's two base-16 digits, side by side: the second stage of the square unit.
    DigitSquares,
    /// The product of the low digit and the lower half of the high one, also in the second stage.
    LowProduct,
    /// The product of the low digit and the upper half of the high one, also in the second stage.
    HighProduct,
    /// `v`: the square.
    Square,
    /// `c`: the adder's first operand where that is not a sum; it holds the square of one clock ago.
    Addend,
    /// `b`: the adder's second operand. A word written here is added in the next clock.
    Operand,
    /// `a`: a sum of squares.
    Work,
    /// `t`: a photon's squared distance, which the gate compares.
    Distance,
    /// `f`: the in-range flag of the distance of one clock ago.
    InRange,
    /// `s`: the sum of the query.
    Sum,
    /// `w0`, `w1`, ...: the power queue, in this role's channel.
    Power(u8),
    /// Whether the power at that place of the queue has a photon. The flag moves with the power.
    Present(u8),
}

impl Register {
    /// All registers, in the order of the rows.
    pub fn all() -> impl Iterator<Item = Self> {
        use Register::*;
        let fixed = [
            Query,
            RadiusSq,
            Photon,
            Magnitude,
            DigitSquares,
            LowProduct,
            HighProduct,
            Square,
            Addend,
            Operand,
            Work,
            Distance,
            InRange,
            Sum,
        ];
        let queue = (0..POWER_WORDS).flat_map(|place| [Power(place), Present(place)]);
        fixed.into_iter().chain(queue)
    }

    /// The register's name in listings and formulas.
    pub fn mnemonic(self) -> String {
        let letter = match self {
            Self::Query => "q",
            Self::RadiusSq => "r",
            Self::Photon => "p",
            Self::Magnitude => "m",
            Self::DigitSquares => "dd",
            Self::LowProduct => "dl",
            Self::HighProduct => "dh",
            Self::Square => "v",
            Self::Addend => "c",
            Self::Operand => "b",
            Self::Work => "a",
            Self::Distance => "t",
            Self::InRange => "f",
            Self::Sum => "s",
            Self::Power(place) => return format!("w{place}"),
            Self::Present(place) => return format!("n{place}"),
        };
        letter.to_owned()
    }

    /// The register's name in the emitted Verilog.
    pub fn name(self) -> String {
        let name = match self {
            Self::Query => "query",
            Self::RadiusSq => "radius_sq",
            Self::Photon => "photon",
            Self::Magnitude => "magnitude",
            Self::DigitSquares => "digit_squares",
            Self::LowProduct => "low_product",
            Self::HighProduct => "high_product",
            Self::Square => "square",
            Self::Addend => "addend",
            Self::Operand => "operand",
            Self::Work => "work",
            Self::Distance => "distance",
            Self::InRange => "in_range",
            Self::Sum => "sum",
            Self::Power(place) => return format!("power_{place}"),
            Self::Present(place) => return format!("present_{place}"),
        };
        name.to_owned()
    }

    /// The register's width in bits.
    pub fn width(self, widths: &Widths) -> u32 {
        match self {
            Self::Query => widths.coordinate,
            Self::RadiusSq => widths.radius_sq,
            Self::Photon => widths.photon,
            Self::Magnitude => widths.difference,
            Self::DigitSquares | Self::Square | Self::Addend => widths.square,
            // The width of a product of one digit and half a digit.
            Self::LowProduct | Self::HighProduct => 6,
            Self::Work | Self::Distance => widths.work,
            Self::Operand | Self::Sum => widths.sum,
            Self::Power(_) => widths.power,
            Self::InRange | Self::Present(_) => 1,
        }
    }
}
