//! Packs records into bits, in the order that the module of [`photoncube_spec::PhotonRecord`] states.

use photoncube_spec::{Channels, PhotonFormat, PhotonRecord, Widths};

use super::error::{GatherError, PackError};
use super::range::Limits;

/// Packs a record into the lowest [`Widths::bits_per_photon`] bits; the other bits are 0.
///
/// # Errors
/// A value does not fit the format.
pub fn pack(format: &PhotonFormat, record: &PhotonRecord) -> Result<u128, GatherError> {
    Limits::of(&format.into())?.check_record(record)?;
    let mut bits = 0;
    let mut place = 0;
    for (value, width) in values(record).into_iter().zip(field_widths(format)) {
        bits |= u128::from(value) << place;
        place += width;
    }
    Ok(bits)
}

/// Unpacks the bits of a record that [`pack`] made.
///
/// # Errors
/// Bits past the record's width are set, or a field exceeds its limit, such as an exponent over
/// [`photoncube_spec::PowerFormat::exponent_range`].
pub fn unpack(format: &PhotonFormat, bits: u128) -> Result<PhotonRecord, PackError> {
    let limits = Limits::of(&format.into())?;
    let width = Widths::of_format(format).bits_per_photon;
    if bits >> width != 0 {
        return Err(PackError::TooWide {
            found: bits,
            bits_per_photon: width,
            format: format.name(),
        });
    }
    let mut rest = bits;
    let [x, y, z, red, green, blue, exponent] = field_widths(format).map(|width| {
        let field = rest & ((1 << width) - 1);
        rest >>= width;
        field as u16
    });
    let record = PhotonRecord {
        position: [x, y, z],
        mantissa: [red, green, blue],
        exponent: exponent as u8,
    };
    limits.check_record(&record)?;
    Ok(record)
}

fn values(record: &PhotonRecord) -> [u16; 7] {
    let [x, y, z] = record.position;
    let [red, green, blue] = record.mantissa;
    [x, y, z, red, green, blue, record.exponent.into()]
}

fn field_widths(format: &PhotonFormat) -> [u32; 7] {
    let widths = Widths::of_format(format);
    let (p, m) = (widths.position, widths.mantissa);
    let rest = match format.power.channels {
        Channels::Rgb => m,
        Channels::Mono => 0,
    };
    [p, p, p, m, rest, rest, widths.record_exponent]
}
