//! What a schedule costs: photon tests and clocks.

use rayon::prelude::*;
use serde::Serialize;

use super::{Batch, Batches, Cull, Leaves};
use crate::quantise::QuantisedMap;

/// Photons that a chain is given in a clock.
const LANES: u64 = 4;

/// The cost of all batches of a picture.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct Cost {
    /// Queries of the picture.
    pub queries: u64,
    /// Batches of these queries.
    pub batches: u64,
    /// Leaves of the blocks around the batches, whose boxes are compared.
    pub leaves_compared: u64,
    /// Leaves that are within the radius of their batch, and are read.
    pub leaves_read: u64,
    /// Photon tests: each place of a leaf that is read, in each engine of the chain, whether it holds a query or not.
    pub photon_tests: u64,
    /// Clocks of one chain for all batches: for each the longer of comparing the leaves, one a clock, and of reading
    /// those that are near, four photons a clock.
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
            leaves_read: self.leaves_read + other.leaves_read,
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
            read += u64::from(cull.reads(leaf.bounds, batch.bounds, radius));
        }
        let size = u64::from(leaves.size());
        let reading = read * size.div_ceil(LANES);
        Cost {
            queries: batch.queries.len() as u64,
            batches: 1,
            leaves_compared: all,
            leaves_read: read,
            photon_tests: read * size * u64::from(batches.size),
            clocks: reading.max(all),
            reading_clocks: reading,
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
