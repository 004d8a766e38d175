//! The command `microprogram`: the schedule, its utilisation, and the checker's verdict.

mod overlap;
mod spatial;

use anyhow::{Result, bail};
use photoncube_spec::{
    MACHINES, Machine, Microprogram, ScheduleReport, check_schedule, schedule_report,
};
use serde::Serialize;

use crate::args::MicroprogramArgs;
use crate::failure::CheckFailed;
use crate::output;
use crate::own_program::read;

#[derive(Serialize)]
struct Report {
    machine: &'static str,
    source: String,
    photons_per_iteration: usize,
    initiation_interval: u32,
    query_clocks: u32,
    latency_clocks_one_group: u64,
    photon_tests_per_clock: f64,
    utilisation: f64,
    unit_utilisation: f64,
    register_utilisation: f64,
    listing: String,
    accepted: bool,
    verdict: String,
}

/// Prints a machine's program, or checks a listing.
pub fn execute(args: &MicroprogramArgs, json: bool) -> Result<()> {
    let machine = args.machine.find()?;
    let (source, program) = match (&args.file, machine.microprogram(), machine.spatial()) {
        (Some(_), None, _) => {
            let with_program = MACHINES
                .iter()
                .filter(|machine| machine.microprogram().is_some());
            let names: Vec<_> = with_program.map(|machine| machine.name).collect();
            bail!(
                "--file: machine `{}` runs no microprogram, expected one of {}",
                machine.name,
                names.join(", ")
            )
        }
        (Some(path), ..) => (path.display().to_string(), read(path)?),
        (None, Some(program), _) => (format!("machine {}", machine.name), program),
        (None, None, Some(spatial)) => return spatial::execute(machine, spatial, json),
        (None, None, None) => return overlap::execute(machine, json),
    };
    let (report, schedule) = report(machine, source, &program);
    output::print(json, &report, || text(&report, &schedule))?;
    if report.accepted {
        return Ok(());
    }
    Err(CheckFailed(format!("{} is rejected: {}", report.source, report.verdict)).into())
}

fn report(
    machine: &'static Machine,
    source: String,
    program: &Microprogram,
) -> (Report, ScheduleReport) {
    let schedule = schedule_report(program, machine.hypercube());
    let verdict = check_schedule(program, machine.hypercube());
    let interval = schedule.initiation_interval;
    // An empty program has no rate, and JSON has no NaN.
    let rate = |value: f64| if interval == 0 { 0.0 } else { value };
    let report = Report {
        machine: machine.name,
        source,
        photons_per_iteration: schedule.photons,
        initiation_interval: interval,
        query_clocks: program.query_clocks(),
        latency_clocks_one_group: program.latency_clocks(1),
        photon_tests_per_clock: rate(schedule.photons as f64 / f64::from(interval)),
        utilisation: rate(schedule.utilisation()),
        unit_utilisation: rate(schedule.unit_utilisation()),
        register_utilisation: rate(schedule.register_utilisation()),
        listing: program.to_string(),
        accepted: verdict.is_ok(),
        verdict: match verdict {
            Ok(()) => "accepted".to_owned(),
            Err(error) => error.to_string(),
        },
    };
    (report, schedule)
}

/// The listing, with the other results as comments, so that `--file` reads all of it.
fn text(report: &Report, schedule: &ScheduleReport) -> String {
    let said = said(report, schedule);
    let said: String = said.lines().map(|line| format!("# {line}\n")).collect();
    format!("# {}\n\n{}\n{said}", report.source, report.listing)
}

fn said(report: &Report, schedule: &ScheduleReport) -> String {
    let percent = |value: f64| format!("{:.1} %", 100.0 * value);
    let mut text = format!(
        "{} clocks for {} photons; the query phase takes {}.\n",
        report.initiation_interval, report.photons_per_iteration, report.query_clocks
    );
    for unit in &schedule.units {
        text += &format!(
            "  {:<10} busy in {} of {} clocks\n",
            unit.unit.name(),
            unit.busy_clocks,
            report.initiation_interval
        );
    }
    text += &format!(
        "Utilisation: units {}, registers {}, both {}: the clocks in which one works, or is\n\
         read or written, over clocks x number. (The paper's own, 62 %, has no formula.)\n",
        percent(report.unit_utilisation),
        percent(report.register_utilisation),
        percent(report.utilisation)
    );
    text + &format!("Schedule checker: {}\n", report.verdict)
}

#[cfg(test)]
mod tests {
    use super::*;
    use photoncube_spec::{Axis, SEQUENTIAL, find_machine, parse_listing};

    #[test]
    fn the_papers_schedule_report() {
        let machine = find_machine("paper").unwrap();
        let (report, schedule) = report(
            machine,
            "paper".to_owned(),
            &machine.microprogram().unwrap(),
        );
        let text = text(&report, &schedule);
        assert_eq!(parse_listing(&text), Ok(machine.microprogram().unwrap()));
        insta::assert_snapshot!(text);
    }

    #[test]
    fn the_page_about_listings_has_todays_ops_and_registers_and_a_listing_that_is_accepted() {
        let page = include_str!("../../../../docs/microprograms.md");
        for row in SEQUENTIAL.ops {
            let unit = row.unit.map_or("-", |unit| unit.name());
            let line = format!("\n| `{}` | {unit} | {} |\n", row.op.mnemonic(), row.formula);
            assert!(page.contains(&line), "{line}");
        }
        for row in SEQUENTIAL.registers {
            assert!(
                page.contains(&format!("\n| `{}` | ", row.mnemonic)),
                "{}",
                row.name
            );
        }
        let names: Vec<_> = (0..10).filter_map(Axis::new).map(Axis::name).collect();
        assert!(page.contains(&format!("`{}`", names.join(" "))));
        let listing = page.split("```text\n").nth(1).unwrap();
        let listing = listing.split("```").next().unwrap();
        let paper = find_machine("paper").unwrap();
        let program = parse_listing(listing).unwrap();
        assert_eq!(check_schedule(&program, paper.hypercube()), Ok(()));
    }
}
