//! What cannot be measured, and why.

use thiserror::Error;

/// Why a measure cannot be taken.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum MetricsError {
    /// No query has a reference over 0: a comparison of nothing must not pass.
    #[error("comparison: found no query with light in the reference, expected at least one")]
    NothingCompared,
    /// Two sets that belong together differ in length.
    #[error("{what}: found {found} values, expected {expected}, one for each query")]
    Length {
        /// Which set.
        what: &'static str,
        /// Its length.
        found: usize,
        /// What it should be.
        expected: usize,
    },
    /// A value that is no estimate.
    #[error("{what} of query {query}: found {found}, expected a finite number from 0 up")]
    Value {
        /// Which set.
        what: &'static str,
        /// The query's index.
        query: usize,
        /// The value.
        found: f64,
    },
    /// A spread needs two independent samples.
    #[error("independent maps: found {found}, expected at least 2")]
    TooFewMaps {
        /// Maps there are.
        found: u64,
    },
    /// The references of all maps are equal, so nothing can be told in terms of their noise.
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
