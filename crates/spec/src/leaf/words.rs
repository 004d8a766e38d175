//! The words that a leaf machine is given, and those that it answers with.

use crate::stream::{BatchPins, Group, Query, Sums};

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

/// Words for both input streams of a leaf machine, in their order. The batches release all sets.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LeafWords {
    /// The groups of the sets.
    pub groups: Vec<Group>,
    /// The queries of the batches.
    pub queries: Vec<QueryWord>,
}

/// A result with its tag.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct TaggedSums {
    /// The sums of the query.
    pub sums: Sums,
    /// The tag of the query.
    pub tag: u32,
}

/// The results of a leaf machine, in the order in which it gave them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LeafAnswer {
    /// The results.
    pub results: Vec<TaggedSums>,
    /// Clocks from the first word that was offered to the last result that was taken.
    pub clocks: u64,
    /// Groups that the chain was given.
    pub groups_played: u64,
}
