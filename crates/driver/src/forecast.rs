//! A forecast of the clocks that a core takes.
//!
//! A batch takes the longer of two: comparing the boxes of all leaves of its set, [`Leaf::PAIR`] leaves a clock, and playing the groups
//! that are wanted, one a clock; but at least the clocks in which its queries are taken and its first pair is compared. When each
//! chain works on which batch is in the [`Timetable`].

use photoncube_render::{QuantisedMap, QueryPoint};
use photoncube_spec::{Core, Leaf, PhotonFormat};
use rayon::prelude::*;

use crate::chain::{BatchWork, ChainClocks};
use crate::cull::{WantedLeaf, wanted};
use crate::frames::{FramePlan, Set, SetBatch};
use crate::shares::SetWork;
use crate::timetable::Timetable;

/// A forecast for a picture.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Forecast {
    /// Queries of the picture.
    pub queries: u64,
    /// Clocks until the last group is played.
    pub clocks: u64,
}

impl Forecast {
    /// Forecasts the queries of a picture on a core that is given all of them at once.
    ///
    /// # Panics
    /// Where the map has not the numbers of the core's machine.
    pub fn of(core: &Core, map: &QuantisedMap<'_>, queries: &[QueryPoint]) -> Self {
        let plan = FramePlan::new(map, core, queries);
        let forecaster = Forecaster::new(core);
        let works = |frame| -> Vec<_> {
            let sets = plan.sets(frame);
            sets.iter().map(|set| forecaster.work(set)).collect()
        };
        let frames: Vec<_> = plan.frames().par_iter().map(works).collect();
        let sets: Vec<_> = frames.into_iter().flatten().collect();
        Self {
            queries: queries.len() as u64,
            clocks: Timetable::of(core, &sets).clocks,
        }
    }

    /// Queries for each clock.
    pub fn queries_per_clock(&self) -> f64 {
        self.queries as f64 / self.clocks.max(1) as f64
    }
}

/// Forecasts the batches of a core.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Forecaster {
    format: &'static PhotonFormat,
    /// The fewest clocks of a round of a batch.
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
            least: ChainClocks::of(core).least(),
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

    /// The work of a set.
    pub(crate) fn work(&self, set: &Set) -> SetWork {
        let wanted = wanted(self.format, &set.leaves, &set.batches);
        let batches = set.batches.iter().zip(&wanted);
        SetWork {
            leaves: set.leaves.len() as u64,
            batches: batches
                .map(|(batch, wanted)| self.batch_work(batch, wanted, set.leaves.len()))
                .collect(),
        }
    }

    /// The work of a batch that wants these of so many leaves.
    fn batch_work(&self, batch: &SetBatch, wanted: &[WantedLeaf], leaves: usize) -> BatchWork {
        let groups = wanted.iter().map(|leaf| leaf.groups).sum();
        let pairs = leaves.div_ceil(Leaf::PAIR);
        let pair = |leaf: &WantedLeaf| leaf.index / Leaf::PAIR;
        // The last pair is queued in any case, and where none of its groups is wanted, one without photons is played.
        let is_blank = wanted.last().is_none_or(|last| pair(last) + 1 < pairs);
        let clocks = self.batch(groups, leaves);
        BatchWork {
            queries: batch.queries.len() as u64,
            plays: match self.rounds {
                1 => groups as u64 + u64::from(is_blank),
                _ => clocks,
            },
            pairs: pairs as u64,
            before: wanted.first().map_or(pairs - 1, pair) as u64,
            clocks,
        }
    }

    /// The clocks of a batch that wants so many groups of a set of so many leaves, in all rounds.
    pub(crate) fn batch(&self, groups: usize, leaves: usize) -> u64 {
        let played = groups as u64;
        let compared = leaves.div_ceil(Leaf::PAIR) as u64;
        self.rounds * played.max(compared).max(self.least)
    }

    /// The clocks of a set whose batches take so many clocks, where all chains read in sets of as many leaves.
    pub(crate) fn set(&self, batches: u64, leaves: usize) -> u64 {
        batches.max(leaves as u64 * self.leaf)
    }
}
