//! The bit widths of the values that only spatial machines have, and why no value overflows.

use super::Spatial;
use crate::formats::Widths;

/// Below, C is the width of a coordinate and r that of a difference that may be in range.
impl Widths {
    /// Bits of the high digit of |d|: a LUT4 holds one bit of its square.
    pub const HIGH_DIGIT: u32 = 4;
    /// Bits of a pair's count, 0 to 2.
    pub const PAIR_COUNT: u32 = 2;
    /// Bits of a group's count, 0 to 4.
    pub const GROUP_COUNT: u32 = 3;

    /// d = query - photon in two's complement: C + 1.
    pub fn signed_difference(&self) -> u32 {
        self.coordinate + 1
    }

    /// The low digit of |d|: r - 4. The high digit has [`Self::HIGH_DIGIT`] bits.
    pub fn low_digit(&self) -> u32 {
        self.difference.saturating_sub(Self::HIGH_DIGIT)
    }

    /// The high digit times the two lowest bits of the low one.
    pub fn low_product(&self) -> u32 {
        product_bits(self.low_digit().min(2))
    }

    /// The high digit times the other bits of the low one.
    pub fn high_product(&self) -> u32 {
        product_bits(self.low_digit().saturating_sub(2))
    }

    /// The high digit times the low one: r.
    pub fn cross(&self) -> u32 {
        self.difference
    }

    /// d^2 where it is made as one product: 2 C, as |d| < 2^C.
    pub fn product(&self) -> u32 {
        2 * self.coordinate
    }

    /// The sum of two squares: 2 r + 1.
    pub fn pair(&self) -> u32 {
        self.square + 1
    }

    /// The powers of two photons.
    pub fn pair_power(&self) -> u32 {
        self.power + Spatial::LANES.ilog2() - 1
    }

    /// The powers of a group of four.
    pub fn group_power(&self) -> u32 {
        self.power + Spatial::LANES.ilog2()
    }
}

/// The bits of the product of the high digit and `low` bits of the low digit.
fn product_bits(low: u32) -> u32 {
    match low {
        0 | 1 => Widths::HIGH_DIGIT,
        more => Widths::HIGH_DIGIT + more,
    }
}
