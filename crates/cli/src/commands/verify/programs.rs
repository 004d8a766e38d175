//! The method `--programs`: random microprograms in a machine.

use anyhow::{Result, bail};
use photoncube_testbench::{
    DeviceKind, ProgramOptions, ProgramVerdict, ProgramsError, verify_programs,
};
use serde::Serialize;

use super::equivalence::devices;
use crate::args::VerifyArgs;
use crate::failure::CheckFailed;
use crate::verified::{Line, grouped, record};
use crate::{output, progress, table};

/// The iterations of the whole machine for each program.
const ITERATIONS: u64 = 100;

#[derive(Serialize)]
struct Report {
    verdicts: Vec<ProgramVerdict>,
}

/// Draws programs and compares each in each given device.
pub fn execute(args: &VerifyArgs, programs: u64, json: bool) -> Result<()> {
    let machine = args.machine.find()?;
    let options = ProgramOptions {
        programs,
        seed: args.seed,
        iterations: ITERATIONS,
    };
    let mut verdicts = Vec::new();
    for device in devices(args, &[DeviceKind::Text])? {
        let bar = progress::bar(device.name(), programs);
        let open = |machine: &_, level| device.open(machine, level);
        let verdict = verify_programs(machine, &options, &open, &|| bar.inc(1));
        bar.finish_and_clear();
        match verdict {
            Ok(verdict) => verdicts.push(verdict),
            Err(ProgramsError::Failed(failure)) => bail!(CheckFailed(failure.to_string())),
            Err(error) => return Err(error.into()),
        }
    }
    let report = Report { verdicts };
    output::print(json, &report, || text(&report))?;
    match &args.record {
        Some(path) => {
            let lines: Vec<_> = report.verdicts.iter().map(line).collect::<Result<_>>()?;
            record(path, &lines)
        }
        None => Ok(()),
    }
}

fn line(verdict: &ProgramVerdict) -> Result<Line> {
    let vectors = verdict.cell_vectors + verdict.vectors_compared;
    Ok(Line {
        method: "random programs".to_owned(),
        by: format!("{}: {}", verdict.device, verdict.tool_version),
        volume: verdict.programs as u64,
        unit: "programs, each in one cell and in all".to_owned(),
        result: format!(
            "equal in {} vectors; {} programs are gathers",
            grouped(vectors),
            verdict.gather_programs
        ),
        command: format!(
            "photoncube verify --programs {} --machine {} --against {} --seed {}",
            verdict.programs, verdict.machine, verdict.device, verdict.seed
        ),
        ..Line::of_machine(verdict.machine)?
    })
}

fn text(report: &Report) -> String {
    let header = [
        "device",
        "programs",
        "gathers",
        "drawn",
        "steps",
        "vectors of one cell",
        "vectors of the machine",
        "results",
        "tool",
    ];
    let row = |verdict: &ProgramVerdict| {
        vec![
            verdict.device.clone(),
            verdict.programs.to_string(),
            verdict.gather_programs.to_string(),
            grouped(verdict.drawn),
            grouped(verdict.steps),
            grouped(verdict.cell_vectors),
            grouped(verdict.vectors_compared),
            grouped(verdict.results_compared),
            verdict.tool_version.clone(),
        ]
    };
    let rows: Vec<_> = report.verdicts.iter().map(row).collect();
    table::markdown(&header, &rows)
}
