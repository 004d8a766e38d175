//! The register file of a cell whose units work at the same time.

use crate::format::Widths;

/// Words of the power queue: what a photon's power needs to reach the gate together with the
/// photon's distance. With fewer, [`super::recurrence_bound`] is above this kernel's interval.
pub const POWER_WORDS: u8 = 8;

/// A register of a cell.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Register {
    /// `q`: the query's coordinate. D holds z, as Z does.
    Query,
    /// `r`: the squared search radius.
    RadiusSq,
    /// `p`: the photon's coordinate. D holds z, as Z does.
    Photon,
    /// `|q - p|`, the square unit's first stage.
    Magnitude,
    /// The squares of the magnitude's two base-16 digits side by side: its second stage.
    DigitSquares,
    /// The product of the low digit and the lower half of the high one: its second stage too.
    LowProduct,
    /// The product of the low digit and the upper half of the high one: its second stage too.
    HighProduct,
    /// `v`: the square.
    Square,
    /// `c`: the adder's first operand where it is no sum: what the square was a clock ago.
    Addend,
    /// `b`: the adder's second operand; what is put here is added in the very next clock.
    Operand,
    /// `a`: a sum of squares.
    Work,
    /// `t`: a photon's squared distance, which the gate compares.
    Distance,
    /// `f`: whether the distance of a clock ago is in range.
    InRange,
    /// `s`: the sum of the query.
    Sum,
    /// `w0`, `w1`, ...: the power queue, in this role's channel.
    Power(u8),
    /// Whether there is a photon to the power of that place in the queue; it moves with it.
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

    /// Its name in listings and formulas.
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

    /// Its name in the emitted Verilog.
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

    /// Its width in bits.
    pub fn width(self, widths: &Widths) -> u32 {
        match self {
            Self::Query => widths.coordinate,
            Self::RadiusSq => widths.radius_sq,
            Self::Photon => widths.photon,
            Self::Magnitude => widths.difference,
            Self::DigitSquares | Self::Square | Self::Addend => widths.square,
            // Of a digit and half a digit.
            Self::LowProduct | Self::HighProduct => 6,
            Self::Work | Self::Distance => widths.work,
            Self::Operand | Self::Sum => widths.sum,
            Self::Power(_) => widths.power,
            Self::InRange | Self::Present(_) => 1,
        }
    }
}
