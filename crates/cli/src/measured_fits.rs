//! The results of `photoncube fit` for the built-in scenes, which are committed as data like all measured
//! figures.

use anyhow::{Context, Result};
use serde::{Deserialize, Serialize};

use crate::table;

/// By scene, the summary of `photoncube fit SCENE --json`.
const FITS: &[(&str, &str)] = &[
    (
        "cornell",
        include_str!("../../../docs/measured/fit-cornell.json"),
    ),
    ("ring", include_str!("../../../docs/measured/fit-ring.json")),
    (
        "range",
        include_str!("../../../docs/measured/fit-range.json"),
    ),
];

/// The result of a fit for a scene.
#[derive(Clone, Debug, Serialize)]
pub struct FitRow {
    scene: String,
    noise_ratio: f64,
    format: String,
    bits_per_photon: u32,
    machine: String,
    fastest: String,
    predicted_error_over_noise: f64,
    error_over_noise: f64,
    error_over_noise_low: f64,
    error_over_noise_high: f64,
    /// The smallest error of the formats with one bit less.
    one_bit_less_error_over_noise: f64,
}

#[derive(Deserialize)]
struct Fit {
    scene: String,
    noise_ratio: f64,
    fitted: Format,
    removals: Vec<Format>,
    machine: Machine,
    fastest: Machine,
}

#[derive(Deserialize)]
struct Format {
    format: String,
    bits_per_photon: u32,
    prediction: Prediction,
    measurement: Measurement,
}

#[derive(Deserialize)]
struct Prediction {
    error_over_noise: f64,
}

#[derive(Deserialize)]
struct Measurement {
    error_over_noise: f64,
    error_over_noise_low: f64,
    error_over_noise_high: f64,
}

#[derive(Deserialize)]
struct Machine {
    machine: String,
}

/// The committed fits.
pub fn fit_rows() -> Result<Vec<FitRow>> {
    let row = |(scene, text): &(&str, &str)| {
        let fit: Result<Fit, _> = serde_json::from_str(text);
        let fit = fit.with_context(|| format!("docs/measured/fit-{scene}.json"))?;
        Ok(FitRow::of(fit))
    };
    FITS.iter().map(row).collect()
}

impl FitRow {
    fn of(fit: Fit) -> Self {
        let errors = fit.removals.iter().map(|r| r.measurement.error_over_noise);
        let measured = fit.fitted.measurement;
        Self {
            scene: fit.scene,
            noise_ratio: fit.noise_ratio,
            format: fit.fitted.format,
            bits_per_photon: fit.fitted.bits_per_photon,
            machine: fit.machine.machine,
            fastest: fit.fastest.machine,
            predicted_error_over_noise: fit.fitted.prediction.error_over_noise,
            error_over_noise: measured.error_over_noise,
            error_over_noise_low: measured.error_over_noise_low,
            error_over_noise_high: measured.error_over_noise_high,
            one_bit_less_error_over_noise: errors.fold(f64::INFINITY, f64::min),
        }
    }

    /// The format and the machines that were found for the scene.
    fn choice(&self) -> Vec<String> {
        vec![
            self.scene.clone(),
            self.format.clone(),
            self.bits_per_photon.to_string(),
            self.machine.clone(),
            self.fastest.clone(),
        ]
    }

    /// Why nothing less is enough.
    fn errors(&self) -> Vec<String> {
        let ratio = |value: f64| format!("{value:.3}");
        vec![
            self.scene.clone(),
            ratio(self.predicted_error_over_noise),
            format!(
                "{:.3} ({:.3} to {:.3})",
                self.error_over_noise, self.error_over_noise_low, self.error_over_noise_high
            ),
            ratio(self.one_bit_less_error_over_noise),
        ]
    }
}

/// The fits as two tables: the choices, and the error of each beside the noise of its scene.
pub fn fit_table(rows: &[FitRow]) -> String {
    let choices = table::markdown(
        &[
            "scene",
            "fitted format",
            "bits per photon",
            "smallest machine",
            "fastest machine",
        ],
        &rows.iter().map(FitRow::choice).collect::<Vec<_>>(),
    );
    let errors = table::markdown(
        &[
            "scene",
            "error / noise, predicted",
            "measured (95 %)",
            "with a bit less, at least",
        ],
        &rows.iter().map(FitRow::errors).collect::<Vec<_>>(),
    );
    format!("{choices}\n{errors}")
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{find_machine, find_photon_format};

    use super::*;

    /// A machine that is named after a scene has the format that was found for the scene. The format holds
    /// the bound, and one bit less breaks it.
    #[test]
    fn the_fitted_machines_are_those_that_fit_found() {
        for row in fit_rows().unwrap() {
            assert_eq!(row.machine, format!("fit-{}", row.scene));
            let machine = find_machine(&row.machine).unwrap();
            let format = find_photon_format(&row.format).unwrap();
            assert_eq!(machine.format(), Some(&format));
            assert!(row.error_over_noise <= row.noise_ratio, "{row:?}");
            assert!(
                row.one_bit_less_error_over_noise > row.noise_ratio,
                "{row:?}"
            );
            let off = row.predicted_error_over_noise / row.error_over_noise - 1.0;
            assert!(off.abs() < 0.3, "{row:?}");
        }
    }
}
