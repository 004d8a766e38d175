//! What the cells of a machine do, clock by clock, as a table coloured by unit.

use maud::{Markup, html};
use photoncube_spec::overlap::{Program, program_report};
use photoncube_spec::{Machine, OVERLAPPED, Role, SEQUENTIAL, Unit, schedule_report};

use super::scrolling;
use super::trace::clock_names;

/// An entry: what is done, and the name of its unit.
type Entry = (String, &'static str);

/// The colours of the units.
pub fn units() -> Markup {
    html! {
        ul.legend {
            @for unit in [Unit::Square, Unit::Gate, Unit::Add] {
                li { span.mark.(unit.name()) {} (unit.name()) ": " (unit.formula()) }
            }
        }
    }
}

/// The schedule of a machine, coloured by [`units`].
pub fn schedule(machine: &Machine) -> Markup {
    let (says, header, rows) = match (
        machine.microprogram(),
        machine.overlap_program(),
        machine.spatial(),
    ) {
        (Some(program), ..) => {
            let report = schedule_report(&program, machine.hypercube());
            let steps = program.steps().into_iter().zip(clock_names(&program));
            let rows = steps.map(|(step, clock)| {
                let row = SEQUENTIAL.op(step.op);
                let unit = row.unit.map_or("", |unit| unit.module());
                vec![
                    (clock, ""),
                    (step.to_string(), unit),
                    (row.formula.to_owned(), ""),
                ]
            });
            (
                format!(
                    "All cells do one step a clock. The units work in {:.1} % of the clocks.",
                    100.0 * report.unit_utilisation()
                ),
                vec!["clock", "all cells", "meaning"],
                rows.collect(),
            )
        }
        (_, Some(program), _) => (
            format!(
                "Two groups enter every {} clocks. The units work in {:.1} % of the clocks. In the table, b3 is the second \
                 group of the iteration that began three passes ago.",
                program.interval,
                100.0 * program_report(&program).unit_utilisation()
            ),
            vec!["clock of the kernel", "X", "Y", "Z", "D"],
            kernel(&program),
        ),
        (_, _, Some(spatial)) => {
            let flow = spatial.flow(machine.squarer).into_iter().enumerate();
            let rows = flow.map(|(place, row)| {
                vec![
                    (place.to_string(), ""),
                    (row.clock.to_string(), ""),
                    (row.cells.to_owned(), ""),
                    (row.units.to_owned(), unit_of(row.units)),
                    (row.step.to_owned(), ""),
                ]
            });
            (
                format!(
                    "Each cell keeps its instruction, and a group of photons enters every clock: all units work in every clock. The \
                     rows are a group's way through an engine. With the clocks of the head and of the queue of results, {} pass from \
                     a batch's last group to its first result.",
                    spatial.latency_clocks()
                ),
                vec!["place", "clock", "cells", "units", "value"],
                rows.collect(),
            )
        }
        _ => (String::new(), Vec::new(), Vec::new()),
    };
    let caption = format!("The schedule of {}", machine.name);
    html! {
        p { (says) }
        (scrolling(&caption, table(&caption, &header, &rows)))
        @if machine.overlap_program().is_some() { (ops_of_overlap()) }
    }
}

/// The meaning of the entries of an overlapped machine's schedule.
fn ops_of_overlap() -> Markup {
    html! {
        p {
            "An entry is an op, the axis of the neighbour whose value it takes where it takes one, and the group. An entry such as "
            code { "2:b1" } " says that place 2 of the cell's queue of powers has the power of group b1."
        }
        ul.legend {
            @for row in OVERLAPPED.ops { li { code { (row.op.mnemonic()) } ": " (row.formula) } }
        }
    }
}

fn kernel(program: &Program) -> Vec<Vec<Entry>> {
    let of_clock = |clock: u32| {
        let roles = Role::ALL.into_iter();
        let roles = roles.map(|role| (program.listed(clock, role), ""));
        [(clock.to_string(), "")].into_iter().chain(roles).collect()
    };
    (0..program.interval).map(of_clock).collect()
}

/// The class of the first unit that is named.
fn unit_of(units: &str) -> &'static str {
    ["square_unit", "gate_unit", "add_unit"]
        .into_iter()
        .find(|unit| units.starts_with(unit.trim_end_matches("_unit")))
        .unwrap_or("")
}

fn table(caption: &str, header: &[&str], rows: &[Vec<Entry>]) -> Markup {
    html! {
        table.schedule.roles[header.len() == 1 + Role::ALL.len()] {
            caption { (caption) }
            thead { tr { @for title in header { th scope="col" { (title) } } } }
            tbody {
                @for row in rows {
                    tr {
                        @for (column, (text, unit)) in row.iter().enumerate() {
                            @if column == 0 { th scope="row" { (text) } } @else { td class=(unit) { (text) } }
                        }
                    }
                }
            }
        }
    }
}
