//! The pages that show figures hold the tables that are made of the measured figures.

use std::collections::BTreeMap;

use photoncube_spec::{Interface, MACHINES, Machine, Spatial};

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
    table_of(&columns, rows.into_iter())
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

/// The ports of a machine by their names, without the number of a lane.
fn ports(machine: &Machine) -> BTreeMap<String, u32> {
    let ports = Interface::of(machine).ports.into_iter();
    let stem = |name: &str| name.split("_0..").next().unwrap_or_default().to_owned();
    ports.map(|port| (stem(&port.name), port.width)).collect()
}

/// A row for each machine with the widths of its ports.
fn widths_table() -> String {
    let columns = [
        ("query", "query_x"),
        ("radius_sq", "query_radius_sq"),
        ("photon", "photon_x"),
        ("power", "photon_red photon_power"),
        ("exponent", "photon_exponent"),
        ("sum", "result_red result_power"),
        ("count", "result_count"),
    ];
    let row = |machine: &Machine| {
        let ports = ports(machine);
        let bits = |names: &str| names.split(' ').find_map(|name| ports.get(name));
        let cells = columns.map(|(_, names)| bits(names).map_or("-".to_owned(), u32::to_string));
        let channels = machine.channels().count().to_string();
        let mut cells = [&[machine.name.to_owned()], &cells[..]].concat();
        cells.insert(4, channels);
        cells
    };
    let header = [
        "machine",
        "query",
        "radius_sq",
        "photon",
        "channels",
        "power",
        "exponent",
        "sum",
        "count",
    ];
    table::markdown(&header, &MACHINES.iter().map(row).collect::<Vec<_>>())
}

/// A row for each machine with its clocks.
fn timing_table() -> String {
    let row = |machine: &Machine| {
        let spatial = machine.spatial();
        let overlapped = machine.overlap_program().map(|p| p.occupied_clocks(2));
        let program = machine.microprogram().map(|p| p.occupied_clocks(2));
        let interval = machine.rate().interval();
        let more = match (spatial, overlapped.or(program)) {
            (Some(spatial), _) => spatial.batch_gap_clocks().into(),
            (None, two) => two.map_or(0.0, |clocks| clocks as f64 - 2.0 * interval),
        };
        let least = spatial.filter(|spatial| spatial.engines() > 1);
        let clocks = [
            if interval == 1.0 {
                "n".to_owned()
            } else {
                format!("{interval} n")
            },
            if more == 0.0 {
                String::new()
            } else {
                format!(" + {more}")
            },
            least.map_or_else(String::new, |s| {
                format!(", at least {}", s.least_batch_clocks())
            }),
        ];
        let latency = spatial.map(Spatial::latency_clocks);
        vec![
            machine.name.to_owned(),
            machine.queries_at_once().to_string(),
            machine.photons_per_iteration().to_string(),
            clocks.concat(),
            latency.map_or("-".to_owned(), |clocks| clocks.to_string()),
            machine.max_photons().to_string(),
        ]
    };
    let header = [
        "machine",
        "queries",
        "lanes",
        "clocks of n groups",
        "latency",
        "max photons",
    ];
    table::markdown(&header, &MACHINES.iter().map(row).collect::<Vec<_>>())
}

#[test]
fn the_page_of_ports_has_every_port_width_and_clock_of_every_machine() {
    let name = "docs/ports.md";
    shows(PORTS_PAGE, name, &widths_table());
    shows(PORTS_PAGE, name, &timing_table());
    assert_eq!(wide_rows(PORTS_PAGE, table::COLUMNS), [""; 0]);
    let rows = PORTS_PAGE.lines().filter(|line| line.starts_with("| `"));
    let row = |port: &str| rows.clone().find(|row| row.contains(&format!("`{port}")));
    for machine in MACHINES {
        for (port, width) in ports(machine) {
            // A row begins with its first axis or its first channel.
            let first = [
                ("_y", "_x"),
                ("_z", "_x"),
                ("_green", "_red"),
                ("_blue", "_red"),
            ]
            .into_iter()
            .find_map(|(end, first)| Some(port.strip_suffix(end)?.to_owned() + first))
            .unwrap_or(port);
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
