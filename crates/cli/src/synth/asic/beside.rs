//! The table of docs/asic.md that has the machines beside what others state. Every quotient in it is computed here.

use std::fs;

use super::{AsicRow, ROOT, Report, without_clock_gates};
use crate::table;

/// The operations that a photon test needs in floating point: 3 subtractions, 1 multiplication, 2 fused multiply-adds, 1 comparison, and 4
/// additions that depend on it.
const OPERATIONS: f64 = 11.0;
/// The operations as which a fused multiply-add counts in the peak that a vendor states.
const COUNTED_AS: f64 = 2.0;
/// The gates that the paper states.
const PAPER_GATES: f64 = 5592.0;

/// Somebody's hardware.
struct Other {
    who: &'static str,
    made_in: &'static str,
    tests_per_second: f64,
    energy_pj: Option<f64>,
    energy_is: &'static str,
    how_sure: &'static str,
}

impl Other {
    /// A processor at its peak of `tera` floating-point operations in a second and its greatest power.
    fn ceiling(who: &'static str, tera: f64, watts: f64) -> Self {
        let tests_per_second = tera * 1e12 / COUNTED_AS / OPERATIONS;
        Self {
            who,
            made_in: "4N",
            tests_per_second,
            energy_pj: Some(1e12 * watts / tests_per_second),
            energy_is: "the whole card",
            how_sure: "ceiling: arithmetic alone",
        }
    }

    fn cells(&self) -> Vec<String> {
        let energy = self.energy_pj.map(energy);
        vec![
            self.who.to_owned(),
            self.made_in.to_owned(),
            giga(self.tests_per_second),
            energy.unwrap_or_else(|| "not stated".to_owned()),
            self.energy_is.to_owned(),
            self.how_sure.to_owned(),
        ]
    }
}

fn energy(pj: f64) -> String {
    format!("{pj:.digits$}", digits = if pj < 10.0 { 2 } else { 0 })
}

fn giga(per_second: f64) -> String {
    let giga = per_second / 1e9;
    format!("{giga:.digits$}", digits = if giga < 1.0 { 4 } else { 1 })
}

/// What others state, and this project's gather on a core of a processor, which is measured.
fn others(gather_per_second: f64) -> [Other; 6] {
    let (pree_watts, pree_per_second) = (0.184, 496.79e6);
    let (knn_joules, knn_per_second, of_three) = (3.37e-9, 21.5e6, 128.0 * 128.0 / 3.0);
    let (epyc_watts, epyc_cores) = (400.0, 96.0);
    [
        Other {
            who: "Ryu, Kim, Lee",
            made_in: "not stated",
            tests_per_second: 4.0 / 900e-9,
            energy_pj: None,
            energy_is: "-",
            how_sure: "stated: 900 ns for 4 photons",
        },
        Other {
            who: "PREE",
            made_in: "90 nm",
            tests_per_second: pree_per_second,
            energy_pj: Some(1e12 * pree_watts / pree_per_second),
            energy_is: "the core, placed and routed",
            how_sure: "stated: 184 mW, 496.79 M/s",
        },
        Other {
            who: "Intel, k nearest neighbours",
            made_in: "14 nm",
            tests_per_second: knn_per_second * of_three,
            energy_pj: Some(1e12 * knn_joules / of_three),
            energy_is: "the chip, at 0.75 V",
            how_sure: "derived: 3.37 nJ for 128 distances in 128 dimensions, by 128 x 128 / 3",
        },
        Other {
            who: "this gather on a Zen 5 core",
            made_in: "4 nm",
            tests_per_second: gather_per_second,
            energy_pj: Some(1e12 * epyc_watts / epyc_cores / gather_per_second),
            energy_is: "a 96th of an EPYC 9655",
            how_sure: "rate measured; 400 W stated, by 96 cores",
        },
        Other::ceiling("H100 SXM", 67.0, 700.0),
        Other::ceiling("RTX 4090", 82.6, 450.0),
    ]
}

/// The rate of the fastest gather, from the page of its speed: uniform, 1e6 photons, 200 in range, on one thread.
fn gather_per_second() -> f64 {
    let page = fs::read_to_string(format!("{ROOT}/speed.md")).unwrap();
    let mut rows = page.lines();
    let row = rows.find_map(|line| line.strip_prefix("| uniform 1e6 200 | fixed point | "));
    let giga = row.unwrap().split(" | ").nth(1).unwrap();
    giga.parse::<f64>().unwrap() * 1e9
}

/// A machine in the cells of a library, at the activities of a simulation.
fn measured(report: &Report, machine: &str, made_in: &str) -> Option<Vec<String>> {
    let row = report.machines.iter().find(|row| row.machine == machine)?;
    let simulated = row.simulated.as_ref()?;
    Some(vec![
        format!("`{machine}`"),
        made_in.to_owned(),
        giga(row.fmax_mhz * 1e6 * simulated.tests_per_clock()),
        energy(simulated.energy_pj_per_test),
        "cells alone: no wires, clock tree, memory".to_owned(),
        "measured here, never made".to_owned(),
    ])
}

/// The machines that the table has.
const MACHINES: [&str; 4] = [
    "paper",
    "stream",
    "tile-7",
    "tile-7-shallow-local7-rgb6d-n4096",
];

fn beside(reports: &[(String, Report)]) -> String {
    let header = [
        "what",
        "made in",
        "G tests/s",
        "pJ a test",
        "whose energy",
        "how sure",
    ];
    let mut rows = Vec::new();
    for (file, report) in reports {
        let made_in = match file.contains("osu018") {
            true => "0.18 um",
            false => "45 nm",
        };
        rows.extend(
            MACHINES
                .iter()
                .filter_map(|machine| measured(report, machine, made_in)),
        );
    }
    assert_eq!(rows.len(), MACHINES.len() * reports.len());
    rows.extend(others(gather_per_second()).iter().map(Other::cells));
    table::markdown(&header, &rows)
}

#[test]
fn the_page_has_the_machines_beside_others() {
    let page = fs::read_to_string(format!("{ROOT}/asic.md")).unwrap();
    let reports = without_clock_gates();
    let table = beside(&reports);
    assert!(
        page.contains(&table),
        "docs/asic.md should have this table:\n{table}"
    );
    let is_paper = |row: &&AsicRow| row.machine == "paper";
    let gates = reports.iter().map(|(_, report)| {
        let row = report.machines.iter().find(is_paper).unwrap();
        format!("{:.1}", row.kilo_gate_equivalents * 1e3 / PAPER_GATES)
    });
    let [large, small] = gates.collect::<Vec<_>>().try_into().unwrap();
    let said = format!("{small} times as many in 0.18 um and {large} times in 45 nm");
    assert!(page.contains(&said), "docs/asic.md should say: {said}");
}
