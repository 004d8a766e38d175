//! Photon formats: how a stored photon, a query point and their distance become integers.
//!
//! A format is relative to the search radius and to the block, and independent of the scene. Its cost in
//! accuracy depends on the number of steps in the radius; the place and size of the scene do not matter. The
//! rules below are all that a reader of a format may assume.
//!
//! # Positions
//! With p = [`PhotonFormat::position_bits`] and x = [`PhotonFormat::query_extra_bits`]:
//! - A block edge has 2^p *cells* and 2^(p+x) *fine steps*; lengths below are in fine steps.
//! - A photon is stored as the index of the cell that contains it, floor(fraction * 2^p). The index
//!   represents the middle of that cell. A fraction that rounding made exactly 1 is stored in the last cell.
//! - A query point is stored as the index of the fine cell that contains it. The index represents the middle
//!   of that cell.
//! - The search radius is R = 2^(p+x) - 2 = edge - 2, exactly. A scene's radius is never rounded:
//!   the blocks' edge is chosen so that this ratio holds.
//! - Coordinates are counted in a frame of [`crate::Numbers::FRAME_BLOCKS`] block edges. A photon of the block
//!   with offset o is shifted by o edges.
//!
//! # Distance
//! - x = 0: photon and query are both middles of equal cells, so d = query - photon is an integer; m = |d|,
//!   and the square is m^2. In range: sum of squares <= R^2.
//! - x >= 1: a photon's middle lies on a fine grid line, and a query's middle lies halfway between two lines.
//!   With d the difference of the query's index and that line, the distance is |d + 1/2| = m + 1/2, where m =
//!   d for d >= 0 and m = ~d (inversion, no increment) for d < 0. As (m + 1/2)^2 = m (m + 1) + 1/4, the *half
//!   square* m (m + 1) is summed. In range: sum + 3/4 <= R^2, which for integers is sum <= R^2 - 1. Nothing
//!   is rounded.
//! - Overflow: m is clamped to 2^(p+x) - 1 = R + 1, whose square alone is out of range, so a clamped axis
//!   gives the same decision as an unclamped one. The sum of the squares saturates at 2^(2p+2x) - 1, which is
//!   out of range too. The cells instead keep the sum in full, because their work register has the two bits
//!   more that it takes; the decision is the same.
//!
//! # Power
//! - With [`Channels::Rgb`] a photon has a mantissa for each of red, green and blue. With [`Channels::Mono`]
//!   it has one mantissa, for its strongest channel. All photons then have the map's one colour: the sum of
//!   their powers, divided by the sum's strongest channel.
//! - A channel's value is mantissa << exponent, in the map's power unit.
//! - The power unit is the largest channel of any photon in the map, divided by (2^m - 1) << E, with m the
//!   bits of a mantissa and E = [`PowerFormat::exponent_range`]. So the largest power is all ones at the
//!   largest exponent.
//! - An exponent is the smallest one from 0 to E at which the strongest channel (of the photon, or of all
//!   photons of the block) rounds to a mantissa of m bits.
//! - [`Rounding::Nearest`] rounds to nearest, ties away from zero. No format truncates, because truncation is
//!   a bias that more photons do not remove. A power that would need an exponent below 0 rounds to a multiple
//!   of the unit, perhaps 0.
//! - [`Rounding::Dithered`] gives floor(value + t), with t from 0 to 1 - 2^-16 drawn from a hash of the
//!   photon's stored position and the channel. Thus photons of equal power do not all round alike. The
//!   exponent is then the smallest at which the strongest channel itself is at most 2^m - 1, so that no t
//!   makes the mantissa overflow.
//! - Overflow: sums are sized for `max_photons` photons of full scale, see [`crate::Widths::sum`]. A
//!   query of more photons is refused.
//!
//! # Names
//! A format's name states all of its fields, and every legal name is a format:
//! `local` p [`x` x] `-` (`rgb` | `mono`) m [`e` bits | `b` bits] [`d`] [`-n` max_photons], where `e`
//! is an exponent of each photon, `b` one of each block, `d` dithered; without `-n`,
//! [`PhotonFormat::DEFAULT_MAX_PHOTONS`].

use std::fmt;

use thiserror::Error;

use super::numbers::Numbers;

/// The channels of a photon's power.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum Channels {
    /// One channel, for light of one colour.
    Mono,
    /// Red, green and blue.
    Rgb,
}

impl Channels {
    /// The channels' names in pins and reports, in the order of the photon's words.
    pub fn names(self) -> &'static [&'static str] {
        match self {
            Self::Mono => &["power"],
            Self::Rgb => &["red", "green", "blue"],
        }
    }

    /// The number of channels.
    pub fn count(self) -> u32 {
        self.names().len() as u32
    }
}

/// The owner of a power's exponent.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum Exponent {
    /// No exponent: one scale for the whole map.
    None,
    /// Each block has an exponent, which takes no bits of a photon's record.
    Block {
        /// Bits of a block's exponent.
        bits: u32,
    },
    /// Each photon has an exponent, shared by its channels, as in RGBE8 or RGB9E5.
    Photon {
        /// Bits of a photon's exponent.
        bits: u32,
    },
}

impl Exponent {
    /// Bits of the exponent; 0 where there is none.
    pub fn bits(self) -> u32 {
        match self {
            Self::None => 0,
            Self::Block { bits } | Self::Photon { bits } => bits,
        }
    }
}

/// The rounding of a power to a mantissa.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum Rounding {
    /// To nearest, ties away from zero.
    Nearest,
    /// Up or down by a pseudo-random threshold, so that the mean equals the value.
    Dithered,
}

/// The format of a stored power.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub struct PowerFormat {
    /// The channels that are stored.
    pub channels: Channels,
    /// Bits of a mantissa, 1 to 16.
    pub mantissa_bits: u32,
    /// The owner of the exponent; 1 to 8 bits where there is one.
    pub exponent: Exponent,
    /// The rounding of a mantissa.
    pub rounding: Rounding,
}

impl PowerFormat {
    /// The largest exponent that is used. 2^24 is over 1e7, so a photon of a millionth of the map's largest
    /// power keeps a full mantissa. RGBE8 could hold a larger exponent, and no photon would ever use it.
    const LARGEST_EXPONENT: u32 = 24;

    /// The largest exponent that is used: the largest that its bits hold, but at most 24.
    pub fn exponent_range(self) -> u32 {
        ((1 << self.exponent.bits().min(8)) - 1).min(Self::LARGEST_EXPONENT)
    }

    /// The largest decoded power: a mantissa of all ones at the largest exponent.
    pub fn full_scale(self) -> u128 {
        ((1 << self.mantissa_bits) - 1) << self.exponent_range()
    }

    /// Bits of the exponent in a photon's record; 0 where the exponent belongs to the block.
    pub fn record_exponent_bits(self) -> u32 {
        match self.exponent {
            Exponent::Photon { bits } => bits,
            Exponent::None | Exponent::Block { .. } => 0,
        }
    }
}

/// A photon format. The module's documentation defines the meaning of its fields.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub struct PhotonFormat {
    /// Fraction bits of a photon's position in its block, 4 to 12.
    pub position_bits: u32,
    /// Further fraction bits of a query point, 0 to 2.
    pub query_extra_bits: u32,
    /// The format of a stored power.
    pub power: PowerFormat,
    /// The most photons that one query may be given, 1 to 2^32; the sums are sized for it.
    pub max_photons: u64,
}

/// The error of [`PhotonFormat::check`] and [`crate::PlainFormat::check`]: a field is outside its legal range.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{numbers}: {field} is {found}, expected {min} to {max}")]
pub struct FormatError {
    /// The format, by kind and name.
    pub numbers: String,
    /// The name of the field that is out of range.
    pub field: &'static str,
    /// The field's value.
    pub found: u64,
    /// The smallest legal value.
    pub min: u64,
    /// The largest legal value.
    pub max: u64,
}

impl FormatError {
    /// The error of the first of these fields that is outside its range. A row is a field's name, its value,
    /// its smallest and its largest legal value.
    pub(super) fn check(
        numbers: impl Into<Numbers>,
        rows: &[(&'static str, u64, u64, u64)],
    ) -> Result<(), Self> {
        let outside = |&&(_, found, min, max): &&(_, u64, u64, u64)| found < min || found > max;
        match rows.iter().find(outside) {
            None => Ok(()),
            Some(&(field, found, min, max)) => Err(Self {
                numbers: numbers.into().to_string(),
                field,
                found,
                min,
                max,
            }),
        }
    }
}

impl PhotonFormat {
    /// The default of [`Self::max_photons`]: four times the quarter million photons in one block of the hard
    /// cases.
    pub const DEFAULT_MAX_PHOTONS: u64 = 1 << 20;

    /// The format's name, which states all of its fields.
    pub fn name(&self) -> String {
        self.to_string()
    }

    /// A description of the format in one line.
    pub fn summary(&self) -> String {
        let PowerFormat {
            channels,
            mantissa_bits,
            exponent,
            rounding,
        } = self.power;
        let queries = ["", ", queries on half steps", ", queries on quarter steps"];
        let exponent = match exponent {
            Exponent::None => String::new(),
            Exponent::Block { .. } => ", a block's exponent".to_owned(),
            Exponent::Photon { bits } => format!(", {bits}-bit exponent"),
        };
        let words = match channels {
            Channels::Mono => "one channel of",
            Channels::Rgb => "RGB of",
        };
        let rounding = match rounding {
            Rounding::Nearest => "",
            Rounding::Dithered => ", dithered",
        };
        format!(
            "{} bits per axis{}, {words} {mantissa_bits} bits{exponent}{rounding}",
            self.position_bits,
            queries.get(self.query_extra_bits as usize).unwrap_or(&""),
        )
    }

    /// The bits that |A-B| is clamped to: p + x.
    pub fn radius_bits(&self) -> u32 {
        self.position_bits + self.query_extra_bits
    }

    /// The search radius R in fine steps.
    pub fn radius_steps(&self) -> u32 {
        self.edge_steps() - 2
    }

    /// A block's edge in fine steps.
    pub fn edge_steps(&self) -> u32 {
        1 << self.radius_bits()
    }

    /// Whether query points lie halfway between the photons' grid lines, so that half squares are summed.
    pub fn half_steps(&self) -> bool {
        self.query_extra_bits > 0
    }

    /// The largest sum of squares, or of half squares, of a photon in range: the word of the search radius.
    pub fn largest_in_range(&self) -> u32 {
        let word = Numbers::from(self).radius_word(self.radius_steps().pow(2));
        word.unwrap_or(0)
    }

    /// Checks every field against its documented range.
    ///
    /// # Errors
    /// The first field outside its range, with the range.
    pub fn check(&self) -> Result<(), FormatError> {
        let PowerFormat {
            mantissa_bits,
            exponent,
            ..
        } = self.power;
        let least_exponent = u64::from(exponent != Exponent::None);
        let rows = [
            ("position_bits", self.position_bits.into(), 4, 12),
            ("query_extra_bits", self.query_extra_bits.into(), 0, 2),
            ("mantissa_bits", mantissa_bits.into(), 1, 16),
            ("exponent_bits", exponent.bits().into(), least_exponent, 8),
            ("max_photons", self.max_photons, 1, 1 << 32),
        ];
        FormatError::check(self, &rows)
    }
}

impl fmt::Display for PhotonFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let PowerFormat {
            channels,
            mantissa_bits,
            exponent,
            rounding,
        } = self.power;
        write!(f, "local{}", self.position_bits)?;
        if self.query_extra_bits > 0 {
            write!(f, "x{}", self.query_extra_bits)?;
        }
        let word = match channels {
            Channels::Mono => "mono",
            Channels::Rgb => "rgb",
        };
        write!(f, "-{word}{mantissa_bits}")?;
        match exponent {
            Exponent::None => {}
            Exponent::Block { bits } => write!(f, "b{bits}")?,
            Exponent::Photon { bits } => write!(f, "e{bits}")?,
        }
        if rounding == Rounding::Dithered {
            f.write_str("d")?;
        }
        if self.max_photons != Self::DEFAULT_MAX_PHOTONS {
            write!(f, "-n{}", self.max_photons)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{PHOTON_FORMATS, find_photon_format};

    #[test]
    fn every_named_format_is_legal_and_found_by_its_name() {
        for format in PHOTON_FORMATS {
            assert_eq!(format.check(), Ok(()));
            assert_eq!(find_photon_format(&format.name()), Ok(*format));
        }
    }

    #[test]
    fn a_clamped_axis_is_out_of_range_and_the_edge_holds_the_radius() {
        for format in PHOTON_FORMATS {
            let (radius, clamp) = (format.radius_steps(), (1 << format.radius_bits()) - 1);
            assert_eq!(clamp, radius + 1);
            assert!(format.edge_steps() >= radius);
            let half_square = clamp * (clamp + u32::from(format.half_steps()));
            assert!(half_square > format.largest_in_range());
        }
    }

    #[test]
    fn an_exponent_uses_its_bits_up_to_what_light_needs() {
        let range = |name| find_photon_format(name).unwrap().power.exponent_range();
        for (name, expected) in [
            ("local8-rgb8", 0),
            ("local8-rgb8e2", 3),
            ("local8-rgb8b4", 15),
            ("local8-rgb8e5", 24),
            ("local8-rgb8e8", 24),
        ] {
            assert_eq!(range(name), expected, "{name}");
        }
    }

    #[test]
    fn fields_outside_their_range_are_named_with_it() {
        let format = PHOTON_FORMATS[0];
        let power = format.power;
        let with = |power| PhotonFormat { power, ..format };
        let exponent = |bits| {
            with(PowerFormat {
                exponent: Exponent::Photon { bits },
                ..power
            })
        };
        let mantissa = |mantissa_bits| {
            with(PowerFormat {
                mantissa_bits,
                ..power
            })
        };
        #[rustfmt::skip]
        let wrong = [
            (PhotonFormat { position_bits: 3, ..format }, "position_bits is 3, expected 4 to 12"),
            (PhotonFormat { position_bits: 13, ..format }, "position_bits is 13, expected 4 to 12"),
            (PhotonFormat { query_extra_bits: 3, ..format }, "query_extra_bits is 3, expected 0 to 2"),
            (mantissa(17), "mantissa_bits is 17, expected 1 to 16"),
            (exponent(9), "exponent_bits is 9, expected 1 to 8"),
            (exponent(0), "exponent_bits is 0, expected 1 to 8"),
            (PhotonFormat { max_photons: 0, ..format }, "max_photons is 0, expected 1 to 4294967296"),
        ];
        for (format, expected) in wrong {
            let message = format.check().unwrap_err().to_string();
            assert!(message.ends_with(expected), "{message}");
        }
    }
}
