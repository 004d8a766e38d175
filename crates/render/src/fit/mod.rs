//! The smallest photon format that a scene needs.
//!
//! [`fit`] traces a pilot, and measures the scene's light and noise on it. It predicts the error of every
//! format from two parts (positions alone, powers alone). It takes the cheapest format that is predicted
//! below a given fraction of the noise, measures it on other photon maps, and removes bits until none can be
//! removed. The format found is measured to hold the bound, and each format with one bit less is measured to
//! break it.
//!
//! # What must be below the bound
//! [`crate::ErrorReport::error_over_noise`] of luminance *and* of each channel against its own
//! noise ([`crate::Measure`]). Luminance alone would pass wrong colours: on the Cornell box three
//! bits of dithered RGB are at 0.08 of the noise in luminance and at 0.34 in blue. One channel
//! passes only where all photons have one colour exactly.
//!
//! All is a function of scene and options; the number of threads does not matter.

mod candidates;
mod facts;
mod machine;
mod pilot;
mod position;
mod power;
mod predict;
mod search;

use std::collections::HashMap;

use photoncube_spec::PhotonFormat;
use thiserror::Error;

pub use self::facts::{SceneFacts, largest_query};
pub use self::machine::{FieldNeed, covering, covers, fed, field_needs};
pub use self::predict::Prediction;
pub use self::search::{Measurement, Removal, Trial};

use self::candidates::{candidates, max_photons};
use self::pilot::{Pilot, pilot_options};
use self::predict::Predictor;
use self::search::Search;
use crate::metrics::{BenchError, BenchOptions, ErrorBench};
use crate::render::Engine;
use crate::scene::Scene;
use crate::view::ViewOptions;

/// The options of a fit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitOptions {
    /// The bound of the error, as a fraction of the noise.
    pub noise_ratio: f64,
    /// The maps and queries on which formats are measured. The pilot has as many photons and the same radius,
    /// half the maps, and its own seeds.
    pub bench: BenchOptions,
    /// The largest number of photons that a query is known to test, 0 if none is known. The sums are sized
    /// for at least this many.
    pub largest_query: u64,
}

/// A tenth of the noise: noise and error add as squares, to 1.005 of the noise. 16 maps of 200,000
/// photons at 64 x 64 points of the view: a caustic's error is made by few events (a bright line
/// along the border of a query's disc); even so its 95 % interval is some 15 % wide to each side, 6 %
/// where there is none.
impl Default for FitOptions {
    fn default() -> Self {
        let seed = 1;
        Self {
            noise_ratio: 0.1,
            bench: BenchOptions {
                photons: 200_000,
                maps: 16,
                seed,
                view: ViewOptions {
                    width: 64,
                    height: 64,
                    samples_per_axis: 1,
                    seed,
                },
                ..BenchOptions::default()
            },
            largest_query: 0,
        }
    }
}

/// The progress of a fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FitProgress {
    /// The number of photon maps traced and figures measured: parts of predictions, and formats.
    pub done: u64,
    /// The expected number. The number of maps is known; the number of figures is an estimate that grows
    /// where there are more.
    pub expected: u64,
}

/// The number of figures that a fit measures: 11 on `ring`, 40 on `cornell`, 135 on `range`.
const TYPICAL_FIGURES: u64 = 50;
/// The number of formats with one bit less that any fit measures last.
const LAST_FIGURES: u64 = 6;

impl FitProgress {
    fn of(maps: u64, all_maps: u64, figures: u64) -> Self {
        let expected = TYPICAL_FIGURES.max(figures + LAST_FIGURES);
        Self {
            done: maps + figures,
            expected: all_maps + expected,
        }
    }
}

/// The reason why there is no fit.
#[derive(Debug, Error)]
pub enum FitError {
    /// A ratio that no error is below.
    #[error("noise ratio: found {found}, expected a number above 0")]
    Ratio {
        /// The ratio that was given.
        found: f64,
    },
    /// The scene cannot be measured.
    #[error(transparent)]
    Bench(#[from] BenchError),
}

/// The result of a fit, with its evidence.
#[derive(Debug)]
pub struct Fit {
    /// The facts about the scene's light.
    pub facts: SceneFacts,
    /// The number of the pilot's maps.
    pub pilot_maps: u64,
    /// The noise of luminance on the measurement's maps.
    pub noise_relative: f64,
    /// The number of formats to choose from.
    pub candidates: u64,
    /// The number of parts that the pilot measured for the predictions.
    pub parts: u64,
    /// Formats that were predicted below the bound and then measured above it.
    pub broken: Vec<Trial>,
    /// The chosen format; `None` where no legal format is below the bound.
    pub chosen: Option<Trial>,
    /// The candidate with the most bits, where no legal format is below the bound: what the error can come down to.
    pub widest: Option<Trial>,
    /// The effect of removing one bit from it, for each removal.
    pub removals: Vec<Removal>,
    /// The maps of the measurement, for further measurements.
    pub bench: ErrorBench,
}

/// Finds the smallest format whose error is below the bound on this scene.
///
/// `progress` is called after each photon map and each figure.
///
/// # Errors
/// A ratio that is not above 0, or a scene that cannot be measured.
pub fn fit(
    scene: &Scene,
    options: &FitOptions,
    progress: &dyn Fn(FitProgress),
) -> Result<Fit, FitError> {
    let found = options.noise_ratio;
    if !(found.is_finite() && found > 0.0) {
        return Err(FitError::Ratio { found });
    }
    let pilot_options = pilot_options(&options.bench);
    let all_maps = pilot_options.maps + options.bench.maps;
    let traced = |maps| progress(FitProgress::of(maps, all_maps, 0));
    let pilot = Pilot::new(ErrorBench::traced(scene, &pilot_options, &traced)?)?;
    let traced = |maps| traced(pilot_options.maps + maps);
    let bench = ErrorBench::traced(scene, &options.bench, &traced)?;
    let facts = facts(&pilot, &bench);
    let max_photons = max_photons(facts.largest_query, options.largest_query);
    let formats = candidates(&facts, max_photons);
    let pilot_maps = pilot.bench.maps().len() as u64;
    let mut search = Search {
        predictor: Predictor::new(pilot)?,
        proof: &bench,
        noise_ratio: options.noise_ratio,
        measured: HashMap::new(),
        progress: &|figures| progress(FitProgress::of(all_maps, all_maps, figures)),
    };
    let (first, broken) = search.first(&formats)?;
    // Where the prediction rejects every candidate, the measurement of the widest has the last word.
    let first = match first {
        None => search.widest(&formats)?,
        first => first,
    };
    let (chosen, widest, removals) = match first {
        None => (None, None, Vec::new()),
        Some(widest) if !widest.holds => (None, Some(widest), Vec::new()),
        Some(first) => {
            let (chosen, removals) = search.descend(first)?;
            (Some(chosen), None, removals)
        }
    };
    Ok(Fit {
        facts,
        pilot_maps,
        noise_relative: bench.measure(Engine::F64)?.noise_relative,
        candidates: formats.len() as u64,
        parts: search.predictor.parts(),
        broken,
        chosen,
        widest,
        removals,
        bench,
    })
}

/// The pilot's facts, and the largest query of all maps.
fn facts(pilot: &Pilot, bench: &ErrorBench) -> SceneFacts {
    let maps = bench.maps().iter();
    let queries = maps.map(|map| largest_query(map, bench.queries()));
    SceneFacts {
        largest_query: queries.fold(pilot.facts.largest_query, u64::max),
        ..pilot.facts
    }
}

impl Fit {
    /// Measures the error of another format on the same maps.
    ///
    /// # Errors
    /// As for [`ErrorBench::measure`].
    pub fn measure(&self, format: &PhotonFormat) -> Result<Measurement, BenchError> {
        let report = self.bench.measure_light(Engine::from(format))?;
        Ok(Measurement::of(&report))
    }
}
