//! The bit widths of every kind of value in a machine, and why no value overflows.
//!
//! All values are unsigned integers. Coordinates are counted in steps of the frame around the query,
//! `radius_sq` and distances in square steps, powers in multiples of the map's power step. The machine never
//! rounds a value: every result is exact. A photon format clamps differences, and a clamped difference is out
//! of range just as the unclamped one is.

use super::format_widths::FormatWidths;
use super::numbers::{Numbers, PlainFormat};
use super::photon_format::PhotonFormat;
use crate::machine::Machine;

/// The implementation of the squarer of `(A-B)^2`. All implementations give the same square.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum Squarer {
    /// From base-16 digits: tables of 4-bit squares and 4x4-bit products, for LUTs.
    Digits,
    /// As one product `m * m`, for a DSP block.
    Product,
    /// As a table of squares, for a block RAM. Only spatial machines have this squarer.
    Table,
}

impl Squarer {
    /// The squarer's name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Digits => "digits",
            Self::Product => "product",
            Self::Table => "table",
        }
    }
}

/// The width in bits of every kind of value in one machine.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Widths {
    /// A coordinate of a query point in the frame.
    pub coordinate: u32,
    /// A coordinate of a photon in the frame: as wide as a query's, less the query's extra fraction bits.
    pub photon: u32,
    /// The input of the squarer: |A-B|, clamped to p + x bits in a photon format.
    pub difference: u32,
    /// A square or half square: twice as wide as the difference.
    pub square: u32,
    /// `radius_sq`. In plain numbers it is as wide as a squared distance, so that every distance can be
    /// compared. In a photon format it is no wider than a square.
    pub radius_sq: u32,
    /// One channel of a photon's power as it is stored.
    pub mantissa: u32,
    /// A photon's exponent; 0 bits where there is none.
    pub exponent: u32,
    /// A decoded power: a mantissa, shifted by its exponent.
    pub power: u32,
    /// The work register and the links. They hold a squared distance (the sum of three squares, two bits
    /// wider than one square) or the power of all photons of one iteration (`power` plus one bit for each
    /// photon axis), whichever is wider.
    pub work: u32,
    /// The sums of a query: wide enough for `max_photons` photons of full-scale power. Where sums share the
    /// adder with the work register, they are no narrower than that register.
    pub sum: u32,
}

impl Widths {
    /// Computes the widths of a machine from its numbers.
    pub fn of(machine: &Machine) -> Self {
        let own = match &machine.numbers {
            Numbers::Plain(format) => Self::of_plain(format),
            Numbers::Local(format) => Self::of_local(format),
        };
        let photon_axes = machine.photons_per_iteration().ilog2();
        let distance = own.square + 2;
        if machine.spatial().is_some() {
            // In an overlapped or spatial machine, distances and sums have adders of their own.
            return Self {
                work: distance,
                sum: own.sum.max(own.power + photon_axes),
                ..own
            };
        }
        let work = distance.max(own.power + photon_axes);
        Self {
            work,
            // In a sequential machine, one adder serves both.
            sum: own.sum.max(work),
            ..own
        }
    }

    fn of_plain(format: &PlainFormat) -> Self {
        let full_scale = (1_u128 << format.power_bits) - 1;
        let square = 2 * format.coordinate_bits;
        Self {
            coordinate: format.coordinate_bits,
            photon: format.coordinate_bits,
            difference: format.coordinate_bits,
            square,
            radius_sq: square + 2,
            mantissa: format.power_bits,
            exponent: 0,
            power: format.power_bits,
            work: 0,
            sum: bits_for(full_scale * u128::from(format.max_photons)),
        }
    }

    fn of_local(format: &PhotonFormat) -> Self {
        let widths = FormatWidths::of(format);
        Self {
            coordinate: widths.coordinate,
            photon: widths.coordinate - format.query_extra_bits,
            difference: widths.difference,
            square: widths.square,
            radius_sq: widths.square,
            mantissa: widths.mantissa,
            exponent: match format.power.exponent_range() {
                0 => 0,
                largest => bits_for(largest.into()),
            },
            power: widths.power,
            work: 0,
            sum: widths.sum,
        }
    }
}

/// The number of bits that hold every value from 0 to `largest`; at least 1.
pub(crate) fn bits_for(largest: u128) -> u32 {
    (u128::BITS - largest.leading_zeros()).max(1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machines::MACHINES;

    #[test]
    fn bits_hold_the_largest_value_and_no_more() {
        for (largest, bits) in [(0, 1), (1, 1), (2, 2), (255, 8), (256, 9), (u128::MAX, 128)] {
            assert_eq!(bits_for(largest), bits, "{largest}");
        }
    }

    #[test]
    fn no_sum_of_any_named_machine_can_overflow() {
        for machine in MACHINES {
            let widths = Widths::of(machine);
            let largest = (1_u128 << widths.difference) - 1;
            let half_step = u128::from(machine.format().is_some_and(|f| f.half_steps()));
            let square = largest * (largest + half_step);
            assert!(square < 1 << widths.square);
            assert!(3 * square < 1 << widths.work);
            assert!(widths.radius_sq >= widths.square && widths.radius_sq <= widths.work);
            let full_scale = machine.full_scale();
            assert!(full_scale < 1 << widths.power);
            let photons = machine.photons_per_iteration() as u128;
            let group = if machine.spatial().is_some() {
                widths.sum
            } else {
                widths.work
            };
            assert!(photons * full_scale < 1 << group);
            assert!(u128::from(machine.max_photons()) * full_scale < 1 << widths.sum);
            assert!(machine.spatial().is_some() || widths.work <= widths.sum);
            assert!(
                widths.sum <= 64 && widths.coordinate <= 32 && widths.radius_sq <= 32,
                "{}: the runners carry powers and sums in 64 bits, all other values in 32",
                machine.name
            );
        }
    }
}
