//! Campaigns: verifications with successive seeds, on all cores, until a deadline.
//!
//! The [`State`] records the jobs that are done and is saved after each job. A campaign that was killed
//! continues with the jobs that its state lacks, and repeats a job that was under way.

mod job;
mod minimise;
mod regression;
mod state;

use std::num::NonZero;
use std::sync::{Mutex, MutexGuard};
use std::thread;
use std::time::Instant;

use photoncube_spec::{MACHINES, Machine};

use crate::compare::Divergence;
use crate::device::DeviceKind;
use crate::stimulus::{Source, chunk_seed};
use crate::verify::{VerifyError, VerifyOptions, verify};

pub use job::NumberedJob;
pub use minimise::minimised;
pub use regression::{Regression, RegressionError};
pub use state::{Done, Failure, State, StateError, Summary};

/// The intended duration of a job in seconds, which is the work that a kill may lose.
const JOB_SECONDS: f64 = 20.0;
/// The iterations of a machine's first job, before its speed is known: slightly more than a chunk.
const FIRST_ITERATIONS: u64 = 10_000;
/// The largest factor by which a job is longer than the one before it.
const GROWTH: f64 = 8.0;
/// The most queries at once of a machine in a campaign. Machines with more take minutes to build in any
/// Verilog simulator.
const LONGEST_CHAIN: usize = 8;

/// A machine and the device that is fastest for it.
pub type Pair = (&'static Machine, DeviceKind);

/// All named machines, each with the fastest device that verifies its emitted text.
pub fn pairs() -> Vec<Pair> {
    let fastest = |machine: &'static Machine| match machine.queries_at_once() > LONGEST_CHAIN {
        true => (machine, DeviceKind::Text),
        false => (machine, DeviceKind::Verilator),
    };
    MACHINES.iter().map(fastest).collect()
}

/// Stores the results of a campaign. One thread at a time calls it.
pub trait Keeper: Send {
    /// The error of a failure to store.
    type Error: From<VerifyError> + Send;

    /// Saves the state atomically.
    ///
    /// # Errors
    /// The state cannot be saved. The error ends the campaign.
    fn save(&mut self, state: &State) -> Result<(), Self::Error>;

    /// Stores a regression case of a difference and returns its place.
    ///
    /// # Errors
    /// The case cannot be stored. The error ends the campaign.
    fn keep(&mut self, pair: Pair, divergence: &Divergence) -> Result<String, Self::Error>;
}

/// The state that the workers share.
struct Shared<'a, K: Keeper> {
    state: &'a mut State,
    keeper: &'a mut K,
    in_flight: Vec<u64>,
    error: Option<K::Error>,
}

/// One verification to run.
#[derive(Copy, Clone)]
struct Job {
    index: u64,
    pair: Pair,
    seed: u64,
    iterations: u64,
}

/// Runs jobs on all cores until the deadline. Jobs that are under way then run to their end.
///
/// # Errors
/// A device does not run, or the keeper fails. A difference is not an error; it is recorded in the state.
pub fn campaign<K: Keeper>(
    state: &mut State,
    pairs: &[Pair],
    deadline: Instant,
    keeper: &mut K,
) -> Result<(), K::Error> {
    let shared = Mutex::new(Shared {
        state,
        keeper,
        in_flight: Vec::new(),
        error: None,
    });
    let workers = thread::available_parallelism().map_or(1, NonZero::get);
    thread::scope(|scope| {
        for _ in 0..workers {
            scope.spawn(|| work(&shared, pairs, deadline));
        }
    });
    let shared = shared.into_inner().expect("no worker panics");
    shared.error.map_or(Ok(()), Err)
}

fn work<K: Keeper>(shared: &Mutex<Shared<'_, K>>, pairs: &[Pair], deadline: Instant) {
    while Instant::now() < deadline {
        let Some(job) = lock(shared).begin(pairs) else {
            return;
        };
        let options = VerifyOptions {
            iterations: job.iterations,
            seed: job.seed,
            source: Source::Random,
        };
        let start = Instant::now();
        let result = verify(job.pair.0, job.pair.1, &options, &|_| ());
        let seconds = start.elapsed().as_secs_f64();
        let mut shared = lock(shared);
        if let Err(error) = shared.end(job, result, seconds) {
            shared.error.get_or_insert(error);
        }
    }
}

fn lock<'a, 'b, K: Keeper>(shared: &'a Mutex<Shared<'b, K>>) -> MutexGuard<'a, Shared<'b, K>> {
    shared.lock().expect("no worker panics")
}

impl<K: Keeper> Shared<'_, K> {
    /// The next job; `None` where all pairs have failed.
    fn begin(&mut self, pairs: &[Pair]) -> Option<Job> {
        let sound: Vec<_> = pairs
            .iter()
            .filter(|(machine, device)| !self.state.has_failed(machine, *device))
            .collect();
        if self.error.is_some() || sound.is_empty() {
            return None;
        }
        let is_taken = |index: &u64| self.in_flight.contains(index) || self.state.is_done(*index);
        let index = (0..).find(|index| !is_taken(index))?;
        self.in_flight.push(index);
        let pair = *sound[index as usize % sound.len()];
        Some(Job {
            index,
            pair,
            seed: chunk_seed(self.state.seed, index),
            iterations: self.state.iterations(pair),
        })
    }

    fn end(
        &mut self,
        job: Job,
        result: Result<crate::verify::Verdict, VerifyError>,
        seconds: f64,
    ) -> Result<(), K::Error> {
        self.in_flight.retain(|&index| index != job.index);
        let (machine, device) = job.pair;
        match result {
            Ok(verdict) => self.state.jobs.push(Done {
                job: job.index,
                seconds,
                verdict: verdict.into(),
            }),
            // Another worker may have found the failure too.
            Err(VerifyError::Diverged(_)) if self.state.has_failed(machine, device) => {}
            Err(VerifyError::Diverged(divergence)) => {
                let file = self.keeper.keep(job.pair, &divergence)?;
                self.state.failures.push(Failure {
                    machine: machine.name.to_owned(),
                    device: device.name().to_owned(),
                    seed: job.seed,
                    divergence: divergence.to_string(),
                    file,
                });
            }
            Err(error) => return Err(error.into()),
        }
        self.keeper.save(self.state)
    }
}
