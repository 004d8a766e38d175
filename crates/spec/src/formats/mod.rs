//! The number formats: the widths of a machine's words, the photon formats and their records.

mod photon_format;
mod photon_formats;
mod photon_record;
mod squarer;
mod widths;

pub use photon_format::{Channels, Exponent, FormatError, PhotonFormat, PowerFormat, Rounding};
pub use photon_formats::{PHOTON_FORMATS, UnknownFormat, find_photon_format};
pub use photon_record::{LocalQuery, LocalSums, PhotonBlock, PhotonRecord};
pub use squarer::Squarer;
pub use widths::Widths;
pub(crate) use widths::bits_for;
