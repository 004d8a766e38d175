//! The report's second table: forms of the estimate, what each costs and how wrong it is.
//!
//! The first table asks what a number format does to the plain estimate. This one asks what
//! becomes of the others: the k nearest by bisection, and the ladder in place of a smooth kernel, in
//! f64 (the ladder's own error) and in the default format.

use anyhow::Result;
use photoncube_render::{Engine, ErrorBench, Estimator, Kernel, MIN_K};
use photoncube_spec::{PHOTON_FORMATS, PhotonFormat};
use serde::Serialize;

use crate::{progress, table};

/// Rungs of the ladders.
const RUNGS: [usize; 3] = [2, 4, 8];

/// k as a part of the photons that the search radius aims at: the k-th photon is then inside the
/// radius wherever a quarter of the mean density or more is.
const PART_OF_IN_RANGE: f64 = 0.25;

/// One form of the estimate in one engine.
#[derive(Serialize)]
pub struct Row {
    estimator: String,
    /// What it stands for in f64; error and noise are against that.
    reference: String,
    engine: &'static str,
    format: Option<String>,
    gathers_per_query: f64,
    rms_relative_error: f64,
    rms_relative_error_low: f64,
    rms_relative_error_high: f64,
    noise_relative: f64,
    error_over_noise: f64,
    bias_relative: f64,
    bias_relative_low: f64,
    bias_relative_high: f64,
    estimates_compared: u64,
    estimates_too_noisy: u64,
}

/// Measures every form on the maps of `bench`, whose search radius aims at `in_range` photons.
pub fn measure(bench: &ErrorBench, in_range: f64) -> Result<Vec<Row>> {
    let cases = cases(&PHOTON_FORMATS[0], in_range);
    let bar = progress::bar("measuring estimators", cases.len() as u64);
    let mut rows = Vec::new();
    for (estimator, engine) in cases {
        rows.push(row(bench, estimator, engine)?);
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(rows)
}

fn cases(format: &'static PhotonFormat, in_range: f64) -> Vec<(Estimator, Engine<'static>)> {
    // `as` saturates.
    let k = ((PART_OF_IN_RANGE * in_range).round() as u64).max(MIN_K);
    let mut cases = vec![(Estimator::KNearest { k }, Engine::Format(format))];
    for kernel in [Kernel::Cone, Kernel::Epanechnikov] {
        for engine in [Engine::F64, Engine::Format(format)] {
            let ladder = |rungs| (Estimator::Ladder { kernel, rungs }, engine);
            cases.extend(RUNGS.map(ladder));
        }
    }
    cases
}

fn row(bench: &ErrorBench, estimator: Estimator, engine: Engine<'static>) -> Result<Row> {
    let report = bench.measure_estimator(engine, estimator)?;
    let error = report.error;
    let (engine, format) = match engine {
        Engine::F64 => ("f64", None),
        Engine::Model(_) => ("model", None),
        Engine::Format(format) => ("format", Some(format.name())),
    };
    Ok(Row {
        estimator: estimator.to_string(),
        reference: estimator.reference().to_string(),
        engine,
        format,
        gathers_per_query: report.gathers_per_query,
        rms_relative_error: error.rms_relative_error,
        rms_relative_error_low: error.rms_relative_error_low,
        rms_relative_error_high: error.rms_relative_error_high,
        noise_relative: error.noise_relative,
        error_over_noise: error.error_over_noise,
        bias_relative: error.bias_relative,
        bias_relative_low: error.bias_relative_low,
        bias_relative_high: error.bias_relative_high,
        estimates_compared: error.estimates_compared,
        estimates_too_noisy: error.estimates_too_noisy,
    })
}

/// The table for people.
pub fn text(rows: &[Row]) -> String {
    let header = [
        "estimator",
        "in",
        "against f64",
        "gathers/query",
        "rms error",
        "noise",
        "error/noise",
        "bias",
        "left out",
    ];
    let percent = |value: f64| format!("{:.3} %", 100.0 * value);
    let row = |row: &Row| {
        let estimates = row.estimates_compared + row.estimates_too_noisy;
        vec![
            row.estimator.clone(),
            row.format.as_deref().unwrap_or(row.engine).to_owned(),
            row.reference.clone(),
            format!("{:.2}", row.gathers_per_query),
            percent(row.rms_relative_error),
            percent(row.noise_relative),
            format!("{:.4}", row.error_over_noise),
            format!("{:+.4} %", 100.0 * row.bias_relative),
            format!("{} of {estimates}", row.estimates_too_noisy),
        ]
    };
    let rows: Vec<_> = rows.iter().map(row).collect();
    format!(
        "estimators: error and noise of each against its own reference in f64; every gather tests\n\
         the query's photons once\n\n{}",
        table::markdown(&header, &rows)
    )
}
