//! The number formats: the widths of a machine's words, plain numbers and photon formats, stored photons.

mod numbers;
mod photon_format;
mod photon_formats;
mod photon_record;
mod squarer;
mod widths;

pub use numbers::{Numbers, PlainFormat};
pub use photon_format::{Channels, Exponent, FormatError, PhotonFormat, PowerFormat, Rounding};
pub use photon_formats::{PHOTON_FORMATS, UnknownFormat, find_photon_format};
pub use photon_record::{PhotonBlock, PhotonRecord};
pub use squarer::Squarer;
pub use widths::Widths;
pub(crate) use widths::bits_for;
