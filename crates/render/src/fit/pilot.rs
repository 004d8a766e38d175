//! The pilot: photon maps of their own on which a scene is measured before any format is.

use glam::DVec3;

use crate::metrics::{
    BenchError, BenchOptions, ErrorBench, Measure, MetricsError, Moments, NoiseMeter,
};

use super::facts::SceneFacts;

/// A relative error by [`Measure::ALL`]: over the sampled queries of all pilot maps.
pub(super) type Part = [Moments; Measure::ALL.len()];

/// The pilot's maps, with what every error on them is relative to.
pub(super) struct Pilot {
    pub bench: ErrorBench,
    pub facts: SceneFacts,
    /// By measure.
    scales: Vec<Scale>,
}

/// What errors of one measure are relative to, as in [`crate::ErrorStudy`].
struct Scale {
    /// A query's expected light; none for queries that a study leaves out.
    expected: Vec<Option<f64>>,
    /// The noise; none where the measure has no light.
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

    /// The noise of a measure; none where it has no light.
    pub fn noise(&self, measure: Measure) -> Option<f64> {
        self.scales[measure as usize].noise
    }

    /// Takes a map's estimates, reflected light in the queries' order, into the part.
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

/// Seeds of the pilot's maps are this far from those that the formats are then measured on: more
/// than anyone's count of maps.
const SEEDS_APART: u64 = 1 << 32;

/// The fewest maps that show a noise worth the name: 7 degrees of freedom know each query's
/// variance to half of itself, and thousands of queries all of it.
const LEAST_MAPS: u64 = 8;

/// The pilot's options for those of the measurement: its own seeds, its own points of the view.
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
