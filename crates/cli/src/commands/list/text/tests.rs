//! The pages that show figures hold the tables that are made of the measured figures.

use photoncube_spec::{Interface, MACHINES, Port};

use super::super::ports::{clocks, widths};
use super::super::report;
use super::*;
use crate::measured;
use crate::measured_fits::fit_rows;

const README: &str = include_str!("../../../../../../README.md");
const MACHINES_PAGE: &str = include_str!("../../../../../../docs/machines.md");
const PORTS_PAGE: &str = include_str!("../../../../../../docs/ports.md");
const FORMATS_PAGE: &str = include_str!("../../../../../../docs/formats.md");

/// The machines of the README: the paper's, one of each other organisation, and the two largest.
const FRONT_PAGE: [&str; 6] = [
    "paper",
    "overlap",
    "stream",
    "tile-6",
    "chip-lut",
    "chip-mixed",
];

/// The README's table: the six machines, without the columns that say what a stored photon and a register cost.
fn front_page_table(machines: &[MachineRow]) -> String {
    let columns: Vec<Column> = NARROW
        .iter()
        .filter(|(header, _)| !["FF", "bits"].contains(header))
        .copied()
        .collect();
    let find = |name| machines.iter().find(|row| row.machine == name);
    let rows = FRONT_PAGE.map(|name| find(name).expect("the README names machines that exist"));
    table_of(&columns, rows.into_iter()).markdown()
}

/// The lines of a page's tables that are longer than so many characters.
fn wide_rows(page: &str, longest: usize) -> Vec<&str> {
    let rows = page.lines().filter(|line| line.starts_with('|'));
    rows.filter(|line| line.chars().count() > longest).collect()
}

#[track_caller]
fn shows(page: &str, name: &str, table: &str) {
    assert!(
        page.contains(table),
        "{name} has another table; paste this:\n{table}"
    );
}

#[test]
fn the_readme_shows_six_machines_and_fits_a_screen() {
    shows(
        README,
        "README.md",
        &front_page_table(&report().unwrap().machines),
    );
    assert_eq!(wide_rows(README, table::COLUMNS), [""; 0]);
    let lines = README.lines().count();
    assert!(lines <= 150, "README.md has {lines} lines, 150 are enough");
}

#[test]
fn the_page_of_machines_shows_what_list_wide_prints() {
    let report = report().unwrap();
    let name = "docs/machines.md";
    for table in machine_tables(&report.machines).split("\n\n") {
        shows(MACHINES_PAGE, name, table);
    }
    let paper = tables::elsewhere(&report.machines[0].measured.areas);
    shows(MACHINES_PAGE, name, &paper);
    shows(MACHINES_PAGE, name, &measured::fmax_source().unwrap());
    assert_eq!(wide_rows(MACHINES_PAGE, 120), [""; 0]);
}

#[test]
fn the_page_of_ports_has_every_port_width_and_clock_of_every_machine() {
    let name = "docs/ports.md";
    for table in [widths(MACHINES.iter()), clocks(MACHINES.iter())] {
        shows(PORTS_PAGE, name, &table.markdown());
    }
    assert_eq!(wide_rows(PORTS_PAGE, table::COLUMNS), [""; 0]);
    let rows = PORTS_PAGE.lines().filter(|line| line.starts_with("| `"));
    let row = |port: &str| rows.clone().find(|row| row.contains(&format!("`{port}")));
    for machine in MACHINES {
        for Port {
            name: port, width, ..
        } in Interface::of(machine).ports
        {
            // A row begins with its first lane, its first axis or its first channel.
            let first = port
                .split("..")
                .next()
                .unwrap_or_default()
                .replace("_y", "_x");
            let first = first
                .replace("_z", "_x")
                .replace("_green", "_red")
                .replace("_blue", "_red");
            let row = row(&first).unwrap_or_else(|| panic!("{name} has no row of {first}"));
            assert!(width == 1 || !row.contains("| 1 "), "{first}: {width} bits");
        }
    }
}

#[test]
fn the_page_of_formats_shows_the_fits_that_list_wide_prints() {
    let fits = fit_table(&fit_rows().unwrap());
    for table in fits.split("\n\n") {
        shows(FORMATS_PAGE, "docs/formats.md", table);
    }
}

#[test]
fn a_wide_row_is_found() {
    let page = format!("{}\n| {} |\n", "x".repeat(30), "y".repeat(30));
    assert_eq!(wide_rows(&page, 20).len(), 1);
    assert_eq!(wide_rows(&page, 34).len(), 0);
}
