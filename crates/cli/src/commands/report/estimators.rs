//! The second table of `report`: forms of the estimate, with their cost and their error.
//!
//! The first table shows the effect of a number format on the plain estimate. The second shows the other
//! forms: the k nearest photons by bisection, and the ladder in place of a smooth kernel, in f64 (the
//! ladder's own error) and in the default format.

use photoncube_render::{
    Engine, ErrorBench, ErrorReport, Estimator, EstimatorReport, Kernel, Ladder, MIN_K,
};
use photoncube_spec::{PHOTON_FORMATS, PhotonFormat};
use serde::Serialize;

use super::row::reason;
use crate::{progress, table};

/// The numbers of rungs of the ladders.
const RUNGS: [usize; 3] = [2, 4, 8];

/// k as a fraction of the photons that the search radius is chosen for. The k-th photon is then inside the
/// radius wherever the density is at least a quarter of the mean.
const PART_OF_IN_RANGE: f64 = 0.25;

/// One form of the estimate in one engine.
#[derive(Serialize)]
pub struct Row {
    estimator: String,
    /// The f64 estimate that it approximates; error and noise are relative to that.
    reference: String,
    engine: &'static str,
    format: Option<String>,
    /// The reason why it cannot be made for this scene; null where it can, and the figures are present.
    cannot: Option<String>,
    #[serde(flatten)]
    measured: Option<Measured>,
}

#[derive(Serialize)]
struct Measured {
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

/// Measures every form on the maps of `bench`, whose search radius is chosen for `in_range` photons.
pub fn measure(bench: &ErrorBench, in_range: f64) -> Vec<Row> {
    let cases = cases(&PHOTON_FORMATS[0], in_range);
    let bar = progress::bar("measuring estimators", cases.len() as u64);
    let mut rows = Vec::new();
    for (estimator, engine) in cases {
        rows.push(row(bench, &estimator, engine));
        bar.inc(1);
    }
    bar.finish_and_clear();
    rows
}

fn cases(format: &PhotonFormat, in_range: f64) -> Vec<(Estimator, Engine<'static>)> {
    // `as` saturates.
    let k = ((PART_OF_IN_RANGE * in_range).round() as u64).max(MIN_K);
    let mut cases = vec![(Estimator::KNearest { k }, Engine::from(format))];
    for kernel in [Kernel::Cone, Kernel::Epanechnikov] {
        for engine in [Engine::F64, Engine::from(format)] {
            let ladders = RUNGS.map(|rungs| Ladder::new(kernel, rungs));
            let ladders = ladders.into_iter().flatten();
            cases.extend(ladders.map(|ladder| (Estimator::Ladder(ladder), engine)));
        }
    }
    cases
}

fn row(bench: &ErrorBench, estimator: &Estimator, engine: Engine<'_>) -> Row {
    let measured = bench.measure_estimator(engine, estimator);
    let (engine, format) = match engine {
        Engine::F64 => ("f64", None),
        Engine::Integers(numbers, _) => ("format", numbers.format().map(PhotonFormat::name)),
        Engine::Hardware(machine, _) => ("core", machine.format().map(PhotonFormat::name)),
    };
    Row {
        estimator: estimator.to_string(),
        reference: estimator.reference().to_string(),
        engine,
        format,
        cannot: measured.as_ref().err().map(reason),
        measured: measured.ok().map(Measured::of),
    }
}

impl Measured {
    fn of(report: EstimatorReport) -> Self {
        let error: ErrorReport = report.error;
        Self {
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
        }
    }
}

fn percent(value: f64) -> String {
    format!("{:.3} %", 100.0 * value)
}

/// The table as text for people.
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
    let row = |row: &Row| {
        let figure = |of: fn(&Measured) -> String| row.measured.as_ref().map_or("-".to_owned(), of);
        vec![
            row.estimator.clone(),
            row.format.as_deref().unwrap_or(row.engine).to_owned(),
            row.reference.clone(),
            figure(|m| format!("{:.2}", m.gathers_per_query)),
            figure(|m| percent(m.rms_relative_error)),
            figure(|m| percent(m.noise_relative)),
            figure(|m| format!("{:.4}", m.error_over_noise)),
            figure(|m| format!("{:+.4} %", 100.0 * m.bias_relative)),
            figure(|m| {
                let estimates = m.estimates_compared + m.estimates_too_noisy;
                format!("{} of {estimates}", m.estimates_too_noisy)
            }),
        ]
    };
    let rows: Vec<_> = rows.iter().map(row).collect();
    format!(
        "estimators: error and noise of each against its own reference in f64; every gather tests\n\
         the query's photons once\n\n{}",
        table::markdown(&header, &rows)
    )
}
