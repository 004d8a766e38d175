//! The default method: compares a machine with the golden model in every visible signal and every clock.

use anyhow::Result;
use photoncube_spec::Machine;
use photoncube_testbench::{DeviceKind, Source, Verdict, VerifyError, VerifyOptions, verify};
use serde::Serialize;

use crate::args::VerifyArgs;
use crate::failure::CheckFailed;
use crate::verified::{Line, grouped, record};
use crate::{output, progress, table};

#[derive(Serialize)]
struct Report {
    machine: &'static str,
    seed: u64,
    iterations: u64,
    vectors_compared: u64,
    mismatches: u64,
    devices: Vec<Verdict>,
    divergence: Option<String>,
}

impl Report {
    fn new(machine: &Machine, args: &VerifyArgs) -> Self {
        Self {
            machine: machine.name,
            seed: args.seed,
            iterations: args.iterations,
            vectors_compared: 0,
            mismatches: 0,
            devices: Vec::new(),
            divergence: None,
        }
    }

    /// Records the verdict of a device, or the error that prevented one.
    fn record(&mut self, result: Result<Verdict, VerifyError>) -> Result<()> {
        match result {
            Ok(verdict) => {
                self.vectors_compared += verdict.vectors_compared;
                self.devices.push(verdict);
            }
            Err(VerifyError::Diverged(divergence)) => {
                self.vectors_compared += divergence.vectors_compared + 1;
                self.mismatches += 1;
                self.divergence = Some(divergence.to_string());
            }
            Err(error) => return Err(error.into()),
        }
        Ok(())
    }

    /// The lines of this report for the table of results.
    fn lines(&self) -> Vec<Line> {
        let line = |verdict: &Verdict| Line {
            method: "equivalence".to_owned(),
            by: format!("{}: {}", verdict.device, verdict.tool_version),
            volume: verdict.vectors_compared,
            unit: format!("vectors of {} signals", verdict.signals_per_vector),
            result: format!("{} mismatches", self.mismatches),
            command: format!(
                "photoncube verify --machine {} --against {} --iterations {} --seed {}",
                self.machine, verdict.device, self.iterations, self.seed
            ),
            ..Line::about(self.machine.to_owned(), verdict.verilog_sha256.clone())
        };
        self.devices.iter().map(line).collect()
    }

    fn conclusion(&self) -> Result<()> {
        match &self.divergence {
            None => Ok(()),
            Some(divergence) => Err(CheckFailed(divergence.clone()).into()),
        }
    }
}

/// Verifies in each given device, one after another, up to the first difference.
pub fn execute(args: &VerifyArgs, json: bool) -> Result<()> {
    let machine = args.machine.find()?;
    let mut report = Report::new(machine, args);
    let options = VerifyOptions {
        iterations: args.iterations,
        seed: args.seed,
        source: Source::Random,
    };
    for device in devices(args, &[DeviceKind::RustHdl, DeviceKind::Text])? {
        report.record(verify_with_bar(machine, device, &options))?;
        if report.divergence.is_some() {
            break;
        }
    }
    output::print(json, &report, || verdict_table(&report.devices))?;
    report.conclusion()?;
    match &args.record {
        Some(path) => record(path, &report.lines()),
        None => Ok(()),
    }
}

/// Verifies with a progress bar.
pub fn verify_with_bar(
    machine: &Machine,
    device: DeviceKind,
    options: &VerifyOptions<'_>,
) -> Result<Verdict, VerifyError> {
    let bar = progress::bar(device.name(), options.iterations);
    let verdict = verify(machine, device, options, &|done| bar.set_position(done));
    bar.finish_and_clear();
    verdict
}

/// The devices of `--against`, each once, in the given order; `default` without that option.
pub fn devices(args: &VerifyArgs, default: &[DeviceKind]) -> Result<Vec<DeviceKind>> {
    let Some(names) = &args.against else {
        return Ok(default.to_vec());
    };
    let mut devices = Vec::new();
    for name in names {
        let named = match name.as_str() {
            "all" => DeviceKind::ALL.to_vec(),
            name => vec![DeviceKind::from_name(name)?],
        };
        for device in named {
            if !devices.contains(&device) {
                devices.push(device);
            }
        }
    }
    Ok(devices)
}

/// A table of the comparisons, for people.
pub fn verdict_table(verdicts: &[Verdict]) -> String {
    let header = [
        "device",
        "iterations",
        "results",
        "vectors",
        "signals each",
        "clocks/s",
        "tool",
    ];
    let row = |verdict: &Verdict| {
        let scope = match verdict.registers_compared {
            true => "all registers",
            false => "outputs only",
        };
        vec![
            verdict.device.clone(),
            verdict.iterations.to_string(),
            verdict.results_compared.to_string(),
            verdict.vectors_compared.to_string(),
            format!("{} ({scope})", verdict.signals_per_vector),
            grouped(verdict.clocks_per_second),
            verdict.tool_version.clone(),
        ]
    };
    table::markdown(&header, &verdicts.iter().map(row).collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
    use std::process::ExitCode;

    use clap::Parser;
    use photoncube_spec::find_machine;
    use photoncube_testbench::{Mutant, verify_device};

    use super::*;
    use crate::args::{Args, Command};
    use crate::failure::exit_code;

    #[test]
    fn a_divergence_is_reported_and_ends_1() {
        let args = Args::parse_from(["photoncube", "verify", "--iterations", "10"]);
        let Command::Verify(args) = args.command else {
            panic!("parsed as {args:?}");
        };
        let machine = find_machine("paper").unwrap();
        let options = VerifyOptions {
            iterations: args.iterations,
            seed: args.seed,
            source: Source::Random,
        };
        // A device that is the golden model, except for the first register of the last cell.
        let flip = |_clock, row: &mut [u64]| {
            if let Some(register) = row.iter_mut().rev().nth(5) {
                *register ^= 1;
            }
        };
        let mut mutant = Mutant::sound(machine).with_row_fault(flip);
        let result = verify_device(machine, &mut mutant, &options, &|_| {});
        let mut report = Report::new(machine, &args);
        report.record(result).unwrap();
        assert_eq!(report.mismatches, 1);
        let error = report.conclusion().unwrap_err();
        assert_eq!(exit_code(&error), ExitCode::from(1));
        let message = error.to_string();
        assert!(message.contains("node 15, register q"), "{message}");
        assert!(message.contains("repeat    photoncube verify"), "{message}");
    }
}
