//! The errors of values that the numbers of a machine cannot represent.

use photoncube_spec::FormatError;
use thiserror::Error;

/// The reason why a gather is refused.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum GatherError {
    /// The format itself is not legal.
    #[error(transparent)]
    Format(#[from] FormatError),
    /// A value does not fit its format.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The query has more photons than the sums are sized for.
    #[error(transparent)]
    Count(#[from] CountError),
}

/// The error of a value that does not fit its format.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{what} is {value}, {} over the largest that {holder} holds, {largest}", .value - .largest)]
pub struct RangeError {
    /// The name of the value.
    pub what: &'static str,
    /// The value that does not fit.
    pub value: u32,
    /// The largest value that fits.
    pub largest: u32,
    /// The numbers, by kind and name.
    pub holder: String,
}

/// The error of a query with more photons than its numbers declare.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "a query of {found} photons is {} over the {max_photons} that {holder} declares: \
     its sums could overflow; a smaller search radius or a format with -n{} has room",
    .found - .max_photons, .found.next_power_of_two()
)]
pub struct CountError {
    /// The number of photons given.
    pub found: u64,
    /// The most photons that are declared for one query.
    pub max_photons: u64,
    /// The numbers, by kind and name.
    pub holder: String,
}

/// The error of bits that are not a packed record.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum PackError {
    /// The format itself is not legal.
    #[error(transparent)]
    Format(#[from] FormatError),
    /// Bits past the record's width are set.
    #[error("record {found:#x} does not fit the {bits_per_photon} bits of format `{format}`")]
    TooWide {
        /// The bits that were given.
        found: u128,
        /// The number of bits of a record.
        bits_per_photon: u32,
        /// The name of the format.
        format: String,
    },
    /// A field has a value that no photon has.
    #[error(transparent)]
    Range(#[from] RangeError),
}
