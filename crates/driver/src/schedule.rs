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

use photoncube_spec::{BatchPins, Beat, Core, CoreStreams, CoreWords, QueryRounds, QueryWord};

use crate::forecast::{Forecaster, Load};
use crate::frames::{PhotonLeaf, Set, SetBatch};

/// A result that a chain owes.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Owed {
    /// The index of the query in the picture.
    pub index: usize,
    /// The tag.
    pub tag: u32,
    /// The number of the result among those of the query.
    pub result: usize,
}

/// The words for a core, and what its chains owe for them.
#[derive(Debug, Default)]
pub struct Schedule {
    /// The words.
    pub words: CoreWords,
    /// Of each chain, in the order of its queries.
    pub owed: Vec<VecDeque<Owed>>,
    /// A forecast of the clocks until the last result.
    pub clocks: u64,
}

/// Makes schedules for a core.
#[derive(Debug)]
pub struct Scheduler {
    core: Core,
    streams: CoreStreams,
    forecaster: Forecaster,
}

impl Scheduler {
    /// A scheduler for a core.
    pub fn new(core: &Core) -> Self {
        Self {
            core: *core,
            streams: CoreStreams::of(core),
            forecaster: Forecaster::new(core),
        }
    }

    /// The words of the streams.
    pub fn streams(&self) -> &CoreStreams {
        &self.streams
    }

    /// Schedules sets, each on the chain that is free first, whose batches have these rounds.
    pub fn schedule(&self, sets: &[Set], rounds: &QueryRounds) -> Schedule {
        let chains = self.core.chains as usize;
        let mut leaves = Vec::new();
        let mut batches = Vec::new();
        let mut load = Load::new(chains);
        let forecaster = self.forecaster.with_rounds(rounds.rounds(&self.core));
        for (set, clocks) in mixed(&forecaster, sets) {
            let chain = load.first_free();
            let times = load.add(chain, set.size(), clocks.iter().sum());
            for (place, leaf) in set.leaves.iter().enumerate() {
                let before = times.begins - times.bank_is_free;
                let share = before * place as u64 / (2 * set.leaves.len() as u64);
                let last = place + 1 == set.leaves.len();
                leaves.push((times.bank_is_free + share, chain, leaf, last));
            }
            let mut begins = times.begins;
            for (place, (batch, clocks)) in set.batches.iter().zip(clocks).enumerate() {
                let release = place + 1 == set.batches.len();
                batches.push((begins, chain, batch, release));
                begins += clocks;
            }
        }
        // Stable: leaves and batches of equal times keep their order.
        leaves.sort_by_key(|(time, ..)| *time);
        batches.sort_by_key(|(time, ..)| *time);
        let mut schedule = Schedule {
            owed: vec![VecDeque::new(); chains],
            clocks: load.clocks(),
            words: CoreWords {
                rounds: rounds.clone(),
                ..CoreWords::default()
            },
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
        let mut tags = Vec::with_capacity(batch.queries.len());
        for (place, query) in batch.queries.iter().enumerate() {
            let tag = schedule.words.queries.len() as u32 % (1 << Core::TAG_BITS);
            tags.push(tag);
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
                    .bytes(&CoreStreams::query_values(&self.core, &word)),
                last,
                dest: chain as u32,
            });
        }
        for result in 0..schedule.words.rounds.results() {
            let owed = batch.queries.iter().zip(&tags);
            schedule.owed[chain].extend(owed.map(|(query, &tag)| Owed {
                index: query.index,
                tag,
                result,
            }));
        }
    }
}

/// The sets, each with the clocks of its batches, in an order in which some of few neighbours take few clocks a query and some many. Where
/// all chains take few, they wait for queries, of which the stream has one a clock.
fn mixed<'a>(forecaster: &Forecaster, sets: &'a [Set]) -> Vec<(&'a Set, Vec<u64>)> {
    let clocks = |set: &'a Set| (set, forecaster.batches(set));
    let mut sets: Vec<_> = sets.iter().map(clocks).collect();
    sets.sort_by_cached_key(|(set, clocks)| {
        // A fraction as an integer.
        (clocks.iter().sum::<u64>() << 16) / set.size().queries.max(1)
    });
    // In the order of their numbers with the bits reversed, numbers that are close together are far apart.
    let mut numbered: Vec<_> = (0_u32..).zip(sets).collect();
    numbered.sort_by_key(|(number, _)| number.reverse_bits());
    numbered.into_iter().map(|(_, set)| set).collect()
}
