//! The method `--mutants`: mutants of a machine's emitted Verilog are killed, equivalent or survive.

use anyhow::{Result, bail};
use photoncube_spec::Machine;
use photoncube_testbench::{
    Fate, Judged, MutantOptions, MutantPart, MutantReport, VerifyError, mutants,
};

use crate::args::VerifyArgs;
use crate::failure::CheckFailed;
use crate::verified::{Line, grouped, record};
use crate::{output, progress, table};

/// The iterations for each mutant before proofs are tried.
const ITERATIONS: u64 = 3_000;

/// Draws mutants, kills as many as possible, and proves the others equivalent. A survivor fails.
pub fn execute(args: &VerifyArgs, wanted: u64, json: bool) -> Result<()> {
    let machine = args.machine.find()?;
    let options = MutantOptions {
        part: part(machine, args.part.as_deref())?,
        mutants: wanted,
        seed: args.seed,
        iterations: ITERATIONS,
        more_iterations: args.iterations,
    };
    let bar = progress::bar("mutants", wanted);
    let report = match mutants(machine, &options, &|done| bar.set_position(done)) {
        Ok(report) => report,
        Err(VerifyError::Diverged(divergence)) => bail!(CheckFailed(divergence.to_string())),
        Err(error) => return Err(error.into()),
    };
    bar.finish_and_clear();
    output::print(json, &report, || text(&report))?;
    if let Some(path) = &args.record {
        record(path, &[line(&report, wanted, args.iterations)?])?;
    }
    match report.count(Fate::Survived) {
        0 => Ok(()),
        survived => {
            let message = format!(
                "{survived} mutants survived: the stimulus has a hole where none is equivalent"
            );
            Err(CheckFailed(message).into())
        }
    }
}

/// The part of that name; the whole machine without a name.
fn part(machine: &Machine, name: Option<&str>) -> Result<MutantPart> {
    let parts = MutantPart::of(machine);
    let named = |part: &&MutantPart| name.is_none_or(|name| part.name() == name);
    match parts.iter().find(named) {
        Some(part) => Ok(*part),
        None => bail!(
            "--part: machine `{}` has no part `{}` that is mutated for itself; it has: {}",
            machine.name,
            name.unwrap_or_default(),
            parts
                .iter()
                .map(|part| part.name())
                .collect::<Vec<_>>()
                .join(", ")
        ),
    }
}

fn line(report: &MutantReport, wanted: u64, iterations: u64) -> Result<Line> {
    let whole = MutantPart::Machine.name();
    let part = if report.part == whole {
        ""
    } else {
        report.part
    };
    let option = if part.is_empty() {
        String::new()
    } else {
        format!(" --part {part}")
    };
    Ok(Line {
        method: match part {
            "" => "mutants".to_owned(),
            part => format!("mutants of its {part}"),
        },
        by: report.tool_version.clone(),
        volume: report.mutants.len() as u64,
        unit: "mutants".to_owned(),
        result: format!(
            "{} killed, {} proven equivalent, {} survived",
            report.count(Fate::Killed),
            report.count(Fate::Equivalent),
            report.count(Fate::Survived)
        ),
        command: format!(
            "photoncube verify --mutants {wanted} --machine {}{option} --iterations {iterations} --seed {}",
            report.machine, report.seed
        ),
        ..Line::of_machine(report.machine)?
    })
}

fn text(report: &MutantReport) -> String {
    let row = |(module, counts): (&str, [usize; 3])| {
        let mut row = vec![module.to_owned()];
        row.extend(counts.map(|count| count.to_string()));
        row
    };
    let mut rows: Vec<_> = report.counts().into_iter().map(row).collect();
    let fates = [Fate::Killed, Fate::Equivalent, Fate::Survived];
    rows.push(row(("all", fates.map(|fate| report.count(fate)))));
    let alive = |judged: &&Judged| judged.fate != Fate::Killed;
    let left: Vec<_> = report
        .mutants
        .iter()
        .filter(alive)
        .map(|judged| {
            let fate = match judged.fate {
                Fate::Equivalent => "equivalent",
                _ => "SURVIVED",
            };
            vec![
                judged.mutation.mutant.to_string(),
                judged.mutation.module.clone(),
                fate.to_owned(),
                judged.reason.clone().unwrap_or_default(),
                judged.mutation.options.clone(),
            ]
        })
        .collect();
    format!(
        "{}\n{}\n{}: {} mutants, {} vectors compared; the proofs were refuted on {} killed \
         ones\n",
        table::markdown(&["module", "killed", "equivalent", "survived"], &rows),
        table::markdown(&["mutant", "module", "", "because", "`mutate`"], &left),
        report.machine,
        report.mutants.len(),
        grouped(report.vectors_compared),
        report.controls
    )
}
