//! The table of docs/asic.md that has clock gates beside registers that every edge of the clock reaches.

use std::fs;
use std::path::Path;

use super::{AsicRow, PREFIX, ROOT, Report, recorded};
use crate::table;

fn cells(row: &AsicRow, plain: &AsicRow) -> Vec<String> {
    let [energy, of_plain] = [row, plain].map(|row| {
        let simulated = row.simulated.as_ref().unwrap();
        simulated.energy_pj_per_test
    });
    vec![
        row.machine.clone(),
        row.clock_gates.to_string(),
        format!("{:.1}", row.kilo_gate_equivalents),
        format!("{:.2}", row.area_um2 / plain.area_um2),
        format!("{:.0}", row.fmax_mhz),
        format!("{energy:.1}"),
        format!("{:.2}", energy / of_plain),
    ]
}

#[test]
fn the_page_has_clock_gates_beside_none() {
    let header = [
        "machine",
        "clock gates",
        "kGE",
        "of that without",
        "MHz",
        "pJ a test, simulated",
        "of that without",
    ];
    let page = fs::read_to_string(format!("{ROOT}/asic.md")).unwrap();
    let reports = recorded::<Report>(&Path::new(ROOT).join("measured"), PREFIX).unwrap();
    let (gated, plain): (Vec<_>, Vec<_>) = reports
        .into_iter()
        .map(|(_, report)| report)
        .partition(|report| report.clock_gating);
    assert!(!gated.is_empty());
    for report in gated {
        let beside = plain.iter().find(|plain| plain.library == report.library);
        let beside = &beside.unwrap().machines;
        let rows = report.machines.iter().map(|row| {
            let plain = beside.iter().find(|plain| plain.machine == row.machine);
            cells(row, plain.unwrap())
        });
        let table = table::markdown(&header, &rows.collect::<Vec<_>>());
        assert!(
            page.contains(&table),
            "docs/asic.md should have this table:\n{table}"
        );
    }
}
