//! The state of a campaign: the jobs that are done and the failures.

use std::collections::BTreeMap;

use photoncube_spec::Machine;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::{FIRST_ITERATIONS, GROWTH, JOB_SECONDS, Pair};
use crate::device::DeviceKind;
use crate::verify::Verdict;

/// The results of a campaign, which are stored as a JSON file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct State {
    /// The campaign's seed, from which the seeds of the jobs follow.
    pub seed: u64,
    /// The jobs that ended without a difference, each once, in the order in which they ended.
    pub jobs: Vec<Done>,
    /// The differences that were found.
    pub failures: Vec<Failure>,
}

/// A job that ended without a difference.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Done {
    /// The job's number in the campaign.
    pub job: u64,
    /// The job's duration in seconds.
    pub seconds: f64,
    /// The amount that was compared.
    #[serde(flatten)]
    pub verdict: Summary,
}

/// A [`Verdict`] in the form that is stored: the data that reproduces it, and the amounts compared.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// The name of the machine.
    pub machine: String,
    /// SHA-256 of the machine's emitted Verilog, see [`Verdict::verilog_sha256`].
    pub verilog_sha256: Option<String>,
    /// The name of the device.
    pub device: String,
    /// The tool behind the device, with its version.
    pub tool_version: String,
    /// The seed of the stimulus.
    pub seed: u64,
    /// The number of groups whose sums were taken.
    pub iterations: u64,
    /// The number of results taken.
    pub results_compared: u64,
    /// The number of clocks. Every visible signal was compared in each.
    pub vectors_compared: u64,
}

impl From<Verdict> for Summary {
    fn from(verdict: Verdict) -> Self {
        Self {
            machine: verdict.machine.to_owned(),
            verilog_sha256: verdict.verilog_sha256,
            device: verdict.device,
            tool_version: verdict.tool_version,
            seed: verdict.seed,
            iterations: verdict.iterations,
            results_compared: verdict.results_compared,
            vectors_compared: verdict.vectors_compared,
        }
    }
}

impl Summary {
    /// For each machine and tool, the sum of its jobs, with the first job's seed, and the number of jobs.
    pub fn totals<'a>(jobs: impl Iterator<Item = &'a Self>) -> Vec<(Self, usize)> {
        let mut totals: BTreeMap<_, (Self, usize)> = BTreeMap::new();
        for job in jobs {
            let key = (&job.machine, &job.device, &job.tool_version);
            match totals.get_mut(&key) {
                None => drop(totals.insert(key, (job.clone(), 1))),
                Some((total, jobs)) => {
                    total.iterations += job.iterations;
                    total.results_compared += job.results_compared;
                    total.vectors_compared += job.vectors_compared;
                    *jobs += 1;
                }
            }
        }
        totals.into_values().collect()
    }
}

/// A machine that differed from its model in a device. The campaign continues without this pair.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Failure {
    /// The name of the machine.
    pub machine: String,
    /// The name of the device.
    pub device: String,
    /// The seed of the job.
    pub seed: u64,
    /// A description of the difference.
    pub divergence: String,
    /// The file of the regression case that was made of it.
    pub file: String,
}

/// The error of a text that is not a campaign's state.
#[derive(Debug, Error)]
pub enum StateError {
    /// The text does not have the format of a state.
    #[error(
        "it is not the state of a campaign; expected what `verify campaign` writes: give another \
         file with --state, or remove this one to start anew"
    )]
    Format(#[from] serde_json::Error),
    /// A job occurs twice.
    #[error("job {0} is there twice; remove one of the two")]
    Twice(u64),
}

impl State {
    /// A state without jobs.
    pub fn new(seed: u64) -> Self {
        Self {
            seed,
            jobs: Vec::new(),
            failures: Vec::new(),
        }
    }

    /// Parses the output of [`Self::text`].
    ///
    /// # Errors
    /// The text is not a campaign's state.
    pub fn parse(text: &str) -> Result<Self, StateError> {
        let state: Self = serde_json::from_str(text)?;
        let mut jobs: Vec<_> = state.jobs.iter().map(|done| done.job).collect();
        jobs.sort_unstable();
        match jobs.windows(2).find(|pair| pair[0] == pair[1]) {
            Some(pair) => Err(StateError::Twice(pair[0])),
            None => Ok(state),
        }
    }

    /// The state as JSON text.
    pub fn text(&self) -> String {
        serde_json::to_string(self).expect("numbers and texts can be written") + "\n"
    }

    /// The number of vectors compared so far.
    pub fn vectors(&self) -> u64 {
        let vectors = self.jobs.iter().map(|done| done.verdict.vectors_compared);
        vectors.sum()
    }

    /// For each machine and tool, the sum of its jobs, with the first job's seed, and the number of jobs.
    pub fn totals(&self) -> Vec<(Summary, usize)> {
        Summary::totals(self.jobs.iter().map(|done| &done.verdict))
    }

    pub(super) fn is_done(&self, job: u64) -> bool {
        self.jobs.iter().any(|done| done.job == job)
    }

    pub(super) fn has_failed(&self, machine: &Machine, device: DeviceKind) -> bool {
        let found = |f: &Failure| f.machine == machine.name && f.device == device.name();
        self.failures.iter().any(found)
    }

    /// The number of iterations that take about [`JOB_SECONDS`], by the last job of this machine and device.
    pub(super) fn iterations(&self, (machine, device): Pair) -> u64 {
        let same = |done: &&Done| {
            done.verdict.machine == machine.name && done.verdict.device == device.name()
        };
        let Some(last) = self.jobs.iter().rev().find(same) else {
            return FIRST_ITERATIONS;
        };
        let factor = (JOB_SECONDS / last.seconds.max(1e-3)).min(GROWTH);
        ((last.verdict.iterations as f64 * factor) as u64).max(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn done(job: u64, seconds: f64) -> Done {
        Done {
            job,
            seconds,
            verdict: Summary {
                machine: "paper".into(),
                verilog_sha256: Some("00".into()),
                device: "verilator".into(),
                tool_version: "5".into(),
                seed: job,
                iterations: 1_000,
                results_compared: 10,
                vectors_compared: 9_000,
            },
        }
    }

    #[test]
    fn a_state_is_read_as_it_was_written_and_another_text_is_refused() {
        let mut state = State::new(u64::MAX);
        state.jobs = vec![done(1, 0.1), done(0, 2.5)];
        assert_eq!(State::parse(&state.text()).unwrap(), state);
        assert_eq!(state.vectors(), 18_000);
        let (total, jobs) = &state.totals()[0];
        assert_eq!((total.vectors_compared, *jobs), (18_000, 2));
        state.jobs.push(done(1, 1.0));
        let twice = State::parse(&state.text());
        assert!(matches!(twice, Err(StateError::Twice(1))));
        assert!(State::parse("[]").is_err());
    }

    #[test]
    fn a_job_is_as_long_as_the_last_one_was_fast_and_grows_slowly() {
        let pair = (
            photoncube_spec::find_machine("paper").unwrap(),
            DeviceKind::Verilator,
        );
        let mut state = State::new(1);
        assert_eq!(state.iterations(pair), FIRST_ITERATIONS);
        state.jobs.push(done(0, JOB_SECONDS * 2.0));
        assert_eq!(state.iterations(pair), 500);
        state.jobs.push(done(1, 1e-6));
        assert_eq!(state.iterations(pair), 8_000);
    }
}
