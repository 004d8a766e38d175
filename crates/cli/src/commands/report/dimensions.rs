//! The tiles from dimension 4 to 10: what every further axis of queries gives and costs. Beside them the
//! machines of the same engines with a photon memory, whose squares may come from blocks.

use std::error::Error;

use anyhow::{Result, anyhow};
use photoncube_spec::{MACHINES, Machine};
use plotters::prelude::*;
use serde::Serialize;

use crate::measured::Measured;
use crate::synth::flow::Flow;
use crate::table;

/// A machine of one dimension.
#[derive(Serialize)]
pub struct Row {
    machine: &'static str,
    /// One of the tiles that differ in nothing but the dimension.
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

/// The speed grade of the clock: the fastest, as for the chips that tiles are made for.
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
    // Of what is placed: without DSP blocks where the machine has no use for them.
    let area = match Flow::to_place(machine) {
        Flow::Ecp5 => measured.area_with_dsp.as_ref(),
        _ => measured.area_without_dsp.as_ref(),
    };
    let mut clocks = measured.fmax_by_grade.iter();
    let clock = clocks.find(|clock| clock.speed_grade == SPEED_GRADE);
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

const SIZE: (u32, u32) = (900, 600);

/// One quantity against the dimension.
struct Line {
    name: &'static str,
    colour: RGBColor,
    of: fn(&Row) -> Option<f64>,
}

const LINES: [Line; 3] = [
    Line {
        name: "photon tests a clock",
        colour: RGBColor(190, 60, 40),
        of: |row| Some(row.photon_tests_per_clock),
    },
    Line {
        name: "LUT4 equivalents",
        colour: RGBColor(60, 100, 170),
        of: |row| row.lut4_equivalents.map(|luts| luts as f64),
    },
    Line {
        name: "Fmax in MHz",
        colour: RGBColor(60, 140, 80),
        of: |row| row.fmax_mhz,
    },
];

/// An SVG picture: the dimension to the right, all quantities upwards on one logarithmic axis.
pub fn plot(rows: &[Row]) -> Result<String> {
    let mut svg = String::new();
    draw(&mut svg, rows).map_err(|error| anyhow!("the plot cannot be drawn: {error}"))?;
    Ok(svg)
}

fn draw(svg: &mut String, rows: &[Row]) -> Result<(), Box<dyn Error>> {
    let dimensions = rows.iter().map(|row| f64::from(row.dimension));
    let (first, last) = dimensions.fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), d| {
        (low.min(d), high.max(d))
    });
    let area = SVGBackend::with_string(svg, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&area)
        .caption(
            "tiles: one axis more, twice the queries; crosses: with a photon memory",
            ("sans-serif", 20),
        )
        .margin(12)
        .x_label_area_size(44)
        .y_label_area_size(84)
        .build_cartesian_2d(
            first - 0.3..last + 0.3,
            (1.0..200_000.0).log_scale().base(10.0),
        )?;
    chart
        .configure_mesh()
        .x_desc("dimension of the hypercube")
        .y_desc("tests a clock, LUT4 equivalents, MHz")
        .light_line_style(WHITE)
        .draw()?;
    for line in &LINES {
        let colour = line.colour;
        let point = |row: &Row| Some((f64::from(row.dimension), (line.of)(row)?));
        let (tiles, chips): (Vec<_>, Vec<_>) = rows.iter().partition(|row| row.is_tile);
        let [points, of_chips] =
            [tiles, chips].map(|rows| rows.into_iter().filter_map(point).collect::<Vec<_>>());
        let dots = points
            .iter()
            .map(|&place| Circle::new(place, 4, colour.filled()));
        chart.draw_series(dots)?;
        // Those with a photon memory: crosses, and no line.
        chart.draw_series(
            of_chips
                .iter()
                .map(|&place| Cross::new(place, 5, colour.stroke_width(2))),
        )?;
        chart
            .draw_series(LineSeries::new(points, colour.stroke_width(2)))?
            .label(line.name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 20, y)], colour));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .border_style(BLACK)
        .background_style(WHITE)
        .draw()?;
    area.present()?;
    Ok(())
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
    fn the_picture_names_its_lines() {
        let svg = plot(&rows().unwrap()).unwrap();
        for line in LINES {
            assert!(svg.contains(line.name), "{}", line.name);
        }
    }
}
