//! Compares the tiles from dimension 4 to 10: the effect and the cost of every further axis of queries.
//! Machines of equal engines with a photon memory, whose squares may come from blocks, are listed beside
//! them.

use anyhow::Result;
use fpga_flow::Device;
use photoncube_spec::{MACHINES, Machine};
use serde::Serialize;

use crate::measured::Measured;
use crate::plots::{Panel, Place, panels};
use crate::synth::{DEFAULT_DEVICE, flow_to_place};
use crate::table;

/// A machine of one dimension, with its figures.
#[derive(Serialize)]
pub struct Row {
    machine: &'static str,
    /// Whether the machine is one of the tiles that differ only in their dimension.
    #[serde(skip)]
    is_tile: bool,
    dimension: u32,
    queries_at_once: usize,
    cells: usize,
    photon_tests_per_clock: f64,
    lut4_equivalents: Option<u64>,
    dsp: Option<u64>,
    block_ram: Option<u64>,
    ff: Option<u64>,
    fmax_mhz: Option<f64>,
    speed_grade: u32,
    photon_tests_per_second_at_fmax: Option<f64>,
}

/// The speed grade of the clocks: the fastest, as for the chips that tiles are made for.
const SPEED_GRADE: u32 = 8;

/// The tiles in the order of their dimensions, then the machines with a photon memory.
pub fn rows() -> Result<Vec<Row>> {
    let tiles = MACHINES.iter().filter(|machine| is_tile(machine));
    let chips = MACHINES.iter().filter(|machine| machine.has_memory());
    tiles.chain(chips).map(row).collect()
}

fn is_tile(machine: &Machine) -> bool {
    machine.name == format!("tile-{}", machine.dimension)
}

fn row(machine: &'static Machine) -> Result<Row> {
    let measured = Measured::of(machine)?;
    // The area is that of the placed netlist: without DSP blocks where the machine does not use them.
    let area = match flow_to_place(machine, Device::find(DEFAULT_DEVICE)?).name {
        "ecp5" => measured.area_with_dsp.as_ref(),
        _ => measured.area_without_dsp.as_ref(),
    };
    let mut clocks = measured.fmax_by_grade.iter();
    let clock = clocks.find(|clock| clock.speed_grade == Some(SPEED_GRADE));
    let fmax_mhz = clock.map(|clock| clock.fmax_mhz);
    let rate = machine.photon_tests_per_clock();
    Ok(Row {
        machine: machine.name,
        is_tile: is_tile(machine),
        dimension: machine.dimension,
        queries_at_once: machine.queries_at_once(),
        cells: machine.hypercube().nodes(),
        photon_tests_per_clock: rate,
        lut4_equivalents: area.map(|area| area.lut4_equivalents),
        dsp: area.map(|area| area.dsp),
        block_ram: area.map(|area| area.block_ram),
        ff: area.map(|area| area.ff),
        fmax_mhz,
        speed_grade: SPEED_GRADE,
        photon_tests_per_second_at_fmax: fmax_mhz.map(|mhz| rate * mhz * 1e6),
    })
}

/// The rows as a table.
pub fn text(rows: &[Row]) -> String {
    let number = |value: Option<u64>| value.map_or_else(|| "-".to_owned(), |v| v.to_string());
    let cells = |row: &Row| {
        vec![
            row.machine.to_owned(),
            row.dimension.to_string(),
            row.queries_at_once.to_string(),
            row.cells.to_string(),
            row.photon_tests_per_clock.to_string(),
            number(row.lut4_equivalents),
            number(row.dsp),
            number(row.block_ram),
            number(row.ff),
            (row.fmax_mhz).map_or_else(|| "-".to_owned(), |mhz| format!("{mhz:.0} MHz")),
            (row.photon_tests_per_second_at_fmax)
                .map_or_else(|| "-".to_owned(), |rate| format!("{:.2}", rate / 1e9)),
        ]
    };
    let header = [
        "machine",
        "dimension",
        "queries at once",
        "cells",
        "tests/clock",
        "LUT4 equivalents",
        "DSP",
        "block RAMs",
        "FF",
        "Fmax, grade 8",
        "G tests/s",
    ];
    table::markdown(&header, &rows.iter().map(cells).collect::<Vec<_>>())
}

/// One quantity against the dimension.
struct Quantity {
    name: &'static str,
    of: fn(&Row) -> Option<f64>,
}

const QUANTITIES: [Quantity; 3] = [
    Quantity {
        name: "photon tests a clock",
        of: |row| Some(row.photon_tests_per_clock),
    },
    Quantity {
        name: "area in LUT4 equivalents",
        of: |row| row.lut4_equivalents.map(|luts| luts as f64),
    },
    Quantity {
        name: "Fmax in MHz, ECP5 grade 8",
        of: |row| row.fmax_mhz,
    },
];

/// An SVG picture with a chart for each quantity and the dimension on the x axis.
pub fn plot(rows: &[Row]) -> Result<String> {
    let charts = QUANTITIES.map(|quantity| {
        let place = |row: &Row| {
            Some(Place {
                dimension: row.dimension,
                value: (quantity.of)(row)?,
                on_line: row.is_tile,
            })
        };
        Panel {
            name: quantity.name,
            places: rows.iter().filter_map(place).collect(),
        }
    });
    panels(
        "What every further axis of queries gives and costs",
        &charts,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_axis_doubles_the_tests_of_a_clock() {
        let mut rows = rows().unwrap();
        rows.retain(|row| row.is_tile);
        let dimensions: Vec<_> = rows.iter().map(|row| row.dimension).collect();
        assert_eq!(dimensions, (4..=10).collect::<Vec<_>>());
        for pair in rows.windows(2) {
            assert_eq!(
                pair[1].photon_tests_per_clock,
                2.0 * pair[0].photon_tests_per_clock
            );
        }
        assert_eq!(rows[0].photon_tests_per_clock, 4.0);
    }

    #[test]
    fn the_picture_names_its_quantities() {
        let svg = plot(&rows().unwrap()).unwrap();
        for quantity in QUANTITIES {
            assert!(svg.contains(quantity.name), "{}", quantity.name);
        }
        // The dimension axis has whole numbers only.
        assert!(svg.contains("\n10\n") && !svg.contains("\n4.5\n"), "{svg}");
    }
}
