//! The numbers of a machine's words, plain or relative to the search radius, and what both have in common.

use std::fmt;

use super::photon_format::{Channels, Exponent, FormatError, PhotonFormat, PowerFormat, Rounding};
use super::widths::Widths;

/// The number format of a machine's words.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Numbers {
    /// The paper's plain arithmetic at full width; the square is `(A-B)^2`.
    Plain(PlainFormat),
    /// Numbers relative to the search radius, by the rules of [`PhotonFormat`].
    Local(PhotonFormat),
}

/// The paper's numbers: coordinates of the frame, linear powers in three channels.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct PlainFormat {
    /// Bits of a coordinate, 3 to 17. The frame of a query is [`Numbers::FRAME_BLOCKS`] block edges wide.
    pub coordinate_bits: u32,
    /// Bits of a photon's power in one channel, 1 to 16.
    pub power_bits: u32,
    /// The most photons that one query may be given, 1 to 2^32; the sums are sized for it.
    pub max_photons: u64,
}

impl PlainFormat {
    /// Fraction bits of a position in its block.
    pub fn position_bits(&self) -> u32 {
        self.coordinate_bits - Numbers::FRAME_BLOCKS.ilog2()
    }

    /// Checks every field against its documented range.
    ///
    /// # Errors
    /// The first field outside its range, with the range.
    pub fn check(&self) -> Result<(), FormatError> {
        let rows = [
            ("coordinate_bits", self.coordinate_bits.into(), 3, 17),
            ("power_bits", self.power_bits.into(), 1, 16),
            ("max_photons", self.max_photons, 1, 1 << 32),
        ];
        FormatError::check(self, &rows)
    }
}

impl fmt::Display for PlainFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            coordinate_bits,
            power_bits,
            ..
        } = self;
        write!(
            f,
            "the plain format of {coordinate_bits}-bit coordinates and {power_bits}-bit powers"
        )
    }
}

impl Numbers {
    /// The block edges that coordinates span: the query's block, one block on each side, and a fourth that
    /// makes the count a power of two. The query's block has offset 1.
    pub const FRAME_BLOCKS: u32 = 4;

    /// Checks every field against its documented range.
    ///
    /// # Errors
    /// The first field outside its range, with the range.
    pub fn check(&self) -> Result<(), FormatError> {
        match self {
            Self::Plain(format) => format.check(),
            Self::Local(format) => format.check(),
        }
    }

    /// The photon format; `None` in plain numbers.
    pub fn format(&self) -> Option<&PhotonFormat> {
        match self {
            Self::Plain(_) => None,
            Self::Local(format) => Some(format),
        }
    }

    /// Fraction bits of a photon's position in its block.
    pub fn position_bits(&self) -> u32 {
        match self {
            Self::Plain(format) => format.position_bits(),
            Self::Local(format) => format.position_bits,
        }
    }

    /// Fraction bits of a query beyond those of a photon; 0 in plain numbers.
    pub fn query_extra_bits(&self) -> u32 {
        self.format().map_or(0, |format| format.query_extra_bits)
    }

    /// Fraction bits of a query in its block. A block's edge has two to this power fine steps.
    pub fn radius_bits(&self) -> u32 {
        self.position_bits() + self.query_extra_bits()
    }

    /// The most photons that one query may be given.
    pub fn max_photons(&self) -> u64 {
        match self {
            Self::Plain(format) => format.max_photons,
            Self::Local(format) => format.max_photons,
        }
    }

    /// The format of a stored power. In plain numbers it is RGB without an exponent, rounded to nearest.
    pub fn power(&self) -> PowerFormat {
        match self {
            Self::Plain(format) => PowerFormat {
                channels: Channels::Rgb,
                mantissa_bits: format.power_bits,
                exponent: Exponent::None,
                rounding: Rounding::Nearest,
            },
            Self::Local(format) => format.power,
        }
    }

    /// Bits of a stored photon: a position in its block, its mantissas and its exponent.
    pub fn bits_per_photon(&self) -> u32 {
        Widths::of_numbers(self).bits_per_photon
    }

    /// The largest word of [`crate::Query::radius_sq`]. A radius of a photon format is at most the format's
    /// own: beyond it, photons outside the frame and clamped distances could be in range.
    pub fn largest_radius_word(&self) -> u32 {
        match self {
            // Every squared distance, in at most 32 bits.
            Self::Plain(_) => {
                u32::MAX >> u32::BITS.saturating_sub(Widths::of_numbers(self).radius_sq)
            }
            Self::Local(format) => format.largest_in_range(),
        }
    }

    /// The word [`crate::Query::radius_sq`] of a squared radius in squared fine steps. On half steps, where
    /// d^2 is the sum of half squares plus 3/4, it is one less. `None` where no photon can be in range.
    pub fn radius_word(&self, radius_sq: u32) -> Option<u32> {
        let half_steps = self.format().is_some_and(PhotonFormat::half_steps);
        radius_sq.checked_sub(half_steps.into())
    }
}

/// The numbers by kind and name, as the errors name them.
impl fmt::Display for Numbers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Plain(format) => write!(f, "{format}"),
            Self::Local(format) => write!(f, "format `{format}`"),
        }
    }
}

impl From<&PlainFormat> for Numbers {
    fn from(format: &PlainFormat) -> Self {
        Self::Plain(*format)
    }
}

impl From<PhotonFormat> for Numbers {
    fn from(format: PhotonFormat) -> Self {
        Self::Local(format)
    }
}

impl From<&PhotonFormat> for Numbers {
    fn from(format: &PhotonFormat) -> Self {
        Self::Local(*format)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_fields_outside_their_range_are_named_with_it() {
        let plain = |coordinate_bits, power_bits, max_photons| PlainFormat {
            coordinate_bits,
            power_bits,
            max_photons,
        };
        assert_eq!(plain(3, 1, 1).check(), Ok(()));
        assert_eq!(plain(17, 16, 1 << 32).check(), Ok(()));
        for (format, expected) in [
            (plain(2, 16, 1), "coordinate_bits is 2, expected 3 to 17"),
            (plain(18, 16, 1), "coordinate_bits is 18, expected 3 to 17"),
            (plain(8, 0, 1), "power_bits is 0, expected 1 to 16"),
            (plain(8, 17, 1), "power_bits is 17, expected 1 to 16"),
            (
                plain(8, 16, 0),
                "max_photons is 0, expected 1 to 4294967296",
            ),
        ] {
            let message = Numbers::Plain(format).check().unwrap_err().to_string();
            assert!(message.ends_with(expected), "{message}");
        }
    }

    #[test]
    fn the_largest_radius_holds_every_plain_distance() {
        for (coordinate_bits, bits) in [(3, 8), (8, 18), (15, 32), (17, 32)] {
            let numbers = Numbers::Plain(PlainFormat {
                coordinate_bits,
                power_bits: 16,
                max_photons: 1,
            });
            assert_eq!(numbers.largest_radius_word(), u32::MAX >> (32 - bits));
        }
    }
}
