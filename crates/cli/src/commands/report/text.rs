//! Prints the report for people, with the verdict first.

use photoncube_render::{BATCH_PATHS, MAX_QUERY_NOISE};

use super::row::Row;
use super::{Report, dimensions, estimators};
use crate::hardware::digits;
use crate::table;

/// The whole text of the report.
pub fn text(report: &Report) -> String {
    let facts = &report.facts;
    format!(
        "{}: {}\npage: {}\n\n\
         noise {} rms over {} maps of at least {} photons ({} stored in the first: batches of {BATCH_PATHS} paths are \
         completed);\n{:.0} in range on average, {} aimed at; {} of {} estimates left out, their queries noisier than {}\n\n\
         {}{}\
         f64 loop {:.0} M photon tests/s, f32 loop {:.0}; `-`: a format by itself, or not measured\n{}\
         plots: {}, {}, {}\n\n{}\n\
         Tiles of every dimension, plot {}:\n\n{}",
        report.scene,
        report
            .scene_needs
            .text(report.noise_ratio, report.query_points),
        report.page,
        percent(report.noise_relative),
        report.maps,
        report.photons,
        facts.photons_found,
        facts.photons_in_range_mean,
        report.in_range,
        facts.estimates_too_noisy,
        facts.estimates,
        percent(MAX_QUERY_NOISE),
        rows(report),
        cannot(report),
        report.speeds.f64_photon_tests_per_second / 1e6,
        report.speeds.f32_photon_tests_per_second / 1e6,
        report.speeds.warning().unwrap_or_default(),
        report.speed_plot,
        report.bits_plot,
        report.hardware_plot,
        estimators::text(&report.estimators),
        report.dimensions_plot,
        dimensions::text(&report.dimensions),
    )
}

fn percent(value: f64) -> String {
    format!("{:.3} %", 100.0 * value)
}

fn rows(report: &Report) -> String {
    let within = format!("within {}", report.noise_ratio);
    let header = [
        "machine",
        "format",
        "bits/photon",
        "error/noise",
        &within,
        "pictures/s",
        "clocks",
        "tests/clock",
        "LUT4 + CCU2C",
        "Fmax",
        "M tests/s at Fmax",
        "rms error",
        "p99",
        "bias",
        "misclassified",
        "model, M tests/s",
        "best in",
    ];
    let rows: Vec<_> = report.rows.iter().map(cells).collect();
    table::markdown(&header, &rows)
}

fn cells(row: &Row) -> Vec<String> {
    let or_dash = |text: Option<String>| text.unwrap_or_else(|| "-".to_owned());
    let (hardware, error) = (&row.hardware, row.error.as_ref());
    let area = hardware.area_without_dsp.as_ref();
    let clock = hardware.time.fmax_mhz.zip(hardware.time.speed_grade);
    vec![
        match row.is_format() {
            true => "-".to_owned(),
            false => row.name.clone(),
        },
        row.format.clone().unwrap_or_else(|| "plain".to_owned()),
        row.bits_per_photon.to_string(),
        or_dash(row.error_over_noise().map(|error| format!("{error:.4}"))),
        verdict_of(row).to_owned(),
        or_dash(row.pictures_per_second().map(digits)),
        or_dash(
            hardware
                .initiation_interval
                .map(|clocks| clocks.to_string()),
        ),
        or_dash(
            hardware
                .photon_tests_per_clock
                .map(|rate| format!("{rate:.3}")),
        ),
        or_dash(area.map(|area| format!("{} + {}", area.lut4, area.ccu2c))),
        or_dash(clock.map(|(mhz, grade)| format!("{mhz:.0} MHz (-{grade})"))),
        or_dash(
            hardware
                .photon_tests_per_second_at_fmax
                .map(|speed| format!("{:.1}", speed / 1e6)),
        ),
        or_dash(error.map(|error| percent(error.rms_relative_error))),
        or_dash(error.map(|error| percent(error.p99_relative_error))),
        or_dash(error.map(|error| format!("{:+.4} %", 100.0 * error.bias_relative))),
        or_dash(error.map(|error| format!("{:.3} %", error.misclassified_percent))),
        or_dash(
            row.photon_tests_per_second
                .map(|speed| format!("{:.0}", speed / 1e6)),
        ),
        best_in(row),
    ]
}

fn verdict_of(row: &Row) -> &'static str {
    match (&row.cannot, row.within_bound) {
        (Some(_), _) => "CANNOT",
        (None, true) => "yes",
        (None, false) => "NO",
    }
}

/// The Pareto fronts that a row is on.
fn best_in(row: &Row) -> String {
    let fronts = [
        (row.on_bits_front, "bits"),
        (row.on_hardware_front, "hardware"),
        (row.on_speed_front, "model"),
    ];
    let names = fronts.iter().filter(|(is_on, _)| *is_on);
    names.map(|(_, name)| *name).collect::<Vec<_>>().join(", ")
}

/// Lines that state why some rows have no figures: one for each reason, with all rows that have it.
fn cannot(report: &Report) -> String {
    let mut reasons: Vec<(&str, Vec<&str>)> = Vec::new();
    for row in &report.rows {
        let Some(reason) = &row.cannot else { continue };
        match reasons.iter_mut().find(|(other, _)| other == reason) {
            Some((_, names)) => names.push(&row.name),
            None => reasons.push((reason, vec![&row.name])),
        }
    }
    let line = |(reason, names): (&str, Vec<&str>)| {
        format!("{} cannot take this scene: {reason}\n", names.join(", "))
    };
    match reasons.is_empty() {
        true => "\n".to_owned(),
        false => {
            let lines: String = reasons.into_iter().map(line).collect();
            format!("\n{lines}fewer photons in range, by --in-range, need less\n\n")
        }
    }
}
