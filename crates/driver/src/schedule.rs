//! Shares sets out among the chains of a core, and puts their words into the order of the core's streams.
//!
//! A stream's words reach the chains in their order, so a word for a busy chain holds back those behind it. The schedule
//! forecasts when each chain will work on each batch, and orders the words by these times. A chain takes a leaf in two clocks, so the leaves of
//! sets for different chains are mixed: those of a set go into the first half of the time in which the chain works on the set before, since
//! when that begins, the other bank is free.
//!
//! No chain waits for ever. A leaf that waits for a bank has a time at which the queries on the bank's set are all earlier. A query that waits for
//! its set has a later time than every leaf of that set. So where both streams wait, the queries that free the bank are in front
//! of the query that waits.

use std::collections::VecDeque;

use photoncube_spec::{
    BatchPins, Beat, Core, CoreStreams, Leaf, LeafSizes, PhotonFormat, QueryWord,
};

use crate::frames::{PhotonLeaf, Set, SetBatch};
use crate::transport::CoreWords;

/// A result that a chain owes: the query's index in the picture, and its tag.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Owed {
    /// The index of the query in the picture.
    pub index: usize,
    /// The tag.
    pub tag: u32,
}

/// The words for a core, and what its chains owe for them.
#[derive(Debug, Default)]
pub struct Schedule {
    /// The words.
    pub words: CoreWords,
    /// Of each chain, in the order of its queries.
    pub owed: Vec<VecDeque<Owed>>,
}

/// Clocks between two batches of a chain beside those of its work, about.
const BATCH_CLOCKS: u64 = 4;

/// Makes schedules for a core.
#[derive(Debug)]
pub struct Scheduler {
    core: Core,
    streams: CoreStreams,
}

impl Scheduler {
    /// A scheduler for a core.
    pub fn new(core: &Core) -> Self {
        Self {
            core: *core,
            streams: CoreStreams::of(core),
        }
    }

    /// The words of the streams.
    pub fn streams(&self) -> &CoreStreams {
        &self.streams
    }

    /// Schedules sets, each on the chain that is free first.
    pub fn schedule(&self, sets: &[Set]) -> Schedule {
        let chains = self.core.chains as usize;
        let mut free_at = vec![0; chains];
        let mut begun_at = vec![0; chains];
        let mut leaves = Vec::new();
        let mut batches = Vec::new();
        for set in sets {
            let chain = (0..chains).min_by_key(|&chain| free_at[chain]);
            let chain = chain.expect("a core has a chain");
            let (bank_is_free, begins) = (begun_at[chain], free_at[chain]);
            begun_at[chain] = begins;
            for (place, leaf) in set.leaves.iter().enumerate() {
                let share = (begins - bank_is_free) * place as u64 / (2 * set.leaves.len() as u64);
                let last = place + 1 == set.leaves.len();
                leaves.push((bank_is_free + share, chain, leaf, last));
            }
            let boxes: Vec<_> = set.leaves.iter().map(Bounds::of_leaf).collect();
            for (place, batch) in set.batches.iter().enumerate() {
                let release = place + 1 == set.batches.len();
                batches.push((free_at[chain], chain, batch, release));
                free_at[chain] += self.clocks(batch, &boxes);
            }
        }
        // Stable: leaves and batches of equal times keep their order.
        leaves.sort_by_key(|(time, ..)| *time);
        batches.sort_by_key(|(time, ..)| *time);
        let mut schedule = Schedule {
            owed: vec![VecDeque::new(); chains],
            ..Schedule::default()
        };
        let beats = leaves
            .into_iter()
            .map(|(_, chain, leaf, last)| self.leaf(chain, leaf, last));
        schedule.words.photons.extend(beats);
        for (_, chain, batch, release) in batches {
            self.batch(chain, batch, release, &mut schedule);
        }
        schedule
    }

    fn leaf(&self, chain: usize, leaf: &PhotonLeaf, last: bool) -> Beat {
        let values = CoreStreams::leaf_values(&self.core, &leaf.photons, leaf.facing);
        Beat {
            data: self.streams.photons.bytes(&values),
            last,
            dest: chain as u32,
        }
    }

    fn batch(&self, chain: usize, batch: &SetBatch, release: bool, schedule: &mut Schedule) {
        for (place, query) in batch.queries.iter().enumerate() {
            let tag = schedule.words.queries.len() as u32 % (1 << Core::TAG_BITS);
            let last = place + 1 == batch.queries.len();
            let word = QueryWord {
                query: query.query,
                release,
                batch: BatchPins {
                    last,
                    facings: batch.facings,
                    tag,
                },
            };
            schedule.words.queries.push(Beat {
                data: self
                    .streams
                    .queries
                    .bytes(&CoreStreams::query_values(&word)),
                last,
                dest: chain as u32,
            });
            let index = query.index;
            schedule.owed[chain].push_back(Owed { index, tag });
        }
    }

    /// A forecast of the clocks of a batch: those to compare all leaves, or to play the leaves that are wanted.
    fn clocks(&self, batch: &SetBatch, leaves: &[(u32, Bounds)]) -> u64 {
        let format = self.core.machine.format();
        let format = format.expect("a leaf machine has a photon format");
        let queries = Bounds::of_queries(batch, format);
        let near = leaves.iter().filter(|(facing, leaf)| {
            batch.facings >> facing & 1 == 1 && queries.is_near(leaf, format)
        });
        let played = (near.count() * Leaf::GROUPS) as u64;
        let compared = leaves.len().div_ceil(Leaf::PAIR) as u64;
        let least = LeafSizes::of(self.core.leaf()).least_spacing;
        played.max(compared).max(least.into()) + BATCH_CLOCKS
    }
}

/// The box around some points, in cells of photons.
#[derive(Copy, Clone, Debug)]
struct Bounds {
    low: [u32; 3],
    high: [u32; 3],
}

impl Bounds {
    fn around(points: impl IntoIterator<Item = [u32; 3]>) -> Self {
        let nothing = Self {
            low: [u32::MAX; 3],
            high: [0; 3],
        };
        points.into_iter().fold(nothing, |all, point| Self {
            low: [0, 1, 2].map(|axis| all.low[axis].min(point[axis])),
            high: [0, 1, 2].map(|axis| all.high[axis].max(point[axis])),
        })
    }

    /// The facing of a leaf, and the box around its photons.
    fn of_leaf(leaf: &PhotonLeaf) -> (u32, Self) {
        let photons = leaf.photons.iter().map(|photon| photon.position);
        (leaf.facing, Self::around(photons))
    }

    fn of_queries(batch: &SetBatch, format: &PhotonFormat) -> Self {
        let finer = format.radius_bits() - format.position_bits;
        let queries = batch.queries.iter().map(|query| query.query.position);
        Self::around(queries.map(|position| position.map(|place| place >> finer)))
    }

    /// Whether two boxes are at most a search radius apart, which is about the edge of a block.
    fn is_near(&self, other: &Self, format: &PhotonFormat) -> bool {
        let gap = |axis: usize| {
            let above = self.low[axis].saturating_sub(other.high[axis]);
            let below = other.low[axis].saturating_sub(self.high[axis]);
            u64::from(above.max(below))
        };
        let squared: u64 = (0..3).map(|axis| gap(axis).pow(2)).sum();
        squared <= 1 << (2 * format.position_bits)
    }
}
