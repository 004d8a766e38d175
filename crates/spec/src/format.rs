//! Number formats: how many bits each value has, and why they cannot overflow.
//!
//! All values are unsigned integers. Coordinates are steps of the frame around the query,
//! `radius_sq` and distances are square steps, powers are multiples of the map's power step.
//! No value is ever rounded inside the machine: every result below is exact.

use crate::hypercube::Hypercube;
use crate::machine::Machine;

/// How the squarer of `(A-B)^2` is built; the result is the same.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum Squarer {
    /// From base-16 digits: tables of 4-bit squares and 4x4-bit products, for LUTs.
    Digits,
    /// As one product `m * m`, for a DSP block.
    Product,
}

impl Squarer {
    /// The word for it in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Digits => "digits",
            Self::Product => "product",
        }
    }
}

/// The width in bits of every kind of value in one machine.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Widths {
    /// A coordinate of a photon or a query point: `coordinate_bits`.
    pub coordinate: u32,
    /// `(A-B)^2` of two coordinates: twice the coordinate.
    pub square: u32,
    /// A squared distance, the sum of three squares: `3 (2^c - 1)^2 < 2^(2c + 2)`.
    /// `radius_sq` has the same width, so every distance can be compared.
    pub distance: u32,
    /// A photon's power in one channel: `power_bits`.
    pub power: u32,
    /// The work register and the links: a squared distance, or the power of all the photons of
    /// one iteration (`power` plus one bit for each photon axis), whichever is wider.
    pub work: u32,
    /// The sums of a query: `max_photons` photons of full-scale power.
    pub sum: u32,
}

impl Widths {
    /// The widths that follow from a machine's formats.
    pub fn of(machine: &Machine) -> Self {
        let cube = Hypercube::new(machine.dimension);
        let distance = 2 * machine.coordinate_bits + 2;
        let iteration_power = machine.power_bits + cube.photon_axes().count() as u32;
        let full_scale = (1_u128 << machine.power_bits) - 1;
        Self {
            coordinate: machine.coordinate_bits,
            square: 2 * machine.coordinate_bits,
            distance,
            power: machine.power_bits,
            work: distance.max(iteration_power),
            sum: bits_for(full_scale * u128::from(machine.max_photons)),
        }
    }
}

/// The bits that hold every value from 0 to `largest`; at least 1.
pub(crate) fn bits_for(largest: u128) -> u32 {
    (u128::BITS - largest.leading_zeros()).max(1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::MACHINES;

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
            let largest_coordinate = (1_u128 << widths.coordinate) - 1;
            assert!(largest_coordinate.pow(2) < 1 << widths.square);
            assert!(3 * largest_coordinate.pow(2) < 1 << widths.distance);
            let full_scale = (1_u128 << widths.power) - 1;
            let photons = Hypercube::new(machine.dimension).photons() as u128;
            assert!(photons * full_scale < 1 << widths.work);
            assert!(u128::from(machine.max_photons) * full_scale < 1 << widths.sum);
            assert!(
                widths.sum <= 64 && widths.work <= 32,
                "{}: the runners carry sums in 64 bits, all other values in 32",
                machine.name
            );
        }
    }
}
