//! The number formats: the widths of a machine's words, plain numbers and photon formats, stored photons.

mod format;
mod format_widths;
mod numbers;
mod photon_format;
mod photon_formats;
mod photon_record;

pub(crate) use format::bits_for;
pub use format::{Squarer, Widths};
pub use format_widths::FormatWidths;
pub use numbers::{Numbers, PlainFormat};
pub use photon_format::{Channels, Exponent, FormatError, PhotonFormat, PowerFormat, Rounding};
pub use photon_formats::{PHOTON_FORMATS, UnknownFormat, find_photon_format};
pub use photon_record::{PhotonBlock, PhotonRecord};
