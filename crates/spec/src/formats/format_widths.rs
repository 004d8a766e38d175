//! The bit widths of every kind of value in a photon format, and why no value overflows.

use super::format::bits_for;
use super::numbers::Numbers;
use super::photon_format::PhotonFormat;

/// The width in bits of every kind of value in one photon format. The format must be legal, see
/// [`PhotonFormat::check`].
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct FormatWidths {
    /// A coordinate in the frame, in fine steps: position, extra bits, and the frame's blocks.
    pub coordinate: u32,
    /// A photon's position in its block, on one axis.
    pub position: u32,
    /// m, the clamped difference on one axis: p + x bits.
    pub difference: u32,
    /// A square or half square of m, at most (2^r - 1) 2^r < 2^(2r).
    pub square: u32,
    /// A squared distance, as wide as a square. A sum that does not fit saturates at all ones, which exceeds
    /// R^2 < (2^r - 1)^2.
    pub distance: u32,
    /// A stored mantissa.
    pub mantissa: u32,
    /// The exponent in a photon's record; 0 bits where the exponent belongs to the block.
    pub exponent: u32,
    /// A decoded power: a mantissa, shifted by up to the exponent's range.
    pub power: u32,
    /// A query's sum of powers: `max_photons` photons of full-scale power.
    pub sum: u32,
    /// A query's count of photons in range: 0 to `max_photons`.
    pub count: u32,
    /// A photon's record: three positions, a mantissa for each channel, and the exponent.
    pub bits_per_photon: u32,
}

impl FormatWidths {
    /// Computes the widths of a format.
    pub fn of(format: &PhotonFormat) -> Self {
        let mantissa = format.power.mantissa_bits;
        let exponent = format.power.record_exponent_bits();
        let exponent_range = format.power.exponent_range();
        let full_scale = ((1_u128 << mantissa) - 1) << exponent_range;
        let radius_bits = format.radius_bits();
        Self {
            coordinate: radius_bits + Numbers::FRAME_BLOCKS.ilog2(),
            position: format.position_bits,
            difference: radius_bits,
            square: 2 * radius_bits,
            distance: 2 * radius_bits,
            mantissa,
            exponent,
            power: mantissa + exponent_range,
            sum: bits_for(full_scale * u128::from(format.max_photons)),
            count: bits_for(format.max_photons.into()),
            bits_per_photon: 3 * format.position_bits
                + format.power.channels.count() * mantissa
                + exponent,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{PHOTON_FORMATS, find_photon_format};

    #[test]
    fn no_value_of_any_named_format_can_overflow() {
        for format in PHOTON_FORMATS {
            let widths = FormatWidths::of(format);
            let largest_offset = u128::from(Numbers::FRAME_BLOCKS - 1);
            let edge = u128::from(format.edge_steps());
            assert!(largest_offset * edge + (edge - 1) < 1 << widths.coordinate);
            let m = (1_u128 << widths.difference) - 1;
            assert!(m * (m + 1) < 1 << widths.square);
            let radius_sq = u128::from(format.radius_steps()).pow(2);
            assert!(radius_sq < (1 << widths.distance) - 1);
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
        let widths = FormatWidths::of(&widest);
        assert!(widths.coordinate <= 16 && widths.distance <= 28);
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
            assert_eq!(FormatWidths::of(&format).bits_per_photon, bits, "{name}");
        }
        assert_eq!(PHOTON_FORMATS[0].name(), "local8-rgb8e5");
    }
}
