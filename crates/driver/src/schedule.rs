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

use photoncube_render::{Bounds, Cull};
use photoncube_spec::{
    BatchPins, Beat, Core, CoreStreams, CoreWords, Leaf, LeafSizes, PhotonFormat, QueryWord,
};

use crate::frames::{PhotonLeaf, Set, SetBatch};

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
            let boxes: Vec<_> = set
                .leaves
                .iter()
                .filter_map(|leaf| leaf_bounds(leaf, self.format()))
                .collect();
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

    fn format(&self) -> &'static PhotonFormat {
        let format = self.core.machine.format();
        format.expect("a leaf machine has a photon format")
    }

    /// A forecast of the clocks of a batch: those to compare all leaves, or to play the leaves that are wanted.
    fn clocks(&self, batch: &SetBatch, leaves: &[(u32, Bounds)]) -> u64 {
        let radius = i64::from(2 * self.format().radius_steps());
        let queries = batch_bounds(batch);
        let is_wanted = |(facing, leaf): &&(u32, Bounds)| {
            batch.facings >> facing & 1 == 1
                && queries.is_some_and(|queries| Cull::Distance.reads(*leaf, queries, radius))
        };
        let wanted = leaves.iter().filter(is_wanted).count();
        let played = (wanted * Leaf::GROUPS) as u64;
        let compared = leaves.len().div_ceil(Leaf::PAIR) as u64;
        let least = LeafSizes::of(self.core.leaf()).least_spacing;
        played.max(compared).max(least.into()) + BATCH_CLOCKS
    }
}

/// The facing of a leaf, and the box around the middles of its photons' cells.
fn leaf_bounds(leaf: &PhotonLeaf, format: &PhotonFormat) -> Option<(u32, Bounds)> {
    let middle = |place: u32| i64::from(2 * place + 1) << format.query_extra_bits;
    let middles = leaf
        .photons
        .iter()
        .map(|photon| photon.position.map(middle));
    Some((leaf.facing, Bounds::around(middles)?))
}

/// The box around the middles of the queries' cells.
fn batch_bounds(batch: &SetBatch) -> Option<Bounds> {
    let middle = |place: u32| i64::from(2 * place + 1);
    let queries = batch.queries.iter().map(|query| query.query.position);
    Bounds::around(queries.map(|position| position.map(middle)))
}
