//! The method `--campaign`: all machines, with successive seeds, until a deadline.

use std::io::ErrorKind;
use std::path::Path;
use std::time::{Duration, Instant};

use anyhow::{Context, Result};
use indicatif::ProgressBar;
use photoncube_testbench::{
    Divergence, Failure, Keeper, Pair, State, Summary, campaign, minimised, pairs,
};
use serde::Serialize;

use crate::args::VerifyArgs;
use crate::failure::CheckFailed;
use crate::verified::{Line, grouped, record};
use crate::{files, output, progress, table};

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

impl<'a> Report<'a> {
    fn of(state: &'a State) -> Self {
        let total = |(summary, jobs)| Total { summary, jobs };
        Self {
            seed: state.seed,
            vectors_compared: state.vectors(),
            totals: state.totals().into_iter().map(total).collect(),
            failures: &state.failures,
        }
    }
}

/// Continues the campaign of a state file, or begins one, and prints its results.
pub fn execute(args: &VerifyArgs, hours: f64, json: bool) -> Result<()> {
    let mut state = read(&args.state)?.unwrap_or_else(|| State::new(rand::random()));
    let deadline = Instant::now() + Duration::from_secs_f64(hours * 3600.0);
    let mut files = Files {
        state: &args.state,
        regressions: &args.regressions,
        bar: progress::spinner("vectors compared:"),
    };
    files.bar.enable_steady_tick(Duration::from_millis(200));
    campaign(&mut state, &pairs(), deadline, &mut files)?;
    files.bar.finish_and_clear();
    let report = Report::of(&state);
    output::print(json, &report, || text(&report))?;
    if let Some(path) = &args.record {
        record(path, &lines(&report))?;
    }
    conclusion(&report)
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

    fn keep(&mut self, (machine, device): Pair, divergence: &Divergence) -> Result<String> {
        let mut open = || device.open(machine, photoncube_hdl::Level::Machine);
        let case = minimised(machine, divergence, &mut open)?;
        let name = format!("{}-{device}-{:016x}.json", machine.name, divergence.seed);
        let path = self.regressions.join(name);
        files::write(&path, case.text().as_bytes())?;
        Ok(path.display().to_string())
    }
}

/// A campaign without a vector fails, because it has shown nothing.
fn conclusion(report: &Report<'_>) -> Result<()> {
    if let Some(failure) = report.failures.first() {
        let message = format!(
            "{} failures; the first, kept in {}:\n{}",
            report.failures.len(),
            failure.file,
            failure.divergence
        );
        return Err(CheckFailed(message).into());
    }
    if report.vectors_compared == 0 {
        let message = "the campaign has compared nothing yet; give it time with --hours";
        return Err(CheckFailed(message.to_owned()).into());
    }
    Ok(())
}

fn lines(report: &Report<'_>) -> Vec<Line> {
    let line = |total: &Total| {
        let summary = &total.summary;
        let failed = |f: &&Failure| f.machine == summary.machine && f.device == summary.device;
        Line {
            method: "campaign".to_owned(),
            by: format!("{}: {}", summary.device, summary.tool_version),
            volume: summary.vectors_compared,
            unit: "vectors".to_owned(),
            result: format!(
                "{} mismatches; {} seeds",
                report.failures.iter().filter(failed).count(),
                total.jobs
            ),
            command: "photoncube verify --campaign --hours H".to_owned(),
            ..Line::about(summary.machine.clone(), summary.verilog_sha256.clone())
        }
    };
    report.totals.iter().map(line).collect()
}

fn text(report: &Report<'_>) -> String {
    let header = [
        "machine",
        "device",
        "seeds",
        "iterations",
        "results",
        "vectors",
    ];
    let row = |total: &Total| {
        let summary = &total.summary;
        vec![
            summary.machine.clone(),
            summary.device.clone(),
            total.jobs.to_string(),
            grouped(summary.iterations),
            grouped(summary.results_compared),
            grouped(summary.vectors_compared),
        ]
    };
    let rows: Vec<_> = report.totals.iter().map(row).collect();
    format!(
        "{}\n{} vectors compared, {} mismatches; seed {}\n",
        table::markdown(&header, &rows),
        grouped(report.vectors_compared),
        report.failures.len(),
        report.seed
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_done_is_no_pass_and_a_failure_is_told() {
        let mut state = State::new(1);
        assert!(conclusion(&Report::of(&state)).is_err());
        state.failures.push(Failure {
            machine: "paper".into(),
            device: "verilator".into(),
            seed: 1,
            divergence: "it differs".into(),
            file: "case.json".into(),
        });
        let error = conclusion(&Report::of(&state)).unwrap_err().to_string();
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
