//! The errors of measures that cannot be taken.

use thiserror::Error;

/// The reason why a measure cannot be taken.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum MetricsError {
    /// No query has a reference over 0. A comparison of nothing is an error.
    #[error("comparison: found no query with light in the reference, expected at least one")]
    NothingCompared,
    /// Two sets that must have equal lengths differ.
    #[error("{what}: found {found} values, expected {expected}, one for each query")]
    Length {
        /// The name of the set.
        what: &'static str,
        /// The length of the set.
        found: usize,
        /// The expected length.
        expected: usize,
    },
    /// A value is negative or not finite.
    #[error("{what} of query {query}: found {found}, expected a finite number from 0 up")]
    Value {
        /// The name of the set.
        what: &'static str,
        /// The query's index.
        query: usize,
        /// The value that was found.
        found: f64,
    },
    /// A spread needs two independent samples.
    #[error("independent maps: found {found}, expected at least 2")]
    TooFewMaps {
        /// The number of maps.
        found: u64,
    },
    /// The references of all maps are equal, so there is no noise to compare with.
    #[error("noise: found none between the maps, expected some: were they traced with one seed?")]
    NoNoise,
    /// No photon is in range of any query in the reference.
    #[error("misclassified photons: found no photon in range of a query, expected at least one")]
    NothingInRange,
}

/// # Errors
/// [`MetricsError::Length`] or [`MetricsError::Value`].
pub(super) fn check(
    what: &'static str,
    values: &[f64],
    expected: usize,
) -> Result<(), MetricsError> {
    let found = values.len();
    if found != expected {
        return Err(MetricsError::Length {
            what,
            found,
            expected,
        });
    }
    let bad = |value: &f64| !(value.is_finite() && *value >= 0.0);
    match values.iter().position(bad) {
        None => Ok(()),
        Some(query) => Err(MetricsError::Value {
            what,
            query,
            found: values[query],
        }),
    }
}
