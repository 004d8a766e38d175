//! What a photon format cannot represent: which limit, and by how much.

use photoncube_spec::FormatError;
use thiserror::Error;

/// Why a gather in a photon format is refused.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum LocalError {
    /// The format itself is not legal.
    #[error(transparent)]
    Format(#[from] FormatError),
    /// A value does not fit.
    #[error(transparent)]
    Value(#[from] ValueError),
    /// More photons than the sums are sized for.
    #[error(transparent)]
    Count(#[from] CountError),
}

/// A value does not fit its format.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "{what} is {value}, {} over the largest that format `{format}` holds, {largest}",
    .value - .largest
)]
pub struct ValueError {
    /// Which value.
    pub what: &'static str,
    /// What it is.
    pub value: u32,
    /// The largest that fits.
    pub largest: u32,
    /// The format.
    pub format: String,
}

/// A query was given more photons than the format declares.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "a query of {found} photons is {} over the {max_photons} that format `{format}` declares: \
     its sums could overflow; a smaller search radius or a format with a larger `max_photons` has room",
    .found - .max_photons
)]
pub struct CountError {
    /// The photons given.
    pub found: u64,
    /// The most that the format declares.
    pub max_photons: u64,
    /// The format.
    pub format: String,
}

/// Bits that are no packed record.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum PackError {
    /// The format itself is not legal.
    #[error(transparent)]
    Format(#[from] FormatError),
    /// Bits past the record's width are set.
    #[error("record {found:#x} does not fit the {bits_per_photon} bits of format `{format}`")]
    TooWide {
        /// The bits.
        found: u128,
        /// The width of a record.
        bits_per_photon: u32,
        /// The format.
        format: String,
    },
    /// A field holds what no photon has.
    #[error(transparent)]
    Value(#[from] ValueError),
}
