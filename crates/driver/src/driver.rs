//! Does the queries of a picture over one or several machines.

use std::fmt;
use std::ops::AddAssign;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use photoncube_model::Gathered;
use photoncube_render::{Gatherer, GathererError, QuantisedMap, QueryPoint};
use photoncube_spec::{LeafAnswer, Machine, Spatial, Sums};
use thiserror::Error;

use crate::frames::{FramePlan, FrameWords};
use crate::transport::{Transport, TransportError};

/// Words of the query stream, about, that a machine is given at once. A machine is empty at their end, which costs it some hundred
/// clocks.
const QUERIES_AT_ONCE: usize = 4096;

/// The error of a driver.
#[derive(Debug, Error)]
pub enum DriverError {
    /// The machine has no memory of leaves.
    #[error("machine `{0}` is no leaf machine; expected one such as leaf-7-local7-rgb6d-n4096")]
    NoLeaves(&'static str),
    /// There is no machine to drive.
    #[error("found no transport, expected one at least")]
    NoTransport,
    /// The machine gave fewer or more results than it was given queries.
    #[error("machine `{machine}`: found {found} results, expected {expected}")]
    Results {
        /// The name of the machine.
        machine: &'static str,
        /// The number of results.
        found: usize,
        /// The number of queries.
        expected: usize,
    },
    /// A result has another tag than its query.
    #[error("machine `{machine}`: result {place} has the tag {found}, expected {expected}")]
    Tag {
        /// The name of the machine.
        machine: &'static str,
        /// The place of the result.
        place: usize,
        /// The tag of the result.
        found: u32,
        /// The tag of the query.
        expected: u32,
    },
}

/// The work that machines did.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Queries of the picture.
    pub queries: u64,
    /// Words of the query streams. A query whose photons need several sets is there for each of them.
    pub query_words: u64,
    /// Frames with photons.
    pub frames: u64,
    /// Groups that were read in.
    pub groups_loaded: u64,
    /// Groups that the chains were given.
    pub groups_played: u64,
    /// Photons in range of the queries.
    pub in_range: u64,
    /// Clocks of all machines together.
    pub clocks: u64,
    /// Photon tests: each place of a group that was played, in each engine, whether it holds a query or not.
    pub photon_tests: u64,
}

impl AddAssign for Work {
    fn add_assign(&mut self, other: Self) {
        self.queries += other.queries;
        self.query_words += other.query_words;
        self.frames += other.frames;
        self.groups_loaded += other.groups_loaded;
        self.groups_played += other.groups_played;
        self.in_range += other.in_range;
        self.clocks += other.clocks;
        self.photon_tests += other.photon_tests;
    }
}

/// Receives the number of frames that are done, and of all frames.
type Progress = Box<dyn Fn(usize, usize) + Sync + Send>;

/// Machines of one kind, each over a transport of its own, that share the frames of a picture.
pub struct Driver<T> {
    machine: &'static Machine,
    transports: Vec<Mutex<T>>,
    work: Mutex<Work>,
    progress: Progress,
}

impl<T> fmt::Debug for Driver<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Driver")
            .field("machine", &self.machine.name)
            .field("transports", &self.transports.len())
            .finish_non_exhaustive()
    }
}

impl<T: Transport> Driver<T> {
    /// Makes a driver of these machines.
    ///
    /// # Errors
    /// The machine is no leaf machine, or there is none.
    pub fn new(machine: &'static Machine, transports: Vec<T>) -> Result<Self, DriverError> {
        if machine.leaf().is_none() {
            return Err(DriverError::NoLeaves(machine.name));
        }
        if transports.is_empty() {
            return Err(DriverError::NoTransport);
        }
        Ok(Self {
            machine,
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
        *self
            .work
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner)
    }

    fn run(
        &self,
        map: &QuantisedMap<'_>,
        queries: &[QueryPoint],
    ) -> Result<Vec<Sums>, TransportError> {
        let plan = FramePlan::new(map, self.machine, queries);
        let (next, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
        let worker = |transport: &Mutex<T>| {
            let mut transport = transport
                .lock()
                .unwrap_or_else(std::sync::PoisonError::into_inner);
            self.share(&plan, &mut *transport, queries.len(), &next, &done)
        };
        let shares: Vec<_> = thread::scope(|scope| {
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
        let mut all = vec![Sums::default(); queries.len()];
        let mut work = Work {
            queries: queries.len() as u64,
            ..Work::default()
        };
        for share in shares {
            let (sums, share_work) = share?;
            work += share_work;
            all.iter_mut()
                .zip(sums)
                .for_each(|(all, sums)| add(all, sums));
        }
        *self
            .work
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner) += work;
        Ok(all)
    }

    /// Does frames until none is left. Returns the sums of all queries, 0 where another machine does them.
    fn share(
        &self,
        plan: &FramePlan<'_>,
        transport: &mut T,
        queries: usize,
        next: &AtomicUsize,
        done: &AtomicUsize,
    ) -> Result<(Vec<Sums>, Work), TransportError> {
        let mut sums = vec![Sums::default(); queries];
        let mut work = Work::default();
        loop {
            let (words, frames) = self.several(plan, next);
            if frames == 0 {
                return Ok((sums, work));
            }
            if !words.queries.is_empty() {
                let answer = transport.exchange(&words.words)?;
                self.check(&words, &answer)?;
                for (query, result) in words.queries.iter().zip(&answer.results) {
                    add(&mut sums[*query], result.sums);
                }
                work += self.work_of(&words, &answer);
                work.frames += words.frames;
            }
            let done = done.fetch_add(frames, Ordering::Relaxed) + frames;
            (self.progress)(done, plan.frames().len());
        }
    }

    /// The words of the next frames, and their number; 0 where none is left.
    fn several(&self, plan: &FramePlan<'_>, next: &AtomicUsize) -> (FrameWords, usize) {
        let mut all = FrameWords::default();
        let mut frames = 0;
        while all.queries.len() < QUERIES_AT_ONCE {
            let Some(frame) = plan.frames().get(next.fetch_add(1, Ordering::Relaxed)) else {
                break;
            };
            frames += 1;
            all.append(plan.words(frame));
        }
        (all, frames)
    }

    fn check(&self, words: &FrameWords, answer: &LeafAnswer) -> Result<(), DriverError> {
        let (found, expected) = (answer.results.len(), words.queries.len());
        if found != expected {
            return Err(DriverError::Results {
                machine: self.machine.name,
                found,
                expected,
            });
        }
        let tags = words.words.queries.iter().map(|word| word.batch.tag);
        let mut pairs = answer.results.iter().zip(tags).enumerate();
        match pairs.find(|(_, (result, tag))| result.tag != *tag) {
            None => Ok(()),
            Some((place, (result, expected))) => Err(DriverError::Tag {
                machine: self.machine.name,
                place,
                found: result.tag,
                expected,
            }),
        }
    }

    fn work_of(&self, words: &FrameWords, answer: &LeafAnswer) -> Work {
        let tests = Spatial::LANES * self.machine.queries_at_once();
        Work {
            query_words: words.queries.len() as u64,
            groups_loaded: words.words.groups.len() as u64,
            groups_played: answer.groups_played,
            in_range: answer.results.iter().map(|result| result.sums.count).sum(),
            clocks: answer.clocks,
            photon_tests: answer.groups_played * tests as u64,
            ..Work::default()
        }
    }
}

impl<T: Transport> Gatherer for Driver<T> {
    fn gather_all(
        &self,
        map: &QuantisedMap<'_>,
        queries: &[QueryPoint],
    ) -> Result<Vec<Gathered>, GathererError> {
        let sums = self.run(map, queries)?;
        let gathered = |sums: Sums| Gathered {
            sums,
            photons: sums.count,
            tests: sums.count,
        };
        Ok(sums.into_iter().map(gathered).collect())
    }
}

fn add(all: &mut Sums, more: Sums) {
    for (all, more) in all.power.iter_mut().zip(more.power) {
        *all += more;
    }
    all.count += more.count;
}
