//! The command `microprogram` for an overlapped machine: its modulo schedule.

use anyhow::Result;
use photoncube_spec::overlap::{Program, ProgramReport, check_program, program_report};
use photoncube_spec::{Machine, OVERLAPPED, UnitUse};
use serde::Serialize;

use crate::failure::CheckFailed;
use crate::narrow::narrow;
use crate::output;

#[derive(Serialize)]
struct Report {
    machine: &'static str,
    photons_per_iteration: usize,
    /// The clocks for as many photons, on average over a pass of the kernel.
    initiation_interval: f64,
    kernel_clocks: u32,
    groups_per_pass: usize,
    resource_bound: f64,
    latency_clocks: u32,
    latency_clocks_one_group: u64,
    photon_tests_per_clock: f64,
    utilisation: f64,
    units: Vec<UnitRow>,
    listing: String,
    accepted: bool,
    verdict: String,
}

#[derive(Serialize)]
struct UnitRow {
    unit: &'static str,
    utilisation: f64,
    resource_bound: f64,
}

/// Prints the machine's program and the checker's verdict.
pub fn execute(machine: &'static Machine, json: bool) -> Result<()> {
    let report = report(machine);
    output::print(json, &report, || narrow(&text(&report)))?;
    if report.accepted {
        return Ok(());
    }
    Err(CheckFailed(format!(
        "{} is rejected: {}",
        report.machine, report.verdict
    ))
    .into())
}

fn report(machine: &'static Machine) -> Report {
    let program = machine
        .overlap_program()
        .expect("the machine's units overlap");
    let schedule = program_report(&program);
    let verdict = check_program(&program);
    let per_group = |clocks: u32| f64::from(clocks) / schedule.groups as f64;
    Report {
        machine: machine.name,
        photons_per_iteration: machine.photons_per_iteration(),
        initiation_interval: per_group(schedule.interval),
        kernel_clocks: schedule.interval,
        groups_per_pass: schedule.groups,
        resource_bound: per_group(schedule.resource_bound),
        latency_clocks: schedule.latency_clocks,
        latency_clocks_one_group: program.latency_clocks(1),
        photon_tests_per_clock: machine.photon_tests_per_clock(),
        utilisation: schedule.unit_utilisation(),
        units: unit_rows(&schedule),
        listing: listing(&program),
        accepted: verdict.is_ok(),
        verdict: match verdict {
            Ok(()) => "accepted".to_owned(),
            Err(error) => error.to_string(),
        },
    }
}

fn unit_rows(schedule: &ProgramReport) -> Vec<UnitRow> {
    let row = |unit: &UnitUse| UnitRow {
        unit: unit.unit.name(),
        utilisation: unit.utilisation(),
        resource_bound: f64::from(unit.bound) / schedule.groups as f64,
    };
    schedule.units.iter().map(row).collect()
}

/// The program, with the meaning of its words.
fn listing(program: &Program) -> String {
    let mut text = format!("{program}ops:\n");
    for row in OVERLAPPED.ops {
        let unit = row.unit.map_or("-", |unit| unit.name());
        text += &format!(
            "  {:<5} {unit:<12} latency {}  {}\n",
            row.op.mnemonic(),
            row.latency,
            row.formula
        );
    }
    text
}

fn text(report: &Report) -> String {
    let mut text = format!("machine {}\n\n{}\n", report.machine, report.listing);
    text += &format!(
        "{} clocks for {} photons: {} groups in {} clocks; the resources allow {}.\n",
        report.initiation_interval,
        report.photons_per_iteration,
        report.groups_per_pass,
        report.kernel_clocks,
        report.resource_bound
    );
    text += &format!(
        "A group is in the machine for {} clocks; a query of one group takes {}.\n",
        report.latency_clocks, report.latency_clocks_one_group
    );
    for unit in &report.units {
        text += &format!(
            "  {:<10} works {:>5.1} % of the time; alone it would allow {} clocks\n",
            unit.unit,
            100.0 * unit.utilisation,
            unit.resource_bound
        );
    }
    text += &format!(
        "Utilisation of the three units together: {:.1} %.\n",
        100.0 * report.utilisation
    );
    text + &format!("Schedule checker: {}\n", report.verdict)
}

#[cfg(test)]
mod tests {
    use super::*;
    use photoncube_spec::find_machine;

    #[test]
    fn the_overlapped_schedule_report() {
        let machine = find_machine("overlap").unwrap();
        insta::assert_snapshot!(text(&report(machine)));
    }
}
