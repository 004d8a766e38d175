//! Photon formats: how a stored photon, a query point and their distance become integers.
//!
//! A format is relative to the search radius and to the block, never to the scene: what it costs
//! in accuracy depends on how many steps the radius has, and not on where the scene lies or how
//! large it is. The rules below are all that a reader of a format may assume.
//!
//! # Positions
//! With p = [`PhotonFormat::position_bits`] and x = [`PhotonFormat::query_extra_bits`]:
//! - A block edge has 2^p *cells* and 2^(p+x) *fine steps*; lengths below are in fine steps.
//! - A photon is stored as the index of the cell that contains it, floor(fraction * 2^p), and
//!   stands for that cell's middle. A fraction that rounding made exactly 1 is in the last cell.
//! - A query point is the index of the fine cell that contains it and stands for its middle.
//! - The search radius is R = 2^`radius_bits` - 2, exactly; the edge is 2^(p+x) >= R. A scene's
//!   radius is never rounded: the blocks' edge is chosen so that this ratio holds.
//! - Coordinates are counted in a frame of [`PhotonFormat::FRAME_BLOCKS`] block edges; a photon
//!   of the block with offset o stands o edges further on.
//!
//! # Distance
//! - x = 0: both are middles of equal cells, so d = query - photon is an integer; m = |d|, and
//!   the square is m^2. In range: sum of squares <= R^2.
//! - x >= 1: a photon's middle lies on a fine grid line and a query's between two. With d the
//!   difference of the query's index and that line, the distance is |d + 1/2| = m + 1/2 where
//!   m = d for d >= 0 and m = ~d (inversion, no increment) below. As (m + 1/2)^2 =
//!   m (m + 1) + 1/4, the *half square* m (m + 1) is summed. In range: sum + 3/4 <= R^2, which
//!   for integers is sum <= R^2 - 1. No rounding anywhere: exact.
//! - Overflow: m is clamped to 2^`radius_bits` - 1 = R + 1, whose square alone is out of range,
//!   so a clamped axis decides the same as an unclamped one. The sum of the squares saturates at
//!   2^(2 `radius_bits`) - 1, which is out of range too.
//!
//! # Power
//! - A channel's value is mantissa << exponent, in units of the map's own.
//! - The unit is the largest channel of any photon in the map, over (2^m - 1) << `exponent_range`
//!   with m the mantissa's bits; so the largest power is all ones at the largest exponent.
//! - An exponent is the smallest from 0 to `exponent_range` at which the strongest channel (of the
//!   photon, or of the block's photons) rounds to a mantissa of m bits.
//! - Mantissas round to nearest, ties away from zero; never truncation, which is a bias that
//!   more photons do not remove. What would need an exponent below 0 rounds to a multiple of the
//!   unit, perhaps 0.
//! - Overflow: sums are sized for `max_photons` of full scale, see [`FormatWidths::sum`]; a query
//!   of more photons is refused.

use thiserror::Error;

/// How a photon's three channels are stored.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum PowerFormat {
    /// A mantissa for each channel; one exponent for each block, which costs a photon nothing.
    BlockLinear {
        /// Bits of a mantissa.
        mantissa_bits: u32,
    },
    /// A mantissa for each channel and an exponent for each photon, as in RGBE8 (8 and 8) or
    /// RGB9E5 (9 and 5).
    SharedExponent {
        /// Bits of a mantissa.
        mantissa_bits: u32,
        /// Bits of the exponent.
        exponent_bits: u32,
    },
}

impl PowerFormat {
    /// Bits of a mantissa.
    pub fn mantissa_bits(self) -> u32 {
        match self {
            Self::BlockLinear { mantissa_bits } | Self::SharedExponent { mantissa_bits, .. } => {
                mantissa_bits
            }
        }
    }

    /// Bits of the exponent in a photon's record; 0 where its block has it.
    pub fn exponent_bits(self) -> u32 {
        match self {
            Self::BlockLinear { .. } => 0,
            Self::SharedExponent { exponent_bits, .. } => exponent_bits,
        }
    }
}

/// A photon format; the module's text says what its fields mean.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct PhotonFormat {
    /// Its name on the command line.
    pub name: &'static str,
    /// What it is, in a line.
    pub summary: &'static str,
    /// Fraction bits of a photon's position in its block, 4 to 12.
    pub position_bits: u32,
    /// Further fraction bits of a query point, 0 to 2.
    pub query_extra_bits: u32,
    /// Bits that |A-B| is clamped to, 2 to `position_bits + query_extra_bits`.
    pub radius_bits: u32,
    /// How power is stored.
    pub power: PowerFormat,
    /// The largest exponent, 0 to 47; a stored one must be able to hold it.
    pub exponent_range: u32,
    /// The most photons that one query may be given, 1 to 2^32; it sizes the sums.
    pub max_photons: u64,
}

/// A field of a format is outside what the rules allow.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("format `{format}`: {field} is {found}, expected {min} to {max}")]
pub struct FormatError {
    /// The format.
    pub format: &'static str,
    /// Which of its fields.
    pub field: &'static str,
    /// The field's value.
    pub found: u64,
    /// The smallest that works.
    pub min: u64,
    /// The largest that works.
    pub max: u64,
}

impl PhotonFormat {
    /// Block edges that coordinates span: as in [`crate::Machine::FRAME_BLOCKS`], the query's
    /// block has offset 1, and the fourth keeps the count a power of two.
    pub const FRAME_BLOCKS: u32 = 4;

    /// The search radius R in fine steps.
    pub fn radius_steps(&self) -> u32 {
        (1 << self.radius_bits) - 2
    }

    /// A block's edge in fine steps.
    pub fn edge_steps(&self) -> u32 {
        1 << (self.position_bits + self.query_extra_bits)
    }

    /// Checks every field against its documented range.
    ///
    /// # Errors
    /// The first field outside, with what it could be.
    pub fn check(&self) -> Result<(), FormatError> {
        let fine_bits = u64::from(self.position_bits) + u64::from(self.query_extra_bits);
        let exponent_bits = self.power.exponent_bits();
        let largest_exponent = match self.power {
            PowerFormat::BlockLinear { .. } => Self::LARGEST_EXPONENT,
            PowerFormat::SharedExponent { .. } => {
                Self::LARGEST_EXPONENT.min((1 << exponent_bits.min(8)) - 1)
            }
        };
        let rows = [
            ("position_bits", self.position_bits.into(), 4, 12),
            ("query_extra_bits", self.query_extra_bits.into(), 0, 2),
            ("radius_bits", self.radius_bits.into(), 2, fine_bits),
            ("mantissa_bits", self.power.mantissa_bits().into(), 1, 16),
            ("exponent_bits", exponent_bits.into(), 0, 8),
            (
                "exponent_range",
                self.exponent_range.into(),
                0,
                largest_exponent,
            ),
            ("max_photons", self.max_photons, 1, 1 << 32),
        ];
        match rows
            .into_iter()
            .find(|(_, found, min, max)| !(min..=max).contains(&found))
        {
            None => Ok(()),
            Some((field, found, min, max)) => Err(FormatError {
                format: self.name,
                field,
                found,
                min,
                max,
            }),
        }
    }

    /// Keeps a decoded power of 16 mantissa bits within 63.
    const LARGEST_EXPONENT: u64 = 47;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{PHOTON_FORMATS, find_photon_format};

    #[test]
    fn every_named_format_is_legal_and_found_by_its_name() {
        for format in PHOTON_FORMATS {
            assert_eq!(format.check(), Ok(()));
            assert_eq!(find_photon_format(format.name), Ok(format));
        }
        let message = find_photon_format("local99").unwrap_err().to_string();
        assert!(message.contains("`local99`") && message.contains("local8-rgbe8, "));
    }

    #[test]
    fn a_clamped_axis_is_out_of_range_and_the_edge_holds_the_radius() {
        for format in PHOTON_FORMATS {
            let (radius, clamp) = (format.radius_steps(), (1 << format.radius_bits) - 1);
            assert_eq!(clamp, radius + 1);
            assert!(format.edge_steps() >= radius);
        }
    }

    #[test]
    fn fields_outside_their_range_are_named_with_it() {
        let format = PHOTON_FORMATS[0];
        let shared = |mantissa_bits, exponent_bits| PowerFormat::SharedExponent {
            mantissa_bits,
            exponent_bits,
        };
        #[rustfmt::skip]
        let wrong = [
            (PhotonFormat { position_bits: 3, ..format }, "position_bits is 3, expected 4 to 12"),
            (PhotonFormat { position_bits: 13, ..format }, "position_bits is 13, expected 4 to 12"),
            (PhotonFormat { query_extra_bits: 3, ..format }, "query_extra_bits is 3, expected 0 to 2"),
            (PhotonFormat { radius_bits: 9, ..format }, "radius_bits is 9, expected 2 to 8"),
            (PhotonFormat { radius_bits: 1, ..format }, "radius_bits is 1, expected 2 to 8"),
            (PhotonFormat { power: shared(17, 8), ..format }, "mantissa_bits is 17, expected 1 to 16"),
            (PhotonFormat { power: shared(8, 9), ..format }, "exponent_bits is 9, expected 0 to 8"),
            (PhotonFormat { power: shared(8, 4), ..format }, "exponent_range is 24, expected 0 to 15"),
            (PhotonFormat { exponent_range: 48, ..format }, "exponent_range is 48, expected 0 to 47"),
            (PhotonFormat { max_photons: 0, ..format }, "max_photons is 0, expected 1 to 4294967296"),
        ];
        for (format, expected) in wrong {
            let message = format.check().unwrap_err().to_string();
            assert!(message.ends_with(expected), "{message}");
        }
    }
}
