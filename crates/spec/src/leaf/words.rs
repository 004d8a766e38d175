//! The words that a leaf machine is given.

use crate::stream::{BatchPins, Query};

/// A word of the query stream.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct QueryWord {
    /// The query point.
    pub query: Query,
    /// The query's batch is the last on its set.
    pub release: bool,
    /// The batch and the tag of the query.
    pub batch: BatchPins,
}
