//! Gathers many queries at once with the fast gather; a lookup serves all queries near each other.

use photoncube_model::{
    GatherError, Gathered, INDEX_MASK, Instructions, PhotonPlanes, PlacedQuery,
};
use rayon::prelude::*;

use crate::geometry::morton;
use crate::photon_map::PhotonMap;
use crate::quantise::QuantisedMap;
use crate::view::{Front, QueryPoint};

/// The queries that one task of the thread pool gathers. They cover many blocks, and their results fit the
/// caches.
const TASK_QUERIES: usize = 1024;

impl QuantisedMap<'_> {
    /// Gathers the sums of all queries with a search radius of `radius_sq` squared fine steps, in their order.
    /// They equal those of [`Self::gather_within`], bit for bit.
    ///
    /// In a photon format, consecutive queries in one cube of blocks, on surfaces that face alike, share the
    /// lookup of the photons around them: see [`PhotonMap::sort_queries`].
    ///
    /// # Errors
    /// As for [`Self::gather_within`], for one of the queries.
    pub fn gather_all(
        &self,
        queries: &[QueryPoint],
        radius_sq: u32,
    ) -> Result<Vec<Gathered>, GatherError> {
        self.gather_all_by(Instructions::fastest(), queries, radius_sq)
    }

    /// Gathers as [`Self::gather_all`] does, with the given instruction set.
    ///
    /// # Errors
    /// As for [`Self::gather_all`].
    pub fn gather_all_by(
        &self,
        instructions: Instructions,
        queries: &[QueryPoint],
        radius_sq: u32,
    ) -> Result<Vec<Gathered>, GatherError> {
        let mut found = vec![Gathered::default(); queries.len()];
        let tasks = queries.par_chunks(TASK_QUERIES);
        let tasks = tasks.zip(found.par_chunks_mut(TASK_QUERIES));
        match (self.planes(), self.numbers().radius_word(radius_sq)) {
            (Some(planes), Some(word)) => tasks.try_for_each(|(queries, found)| {
                self.gather_task(planes, instructions, queries, word, found)
            }),
            _ => tasks.try_for_each(|(queries, found)| {
                let mut places = queries.iter().zip(found);
                places.try_for_each(|(query, found)| {
                    *found = self.gather_one(query, radius_sq)?;
                    Ok(())
                })
            }),
        }?;
        Ok(found)
    }

    /// Gathers the sums of one query by the plain gather, which tests every photon.
    ///
    /// # Errors
    /// As for [`Self::gather_within`].
    pub(super) fn gather_one(
        &self,
        query: &QueryPoint,
        radius_sq: u32,
    ) -> Result<Gathered, GatherError> {
        let blocks = self.blocks(query.position, query.front());
        let photons = blocks.map(|block| block.photons.len() as u64).sum();
        Ok(Gathered {
            sums: self.gather_within(query.position, query.front(), radius_sq)?,
            photons,
            tests: photons,
        })
    }

    fn gather_task(
        &self,
        planes: &PhotonPlanes,
        instructions: Instructions,
        queries: &[QueryPoint],
        radius_word: u32,
        found: &mut [Gathered],
    ) -> Result<(), GatherError> {
        let mut fronts = Fronts::new(self.map());
        let bits = self.numbers().radius_bits();
        let placed: Vec<_> = queries
            .iter()
            .map(|query| {
                let steps = self.map().steps(query.position, bits);
                PlacedQuery {
                    // Blocks further out have no photons around them.
                    block: steps.map(|at| (at >> bits).clamp(-2, OUTSIDE) as i32),
                    fraction: steps.map(|at| (at & ((1 << bits) - 1)) as u16),
                    facing: fronts.number(query.front()),
                }
            })
            .collect();
        let faces = |front, group| fronts.gather(front, group);
        planes.gather(instructions, radius_word, &placed, faces, found)
    }
}

/// A block that is not next to any of the grid.
const OUTSIDE: i64 = INDEX_MASK as i64 + 2;

/// The fronts that queries are on, numbered, and the groups of photons that count there.
struct Fronts<'a> {
    map: &'a PhotonMap,
    fronts: Vec<Front>,
}

impl<'a> Fronts<'a> {
    fn new(map: &'a PhotonMap) -> Self {
        Self {
            map,
            fronts: Vec::new(),
        }
    }

    /// The number of a query's front. Consecutive queries on one front have one number.
    fn number(&mut self, front: Front) -> u32 {
        if self.fronts.last() != Some(&front) {
            self.fronts.push(front);
        }
        self.fronts.len() as u32 - 1
    }

    /// Whether queries on the front of that number gather a group.
    fn gather(&self, front: u32, group: u32) -> bool {
        self.map.gathers(group, &self.fronts[front as usize])
    }
}

impl PhotonMap {
    /// Sorts queries so that those of one block and front are consecutive, and blocks follow a Morton
    /// curve. Photons are then still in the caches when the next queries need them.
    pub fn sort_queries(&self, queries: &mut [QueryPoint]) {
        queries.sort_by_cached_key(|query| self.sort_key(query));
    }

    /// The sort key of that order.
    pub(crate) fn sort_key(&self, query: &QueryPoint) -> (u64, ([u64; 3], Option<u32>)) {
        // Blocks outside the grid hold no photons to share.
        let block = self.place(query.position).0.to_array();
        (morton(block.map(|index| index as u64)), query.front().key())
    }
}
