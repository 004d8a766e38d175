//! `list`: scenes and machines, each with its figures.

use anyhow::Result;
use photoncube_render::Scene;
use photoncube_spec::{FormatWidths, MACHINES, Machine, PHOTON_FORMATS, PhotonFormat, Widths};
use serde::Serialize;

use crate::measured::{self, Area, Measured};
use crate::measured_fits::{FitRow, fit_rows, fit_table};
use crate::synth::tables;
use crate::{output, table};

#[derive(Serialize)]
struct Report {
    scenes: Vec<SceneRow>,
    machines: Vec<MachineRow>,
    formats: Vec<FormatRow>,
    fits: Vec<FitRow>,
}

/// A photon format; machines that are built for one come with them.
#[derive(Serialize)]
struct FormatRow {
    format: String,
    summary: String,
    bits_per_photon: u32,
    position_bits: u32,
    query_extra_bits: u32,
    radius_bits: u32,
    channels: u32,
    mantissa_bits: u32,
    exponent_bits: u32,
    exponent_range: u32,
    max_photons: u64,
    sum_bits: u32,
}

#[derive(Serialize)]
struct SceneRow {
    scene: &'static str,
    surfaces: usize,
}

#[derive(Serialize)]
struct MachineRow {
    machine: &'static str,
    summary: &'static str,
    format: Option<String>,
    cells: usize,
    coordinate_bits: u32,
    position_bits: u32,
    power_bits: u32,
    radius_sq_bits: u32,
    work_bits: u32,
    sum_bits: u32,
    bits_per_photon: u32,
    max_photons: u64,
    squarer: &'static str,
    photons_per_iteration: usize,
    queries_at_once: usize,
    initiation_interval: f64,
    photon_tests_per_clock: f64,
    #[serde(flatten)]
    measured: Measured,
}

/// Lists what there is.
pub fn execute(json: bool) -> Result<()> {
    let report = report()?;
    let fmax_source = measured::fmax_source()?;
    output::print(json, &report, || text(&report, &fmax_source))?;
    measured::refuse_stale()
}

fn report() -> Result<Report> {
    let scenes = Scene::names().map(|scene| {
        let surfaces = Scene::built_in(scene)?.surfaces().len();
        Ok(SceneRow { scene, surfaces })
    });
    Ok(Report {
        scenes: scenes.collect::<Result<_>>()?,
        machines: MACHINES.iter().map(machine_row).collect::<Result<_>>()?,
        formats: PHOTON_FORMATS.iter().map(format_row).collect(),
        fits: fit_rows()?,
    })
}

fn format_row(format: &PhotonFormat) -> FormatRow {
    let widths = FormatWidths::of(format);
    FormatRow {
        format: format.name(),
        summary: format.summary(),
        bits_per_photon: widths.bits_per_photon,
        position_bits: format.position_bits,
        query_extra_bits: format.query_extra_bits,
        radius_bits: format.radius_bits(),
        channels: format.power.channels.count(),
        mantissa_bits: format.power.mantissa_bits,
        exponent_bits: format.power.exponent.bits(),
        exponent_range: format.power.exponent_range(),
        max_photons: format.max_photons,
        sum_bits: widths.sum,
    }
}

fn machine_row(machine: &Machine) -> Result<MachineRow> {
    let widths = Widths::of(machine);
    Ok(MachineRow {
        machine: machine.name,
        summary: machine.summary,
        format: machine.format().map(PhotonFormat::name),
        cells: machine.hypercube().nodes(),
        coordinate_bits: widths.coordinate,
        position_bits: machine.position_bits(),
        power_bits: widths.power,
        radius_sq_bits: widths.radius_sq,
        work_bits: widths.work,
        sum_bits: widths.sum,
        bits_per_photon: machine.bits_per_photon(),
        max_photons: machine.max_photons(),
        squarer: machine.squarer.name(),
        photons_per_iteration: machine.photons_per_iteration(),
        queries_at_once: machine.queries_at_once(),
        initiation_interval: machine.rate().interval(),
        photon_tests_per_clock: machine.photon_tests_per_clock(),
        measured: Measured::of(machine)?,
    })
}

fn text(report: &Report, fmax_source: &str) -> String {
    let mut text = "Scenes:\n".to_owned();
    for scene in &report.scenes {
        text += &format!("  {:<10} {} surfaces\n", scene.scene, scene.surfaces);
    }
    text += "\nMachines:\n";
    for machine in &report.machines {
        text += &format!("  {:<10} {}\n", machine.machine, machine.summary);
    }
    text += "\nPhoton formats of the golden model (`photoncube report` measures them):\n";
    for format in &report.formats {
        text += &format!(
            "  {:<17} {:>2} bits per photon  {}\n",
            format.format, format.bits_per_photon, format.summary
        );
    }
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
    let clock = row.measured.fastest();
    let rate = clock.map(|clock| row.photon_tests_per_clock * clock.fmax_mhz / 1e3);
    rate.map_or_else(|| "not measured".to_owned(), |rate| format!("{rate:.3}"))
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
        row.measured
            .rms_relative_error
            .map_or_else(not_measured, |error| format!("{:.2} %", 100.0 * error)),
        row.measured.verified_against.clone(),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_readme_shows_the_table_that_list_prints() {
        let readme = include_str!("../../../../README.md");
        let table = machine_table(&report().unwrap().machines);
        assert!(
            readme.contains(&table),
            "the README's table is not what `photoncube list` prints; paste this:\n{table}"
        );
        let fits = fit_table(&fit_rows().unwrap());
        assert!(
            readme.contains(&fits),
            "the README's fits are not what `photoncube list` prints; paste this:\n{fits}"
        );
        let paper = tables::elsewhere(&report().unwrap().machines[0].measured.areas);
        assert!(
            readme.contains(&paper),
            "the README's gates are not what `photoncube list` prints; paste this:\n{paper}"
        );
        let source = measured::fmax_source().unwrap();
        assert!(
            readme.contains(&source),
            "the README does not say: {source}"
        );
    }
}
