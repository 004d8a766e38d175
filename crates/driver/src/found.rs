//! What cores found of the queries of a picture.

use std::collections::HashMap;

use photoncube_model::Gathered;
use photoncube_spec::Sums;

use crate::frames::{Set, SetBatch};

/// What was found of a query.
#[derive(Copy, Clone, Debug, Default)]
pub(crate) struct Found {
    pub(crate) sums: Sums,
    /// The radius of its result, where it has only one.
    pub(crate) radius_sq: u32,
    /// The results: one for each set that it gathers from.
    pub(crate) results: u32,
    /// It would gather from several sets, and so was not asked.
    pub(crate) is_split: bool,
}

impl Found {
    /// As the renderer has it.
    pub(crate) fn gathered(&self) -> Gathered {
        Gathered {
            sums: self.sums,
            photons: self.sums.count,
            tests: self.sums.count,
        }
    }

    /// Adds another result.
    pub(crate) fn add(&mut self, more: &Self) {
        add(&mut self.sums, more.sums);
        self.radius_sq = self.radius_sq.max(more.radius_sq);
        self.results += more.results;
        self.is_split |= more.is_split;
    }
}

/// Takes out the batches that gather from several sets of a frame.
pub(crate) fn take_split(sets: &mut Vec<Set>, found: &mut [Found]) {
    let mut sets_of_query: HashMap<usize, u32> = HashMap::new();
    let queries = |sets: &[Set]| -> Vec<usize> {
        let batches = sets.iter().flat_map(|set| &set.batches);
        let queries = batches.flat_map(|batch| &batch.queries);
        queries.map(|query| query.index).collect()
    };
    for query in queries(sets) {
        *sets_of_query.entry(query).or_default() += 1;
    }
    for (&query, &sets) in &sets_of_query {
        found[query].is_split = sets > 1;
    }
    for set in &mut *sets {
        let is_whole = |batch: &SetBatch| {
            batch
                .queries
                .iter()
                .all(|query| !found[query.index].is_split)
        };
        set.batches.retain(is_whole);
    }
    sets.retain(|set| !set.batches.is_empty());
}

fn add(all: &mut Sums, more: Sums) {
    for (all, more) in all.power.iter_mut().zip(more.power) {
        *all += more;
    }
    all.count += more.count;
}
