//! Prints the lists as text: the figures that fit a terminal, or all of them.

use super::{MachineRow, Report};
use crate::measured::Area;
use crate::measured_fits::fit_table;
use crate::synth::tables;
use crate::table;

const COLUMNS_SAY: &str = "LUT4: LUTs and what takes their place on ECP5, without DSP blocks or, where that was \
    not measured, with them. MHz and tests/s: Fmax in the fastest speed grade that was measured. Bits: of a stored \
    photon. Error: rms of the picture's pixels, the machine's integers against f64.";

/// Scenes, machines and formats by name, and a table of the machines that fits 100 columns.
pub fn narrow(report: &Report, fmax_source: &str) -> String {
    let mut text = names(report);
    text += "\nFigures:\n";
    text += &narrow_table(&report.machines);
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
    text += &machine_table(&report.machines);
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
    text += "\nPhoton formats of the golden model, bits per photon (`photoncube report` measures them):\n";
    let formats = report.formats.iter();
    text + &padded(formats.map(|row| {
        let said = format!("{:>2} {}", row.bits_per_photon, row.summary);
        (row.format.as_str(), said)
    }))
}

/// A line for each name, with the descriptions in one column.
fn padded<'a>(rows: impl Iterator<Item = (&'a str, String)> + Clone) -> String {
    let width = rows.clone().map(|(name, _)| name.len()).max().unwrap_or(0);
    rows.map(|(name, said)| format!("  {name:width$}  {said}\n"))
        .collect()
}

fn narrow_table(machines: &[MachineRow]) -> String {
    let header = [
        "machine",
        "clocks",
        "LUT4",
        "FF",
        "MHz",
        "G tests/s",
        "bits",
        "error",
    ];
    let row = |row: &MachineRow| {
        let measured = &row.measured;
        let area = measured.area_without_dsp.as_ref();
        let area = area.or(measured.area_with_dsp.as_ref());
        let or_dash = |text: Option<String>| text.unwrap_or_else(|| "-".to_owned());
        let clock = measured.fastest();
        vec![
            row.machine.to_owned(),
            clocks_cell(row),
            or_dash(area.map(|area| area.lut4_equivalents.to_string())),
            or_dash(area.map(|area| area.ff.to_string())),
            or_dash(clock.map(|clock| format!("{:.0}", clock.fmax_mhz))),
            or_dash(rate(row).map(|rate| format!("{rate:.3}"))),
            row.bits_per_photon.to_string(),
            or_dash(error(row)),
        ]
    };
    table::markdown(&header, &machines.iter().map(row).collect::<Vec<_>>())
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

/// The table of the README's first screen.
fn machine_table(machines: &[MachineRow]) -> String {
    let header = [
        "machine",
        "clocks",
        "LUT4, no DSP",
        "with DSP",
        "FF",
        "Fmax, grade 6 / 8",
        "G tests/s",
        "bits per photon",
        "error",
        "verified against",
    ];
    let rows: Vec<_> = machines.iter().map(table_row).collect();
    table::markdown(&header, &rows)
}

fn fmax_cell(row: &MachineRow) -> String {
    let clocks = row.measured.in_default_grades();
    if clocks.iter().all(Option::is_none) {
        return "not measured".to_owned();
    }
    let clock = |mhz: Option<f64>| mhz.map_or_else(|| "-".to_owned(), |mhz| format!("{mhz:.0}"));
    format!("{} MHz", clocks.map(clock).join(" / "))
}

/// Photon tests per second in the fastest speed grade that was measured.
fn fastest_cell(row: &MachineRow) -> String {
    rate(row).map_or_else(|| "not measured".to_owned(), |rate| format!("{rate:.3}"))
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

fn table_row(row: &MachineRow) -> Vec<String> {
    let not_measured = || "not measured".to_owned();
    let luts = |area: &Option<Area>| match area {
        None => not_measured(),
        Some(area) => format!("{} + {} CCU2C", area.lut4, area.ccu2c),
    };
    let dsp = |area: &Option<Area>| match area {
        None => not_measured(),
        Some(area) if area.dsp == 0 => "no use of DSP".to_owned(),
        Some(area) => format!("{} + {} CCU2C, {} DSP", area.lut4, area.ccu2c, area.dsp),
    };
    let without = &row.measured.area_without_dsp;
    vec![
        row.machine.to_owned(),
        clocks_cell(row),
        luts(without),
        dsp(&row.measured.area_with_dsp),
        without
            .as_ref()
            .map_or_else(not_measured, |area| area.ff.to_string()),
        fmax_cell(row),
        fastest_cell(row),
        row.bits_per_photon.to_string(),
        error(row).unwrap_or_else(not_measured),
        row.measured.verified_against.clone(),
    ]
}

#[cfg(test)]
mod tests {
    use super::super::report;
    use super::*;
    use crate::measured;
    use crate::measured_fits::fit_rows;

    #[test]
    fn the_readme_shows_the_table_that_list_prints() {
        let readme = include_str!("../../../../../README.md");
        let table = machine_table(&report().unwrap().machines);
        assert!(
            readme.contains(&table),
            "the README's table is not what `photoncube list --wide` prints; paste this:\n{table}"
        );
        let fits = fit_table(&fit_rows().unwrap());
        assert!(
            readme.contains(&fits),
            "the README's fits are not what `photoncube list --wide` prints; paste this:\n{fits}"
        );
        let paper = tables::elsewhere(&report().unwrap().machines[0].measured.areas);
        assert!(
            readme.contains(&paper),
            "the README's gates are not what `photoncube list --wide` prints; paste this:\n{paper}"
        );
        let source = measured::fmax_source().unwrap();
        assert!(
            readme.contains(&source),
            "the README does not say: {source}"
        );
    }
}
