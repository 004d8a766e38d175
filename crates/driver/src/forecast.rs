//! A forecast of the clocks that a core takes.
//!
//! A batch takes the longer of two: comparing the boxes of all leaves of its set, [`Leaf::PAIR`] leaves a clock, and playing the groups
//! that are wanted, one a clock. A chain has two banks: while it works on a set it reads in the next, a group a clock. The
//! stream of photons has a leaf a clock for all chains, and the stream of queries a query.

use photoncube_render::{QuantisedMap, QueryPoint};
use photoncube_spec::{Core, Leaf, LeafSizes, PhotonFormat};
use rayon::prelude::*;

use crate::cull::{WantedLeaf, wanted};
use crate::frames::{FramePlan, Set, SetSize};

/// Clocks between two batches of a chain beside those of its work, about.
const BATCH_CLOCKS: u64 = 1;

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
        let of_set = |set: &Set| (set.size(), forecaster.batches(set).iter().sum());
        let of_frame = |frame| plan.sets(frame).iter().map(of_set).collect::<Vec<_>>();
        let frames: Vec<_> = plan.frames().par_iter().map(of_frame).collect();
        let mut load = Load::new(1);
        for (size, batches) in frames.into_iter().flatten() {
            load.add(0, size, batches);
        }
        Self {
            queries: queries.len() as u64,
            clocks: load
                .of_chains()
                .div_ceil(core.chains.into())
                .max(load.of_streams()),
        }
    }

    /// Queries for each clock.
    pub fn queries_per_clock(&self) -> f64 {
        self.queries as f64 / self.clocks.max(1) as f64
    }
}

/// When a chain reads in a set and works on it.
#[derive(Copy, Clone, Debug, Default)]
pub(crate) struct Times {
    /// The clock from which a bank is free for the set: that in which the set before it begins.
    pub(crate) bank_is_free: u64,
    /// The clock in which its first batch begins.
    pub(crate) begins: u64,
}

/// What a chain was given.
#[derive(Copy, Clone, Debug, Default)]
struct Chain {
    last: Times,
    /// The clock in which the last leaf is read in.
    is_loaded: u64,
    /// The clock in which the last batch ends.
    ends: u64,
}

/// The sets that the chains of a core were given.
#[derive(Clone, Debug)]
pub(crate) struct Load {
    chains: Vec<Chain>,
    /// Leaves and queries of all chains.
    leaves: u64,
    queries: u64,
}

impl Load {
    pub(crate) fn new(chains: usize) -> Self {
        Self {
            chains: vec![Chain::default(); chains],
            leaves: 0,
            queries: 0,
        }
    }

    /// The chain that is done first.
    pub(crate) fn first_free(&self) -> usize {
        let chains = 0..self.chains.len();
        let first = chains.min_by_key(|&chain| self.chains[chain].ends);
        first.expect("a core has a chain")
    }

    /// Gives a chain a set of a size whose batches take so many clocks.
    pub(crate) fn add(&mut self, chain: usize, size: SetSize, batches: u64) -> Times {
        let SetSize { leaves, queries } = size;
        self.leaves += leaves;
        self.queries += queries;
        let chain = &mut self.chains[chain];
        let bank_is_free = chain.last.begins;
        chain.is_loaded = chain.is_loaded.max(bank_is_free) + leaves * Leaf::GROUPS as u64;
        let begins = chain.ends.max(chain.is_loaded);
        chain.ends = begins + batches;
        chain.last = Times {
            bank_is_free,
            begins,
        };
        chain.last
    }

    /// The clocks until the last chain is done.
    pub(crate) fn clocks(&self) -> u64 {
        self.of_chains().max(self.of_streams())
    }

    /// The clocks of the chain that is done last.
    fn of_chains(&self) -> u64 {
        let ends = self.chains.iter().map(|chain| chain.ends);
        ends.max().unwrap_or(0)
    }

    /// The clocks of the longer stream, where a word moves in each.
    fn of_streams(&self) -> u64 {
        self.leaves.max(self.queries)
    }
}

/// Forecasts the batches of a core.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Forecaster {
    format: &'static PhotonFormat,
    /// The fewest clocks of a batch.
    least: u64,
    /// The clocks in which each chain is given a leaf.
    leaf: u64,
    /// The rounds of each batch.
    rounds: u64,
}

impl Forecaster {
    pub(crate) fn new(core: &Core) -> Self {
        let format = core.machine.format();
        Self {
            format: format.expect("a leaf machine has a photon format"),
            least: LeafSizes::of(core.leaf()).least_spacing.into(),
            leaf: (Leaf::GROUPS as u64).max(core.chains.into()),
            rounds: 1,
        }
    }

    /// A forecaster of batches of so many rounds.
    pub(crate) fn with_rounds(self, rounds: u32) -> Self {
        Self {
            rounds: rounds.into(),
            ..self
        }
    }

    /// The photon format of the core.
    pub(crate) fn format(&self) -> &'static PhotonFormat {
        self.format
    }

    /// The rounds of each batch.
    pub(crate) fn rounds(&self) -> u64 {
        self.rounds
    }

    /// The clocks of each batch of a set.
    pub(crate) fn batches(&self, set: &Set) -> Vec<u64> {
        let wanted = wanted(self.format, &set.leaves, &set.batches);
        let clocks = |wanted: &Vec<WantedLeaf>| {
            let groups = wanted.iter().map(|leaf| leaf.groups).sum();
            self.batch(groups, set.leaves.len())
        };
        wanted.iter().map(clocks).collect()
    }

    /// The clocks of a batch that wants so many groups of a set of so many leaves.
    pub(crate) fn batch(&self, groups: usize, leaves: usize) -> u64 {
        let played = groups as u64;
        let compared = leaves.div_ceil(Leaf::PAIR) as u64;
        self.rounds * (played.max(compared).max(self.least) + BATCH_CLOCKS)
    }

    /// The clocks of a set whose batches take so many clocks, where all chains read in sets of as many leaves.
    pub(crate) fn set(&self, batches: u64, leaves: usize) -> u64 {
        batches.max(leaves as u64 * self.leaf)
    }
}
