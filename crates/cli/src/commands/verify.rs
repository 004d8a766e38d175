//! `verify`: a machine against the golden model.

use anyhow::Result;
use photoncube_spec::Machine;
use photoncube_testbench::{DeviceKind, Source, Verdict, VerifyError, VerifyOptions, verify};
use serde::Serialize;

use crate::args::VerifyArgs;
use crate::failure::CheckFailed;
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

/// Verifies in each device that was named, one after the other.
pub fn execute(args: &VerifyArgs, json: bool) -> Result<()> {
    let machine = args.machine.find()?;
    let devices = devices(&args.against)?;
    let mut report = Report {
        machine: machine.name,
        seed: args.seed,
        iterations: args.iterations,
        vectors_compared: 0,
        mismatches: 0,
        devices: Vec::new(),
        divergence: None,
    };
    for device in devices {
        let options = VerifyOptions {
            iterations: args.iterations,
            seed: args.seed,
            source: Source::Random,
        };
        match verify_with_bar(machine, device, &options) {
            Ok(verdict) => {
                report.vectors_compared += verdict.vectors_compared;
                report.mismatches += verdict.mismatches;
                report.devices.push(verdict);
            }
            Err(VerifyError::Diverged(divergence)) => {
                report.mismatches += 1;
                report.divergence = Some(divergence.to_string());
                break;
            }
            Err(error) => return Err(error.into()),
        }
    }
    output::print(json, &report, || verdict_table(&report.devices))?;
    match report.divergence {
        None => Ok(()),
        Some(divergence) => Err(CheckFailed(divergence).into()),
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

/// The devices of `--against`, each once, in the order given.
fn devices(names: &[String]) -> Result<Vec<DeviceKind>> {
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

/// What was compared, for people.
pub fn verdict_table(verdicts: &[Verdict]) -> String {
    let header = [
        "device",
        "iterations",
        "results",
        "vectors",
        "signals each",
        "mismatches",
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
            verdict.mismatches.to_string(),
            verdict.tool_version.clone(),
        ]
    };
    table::markdown(&header, &verdicts.iter().map(row).collect::<Vec<_>>())
}
