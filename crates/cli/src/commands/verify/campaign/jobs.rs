//! A campaign of a number of jobs, which can be shared out.

use anyhow::Result;
use photoncube_hdl::{Level, emit};
use photoncube_spec::find_machine;
use photoncube_testbench::{Failure, NumberedJob, Pair, Summary, VerifyError, pairs};
use serde::{Deserialize, Serialize};

use super::{Campaign, Report, keep, outcome, totals};
use crate::commands::verify::outcome::Outcome;
use crate::shards::{Header, Ledger, Settings, Shard};
use crate::{digests, progress};

/// The result of a job.
#[derive(Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Found {
    /// No difference.
    Equal(Summary),
    /// The machine differed from its model.
    Differs(Failure),
}

/// The machines of these names, or all, each with its device.
pub fn pairs_of(names: &[String]) -> Result<Vec<Pair>> {
    if names.is_empty() {
        return Ok(pairs());
    }
    let machines = names.iter().map(|name| find_machine(name));
    let machines = machines.collect::<Result<Vec<_>, _>>()?;
    let is_named = |pair: &Pair| machines.iter().any(|machine| machine.name == pair.0.name);
    Ok(pairs().into_iter().filter(is_named).collect())
}

impl Campaign {
    /// Does the jobs of the shard that its state lacks.
    pub fn run_jobs(&self, jobs: u64) -> Result<Outcome> {
        let pairs = pairs_of(&self.machines)?;
        let shard = self.shard.shard.unwrap_or(Shard::WHOLE);
        let header = Header::new("verify campaign", self.settings(&pairs)?, Some(jobs), shard);
        let ledger = Ledger::open(self.shard.state.as_deref(), header)?;
        let to_do = ledger.to_do();
        let bar = progress::bar("jobs", 0);
        let run = |number| self.job(NumberedJob::new(&pairs, self.seed, number, self.iterations));
        let found = ledger.work(rayon::current_num_threads(), &bar, |&number| number, run)?;
        let equal = || found.values().filter_map(Found::equal);
        let failures: Vec<_> = found.values().filter_map(Found::differs).cloned().collect();
        let report = Report {
            seed: self.seed,
            vectors_compared: equal().map(|summary| summary.vectors_compared).sum(),
            totals: totals(Summary::totals(equal())),
            failures: &failures,
        };
        // The devices at work now; a campaign that only prints has none.
        let devices = to_do.iter().take(pairs.len());
        let devices = devices.map(|number| NumberedJob::new(&pairs, 0, *number, 1).pair.1);
        let options = format!(
            "--jobs {jobs} --iterations {} --seed {}",
            self.iterations, self.seed
        );
        outcome(&report, devices, &options)
    }

    fn job(&self, job: NumberedJob) -> Result<Found> {
        match job.run() {
            Ok(verdict) => Ok(Found::Equal(verdict.into())),
            Err(VerifyError::Diverged(divergence)) => {
                let file = keep(&self.regressions, job.pair, &divergence)?;
                Ok(Found::Differs(Failure {
                    machine: job.pair.0.name.to_owned(),
                    device: job.pair.1.name().to_owned(),
                    seed: job.seed,
                    divergence: divergence.to_string(),
                    file,
                }))
            }
            Err(error) => Err(error.into()),
        }
    }

    /// What other workers must have in common. The digest is that of the Verilog of all machines.
    fn settings(&self, pairs: &[Pair]) -> Result<Settings> {
        let emitted = pairs.iter().map(|pair| emit(pair.0, Level::Machine));
        let each = emitted.map(|emitted| Ok(emitted?.verilog_sha256()));
        let digest = digests::of_file(&each.collect::<Result<String>>()?);
        let machines = pairs.iter().map(|pair| pair.0.name);
        let settings = [
            ("--seed", self.seed.to_string()),
            ("--iterations", self.iterations.to_string()),
            ("--machine", machines.collect::<Vec<_>>().join(",")),
            ("Verilog, its SHA-256", digest),
        ];
        let settings = settings.map(|(name, value)| (name.to_owned(), value));
        Ok(settings.into())
    }
}

impl Found {
    fn equal(&self) -> Option<&Summary> {
        match self {
            Self::Equal(summary) => Some(summary),
            Self::Differs(_) => None,
        }
    }

    fn differs(&self) -> Option<&Failure> {
        match self {
            Self::Equal(_) => None,
            Self::Differs(failure) => Some(failure),
        }
    }
}
