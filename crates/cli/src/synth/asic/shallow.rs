//! The table of docs/asic.md that has shallow pipelines beside deep ones.

use std::fs;

use photoncube_spec::find_machine;

use super::{AsicRow, ROOT, Report, without_clock_gates};
use crate::table;

/// Machines with a deep pipeline, and those of the same numbers and engines with a shallow one.
const PAIRS: [[&str; 2]; 3] = [
    ["stream", "stream-shallow-local8-rgb8d-n16384"],
    ["tile-6", "tile-6-shallow-local7-rgb6d-n4096"],
    ["tile-7", "tile-7-shallow-local7-rgb6d-n4096"],
];

fn stages(machine: &str) -> u32 {
    find_machine(machine).unwrap().spatial().unwrap().latency()
}

fn cells(made_in: &str, row: &AsicRow, deep: &AsicRow) -> Vec<String> {
    let [simulated, of_deep] = [row, deep].map(|row| row.simulated.as_ref().unwrap());
    let tests_per_second = row.fmax_mhz * 1e6 * simulated.tests_per_clock();
    let energy = simulated.energy_pj_per_test;
    vec![
        made_in.to_owned(),
        row.machine.clone(),
        stages(&row.machine).to_string(),
        format!("{:.1}", row.kilo_gate_equivalents),
        format!("{:.0}", row.fmax_mhz),
        format!("{:.2}", tests_per_second / 1e9),
        format!("{:.1}", tests_per_second / 1e9 / (row.area_um2 / 1e6)),
        format!("{energy:.1}"),
        format!("{:.2}", energy / of_deep.energy_pj_per_test),
    ]
}

fn shallow(reports: &[(String, Report)]) -> String {
    let header = [
        "made in",
        "machine",
        "registers to the in-range flag",
        "kGE",
        "MHz",
        "G tests/s",
        "G tests/s a mm2",
        "pJ a test, simulated",
        "of the deep one's",
    ];
    let mut rows = Vec::new();
    for (file, report) in reports {
        let made_in = match file.contains("osu018") {
            true => "0.18 um",
            false => "45 nm",
        };
        for pair in PAIRS {
            let row = |name: &str| report.machines.iter().find(|row| row.machine == name);
            let [deep, shallow] = pair.map(|name| row(name).unwrap());
            assert!(shallow.energy_pj_per_test < deep.energy_pj_per_test);
            rows.extend([deep, shallow].map(|row| cells(made_in, row, deep)));
        }
    }
    table::markdown(&header, &rows)
}

#[test]
fn the_page_has_shallow_pipelines_beside_deep_ones() {
    let page = fs::read_to_string(format!("{ROOT}/asic.md")).unwrap();
    let reports = without_clock_gates();
    assert!(!reports.is_empty());
    let table = shallow(&reports);
    assert!(
        page.contains(&table),
        "docs/asic.md should have this table:\n{table}"
    );
}
