//! The bit widths of every kind of value in a spatial machine, and why no value overflows.

use super::Spatial;
use crate::formats::{FormatWidths, PhotonFormat, bits_for};

/// The width in bits of every kind of value in one spatial machine. Below, r is the number of radius bits and
/// C that of a coordinate.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct SpatialWidths {
    /// C: a coordinate of query or photon in the frame.
    pub coordinate: u32,
    /// query - photon in two's complement: C + 1.
    pub difference: u32,
    /// r: |d| of a photon that may be in range.
    pub radius: u32,
    /// The low digit of |d|: r - 4 bits. The high digit has [`Self::HIGH_DIGIT`] bits.
    pub low_digit: u32,
    /// The high digit times the two lowest bits of the low one.
    pub low_product: u32,
    /// The high digit times the other bits of the low one.
    pub high_product: u32,
    /// The high digit times the low one: r.
    pub cross: u32,
    /// A square: 2 r.
    pub square: u32,
    /// d^2 where it is made as one product: 2 C, as |d| < 2^C.
    pub product: u32,
    /// The sum of two squares: 2 r + 1.
    pub pair: u32,
    /// The sum of three squares: 2 r + 2.
    pub distance: u32,
    /// `radius_sq`: as wide as a square.
    pub radius_sq: u32,
    /// A stored mantissa.
    pub mantissa: u32,
    /// A photon's exponent; 0 bits where there is none.
    pub exponent: u32,
    /// A decoded power.
    pub power: u32,
    /// The powers of two photons.
    pub pair_power: u32,
    /// The powers of a group of four.
    pub group_power: u32,
    /// A query's sum of powers.
    pub sum: u32,
    /// A query's count.
    pub count: u32,
}

impl SpatialWidths {
    /// Bits of the high digit of |d|: a LUT4 holds one bit of its square.
    pub const HIGH_DIGIT: u32 = 4;
    /// Bits of a pair's count, 0 to 2.
    pub const PAIR_COUNT: u32 = 2;
    /// Bits of a group's count, 0 to 4.
    pub const GROUP_COUNT: u32 = 3;

    /// Computes the widths of a format on whole steps.
    pub fn of(format: &PhotonFormat) -> Self {
        let widths = FormatWidths::of(format);
        let radius = format.radius_bits();
        let low_digit = radius - Self::HIGH_DIGIT;
        Self {
            coordinate: widths.coordinate,
            difference: widths.coordinate + 1,
            radius,
            low_digit,
            low_product: product_bits(low_digit.min(2)),
            high_product: product_bits(low_digit.saturating_sub(2)),
            cross: radius,
            square: widths.square,
            product: 2 * widths.coordinate,
            pair: widths.square + 1,
            distance: widths.square + 2,
            radius_sq: widths.square,
            mantissa: widths.mantissa,
            exponent: match format.power.exponent_range() {
                0 => 0,
                largest => bits_for(largest.into()),
            },
            power: widths.power,
            pair_power: widths.power + Spatial::LANES.ilog2() - 1,
            group_power: widths.power + Spatial::LANES.ilog2(),
            sum: widths.sum.max(widths.power + Spatial::LANES.ilog2()),
            count: widths.count.max(Self::GROUP_COUNT),
        }
    }
}

/// The bits of the product of the high digit and `low` bits of the low digit.
fn product_bits(low: u32) -> u32 {
    match low {
        0 | 1 => SpatialWidths::HIGH_DIGIT,
        more => SpatialWidths::HIGH_DIGIT + more,
    }
}
