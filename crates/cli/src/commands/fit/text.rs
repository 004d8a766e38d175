//! Prints the report of `fit` for people.

use super::{Compared, MachineRow, RemovalRow, Report};
use crate::chains::ChainsChoice;
use crate::fitted::FormatRow;
use crate::table::{self, grouped};

/// The whole text of the report.
pub fn text(report: &Report) -> String {
    let mut text = facts(report);
    let trials = trials(report);
    if !trials.is_empty() {
        text += "\nPredicted on the pilot, then measured on maps of their own; error / noise:\n";
        text += &trials;
    }
    if let Some(fitted) = &report.fitted {
        text += &format!(
            "\n{}: {} bits per photon, error / noise {:.4}, below {}; each removal above it\n",
            fitted.format,
            fitted.bits_per_photon,
            fitted.measurement.error_over_noise,
            report.noise_ratio
        );
        text += "\nLeft out of the default format, and the bits of a photon that each saves:\n";
        text += &left_out(report);
        text += "\nWhat that saves (area in LUT4 equivalents, no DSP):\n";
        text += &comparison(&report.comparison);
    }
    if let (Some(smallest), Some(fastest)) = (&report.machine, &report.fastest) {
        text += &format!("\nsmallest machine {}\n", machine_line(smallest));
        text += &format!(
            "fastest machine whose every field is wide enough {}\n",
            machine_line(fastest)
        );
        text += &format!(
            "a picture of these two machines is the {} queries of the fit, one a pixel\n",
            grouped(report.query_points)
        );
    }
    text += &report
        .cores
        .as_ref()
        .map_or_else(String::new, ChainsChoice::text);
    for file in &report.emitted {
        text += &format!("wrote {file}\n");
    }
    if let Some(next) = &report.next {
        text += &format!("go on with:\n  {next}\n");
    }
    text + &format!("{:.0} s\n", report.seconds)
}

fn facts(report: &Report) -> String {
    let light = &report.light;
    format!(
        "{}: noise {:.2} % rms over {} maps of {} photons at least; pilot of {} maps\n\
         \x20 in range     {:.0} photons on average, {} aimed at among the photons asked for\n\
         \x20 colours      {} (photons deviate from one colour by {:.0e})\n\
         \x20 powers       the strongest photon has {:.6} times the weakest's\n\
         \x20 largest query {} photons\n\
         \x20 candidates   {}, predicted from {} figures of the pilot\n",
        report.scene,
        100.0 * report.noise_relative,
        report.maps,
        report.photons,
        report.pilot_maps,
        report.photons_in_range_mean,
        report.in_range,
        if light.one_colour { "one" } else { "several" },
        light.colour_deviation,
        light.power_spread,
        light.largest_query,
        report.candidates,
        report.pilot_figures,
    )
}

/// The measured formats; empty where none was predicted to be within the bound.
fn trials(report: &Report) -> String {
    let header = [
        "",
        "format",
        "bits/photon",
        "predicted",
        "measured",
        "95 % interval",
        "positions",
        "powers",
        "even light",
        "worst in",
        "luminance",
    ];
    let broken = report
        .broken
        .iter()
        .map(|row| cells("too small".to_owned(), row));
    let fitted = report
        .fitted
        .iter()
        .map(|row| cells("fitted".to_owned(), row));
    let less = |removal: &RemovalRow| cells(format!("less: {}", removal.less), &removal.row);
    let removals = report.removals.iter().map(less);
    let rows: Vec<_> = broken.chain(fitted).chain(removals).collect();
    match rows.is_empty() {
        true => String::new(),
        false => table::markdown(&header, &rows),
    }
}

fn cells(what: String, row: &FormatRow) -> Vec<String> {
    let (prediction, measurement) = (&row.prediction, &row.measurement);
    let figure = |value: f64| format!("{value:.4}");
    vec![
        what,
        row.format.clone(),
        row.bits_per_photon.to_string(),
        figure(prediction.error_over_noise),
        figure(measurement.error_over_noise),
        format!(
            "{:.4} to {:.4}",
            measurement.error_over_noise_low, measurement.error_over_noise_high
        ),
        figure(prediction.position_error_over_noise),
        figure(prediction.power_error_over_noise),
        figure(prediction.law_error_over_noise),
        measurement.measure.name().to_owned(),
        figure(measurement.luminance_error_over_noise),
    ]
}

fn left_out(report: &Report) -> String {
    let header = ["field", "default", "fitted", "saved", "because"];
    let rows = report.left_out.iter().map(|row| {
        vec![
            row.field.to_owned(),
            row.default.to_string(),
            row.fitted.to_string(),
            row.bits_saved.to_string(),
            row.because.clone(),
        ]
    });
    table::markdown(&header, &rows.collect::<Vec<_>>())
}

fn comparison(rows: &[Compared]) -> String {
    let header = [
        "machine",
        "format",
        "bits/photon",
        "saved",
        "area",
        "clocks",
        "Fmax",
        "FF",
        "radius",
        "power",
        "work",
        "sum",
    ];
    let unknown = || "not measured".to_owned();
    let row = |row: &Compared| {
        vec![
            row.name.clone(),
            row.format.clone().unwrap_or_else(|| "plain".to_owned()),
            row.bits_per_photon.to_string(),
            row.bits_per_photon_saved.to_string(),
            row.lut4_equivalents
                .map_or_else(unknown, |area| area.to_string()),
            format!(
                "{} for {} photons",
                row.initiation_interval, row.photons_per_iteration
            ),
            row.fmax_mhz
                .map_or_else(unknown, |fmax| format!("{fmax:.0} MHz")),
            row.ff.map_or_else(unknown, |ff| ff.to_string()),
            row.radius_bits.to_string(),
            row.power_bits.to_string(),
            row.work_bits.to_string(),
            row.sum_bits.to_string(),
        ]
    };
    table::markdown(&header, &rows.iter().map(row).collect::<Vec<_>>())
}

fn machine_line(row: &MachineRow) -> String {
    let wider: Vec<_> = row
        .wider_than_needed
        .iter()
        .map(|need| format!("{} {} for {}", need.field, need.found, need.needed))
        .collect();
    let wider = match wider.is_empty() {
        true => "exactly as wide as needed".to_owned(),
        false => format!("wider than needed: {}", wider.join(", ")),
    };
    format!(
        "{} ({}): {wider}; error / noise {:.4}; {}",
        row.machine,
        row.format,
        row.measurement.error_over_noise,
        row.time.text()
    )
}
