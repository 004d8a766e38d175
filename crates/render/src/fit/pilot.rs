//! The pilot: separate photon maps on which a scene is measured before any format is.

use glam::DVec3;

use crate::metrics::{
    BenchError, BenchOptions, ErrorBench, Measure, MetricsError, Moments, NoiseMeter,
};

use super::facts::SceneFacts;

/// The moments of a relative error for each of [`Measure::ALL`], over the sampled queries of all pilot maps.
pub(super) type Part = [Moments; Measure::ALL.len()];

/// The pilot's maps, with the scales of the errors on them.
pub(super) struct Pilot {
    pub bench: ErrorBench,
    pub facts: SceneFacts,
    /// The scale of each measure.
    scales: Vec<Scale>,
}

/// The scale of the errors of one measure, as in [`crate::ErrorStudy`].
struct Scale {
    /// The expected light of each query; `None` for queries that a study leaves out.
    expected: Vec<Option<f64>>,
    /// The noise; `None` where the measure has no light.
    noise: Option<f64>,
}

impl Pilot {
    pub fn new(bench: ErrorBench) -> Result<Self, BenchError> {
        let scale = |measure| Scale::of(&bench, measure);
        let scales = Measure::ALL.into_iter().map(scale);
        let scales = scales.collect::<Result<Vec<_>, _>>()?;
        let facts = SceneFacts::of(bench.maps(), bench.queries());
        Ok(Self {
            scales,
            facts,
            bench,
        })
    }

    /// The noise of a measure; `None` where it has no light.
    pub fn noise(&self, measure: Measure) -> Option<f64> {
        self.scales[measure as usize].noise
    }

    /// Adds a map's estimates to the part. They are reflected light in the order of the queries.
    pub fn push(&self, part: &mut Part, map: usize, estimates: &[DVec3]) {
        let lights = &self.bench.lights()[map];
        for (measure, moments) in Measure::ALL.into_iter().zip(part) {
            let expected = &self.scales[measure as usize].expected;
            for ((estimate, light), expected) in estimates.iter().zip(lights).zip(expected) {
                if let Some(expected) = expected {
                    moments.push(measure.of(estimate - light) / expected);
                }
            }
        }
    }
}

impl Scale {
    fn of(bench: &ErrorBench, measure: Measure) -> Result<Self, BenchError> {
        let mut meter = NoiseMeter::new(bench.queries().len());
        for lights in bench.lights() {
            let values: Vec<f64> = lights.iter().map(|light| measure.of(*light)).collect();
            meter.push_map(&values)?;
        }
        let queries = 0..bench.queries().len();
        let expected =
            queries.map(|query| meter.is_sampled(query).then(|| meter.mean_of_query(query)));
        let noise = match (meter.noise(), measure) {
            (Ok(noise), _) if noise.relative > 0.0 => Some(noise.relative),
            (Ok(_), Measure::Luminance) => return Err(MetricsError::NoNoise.into()),
            (Err(error), Measure::Luminance) => return Err(error.into()),
            _ => None,
        };
        Ok(Self {
            expected: expected.collect(),
            noise,
        })
    }
}

/// The distance of the pilot's seeds from those of the measurement, larger than any number of maps.
const SEEDS_APART: u64 = 1 << 32;

/// The fewest maps that measure the noise usefully: 7 degrees of freedom give each query's variance to half
/// of itself, and thousands of queries average this error.
const LEAST_MAPS: u64 = 8;

/// The pilot's options: those of the measurement with other seeds and other points of the view.
pub(super) fn pilot_options(options: &BenchOptions) -> BenchOptions {
    let seed = options.seed.wrapping_add(SEEDS_APART);
    let mut view = options.view;
    view.seed = seed;
    BenchOptions {
        maps: LEAST_MAPS.max(options.maps / 2),
        seed,
        view,
        ..*options
    }
}
