//! The number formats: the widths of a machine's words, the photon formats and their records.

mod format;
mod format_widths;
mod photon_format;
mod photon_formats;
mod photon_record;

pub(crate) use format::bits_for;
pub use format::{Squarer, Widths};
pub use format_widths::FormatWidths;
pub use photon_format::{Channels, Exponent, FormatError, PhotonFormat, PowerFormat, Rounding};
pub use photon_formats::{PHOTON_FORMATS, UnknownFormat, find_photon_format};
pub use photon_record::{LocalQuery, LocalSums, PhotonBlock, PhotonRecord};
