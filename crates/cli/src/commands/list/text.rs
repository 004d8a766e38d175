//! Prints the lists as text: the figures that fit a terminal, or all of them.

use fpga_flow::Figure;

use super::{CoreRow, MachineRow, Report};
use crate::core::chains_said;
use crate::measured::Area;
use crate::measured_fits::fit_table;
use crate::synth::tables;
use crate::table::{self, Table};

const COLUMNS_SAY: &str = "LUT4: LUTs and what takes their place on ECP5, without DSP blocks or, where that was \
    not measured, with them. MHz and tests/s: Fmax in the fastest speed grade that was measured. Bits: of a stored \
    photon. Error: rms of the picture's pixels, the machine's integers against f64.";

/// Scenes, machines and formats by name, and a table of the machines that fits 100 columns.
pub fn narrow(report: &Report, fmax_source: &str) -> String {
    let mut text = names(report);
    text += "\nFigures:\n";
    text += &table_of(NARROW, report.machines.iter()).markdown();
    text + &format!(
        "\n{}\n{}\n\nAll of one machine: `photoncube list MACHINE`. Every table: `photoncube list --wide`.\n",
        table::wrapped(COLUMNS_SAY, 0),
        table::wrapped(fmax_source, 0)
    )
}

/// Scenes, machines and formats, and every table.
pub fn wide(report: &Report, fmax_source: &str) -> String {
    let mut text = names(report);
    text += "\nWhat `photoncube fit` found for them:\n";
    text += &fit_table(&report.fits);
    text += "\nWidths of the machines (bits):\n";
    text += &width_table(&report.machines);
    text += "\nFigures:\n";
    text += &machine_tables(&report.machines);
    text += &format!("\n{fmax_source}\n");
    text += "\nFmax in each speed grade, and what binds it:\n";
    let all = |row: &MachineRow| row.measured.fmax_by_grade.clone();
    text += &tables::clocks(&report.machines.iter().flat_map(all).collect::<Vec<_>>());
    text += "\nArea elsewhere than on ECP5:\n";
    let all = |row: &MachineRow| row.measured.areas.clone();
    text + &tables::elsewhere(&report.machines.iter().flat_map(all).collect::<Vec<_>>())
}

/// Lines of names with descriptions.
fn names(report: &Report) -> String {
    let mut text = "Scenes:\n".to_owned();
    let scenes = report.scenes.iter();
    text += &padded(scenes.map(|row| (row.scene, format!("{} surfaces", row.surfaces))));
    text += "\nMachines:\n";
    let machines = report.machines.iter();
    text += &padded(machines.map(|row| (row.machine, row.summary.to_owned())));
    text += "\nCores whose clock is measured (docs/cores.md):\n";
    let cores = report.measured_cores.iter();
    text += &padded(cores.map(|row| (row.core.as_str(), core_said(row))));
    text += "\nPhoton formats of the golden model, bits per photon (`photoncube report` measures them):\n";
    let formats = report.formats.iter();
    text + &padded(formats.map(|row| {
        let said = format!("{:>2}: {}", row.bits_per_photon, row.summary);
        (row.format.as_str(), said)
    }))
}

/// "6 chains of 8 engines, 140 MHz, 61956 LUT4 and 108 DSP blocks".
fn core_said(row: &CoreRow) -> String {
    let area = |figure| row.area.get(&figure).copied().unwrap_or_default();
    format!(
        "{}: {:.0} MHz, {} LUT4 and {} DSP blocks",
        chains_said(row.chains, row.chain_engines),
        row.fmax_mhz,
        area(Figure::Lut4Equivalents),
        area(Figure::Dsp)
    )
}

/// A line for each name, with the descriptions in one column.
fn padded<'a>(rows: impl Iterator<Item = (&'a str, String)> + Clone) -> String {
    let width = rows.clone().map(|(name, _)| name.len()).max().unwrap_or(0);
    rows.map(|(name, said)| format!("  {name:width$}  {said}\n"))
        .collect()
}

/// A column of a table of machines: its header, and a machine's cell.
type Column = (&'static str, fn(&MachineRow) -> String);

/// The columns of the table that fits a terminal.
const NARROW: &[Column] = &[
    ("machine", |row| row.machine.to_owned()),
    ("clocks", clocks_cell),
    ("LUT4", |row| {
        or_dash(any_area(row).map(|area| area.lut4_equivalents.to_string()))
    }),
    ("FF", |row| {
        or_dash(any_area(row).map(|area| area.ff.to_string()))
    }),
    ("MHz", |row| {
        let clock = row.measured.fastest();
        or_dash(clock.map(|clock| format!("{:.0}", clock.fmax_mhz)))
    }),
    ("G tests/s", |row| {
        or_dash(rate(row).map(|rate| format!("{rate:.3}")))
    }),
    ("bits", |row| row.bits_per_photon.to_string()),
    ("error", |row| or_dash(error(row))),
];

/// The columns of speed and error.
const SPEED: &[Column] = &[
    ("machine", |row| row.machine.to_owned()),
    ("clocks", clocks_cell),
    ("Fmax, grade 6 / 8", fmax_cell),
    ("G tests/s", fastest_cell),
    ("bits per photon", |row| row.bits_per_photon.to_string()),
    ("error", |row| error(row).unwrap_or_else(not_measured)),
];

/// The columns of area on ECP5.
const AREA: &[Column] = &[
    ("machine", |row| row.machine.to_owned()),
    ("LUT4, no DSP", |row| match &row.measured.area_without_dsp {
        None => not_measured(),
        Some(area) => format!("{} + {} CCU2C", area.lut4, area.ccu2c),
    }),
    ("with DSP", |row| match &row.measured.area_with_dsp {
        None => not_measured(),
        Some(area) if area.dsp == 0 => "no use of DSP".to_owned(),
        Some(area) => format!("{} + {} CCU2C, {} DSP", area.lut4, area.ccu2c, area.dsp),
    }),
    ("FF", |row| {
        any_area(row).map_or_else(not_measured, |area| area.ff.to_string())
    }),
];

/// A table of machines with these columns.
fn table_of<'a>(columns: &[Column], machines: impl Iterator<Item = &'a MachineRow>) -> Table {
    let header: Vec<_> = columns.iter().map(|(header, _)| *header).collect();
    let row = |row| columns.iter().map(|(_, cell)| cell(row)).collect();
    Table::new(&header, machines.map(row))
}

/// The speed and the error of machines.
pub fn speed<'a>(machines: impl Iterator<Item = &'a MachineRow>) -> Table {
    table_of(SPEED, machines)
}

fn or_dash(text: Option<String>) -> String {
    text.unwrap_or_else(|| "-".to_owned())
}

fn not_measured() -> String {
    "not measured".to_owned()
}

/// The area without DSP blocks or, where that was not measured, with them.
fn any_area(row: &MachineRow) -> Option<&Area> {
    let measured = &row.measured;
    let area = measured.area_without_dsp.as_ref();
    area.or(measured.area_with_dsp.as_ref())
}

fn width_table(machines: &[MachineRow]) -> String {
    let header = [
        "machine",
        "coordinate",
        "position in block",
        "radius_sq",
        "power",
        "work and link",
        "sum",
        "bits per photon",
        "largest query",
    ];
    let row = |row: &MachineRow| {
        let numbers = [
            row.coordinate_bits,
            row.position_bits,
            row.radius_sq_bits,
            row.power_bits,
            row.work_bits,
            row.sum_bits,
            row.bits_per_photon,
        ];
        let mut cells = vec![row.machine.to_owned()];
        cells.extend(numbers.map(|bits| bits.to_string()));
        cells.push(format!("{} photons", row.max_photons));
        cells
    };
    table::markdown(&header, &machines.iter().map(row).collect::<Vec<_>>())
}

/// The tables of docs/machines.md: speed and error, area, proof.
fn machine_tables(machines: &[MachineRow]) -> String {
    let [speed, area] = [SPEED, AREA].map(|columns| table_of(columns, machines.iter()).markdown());
    format!("{speed}\n{area}\n{}", proofs(machines.iter()).markdown())
}

/// A row for each comparison of a machine's Verilog with the golden model.
pub fn proofs<'a>(machines: impl Iterator<Item = &'a MachineRow>) -> Table {
    let header = ["machine", "verified against", "compared"];
    let rows = machines.flat_map(|row| {
        let proofs = row.measured.verified_against.split("; ");
        proofs.map(|proof| {
            let (devices, compared) = proof.split_once(": ").unwrap_or((proof, ""));
            [row.machine, devices, compared].map(str::to_owned).to_vec()
        })
    });
    Table::new(&header, rows)
}

fn fmax_cell(row: &MachineRow) -> String {
    let clocks = row.measured.in_default_grades();
    if clocks.iter().all(Option::is_none) {
        return not_measured();
    }
    let clock = |mhz: Option<f64>| mhz.map_or_else(|| "-".to_owned(), |mhz| format!("{mhz:.0}"));
    format!("{} MHz", clocks.map(clock).join(" / "))
}

/// Photon tests per second in the fastest speed grade that was measured.
fn fastest_cell(row: &MachineRow) -> String {
    rate(row).map_or_else(not_measured, |rate| format!("{rate:.3}"))
}

/// A machine's peak of photon tests at its fastest measured clock, in G tests/s.
fn rate(row: &MachineRow) -> Option<f64> {
    let clock = row.measured.fastest()?;
    Some(row.photon_tests_per_clock * clock.fmax_mhz / 1e3)
}

fn error(row: &MachineRow) -> Option<String> {
    let error = row.measured.rms_relative_error?;
    Some(format!("{:.2} %", 100.0 * error))
}

fn clocks_cell(row: &MachineRow) -> String {
    let queries = match row.queries_at_once {
        1 => String::new(),
        queries => format!(", {queries} queries"),
    };
    format!(
        "{} for {} photons{queries}",
        row.initiation_interval, row.photons_per_iteration
    )
}

#[cfg(test)]
mod tests;
