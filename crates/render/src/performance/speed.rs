//! Measures the speed of an engine's gather on this computer: photon tests per second on one thread, beside
//! plain loops.
//!
//! A photon test is the decision about one photon for one query. The fast gather decides most photons that
//! are out of range by their block or leaf, so it computes fewer distances than the number of tests that are
//! counted here.

use std::hint::black_box;
use std::time::{Duration, Instant};

use glam::Vec3;
use rayon::ThreadPoolBuilder;

use crate::estimate::{Estimator, estimate_f64};
use crate::photon_map::PhotonMap;
use crate::quantise::QuantisedMap;
use crate::render::{Engine, RenderError};
use crate::view::QueryPoint;

/// The duration of a measurement, long compared with a clock tick.
const TIME: Duration = Duration::from_millis(40);

/// The number of repeats. Short disturbances by other processes do not change their median.
const REPEATS: usize = 5;

/// A speed in photon tests per second, measured several times.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Speed {
    /// The median of the repeats.
    pub photon_tests_per_second: f64,
    /// The slowest repeat.
    pub slowest: f64,
    /// The fastest repeat.
    pub fastest: f64,
}

/// The speed of an engine's gather at these queries, as in rendering: engines of integers gather all queries
/// together, photon formats those of a block. [`Engine::F64`] is the plain f64 loop.
///
/// # Errors
/// Formats that do not fit the map, or a query that the golden model refuses.
pub fn gather_speed(
    map: &PhotonMap,
    queries: &[QueryPoint],
    engine: Engine<'_>,
) -> Result<Speed, RenderError> {
    let quantised = engine.quantised(map)?;
    for (index, query) in queries.iter().enumerate() {
        let estimate = Estimator::FixedRadius.estimate(map, quantised.as_ref(), query);
        // The query's index takes the place of its pixel.
        estimate.map_err(|refusal| RenderError::of(refusal, index as u32, 0))?;
    }
    if let Some(quantised) = &quantised {
        return Ok(fast_speed(quantised, queries));
    }
    let tests_of = |query: &QueryPoint| black_box(estimate_f64(map, query)).tests;
    Ok(speed(|| queries.iter().map(tests_of).sum()))
}

/// The speed of the fast gather, with the queries in the order in which it is fastest.
fn fast_speed(map: &QuantisedMap<'_>, queries: &[QueryPoint]) -> Speed {
    let mut queries = queries.to_vec();
    map.map().sort_queries(&mut queries);
    let pool = ThreadPoolBuilder::new().num_threads(1).build();
    pool.expect("a thread").install(|| {
        speed(|| {
            let found = black_box(map.gather_all(&queries, map.radius_sq()));
            found.map_or(0, |found| found.iter().map(|query| query.photons).sum())
        })
    })
}

/// The speed of the reference's loop on f32 copies of the photons.
#[must_use]
pub fn f32_speed(map: &PhotonMap, queries: &[QueryPoint]) -> Speed {
    let photons: Vec<(Vec3, Vec3)> = map
        .photons()
        .iter()
        .map(|photon| (photon.position.as_vec3(), photon.power.as_vec3()))
        .collect();
    let radius_sq = (map.radius() * map.radius()) as f32;
    let tests_of = |query: &QueryPoint| {
        let (centre, mut power, mut tests) = (query.position.as_vec3(), Vec3::ZERO, 0);
        for run in map.candidates(query.position, query.front()) {
            tests += run.photons.len() as u64;
            for (position, flux) in &photons[run.photons] {
                if position.distance_squared(centre) <= radius_sq {
                    power += flux;
                }
            }
        }
        black_box(power);
        tests
    };
    speed(|| queries.iter().map(&tests_of).sum())
}

/// The speed of rounds that return their number of photon tests.
fn speed(mut round: impl FnMut() -> u64) -> Speed {
    let mut repeat = || {
        let start = Instant::now();
        let mut tests = 0;
        while start.elapsed() < TIME {
            tests += round();
        }
        tests as f64 / start.elapsed().as_secs_f64()
    };
    Speed::of(std::array::from_fn(|_| repeat()))
}

impl Speed {
    fn of(mut repeats: [f64; REPEATS]) -> Self {
        repeats.sort_by(f64::total_cmp);
        let median = repeats[REPEATS / 2];
        Self {
            photon_tests_per_second: median,
            slowest: repeats[0],
            fastest: repeats[REPEATS - 1],
        }
    }

    /// The difference of the fastest and the slowest repeat, divided by the median.
    #[must_use]
    pub fn spread(&self) -> f64 {
        (self.fastest - self.slowest) / self.photon_tests_per_second
    }
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{find_machine, find_photon_format};

    use super::*;
    use crate::{BenchOptions, ErrorBench, Scene};

    #[test]
    fn the_median_is_not_moved_by_one_slow_repeat() {
        let speed = Speed::of([100.0, 101.0, 10.0, 99.0, 102.0]);
        assert_eq!(speed.photon_tests_per_second, 100.0);
        assert_eq!((speed.slowest, speed.fastest), (10.0, 102.0));
        assert!((speed.spread() - 0.92).abs() < 1e-12);
    }

    #[test]
    fn every_engine_has_a_speed() {
        let scene = Scene::built_in("cornell").unwrap();
        let options = BenchOptions {
            photons: 5_000,
            maps: 1,
            ..BenchOptions::default()
        };
        let bench = ErrorBench::new(&scene, &options).unwrap();
        let (map, queries) = (&bench.maps()[0], bench.queries());
        let engines = [
            Engine::F64,
            Engine::from(find_machine("paper").unwrap()),
            Engine::from(&find_photon_format("local8-rgb8e5").unwrap()),
        ];
        for engine in engines {
            let speed = gather_speed(map, queries, engine).unwrap();
            assert!(speed.photon_tests_per_second > 0.0 && speed.spread() >= 0.0);
        }
        assert!(f32_speed(map, queries).photon_tests_per_second > 0.0);
    }
}
