//! The table of listed photon formats, and the search for a format by its name.

use thiserror::Error;

use super::photon_format::{Channels, Exponent, FormatError, PhotonFormat, PowerFormat, Rounding};
use crate::nearest::did_you_mean;

/// A row of the table: p and x, then RGB rounded to nearest.
const fn row(
    position_bits: u32,
    query_extra_bits: u32,
    mantissa_bits: u32,
    exponent: Exponent,
) -> PhotonFormat {
    PhotonFormat {
        position_bits,
        query_extra_bits,
        power: PowerFormat {
            channels: Channels::Rgb,
            mantissa_bits,
            exponent,
            rounding: Rounding::Nearest,
        },
        max_photons: PhotonFormat::DEFAULT_MAX_PHOTONS,
    }
}

const fn own(bits: u32) -> Exponent {
    Exponent::Photon { bits }
}

/// The exponent of a block in the listed formats: as large as an exponent that a photon could use.
const BLOCK: Exponent = Exponent::Block { bits: 5 };

/// The listed formats; the first is the default. `local8-rgb9e5` is RGB9E5 (EXT_texture_shared_exponent). The
/// default is RGBE8 (Ward, "Real pixels", Graphics Gems II, 1991) restricted to the exponents that light uses. Its
/// records lack three bits that would always be 0. RGBE8 itself, `local8-rgb8e8`, is legal and not listed: its
/// estimates equal those of the default, digit for digit, with three more bits.
pub const PHOTON_FORMATS: &[PhotonFormat] = &[
    row(8, 0, 8, own(5)),
    row(8, 0, 9, own(5)),
    row(4, 0, 8, own(5)),
    row(6, 0, 8, own(5)),
    row(7, 0, 8, own(5)),
    row(10, 0, 8, own(5)),
    row(12, 0, 8, own(5)),
    row(8, 0, 8, BLOCK),
    row(8, 0, 10, BLOCK),
    row(8, 0, 12, BLOCK),
    row(8, 0, 16, BLOCK),
    row(7, 1, 8, own(5)),
    row(6, 2, 8, own(5)),
    row(7, 1, 6, own(5)),
    row(7, 1, 5, own(5)),
    row(6, 2, 6, own(5)),
    row(7, 1, 8, BLOCK),
    row(7, 1, 6, BLOCK),
    row(6, 2, 8, BLOCK),
];

/// The error of [`find_photon_format`].
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum UnknownFormat {
    /// The name does not follow the syntax of format names.
    #[error(
        "there is no format `{found}`{meant}; expected local P [x X] - (rgb | mono) M [e BITS | b BITS] [d] \
         [-n PHOTONS] without spaces, such as {examples}"
    )]
    Name {
        /// The name that was given.
        found: String,
        /// A hint with the nearest listed format, made by [`did_you_mean`]; empty where none is near.
        meant: String,
        /// Examples of format names.
        examples: String,
    },
    /// The name follows the syntax, but a field is outside its range.
    #[error(transparent)]
    Illegal(#[from] FormatError),
}

/// Finds the format of a name. The format need not be listed.
///
/// # Errors
/// The name does not follow the syntax of format names, or a field is outside its range.
pub fn find_photon_format(name: &str) -> Result<PhotonFormat, UnknownFormat> {
    let format = parse(name).ok_or_else(|| UnknownFormat::Name {
        found: name.to_owned(),
        meant: meant(name),
        examples: PHOTON_FORMATS[..3]
            .iter()
            .map(PhotonFormat::name)
            .collect::<Vec<_>>()
            .join(", "),
    })?;
    format.check()?;
    Ok(format)
}

/// A hint for a name that begins as a format name does. Other names get no hint, because listed names are too
/// alike.
fn meant(name: &str) -> String {
    let listed: Vec<_> = PHOTON_FORMATS.iter().map(PhotonFormat::name).collect();
    let known = listed.iter().map(String::as_str);
    match name.to_lowercase().starts_with("local") {
        true => did_you_mean(name, known),
        false => String::new(),
    }
}

fn parse(name: &str) -> Option<PhotonFormat> {
    let rest = name.strip_prefix("local")?;
    let (position, rest) = rest.split_once('-')?;
    let (power, max_photons) = match rest.split_once("-n") {
        Some((power, count)) => (power, number(count)?),
        None => (rest, PhotonFormat::DEFAULT_MAX_PHOTONS),
    };
    let (position_bits, query_extra_bits) = match position.split_once('x') {
        Some((position, extra)) => (number(position)?, number(extra)?),
        None => (number(position)?, 0),
    };
    let format = PhotonFormat {
        position_bits,
        query_extra_bits,
        power: parse_power(power)?,
        max_photons,
    };
    // Each format has one name: `local08x0-rgb8e0` is refused.
    (format.name() == name).then_some(format)
}

fn parse_power(text: &str) -> Option<PowerFormat> {
    let (text, rounding) = match text.strip_suffix('d') {
        Some(rest) => (rest, Rounding::Dithered),
        None => (text, Rounding::Nearest),
    };
    let (channels, text) = match text.strip_prefix("rgb") {
        Some(rest) => (Channels::Rgb, rest),
        None => (Channels::Mono, text.strip_prefix("mono")?),
    };
    let (mantissa, exponent) = if let Some((mantissa, bits)) = text.split_once('e') {
        (
            mantissa,
            Exponent::Photon {
                bits: number(bits)?,
            },
        )
    } else if let Some((mantissa, bits)) = text.split_once('b') {
        (
            mantissa,
            Exponent::Block {
                bits: number(bits)?,
            },
        )
    } else {
        (text, Exponent::None)
    };
    Some(PowerFormat {
        channels,
        mantissa_bits: number(mantissa)?,
        exponent,
        rounding,
    })
}

fn number<T: std::str::FromStr>(text: &str) -> Option<T> {
    text.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_says_all_of_a_format() {
        let format = find_photon_format("local6x2-mono5b3d-n4096").unwrap();
        let expected = PhotonFormat {
            position_bits: 6,
            query_extra_bits: 2,
            power: PowerFormat {
                channels: Channels::Mono,
                mantissa_bits: 5,
                exponent: Exponent::Block { bits: 3 },
                rounding: Rounding::Dithered,
            },
            max_photons: 4096,
        };
        assert_eq!(format, expected);
        assert_eq!(format.name(), "local6x2-mono5b3d-n4096");
        assert_eq!(
            format.summary(),
            "6 bits per axis, queries on quarter steps, one channel of 5 bits, a block's exponent, dithered"
        );
    }

    #[test]
    fn a_name_that_says_nothing_is_refused_with_what_one_is() {
        for name in [
            "",
            "local",
            "local8",
            "rgb8",
            "local8-rgb",
            "local8-cmyk8",
            "local08-rgb8",
            "local8x0-rgb8",
            "local8-rgb8-n1048576",
        ] {
            let message = find_photon_format(name).unwrap_err().to_string();
            assert!(
                message.contains(&format!("`{name}`")) && message.contains("local8-rgb8e5, "),
                "{message}"
            );
        }
        let message = find_photon_format("local3-rgb8e5").unwrap_err().to_string();
        assert!(
            message.ends_with("position_bits is 3, expected 4 to 12"),
            "{message}"
        );
        let message = find_photon_format("local8-rgb8e0").unwrap_err().to_string();
        assert!(
            message.ends_with("exponent_bits is 0, expected 1 to 8"),
            "{message}"
        );
    }

    #[test]
    fn no_format_is_listed_twice() {
        for (index, format) in PHOTON_FORMATS.iter().enumerate() {
            assert!(!PHOTON_FORMATS[..index].contains(format), "{format}");
        }
    }
}
