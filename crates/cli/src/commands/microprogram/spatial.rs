//! The command `microprogram` for a spatial machine, whose cells keep their instructions.

use anyhow::Result;
use photoncube_spec::{EngineUnits, Machine, Spatial};
use serde::Serialize;

use crate::narrow::narrow;
use crate::{output, table};

#[derive(Serialize)]
struct Report {
    machine: &'static str,
    photons_per_iteration: usize,
    queries_at_once: usize,
    initiation_interval: f64,
    latency_clocks: u32,
    batch_gap_clocks: u32,
    least_batch_clocks: u32,
    photon_tests_per_clock: f64,
    cells: usize,
    squares_per_engine: usize,
    gates_per_engine: usize,
    adders_per_engine: usize,
    steps: Vec<Step>,
}

#[derive(Serialize)]
struct Step {
    clock: u32,
    cells: &'static str,
    unit: &'static str,
    step: &'static str,
    registered: bool,
}

/// Prints the steps of a group through the machine.
pub fn execute(machine: &'static Machine, spatial: &Spatial, json: bool) -> Result<()> {
    let report = report(machine, spatial);
    output::print(json, &report, || narrow(&text(&report)))
}

fn report(machine: &'static Machine, spatial: &Spatial) -> Report {
    let units = EngineUnits::of(machine.channels().names().len());
    Report {
        machine: machine.name,
        photons_per_iteration: machine.photons_per_iteration(),
        queries_at_once: machine.queries_at_once(),
        initiation_interval: machine.rate().interval(),
        latency_clocks: spatial.latency_clocks(),
        batch_gap_clocks: spatial.batch_gap_clocks(),
        least_batch_clocks: spatial.least_batch_clocks(),
        photon_tests_per_clock: machine.photon_tests_per_clock(),
        cells: machine.hypercube().nodes(),
        squares_per_engine: units.squares,
        gates_per_engine: units.gates,
        adders_per_engine: units.adds(),
        steps: (spatial.flow(machine.squarer).into_iter())
            .map(|row| Step {
                clock: row.clock,
                cells: row.cells,
                unit: row.units,
                step: row.step,
                registered: row.registered,
            })
            .collect(),
    }
}

fn text(report: &Report) -> String {
    let row = |step: &Step| {
        let clock = match step.registered {
            true => step.clock.to_string(),
            // Without a register, the step happens before the register of that clock.
            false => format!("({})", step.clock),
        };
        [&clock, step.cells, step.unit, step.step]
            .map(str::to_owned)
            .to_vec()
    };
    let rows: Vec<_> = report.steps.iter().map(row).collect();
    format!(
        "machine {}: every cell keeps its instruction; a group's way through an engine\n\n{}\n\
         A clock in parentheses has no register of its own. A group of {} photons enters every\n\
         clock and meets {} quer{} ({} cells), so every unit works in every clock: in an engine\n\
         {} squares, {} gates and {} adds, which on one adder for each of its 16 cells would take\n\
         1.5 clocks; Y and D cells have two. The first result comes {} clocks after the last group.\n\
         {}",
        report.machine,
        table::markdown(&["clock", "cells", "units", "step"], &rows),
        report.photons_per_iteration,
        report.queries_at_once,
        if report.queries_at_once == 1 {
            "y"
        } else {
            "ies"
        },
        report.cells,
        report.squares_per_engine,
        report.gates_per_engine,
        report.adders_per_engine,
        report.latency_clocks,
        batch_line(report),
    )
}

/// A line that states the clocks of a change of the batch, where there are any.
fn batch_line(report: &Report) -> String {
    match (report.batch_gap_clocks, report.least_batch_clocks) {
        (0, 1) => String::new(),
        (0, least) => {
            format!("From one batch of queries to the next are at least {least} clocks.\n")
        }
        (gap, least) => format!(
            "After a batch of queries no group enters for {gap} clocks, and from one batch to the next are at least\n\
             {least} clocks.\n"
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use photoncube_spec::find_machine;

    #[test]
    fn the_way_through_the_stream_machine() {
        let machine = find_machine("stream").unwrap();
        insta::assert_snapshot!(text(&report(machine, machine.spatial().unwrap())));
    }

    #[test]
    fn a_tile_says_what_a_batch_costs() {
        let text_of = |name| {
            let machine = find_machine(name).unwrap();
            text(&report(machine, machine.spatial().unwrap()))
        };
        assert!(text_of("tile-6").ends_with("to the next are at least 7 clocks.\n"));
        let mixed = text_of("tile-6-mixed");
        assert!(mixed.contains("no group enters for 3 clocks"), "{mixed}");
        assert!(mixed.contains("at least\n10 clocks"), "{mixed}");
    }
}
