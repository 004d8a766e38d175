//! A campaign: verifications with seed after seed, on all cores, until time is up.
//!
//! What is done stands in a [`State`], which is saved after each job. A campaign that was killed goes on with the
//! jobs that its state lacks; a job that was under way is done again.

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

pub use minimise::minimised;
pub use regression::{Regression, RegressionError};
pub use state::{Done, Failure, State, StateError, Summary};

/// A job is made about so long, in seconds: a kill costs no more.
const JOB_SECONDS: f64 = 20.0;
/// Iterations of a machine's first job, when nobody knows how fast it is: a chunk and a bit.
const FIRST_ITERATIONS: u64 = 10_000;
/// The most by which a job is longer than the one before it.
const GROWTH: f64 = 8.0;
/// Above so many queries at once, a machine takes minutes to build in any Verilog simulator.
const LONGEST_CHAIN: usize = 8;

/// A machine in the device that is fastest for it.
pub type Pair = (&'static Machine, DeviceKind);

/// All named machines, each in the fastest device that proves its emitted text.
pub fn pairs() -> Vec<Pair> {
    let fastest = |machine: &'static Machine| match machine.queries_at_once() > LONGEST_CHAIN {
        true => (machine, DeviceKind::Text),
        false => (machine, DeviceKind::Verilator),
    };
    MACHINES.iter().map(fastest).collect()
}

/// What a campaign does with what it finds. It is called by one thread at a time.
pub trait Keeper: Send {
    /// What it fails with.
    type Error: From<VerifyError> + Send;

    /// Saves the state, whole or not at all.
    ///
    /// # Errors
    /// It cannot be saved, which ends the campaign.
    fn save(&mut self, state: &State) -> Result<(), Self::Error>;

    /// Makes a regression case of a difference, and says where it is.
    ///
    /// # Errors
    /// It cannot be saved, which ends the campaign.
    fn keep(&mut self, pair: Pair, divergence: &Divergence) -> Result<String, Self::Error>;
}

/// What the workers share.
struct Shared<'a, K: Keeper> {
    state: &'a mut State,
    keeper: &'a mut K,
    in_flight: Vec<u64>,
    error: Option<K::Error>,
}

/// One verification to be done.
#[derive(Copy, Clone)]
struct Job {
    index: u64,
    pair: Pair,
    seed: u64,
    iterations: u64,
}

/// Runs jobs on all cores until the deadline; those that are under way then are done to their end.
///
/// # Errors
/// A device does not run, or the keeper fails. A difference is no error: it is in the state.
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
    /// The next job; none where nothing can go on.
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
            // Another worker may have found it too.
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
