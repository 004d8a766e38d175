//! The bit widths of every kind of value in a machine or a photon format, and why no value overflows.
//!
//! All values are unsigned integers. Coordinates are counted in steps of the frame around the query,
//! `radius_sq` and distances in square steps, powers in multiples of the map's power step. The machine never
//! rounds a value: every result is exact. A photon format clamps differences, and a clamped difference is out
//! of range just as the unclamped one is.

use super::numbers::Numbers;
use super::photon_format::PhotonFormat;
use crate::machine::Machine;

/// The width in bits of every kind of value. A spatial machine has further values, whose widths are methods.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Widths {
    /// A coordinate of a query point in the frame.
    pub coordinate: u32,
    /// A coordinate of a photon in the frame: as wide as a query's, less the query's extra fraction bits.
    pub photon: u32,
    /// A photon's position in its block, on one axis.
    pub position: u32,
    /// The input of the squarer: |A-B|, clamped to p + x bits in a photon format.
    pub difference: u32,
    /// A square or half square: twice as wide as the difference. A half square is at most (2^r - 1) 2^r <
    /// 2^(2r) for a difference of r bits.
    pub square: u32,
    /// A squared distance in full: the sum of three squares, two bits wider than one.
    pub distance: u32,
    /// A squared distance in a photon format, where it is compared and not kept: as wide as a square. A sum
    /// that does not fit saturates at all ones, which exceeds R^2 < (2^r - 1)^2.
    pub saturated_distance: u32,
    /// `radius_sq`. In plain numbers it is as wide as a squared distance, so that every distance can be
    /// compared. In a photon format it is no wider than a square.
    pub radius_sq: u32,
    /// One channel of a photon's power as it is stored.
    pub mantissa: u32,
    /// The exponent on a photon's pins, whether it belongs to the photon or to its block: wide enough for the
    /// largest exponent that is used. 0 bits where there is none.
    pub exponent: u32,
    /// The exponent in a photon's record; 0 bits where the exponent belongs to the block. It may be
    /// wider than the exponent on the pins, because no photon uses the largest exponents of 6 bits and more.
    pub record_exponent: u32,
    /// A decoded power: a mantissa, shifted by up to the exponent's range.
    pub power: u32,
    /// The work register and the links. They hold a squared distance; in a machine without separate adders
    /// for distances and powers, also the power of all photons of one iteration (`power` plus one bit for
    /// each photon axis).
    pub work: u32,
    /// The sums of a query: wide enough for `max_photons` photons of full-scale power and for the photons of
    /// one iteration. Where sums share the adder with the work register, they are no narrower than that.
    pub sum: u32,
    /// A query's count of photons in range, 0 to `max_photons`. Where it is summed as a power, it is as wide
    /// as a sum.
    pub count: u32,
    /// A photon's record: three positions, a mantissa for each channel, and the exponent.
    pub bits_per_photon: u32,
}

impl Widths {
    /// Computes the widths of a machine from its numbers.
    pub fn of(machine: &Machine) -> Self {
        let own = Self::of_numbers(&machine.numbers);
        let iteration = own.power + machine.photons_per_iteration().ilog2();
        if machine.spatial().is_some() {
            // In a spatial machine, distances, sums and counts have adders of their own.
            return Self {
                sum: own.sum.max(iteration),
                count: own.count.max(Self::GROUP_COUNT),
                ..own
            };
        }
        let work = own.distance.max(iteration);
        // In other machines, one adder serves all.
        let sum = own.sum.max(work);
        Self {
            work,
            sum,
            count: sum,
            ..own
        }
    }

    /// Computes the widths of numbers alone: those of a gather that adds one photon at a time and has separate
    /// adders for distances, powers and counts. The numbers must be legal, see [`Numbers::check`].
    pub fn of_numbers(numbers: &Numbers) -> Self {
        let frame = Numbers::FRAME_BLOCKS.ilog2();
        let position = numbers.position_bits();
        let coordinate = numbers.radius_bits() + frame;
        let difference = match numbers {
            Numbers::Plain(_) => coordinate,
            Numbers::Local(format) => format.radius_bits(),
        };
        let square = 2 * difference;
        let distance = square + 2;
        let format = numbers.power();
        let mantissa = format.mantissa_bits;
        let range = format.exponent_range();
        let record_exponent = format.record_exponent_bits();
        let full_scale = ((1_u128 << mantissa) - 1) << range;
        let max_photons = u128::from(numbers.max_photons());
        Self {
            coordinate,
            photon: position + frame,
            position,
            difference,
            square,
            distance,
            saturated_distance: square,
            radius_sq: match numbers {
                Numbers::Plain(_) => distance,
                Numbers::Local(_) => square,
            },
            mantissa,
            exponent: match range {
                0 => 0,
                largest => bits_for(largest.into()),
            },
            record_exponent,
            power: mantissa + range,
            work: distance,
            sum: bits_for(full_scale * max_photons),
            count: bits_for(max_photons),
            bits_per_photon: 3 * position + format.channels.count() * mantissa + record_exponent,
        }
    }

    /// Computes the widths of a photon format alone, as [`Self::of_numbers`] does.
    pub fn of_format(format: &PhotonFormat) -> Self {
        Self::of_numbers(&format.into())
    }
}

/// The number of bits that hold every value from 0 to `largest`; at least 1.
pub(crate) fn bits_for(largest: u128) -> u32 {
    (u128::BITS - largest.leading_zeros()).max(1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{MACHINES, PHOTON_FORMATS, find_photon_format};

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
            assert!(u128::from(machine.max_photons()) < 1 << widths.count);
            assert!(machine.spatial().is_some() || widths.work <= widths.sum);
            assert!(
                widths.sum <= 64 && widths.coordinate <= 32 && widths.radius_sq <= 32,
                "{}: the runners carry powers and sums in 64 bits, all other values in 32",
                machine.name
            );
        }
    }

    #[test]
    fn no_value_of_any_named_format_can_overflow() {
        for format in PHOTON_FORMATS {
            let widths = Widths::of_format(format);
            let largest_offset = u128::from(Numbers::FRAME_BLOCKS - 1);
            let edge = u128::from(format.edge_steps());
            assert!(largest_offset * edge + (edge - 1) < 1 << widths.coordinate);
            let m = (1_u128 << widths.difference) - 1;
            assert!(m * (m + 1) < 1 << widths.square);
            let radius_sq = u128::from(format.radius_steps()).pow(2);
            assert!(radius_sq < (1 << widths.saturated_distance) - 1);
            let full_scale = ((1_u128 << widths.mantissa) - 1) << format.power.exponent_range();
            assert!(full_scale < 1 << widths.power);
            assert!(u128::from(format.max_photons) * full_scale < 1 << widths.sum);
            assert!(u128::from(format.max_photons) < 1 << widths.count);
        }
    }

    #[test]
    fn no_legal_format_exceeds_what_the_model_carries() {
        let widest = find_photon_format("local12x2-rgb16e8-n4294967296").unwrap();
        assert_eq!(widest.check(), Ok(()));
        let widths = Widths::of_format(&widest);
        assert!(widths.coordinate <= 16 && widths.saturated_distance <= 28);
        assert!(widths.power <= 40 && widths.sum <= 72);
        assert!(widths.bits_per_photon <= 92);
    }

    #[test]
    fn the_default_takes_at_most_56_bits() {
        for (name, bits) in [
            ("local8-rgb8e8", 56),
            ("local8-rgb8e5", 53),
            ("local6-rgb8e8", 50),
            ("local7x1-rgb8b5", 45),
            ("local7x1-mono8e3", 32),
        ] {
            let format = find_photon_format(name).unwrap();
            assert_eq!(Widths::of_format(&format).bits_per_photon, bits, "{name}");
        }
        assert_eq!(PHOTON_FORMATS[0].name(), "local8-rgb8e5");
    }
}
