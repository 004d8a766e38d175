//! A forecast of the clocks that a core takes.
//!
//! A batch takes the longer of two: comparing the boxes of all leaves of its set, [`Leaf::PAIR`] a clock, and playing the leaves
//! that are wanted, a group a clock. A set takes the longer of its batches and of reading in the next set of equal size, a
//! group a clock. The stream of photons has a leaf a clock for all chains.

use photoncube_render::{Bounds, Cull, QuantisedMap, QueryPoint};
use photoncube_spec::{Core, Leaf, LeafSizes, PhotonFormat};

use crate::frames::{FramePlan, PhotonLeaf, Set, SetBatch};

/// Clocks between two batches of a chain beside those of its work, about.
const BATCH_CLOCKS: u64 = 4;

/// A forecast for a picture.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Forecast {
    /// Queries of the picture.
    pub queries: u64,
    /// Clocks until the last result.
    pub clocks: u64,
}

impl Forecast {
    /// Forecasts the queries of a picture on a core whose chains are all busy until the end.
    ///
    /// # Panics
    /// Where the map has not the numbers of the core's machine.
    pub fn of(core: &Core, map: &QuantisedMap<'_>, queries: &[QueryPoint]) -> Self {
        let plan = FramePlan::new(map, core, queries);
        let forecaster = Forecaster::new(core);
        let mut load = Load::new(1);
        for frame in plan.frames() {
            for set in plan.sets(frame) {
                load.add(0, &set, forecaster.batches(&set).iter().sum());
            }
        }
        Self {
            queries: queries.len() as u64,
            clocks: load.clocks().div_ceil(core.chains.into()).max(load.leaves),
        }
    }

    /// Queries for each clock.
    pub fn queries_per_clock(&self) -> f64 {
        self.queries as f64 / self.clocks.max(1) as f64
    }
}

/// The clocks of the sets that the chains of a core were given.
#[derive(Clone, Debug)]
pub(crate) struct Load {
    /// Of each chain.
    chains: Vec<u64>,
    /// Leaves of all chains.
    leaves: u64,
}

impl Load {
    pub(crate) fn new(chains: usize) -> Self {
        Self {
            chains: vec![0; chains],
            leaves: 0,
        }
    }

    /// Gives a chain a set whose batches take so many clocks.
    pub(crate) fn add(&mut self, chain: usize, set: &Set, batches: u64) {
        let leaves = set.leaves.len() as u64;
        self.chains[chain] += batches.max(leaves * Leaf::GROUPS as u64);
        self.leaves += leaves;
    }

    /// The clocks until the last chain is done.
    pub(crate) fn clocks(&self) -> u64 {
        let chains = self.chains.iter().copied();
        chains.max().unwrap_or(0).max(self.leaves)
    }
}

/// Forecasts the batches of a core.
#[derive(Debug)]
pub(crate) struct Forecaster {
    format: &'static PhotonFormat,
    /// The fewest clocks of a batch.
    least: u64,
}

impl Forecaster {
    pub(crate) fn new(core: &Core) -> Self {
        let format = core.machine.format();
        Self {
            format: format.expect("a leaf machine has a photon format"),
            least: LeafSizes::of(core.leaf()).least_spacing.into(),
        }
    }

    /// The clocks of each batch of a set.
    pub(crate) fn batches(&self, set: &Set) -> Vec<u64> {
        let leaves = set.leaves.iter();
        let boxes: Vec<_> = leaves.filter_map(|leaf| self.leaf_box(leaf)).collect();
        let batches = set.batches.iter();
        batches.map(|batch| self.clocks(batch, &boxes)).collect()
    }

    fn clocks(&self, batch: &SetBatch, leaves: &[(u32, Bounds)]) -> u64 {
        let radius = i64::from(2 * self.format.radius_steps());
        let queries = batch_box(batch);
        let is_wanted = |(facing, leaf): &&(u32, Bounds)| {
            batch.facings >> facing & 1 == 1
                && queries.is_some_and(|queries| Cull::Distance.reads(*leaf, queries, radius))
        };
        let wanted = leaves.iter().filter(is_wanted).count();
        let played = (wanted * Leaf::GROUPS) as u64;
        let compared = leaves.len().div_ceil(Leaf::PAIR) as u64;
        played.max(compared).max(self.least) + BATCH_CLOCKS
    }

    /// The facing of a leaf, and the box around the middles of its photons' cells.
    fn leaf_box(&self, leaf: &PhotonLeaf) -> Option<(u32, Bounds)> {
        let middle = |place: u32| i64::from(2 * place + 1) << self.format.query_extra_bits;
        let middles = leaf
            .photons
            .iter()
            .map(|photon| photon.position.map(middle));
        Some((leaf.facing, Bounds::around(middles)?))
    }
}

/// The box around the middles of the queries' cells.
fn batch_box(batch: &SetBatch) -> Option<Bounds> {
    let middle = |place: u32| i64::from(2 * place + 1);
    let queries = batch.queries.iter().map(|query| query.query.position);
    Bounds::around(queries.map(|position| position.map(middle)))
}
