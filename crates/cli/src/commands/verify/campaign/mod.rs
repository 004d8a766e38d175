//! The method `campaign`: all machines, with successive seeds, until a deadline or for a number of jobs.

mod jobs;

use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail};
use clap::Args;
use indicatif::ProgressBar;
use photoncube_testbench::{
    DeviceKind, Divergence, Failure, Keeper, Pair, State, Summary, Tool, campaign,
    comparison_controls, minimised, pairs,
};
use serde::Serialize;

use super::method::Method;
use super::outcome::Outcome;
use crate::args::{count, seed};
use crate::shards::ShardArgs;
use crate::table::grouped;
use crate::verified::Line;
use crate::{files, progress};

/// See [`Method::ABOUT`].
#[derive(Args, Debug)]
pub struct Campaign {
    /// Begin no job of about 20 seconds after so long; 0: print what the campaign has done
    #[arg(long, value_name = "H", value_parser = hours, required_unless_present = "jobs", conflicts_with_all = ["jobs", "shard"])]
    hours: Option<f64>,
    /// Do so many jobs instead, which depend on --seed alone; the machines take turns
    #[arg(long, value_name = "N", value_parser = count(1..=u64::MAX))]
    jobs: Option<u64>,
    /// The iterations of a job of --jobs in Verilator; machines of more than 8 engines do a hundredth in the built-in evaluator
    #[arg(long, value_name = "N", default_value_t = 200_000, value_parser = count(1..=u64::MAX), requires = "jobs")]
    iterations: u64,
    /// Seed of the jobs of --jobs
    #[arg(long, value_name = "S", default_value_t = 1, value_parser = seed, requires = "jobs")]
    seed: u64,
    /// Only this machine, with --jobs; can be given several times [default: all]
    #[arg(long = "machine", value_name = "M", requires = "jobs")]
    machines: Vec<String>,
    #[command(flatten)]
    shard: ShardArgs,
    /// Where regression cases are kept; `cargo test` replays those of this folder
    #[arg(long, value_name = "DIR", default_value = "testbenches/regressions")]
    regressions: PathBuf,
}

/// The columns of the table.
const COLUMNS: &str = "machine device jobs iterations results_compared vectors_compared";

/// A time that a clock can hold.
fn hours(text: &str) -> Result<f64, String> {
    let hours: f64 = text.parse().map_err(|_| "expected a number".to_owned())?;
    match (0.0..=24.0 * 366.0).contains(&hours) {
        true => Ok(hours),
        false => Err("expected 0 up to a year".to_owned()),
    }
}

#[derive(Serialize)]
struct Report<'a> {
    seed: u64,
    vectors_compared: u64,
    totals: Vec<Total>,
    failures: &'a [Failure],
}

/// The sum of all jobs of a machine and a tool.
#[derive(Serialize)]
struct Total {
    #[serde(flatten)]
    summary: Summary,
    jobs: usize,
}

impl Method for Campaign {
    const NAME: &'static str = "campaign";
    const ABOUT: &'static str = "Verify all machines with seed after seed, on all cores; what is done stands in the file of \
        --state, so that a campaign that was stopped or killed goes on, and a difference becomes a regression case";
    const EXAMPLES: &'static [&'static str] = &[
        "photoncube verify campaign --hours 8",
        "photoncube verify campaign --jobs 1000 --shard 2/7 --state 2.jobs",
    ];

    /// None where the campaign only prints what it has done.
    fn tools(&self) -> Vec<Tool> {
        let pairs = match self.hours {
            Some(0.0) => Vec::new(),
            Some(_) => pairs(),
            // An unknown machine is an error when the method runs.
            None => jobs::pairs_of(&self.machines).unwrap_or_default(),
        };
        let tools = pairs.iter().flat_map(|pair| pair.1.tools());
        tools.copied().collect()
    }

    fn run(&self) -> Result<Outcome> {
        match (self.hours, self.jobs) {
            (Some(hours), _) => self.run_for(hours),
            (None, Some(jobs)) => self.run_jobs(jobs),
            (None, None) => bail!("expected --hours or --jobs"),
        }
    }
}

impl Campaign {
    fn run_for(&self, hours: f64) -> Result<Outcome> {
        let path = self.shard.state.clone();
        let path = path.unwrap_or_else(|| PathBuf::from(STATE));
        let mut state = read(&path)?.unwrap_or_else(|| State::new(rand::random()));
        let deadline = Instant::now() + Duration::from_secs_f64(hours * 3600.0);
        let mut files = Files {
            state: &path,
            regressions: &self.regressions,
            bar: progress::spinner("vectors compared:"),
        };
        files.bar.enable_steady_tick(Duration::from_millis(200));
        campaign(&mut state, &pairs(), deadline, &mut files)?;
        files.bar.finish_and_clear();
        let devices = pairs().into_iter().map(|pair| pair.1);
        let report = Report {
            seed: state.seed,
            vectors_compared: state.vectors(),
            totals: totals(state.totals()),
            failures: &state.failures,
        };
        outcome(&report, devices.filter(|_| hours > 0.0), "--hours H")
    }
}

/// The state of a campaign by time, where none is given.
const STATE: &str = "out/campaign.json";

fn totals(totals: Vec<(Summary, usize)>) -> Vec<Total> {
    let total = |(summary, jobs)| Total { summary, jobs };
    totals.into_iter().map(total).collect()
}

/// The outcome; `options` are those of the command.
fn outcome(
    report: &Report<'_>,
    devices: impl Iterator<Item = DeviceKind>,
    options: &str,
) -> Result<Outcome> {
    let sum = format!(
        "{} vectors compared, {} mismatches; seed {}",
        grouped(report.vectors_compared),
        report.failures.len(),
        report.seed
    );
    let controls = comparison_controls(devices)?;
    Ok(Outcome::new::<Campaign>(controls, report)?
        .rows("totals", COLUMNS)
        .note(sum)
        .lines(
            report
                .totals
                .iter()
                .map(|total| line(total, report.failures, options)),
        )
        .findings(findings(report)))
}

/// A campaign without a vector has shown nothing.
fn findings(report: &Report<'_>) -> Vec<String> {
    let failures = report.failures.iter();
    let failures = failures.map(|f| format!("kept in {}:\n{}", f.file, f.divergence));
    let nothing = report.vectors_compared == 0 && report.failures.is_empty();
    let nothing = nothing.then(|| {
        "the campaign has compared nothing yet; give it time with --hours or --jobs".to_owned()
    });
    failures.chain(nothing).collect()
}

fn line(total: &Total, failures: &[Failure], options: &str) -> Line {
    let summary = &total.summary;
    let failed = |f: &&Failure| f.machine == summary.machine && f.device == summary.device;
    Line {
        by: format!("{}: {}", summary.device, summary.tool_version),
        volume: summary.vectors_compared,
        unit: "vectors".to_owned(),
        result: format!(
            "{} mismatches; {} seeds",
            failures.iter().filter(failed).count(),
            total.jobs
        ),
        command: format!("photoncube verify campaign {options}"),
        ..Line::about(summary.machine.clone(), summary.verilog_sha256.clone())
    }
}

/// Reads the state in a file; `None` if the file does not exist.
fn read(path: &Path) -> Result<Option<State>> {
    match std::fs::read_to_string(path) {
        Ok(text) => {
            let state = State::parse(&text).with_context(|| path.display().to_string())?;
            Ok(Some(state))
        }
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error).with_context(|| format!("cannot read {}", path.display())),
    }
}

/// The files in which a campaign stores its results.
struct Files<'a> {
    state: &'a Path,
    regressions: &'a Path,
    bar: ProgressBar,
}

impl Keeper for Files<'_> {
    type Error = anyhow::Error;

    fn save(&mut self, state: &State) -> Result<()> {
        self.bar.set_position(state.vectors());
        files::write(self.state, state.text().as_bytes())
    }

    fn keep(&mut self, pair: Pair, divergence: &Divergence) -> Result<String> {
        keep(self.regressions, pair, divergence)
    }
}

/// Writes a regression case of a difference to a folder, as short as it can be made. Returns its path.
fn keep(folder: &Path, (machine, device): Pair, divergence: &Divergence) -> Result<String> {
    let mut open = || device.open(machine, photoncube_hdl::Level::Machine);
    let case = minimised(machine, divergence, &mut open)?;
    let name = format!("{}-{device}-{:016x}.json", machine.name, divergence.seed);
    let path = folder.join(name);
    files::write(&path, case.text().as_bytes())?;
    Ok(path.display().to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_done_is_no_pass_and_a_failure_is_told() {
        let mut state = State::new(1);
        let concluded = |state: &State| {
            let report = Report {
                seed: state.seed,
                vectors_compared: state.vectors(),
                totals: totals(state.totals()),
                failures: &state.failures,
            };
            let outcome = outcome(&report, [].into_iter(), "").unwrap();
            outcome.conclusion().unwrap_err()
        };
        assert!(concluded(&state).to_string().contains("--hours"));
        state.failures.push(Failure {
            machine: "paper".into(),
            device: "verilator".into(),
            seed: 1,
            divergence: "it differs".into(),
            file: "case.json".into(),
        });
        let error = concluded(&state).to_string();
        assert!(
            error.contains("case.json") && error.contains("it differs"),
            "{error}"
        );
    }

    #[test]
    fn a_file_that_is_no_state_is_refused_with_its_name_and_what_to_do() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("state.json");
        assert!(read(&path).unwrap().is_none());
        std::fs::write(&path, "{}").unwrap();
        let error = format!("{:#}", read(&path).unwrap_err());
        assert!(
            error.contains("state.json") && error.contains("--state"),
            "{error}"
        );
    }
}
