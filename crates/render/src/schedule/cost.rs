//! What a schedule costs: photon tests and clocks.

use photoncube_spec::Leaf;
use rayon::prelude::*;
use serde::Serialize;

use super::leaves::GROUP;
use super::{Batch, Batches, Bounds, Cull, Leaves};
use crate::quantise::QuantisedMap;

/// The cost of all batches of a picture.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct Cost {
    /// Queries of the picture.
    pub queries: u64,
    /// Batches of these queries.
    pub batches: u64,
    /// Leaves of the blocks around the batches, whose groups' boxes are compared.
    pub leaves_compared: u64,
    /// Groups whose box is within the radius of their batch, and which are read.
    pub groups_read: u64,
    /// Photon tests: each place of a group that is read, in each engine of the chain, whether it holds a query or not.
    pub photon_tests: u64,
    /// Clocks of one chain for all batches: for each the longer of comparing the leaves, two a clock, and of reading
    /// the groups that are near, one a clock.
    #[serde(rename = "chain_clocks")]
    pub clocks: u64,
    /// The clocks in which photons are read.
    pub reading_clocks: u64,
}

impl Cost {
    fn plus(self, other: Self) -> Self {
        Self {
            queries: self.queries + other.queries,
            batches: self.batches + other.batches,
            leaves_compared: self.leaves_compared + other.leaves_compared,
            groups_read: self.groups_read + other.groups_read,
            photon_tests: self.photon_tests + other.photon_tests,
            clocks: self.clocks + other.clocks,
            reading_clocks: self.reading_clocks + other.reading_clocks,
        }
    }
}

/// The cost of batches that are tested against the leaves of a map.
///
/// # Panics
/// For a map in plain numbers.
pub fn cost(map: &QuantisedMap<'_>, leaves: &Leaves, batches: &Batches, cull: Cull) -> Cost {
    let format = map.numbers().format().expect("the map has a photon format");
    let radius = i64::from(2 * format.radius_steps());
    let one = |batch: &Batch| {
        let runs = runs(map, batches, batch);
        let compared = runs.iter().flat_map(|run| leaves.of_run(*run));
        let (mut all, mut read) = (0_u64, 0_u64);
        for leaf in compared {
            all += 1;
            let groups = leaf.groups.iter();
            let is_read = |group: &&Bounds| cull.reads(**group, batch.bounds, radius);
            read += groups.filter(is_read).count() as u64;
        }
        Cost {
            queries: batch.queries.len() as u64,
            batches: 1,
            leaves_compared: all,
            groups_read: read,
            photon_tests: read * GROUP as u64 * u64::from(batches.size),
            clocks: read.max(all.div_ceil(Leaf::PAIR as u64)),
            reading_clocks: read,
        }
    };
    let costs = batches.batches.par_iter().map(one);
    costs.reduce(Cost::default, Cost::plus)
}

/// The runs that some query of a batch gathers, each once.
fn runs(map: &QuantisedMap<'_>, batches: &Batches, batch: &Batch) -> Vec<usize> {
    let queries = &batches.queries[batch.queries.clone()];
    let mut runs = Vec::new();
    let mut known = None;
    for query in queries {
        let key = (map.map().place(query.position).0, query.front());
        // Neighbours in the order are mostly in one block of one surface.
        if known != Some(key) {
            known = Some(key);
            let found = map.map().candidates(query.position, query.front());
            runs.extend(found.map(|run| run.run));
        }
    }
    runs.sort_unstable();
    runs.dedup();
    runs
}
