//! The recorded layouts of machines, which `scripts/asic/layout.sh` makes.

use std::path::Path;

use anyhow::Result;
use serde::Deserialize;

use super::asic::recorded;
use super::{Subject, is_stale};

/// The files of recorded layouts: `layout-MACHINE.json`.
const PREFIX: &str = "layout-";

/// Of what a recorded layout is.
#[derive(Clone, Debug, Deserialize)]
struct Layout {
    machine: String,
    verilog_sha256: String,
}

/// The recorded layouts in a folder that are of other Verilog than the subjects'.
pub fn faults(folder: &Path, subjects: &[Subject]) -> Result<Vec<String>> {
    let layouts = recorded::<Layout>(folder, PREFIX)?.into_iter();
    let stale =
        layouts.filter(|(_, layout)| is_stale(subjects, &layout.machine, &layout.verilog_sha256));
    let said = stale.map(|(file, Layout { machine, .. })| {
        format!(
            "{file}: {machine} was laid out with other Verilog; `scripts/asic/layout.sh {machine} --record` \
             lays it out anew"
        )
    });
    Ok(said.collect())
}

#[cfg(test)]
mod tests {
    use std::fs;

    use serde_json::Value;

    use super::*;
    use crate::table;

    /// The figures that docs/asic.md shows, and what the checks said.
    #[derive(Debug, Deserialize)]
    struct Figures {
        machine: String,
        library: String,
        die_width_um: f64,
        die_height_um: f64,
        die_area_um2: f64,
        cell_area_um2: f64,
        core_utilisation: f64,
        standard_cells: u64,
        registers: u64,
        clock_buffers: u64,
        clock_tree_levels: u64,
        nets: u64,
        ports: u64,
        wire_length_um: f64,
        vias: u64,
        wire_capacitance_pf: f64,
        drc_errors: u64,
        drc_errors_planted: u64,
        metal_patches: usize,
        lvs: String,
        lvs_cells: u64,
        lvs_nets: u64,
        lvs_transistors: u64,
        lvs_sliver_planted: String,
        lvs_exchange_planted: String,
        fmax_mhz_without_wires: f64,
        fmax_mhz: f64,
        clock_latency_ns: f64,
        clock_skew_ns: f64,
        hold_slack_ns: f64,
    }

    const DOCS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs");

    fn layouts() -> Vec<(String, Figures)> {
        let layouts = recorded(&Path::new(DOCS).join("measured"), PREFIX).unwrap();
        assert!(!layouts.is_empty());
        layouts
    }

    /// The table of a layout in docs/asic.md.
    fn table_of(layout: &Figures) -> String {
        let grouped = |number: f64| table::grouped(number.round() as u64);
        let rows = [
            (
                "die",
                format!(
                    "{:.0} um x {:.0} um",
                    layout.die_width_um, layout.die_height_um
                ),
            ),
            (
                "area of the die",
                format!("{} um2", grouped(layout.die_area_um2)),
            ),
            (
                "area of its cells",
                format!("{} um2", grouped(layout.cell_area_um2)),
            ),
            (
                "cells in the rows",
                format!("{:.0} %", 100.0 * layout.core_utilisation),
            ),
            ("cells", table::grouped(layout.standard_cells)),
            ("of them registers", table::grouped(layout.registers)),
            (
                "of them buffers of the clock",
                format!(
                    "{} in {} levels",
                    layout.clock_buffers, layout.clock_tree_levels
                ),
            ),
            ("transistors", table::grouped(layout.lvs_transistors)),
            ("nets", table::grouped(layout.nets)),
            ("wires", format!("{:.0} mm", layout.wire_length_um / 1e3)),
            ("vias", table::grouped(layout.vias)),
            (
                "capacitance of the wires",
                format!("{:.0} pF", layout.wire_capacitance_pf),
            ),
            (
                "clock without wires",
                format!("{:.0} MHz", layout.fmax_mhz_without_wires),
            ),
            ("clock with wires", format!("{:.0} MHz", layout.fmax_mhz)),
            (
                "way of the clock to the registers",
                format!("{:.2} ns", layout.clock_latency_ns),
            ),
            (
                "first register to last",
                format!("{:.2} ns", layout.clock_skew_ns),
            ),
            (
                "slack of the shortest path (hold)",
                format!("{:.2} ns", layout.hold_slack_ns),
            ),
            (
                "pieces of metal made larger",
                layout.metal_patches.to_string(),
            ),
            (
                "errors against the design rules",
                layout.drc_errors.to_string(),
            ),
            ("layout and netlist", layout.lvs.clone()),
        ];
        let rows = rows.map(|(what, figure)| vec![what.to_owned(), figure]);
        table::markdown(&["figure", &layout.machine], &rows)
    }

    #[test]
    fn the_page_has_the_recorded_layouts_their_pictures_and_their_logs() {
        let page = fs::read_to_string(format!("{DOCS}/asic.md")).unwrap();
        for (file, layout) in layouts() {
            let table = table_of(&layout);
            assert!(page.contains(&table), "{file} has this table:\n{table}");
            let machine = &layout.machine;
            for shown in [
                format!("](layout-{machine}.webp)"),
                format!("(measured/layout-{machine}.json)"),
                format!("(measured/layout-{machine}-drc.log)"),
                format!("(measured/layout-{machine}-lvs.log)"),
            ] {
                assert!(page.contains(&shown), "{file}: docs/asic.md lacks {shown}");
            }
        }
    }

    #[test]
    fn the_recorded_layouts_are_clean_and_their_checks_found_what_was_planted() {
        for (file, layout) in layouts() {
            assert_eq!(layout.drc_errors, 0, "{file}");
            assert!(layout.drc_errors_planted > 0, "{file}");
            let planted = [&layout.lvs_sliver_planted, &layout.lvs_exchange_planted];
            assert_eq!(layout.lvs, "match", "{file}");
            assert!(planted.iter().all(|said| *said == "no match"), "{file}");
            assert!(layout.registers > 0 && layout.ports > 0, "{file}");
            assert_eq!(layout.lvs_cells, layout.standard_cells, "{file}");
            // Two nets are of power.
            assert_eq!(layout.lvs_nets, layout.nets + 2, "{file}");
            assert!(layout.fmax_mhz < layout.fmax_mhz_without_wires, "{file}");
            assert!(layout.hold_slack_ns > 0.0, "{file}");
        }
    }

    /// Without its tree of clock buffers and without wires, a layout has the cells and the clock of its row in docs/asic.md.
    #[test]
    fn the_recorded_layouts_are_of_the_recorded_netlists() {
        let reports = recorded::<Value>(&Path::new(DOCS).join("measured"), "asic-").unwrap();
        for (file, layout) in layouts() {
            let of_library = |report: &&Value| {
                report["library"] == layout.library && report.get("clock_gating").is_none()
            };
            let report = reports.iter().map(|(_, report)| report).find(of_library);
            let rows = report.unwrap()["machines"].as_array().unwrap();
            let row = rows.iter().find(|row| row["machine"] == layout.machine);
            let row = row.unwrap();
            let cells = layout.standard_cells - layout.clock_buffers;
            assert_eq!(row["standard_cells"], cells, "{file}");
            assert_eq!(row["fmax_mhz"], layout.fmax_mhz_without_wires, "{file}");
        }
    }

    /// The logs are the layout's, and not of a small or an empty one.
    #[test]
    fn the_recorded_logs_say_what_the_figures_say() {
        for (file, layout) in layouts() {
            let log = |kind: &str| {
                let path = format!("{DOCS}/measured/layout-{}-{kind}.log", layout.machine);
                fs::read_to_string(path).unwrap()
            };
            let rules = log("drc");
            let errors = |of: &str, count| rules.contains(&format!("\nDRC errors{of}: {count}\n"));
            assert!(errors("", layout.drc_errors), "{file}");
            assert!(
                errors(" with a planted sliver", layout.drc_errors_planted),
                "{file}"
            );
            let patches = rules.matches("\npatch of metal").count();
            assert_eq!(patches, layout.metal_patches, "{file}");
            let comparison = log("lvs");
            for expected in [
                format!("Number of devices: {} ", layout.lvs_cells),
                format!("Number of nets: {} ", layout.lvs_nets),
            ] {
                assert!(comparison.contains(&expected), "{file}: {expected}");
            }
            let last = comparison.trim_end().lines().last();
            assert_eq!(last, Some("Circuits match uniquely."), "{file}");
        }
    }
}
