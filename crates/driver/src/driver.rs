//! Does the queries of a picture over one or several cores.

use std::fmt;
use std::ops::AddAssign;
use std::sync::{Mutex, MutexGuard};
use std::thread;

use photoncube_model::Gathered;
use photoncube_render::{
    Gatherer, GathererError, NearestGathered, QuantisedMap, QueryPoint, gather_rungs,
};
use photoncube_spec::{
    Core, CoreAnswer, CoreCounter, CoreStreams, CounterRow, PhotonFormat, QueryResult, QueryRounds,
    Rounds, Widths,
};
use thiserror::Error;

use crate::exchanges::Exchanges;
use crate::found::{Found, take_split};
use crate::frames::FramePlan;
use crate::schedule::{Owed, Schedule, Scheduler};
use crate::transport::{Transport, TransportError};

/// The error of a driver.
#[derive(Debug, Error)]
pub enum DriverError {
    /// There is no core to drive.
    #[error("found no transport, expected one at least")]
    NoTransport,
    /// The core gave fewer or more results than it was given queries.
    #[error("core `{core}`: found {found} results, expected {expected}")]
    Results {
        /// The name of the core.
        core: String,
        /// The number of results.
        found: usize,
        /// The number of queries.
        expected: usize,
    },
    /// A result is not the one that its chain owes.
    #[error(
        "core `{core}`: result {place}, of chain {chain}, has the tag {found}, expected {expected}"
    )]
    Tag {
        /// The name of the core.
        core: String,
        /// The place of the result.
        place: usize,
        /// The chain.
        chain: u32,
        /// The tag of the result.
        found: u32,
        /// The tag of the query; `none` where the chain owes no result.
        expected: String,
    },
    /// A query has another radius than all queries of the core have.
    #[error(
        "core `{0}`: found a query with a radius of its own, expected the format's, as its machine has no other"
    )]
    Radius(String),
    /// A core says that a query is outside of its frame.
    #[error(
        "core `{core}`: result {place} is of a query outside of its frame; the driver and the core differ"
    )]
    Outside {
        /// The name of the core.
        core: String,
        /// The place of the result.
        place: usize,
    },
}

/// The work that cores did.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Work {
    /// Queries that were asked for: those of the picture, each as often as it has another radius.
    pub queries: u64,
    /// Words of the query streams. A query whose photons need several sets is there for each of them.
    pub query_words: u64,
    /// Sets of photons.
    pub sets: u64,
    /// The scheduler's forecast of the clocks, of all cores.
    pub clocks_forecast: u64,
    /// What the counters of all cores counted, in the order of [`CounterRow::ALL`].
    pub counters: Vec<u64>,
}

impl Default for Work {
    fn default() -> Self {
        Self {
            queries: 0,
            query_words: 0,
            sets: 0,
            clocks_forecast: 0,
            counters: vec![0; CounterRow::ALL.len()],
        }
    }
}

impl Work {
    /// What a counter counted in all cores.
    pub fn counter(&self, counter: CoreCounter) -> u64 {
        self.counters[counter as usize]
    }
}

impl AddAssign for Work {
    fn add_assign(&mut self, other: Self) {
        self.queries += other.queries;
        self.query_words += other.query_words;
        self.sets += other.sets;
        self.clocks_forecast += other.clocks_forecast;
        for (sum, more) in self.counters.iter_mut().zip(other.counters) {
            *sum += more;
        }
    }
}

/// Receives the number of frames that are done, and of all frames.
type Progress = Box<dyn Fn(usize, usize) + Sync + Send>;

/// Cores of one kind, each over a transport of its own, that share the frames of a picture.
pub struct Driver<T> {
    core: Core,
    scheduler: Scheduler,
    transports: Vec<Mutex<T>>,
    work: Mutex<Work>,
    progress: Progress,
}

impl<T> fmt::Debug for Driver<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Driver")
            .field("core", &self.core.name())
            .field("transports", &self.transports.len())
            .finish_non_exhaustive()
    }
}

impl<T: Transport> Driver<T> {
    /// Makes a driver of these cores.
    ///
    /// # Errors
    /// There is none.
    pub fn new(core: &Core, transports: Vec<T>) -> Result<Self, DriverError> {
        if transports.is_empty() {
            return Err(DriverError::NoTransport);
        }
        Ok(Self {
            core: *core,
            scheduler: Scheduler::new(core),
            transports: transports.into_iter().map(Mutex::new).collect(),
            work: Mutex::default(),
            progress: Box::new(|_, _| ()),
        })
    }

    /// This driver with a receiver of its progress: the frames that are done, and all frames.
    #[must_use]
    pub fn with_progress(
        mut self,
        progress: impl Fn(usize, usize) + Sync + Send + 'static,
    ) -> Self {
        self.progress = Box::new(progress);
        self
    }

    /// The work so far.
    pub fn work(&self) -> Work {
        locked(&self.work).clone()
    }

    /// Whether the cores do rounds.
    fn has_rounds(&self) -> bool {
        let mut transports = self.transports.iter();
        transports.all(|transport| locked(transport).has_rounds())
    }

    /// Does queries in rounds, each with a radius of its own where `radii` is not empty. Returns what was found of each query, for each of
    /// its results.
    fn run(
        &self,
        map: &QuantisedMap<'_>,
        queries: &[QueryPoint],
        radii: Vec<u32>,
        rounds: &QueryRounds,
    ) -> Result<Vec<Vec<Found>>, TransportError> {
        let fixed = self.core.machine.fixed_radius_sq();
        if fixed.is_some_and(|fixed| radii.iter().any(|&radius| radius != fixed)) {
            return Err(DriverError::Radius(self.core.name()).into());
        }
        let plan = FramePlan::new(map, &self.core, queries)
            .with_radii(radii)
            .with_rounds(&self.core, rounds);
        let nothing = vec![vec![Found::default(); queries.len()]; rounds.results()];
        let exchanges = &Exchanges::new(&plan, &self.core, self.transports.len());
        let plan = &plan;
        let worker = |transport: &Mutex<T>| {
            let mut share = Share {
                found: nothing.clone(),
                work: Work::default(),
            };
            let transport = &mut *locked(transport);
            self.share(plan, exchanges, rounds, transport, &mut share)?;
            Ok(share)
        };
        let shares: Vec<Result<Share, TransportError>> = thread::scope(|scope| {
            let threads: Vec<_> = self
                .transports
                .iter()
                .map(|transport| scope.spawn(move || worker(transport)))
                .collect();
            let joined = threads.into_iter().map(|thread| thread.join());
            joined
                .map(|share| share.expect("a worker does not panic"))
                .collect()
        });
        let mut all = nothing.clone();
        let mut work = Work {
            queries: queries.len() as u64,
            ..Work::default()
        };
        for share in shares {
            let share: Share = share?;
            work += share.work;
            let all = all.iter_mut().flatten();
            all.zip(share.found.into_iter().flatten())
                .for_each(|(all, found)| all.add(&found));
        }
        *locked(&self.work) += work;
        Ok(all)
    }

    /// Does exchanges until none is left.
    fn share(
        &self,
        plan: &FramePlan<'_>,
        exchanges: &Exchanges<'_>,
        rounds: &QueryRounds,
        transport: &mut T,
        share: &mut Share,
    ) -> Result<(), TransportError> {
        loop {
            let Some(frames) = exchanges.next() else {
                return Ok(());
            };
            let of_frames = frames.iter().flat_map(|frame| plan.sets(frame));
            let mut sets: Vec<_> = of_frames.collect();
            if matches!(rounds, QueryRounds::Nearest(_)) {
                take_split(&mut sets, &mut share.found[0]);
            }
            if !sets.is_empty() {
                let schedule = self.scheduler.schedule(&sets, rounds);
                let answer = transport.exchange(&schedule.words)?;
                share.work += Work {
                    queries: 0,
                    query_words: schedule.words.queries.len() as u64,
                    sets: sets.len() as u64,
                    clocks_forecast: schedule.clocks,
                    counters: answer.counters.clone(),
                };
                self.read(schedule, &answer, &mut share.found)?;
            }
            (self.progress)(exchanges.done(frames.len()), plan.frames().len());
        }
    }

    /// Adds the results to what was found of their queries.
    fn read(
        &self,
        mut schedule: Schedule,
        answer: &CoreAnswer,
        all: &mut [Vec<Found>],
    ) -> Result<(), DriverError> {
        let (found, expected) = (answer.results.len(), schedule.words.results());
        if found != expected {
            return Err(DriverError::Results {
                core: self.core.name(),
                found,
                expected,
            });
        }
        let word = &self.scheduler.streams().results;
        for (place, result) in answer.results.iter().enumerate() {
            let QueryResult {
                sums,
                tag,
                radius_sq,
            } = CoreStreams::result_of(&self.core, &word.values(&result.data));
            let owed = schedule.owed.get_mut(result.id as usize);
            let owed = owed.and_then(|owed| owed.pop_front());
            let Some(Owed {
                index,
                result: number,
                ..
            }) = owed.filter(|owed| owed.tag == tag)
            else {
                return Err(DriverError::Tag {
                    core: self.core.name(),
                    place,
                    chain: result.id,
                    found: tag,
                    expected: owed.map_or("none".to_owned(), |owed| owed.tag.to_string()),
                });
            };
            if result.outside {
                return Err(DriverError::Outside {
                    core: self.core.name(),
                    place,
                });
            }
            all[number][index].add(&Found {
                sums,
                radius_sq: radius_sq.unwrap_or(0),
                results: 1,
                is_split: false,
            });
        }
        Ok(())
    }
}

impl<T: Transport> Gatherer for Driver<T> {
    fn gather_all(
        &self,
        map: &QuantisedMap<'_>,
        queries: &[QueryPoint],
        radii_sq: &[u32],
    ) -> Result<Vec<Gathered>, GathererError> {
        let words = radii_sq
            .iter()
            .map(|&radius_sq| map.numbers().radius_word(radius_sq));
        let words: Vec<_> = words.collect();
        // A query without a word has no photons in range.
        let asked: Vec<_> = (0..queries.len())
            .filter(|&query| words[query].is_some())
            .collect();
        let points: Vec<_> = asked.iter().map(|&query| queries[query]).collect();
        let words = words.into_iter().flatten().collect();
        let found = self.run(map, &points, words, &QueryRounds::Own)?;
        let mut all = vec![Gathered::default(); queries.len()];
        for (query, found) in asked.into_iter().zip(&found[0]) {
            all[query] = found.gathered();
        }
        Ok(all)
    }

    fn gather_ladder(
        &self,
        map: &QuantisedMap<'_>,
        queries: &[QueryPoint],
        radii_sq: &[u32],
    ) -> Result<Vec<Vec<Gathered>>, GathererError> {
        let word = |&radius_sq: &u32| map.numbers().radius_word(radius_sq);
        let words: Option<Vec<_>> = radii_sq.iter().map(word).collect();
        // A single radius is that of the queries, and where no photon can be in range there is no word.
        let words = words.filter(|words| words.len() > 1 && self.has_rounds());
        let Some(words) = words else {
            return gather_rungs(self, map, queries, radii_sq);
        };
        let mut all = Vec::new();
        for words in words.chunks(Rounds::RUNGS as usize) {
            let found = self.run(map, queries, Vec::new(), &QueryRounds::Ladder(words.into()))?;
            let gathered = found
                .iter()
                .map(|found| found.iter().map(Found::gathered).collect());
            all.extend(gathered);
        }
        Ok(all)
    }

    fn k_nearest(
        &self,
        map: &QuantisedMap<'_>,
        queries: &[QueryPoint],
        k: u64,
    ) -> Result<Vec<Option<NearestGathered>>, GathererError> {
        let machine = self.core.machine;
        let k = u32::try_from(k)
            .ok()
            .filter(|k| k.ilog2() < Widths::of(machine).count);
        let (Some(k), Some(rounds)) = (k, Rounds::of(&self.core).filter(|_| self.has_rounds()))
        else {
            return Ok(vec![None; queries.len()]);
        };
        let found = self.run(map, queries, Vec::new(), &QueryRounds::Nearest(k))?;
        let nearest = |found: &Found| {
            if found.is_split {
                return None;
            }
            if found.results == 0 {
                // No leaf is near the query.
                return Some(NearestGathered {
                    radius_sq: map.radius_sq(),
                    ..NearestGathered::default()
                });
            }
            let half_steps = machine.format().is_some_and(PhotonFormat::half_steps);
            // On half steps a word stands for one step more, so that no word stands for a radius of 0, which has no photons.
            let is_within_none = half_steps && found.radius_sq == 0;
            Some(NearestGathered {
                radius_sq: found.radius_sq + u32::from(half_steps),
                gathered: match is_within_none {
                    true => Gathered::default(),
                    false => found.gathered(),
                },
                gathers: rounds.nearest.into(),
            })
        };
        Ok(found[0].iter().map(nearest).collect())
    }
}

/// What a worker found, and its work.
struct Share {
    found: Vec<Vec<Found>>,
    work: Work,
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex
        .lock()
        .unwrap_or_else(std::sync::PoisonError::into_inner)
}
