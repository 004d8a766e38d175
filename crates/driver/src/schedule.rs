//! The words of a core's streams for sets, in the order of their [`Timetable`], and what the chains owe for them.

use std::collections::VecDeque;

use photoncube_spec::{BatchPins, Beat, Core, CoreStreams, CoreWords, QueryRounds, QueryWord};
use rayon::prelude::*;

use crate::forecast::Forecaster;
use crate::frames::{PhotonLeaf, Set, SetBatch};
use crate::timetable::{BatchTurn, LeafTurn, Timetable};

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
    /// A forecast of the clocks until the last group is played.
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

    /// Schedules sets whose batches have these rounds.
    pub fn schedule(&self, sets: &[Set], rounds: &QueryRounds) -> Schedule {
        let forecaster = self.forecaster.with_rounds(rounds.rounds(&self.core));
        let works: Vec<_> = sets.par_iter().map(|set| forecaster.work(set)).collect();
        let timetable = Timetable::of(&self.core, &works);
        let mut schedule = Schedule {
            owed: vec![VecDeque::new(); self.core.chains as usize],
            clocks: timetable.clocks,
            words: CoreWords {
                rounds: rounds.clone(),
                ..CoreWords::default()
            },
        };
        let beat = |LeafTurn { chain, set, leaf }| {
            let leaves = &sets[set].leaves;
            self.leaf(chain, &leaves[leaf], leaf + 1 == leaves.len())
        };
        schedule.words.photons = timetable.leaves.into_iter().map(beat).collect();
        for BatchTurn { chain, set, batch } in timetable.batches {
            let batches = &sets[set].batches;
            let release = batch + 1 == batches.len();
            self.batch(chain, &batches[batch], release, &mut schedule);
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
