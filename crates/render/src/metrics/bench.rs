//! Where every engine is measured alike: several photon maps of a scene, and queries of its view.

use photoncube_model::{GatherError, LocalError, gather};
use rayon::prelude::*;
use thiserror::Error;

use super::error::MetricsError;
use super::misclassified::Misclassified;
use super::queries::{luminance, view_queries};
use super::study::{ErrorReport, ErrorStudy};
use crate::estimate::{Refusal, estimate_f64};
use crate::format_map::FormatMap;
use crate::photon_map::{MapError, PhotonMap};
use crate::quantise::QuantisedMap;
use crate::render::{Engine, Prepared, RenderError};
use crate::scene::Scene;
use crate::trace::{TraceError, TraceOptions, trace};
use crate::view::{QueryPoint, ViewError, ViewOptions};

/// What to measure on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BenchOptions {
    /// Photons of each map.
    pub photons: u64,
    /// Photons in range that the search radius is chosen for, by [`PhotonMap::radius_for`].
    pub in_range: f64,
    /// Independent photon maps, at least 2; their seeds count up from `seed`.
    pub maps: u64,
    /// The first map's seed.
    pub seed: u64,
    /// The picture whose query points are asked.
    pub view: ViewOptions,
}

/// 12 maps of 100,000 photons, about 200 in range, at 24 x 24 points of the view. The noise is then
/// known to about 1 %: sqrt(2 / 11) of each query's variance, by the root of 576 queries.
impl Default for BenchOptions {
    fn default() -> Self {
        Self {
            photons: 100_000,
            in_range: 200.0,
            maps: 12,
            seed: 1,
            view: ViewOptions {
                width: 24,
                height: 24,
                samples_per_axis: 1,
                seed: 1,
            },
        }
    }
}

/// Why an error cannot be measured.
#[derive(Debug, Error)]
pub enum BenchError {
    /// The picture has no pixels.
    #[error(transparent)]
    View(#[from] ViewError),
    /// No photons.
    #[error(transparent)]
    Trace(#[from] TraceError),
    /// The radius gives no map.
    #[error(transparent)]
    Map(#[from] MapError),
    /// The machine's or the photon format's rules do not fit.
    #[error(transparent)]
    Engine(#[from] RenderError),
    /// The machine's golden model refused a query.
    #[error(transparent)]
    Gather(#[from] GatherError),
    /// The photon format's golden model refused a query.
    #[error(transparent)]
    Local(#[from] LocalError),
    /// There is nothing to compare.
    #[error(transparent)]
    Metrics(#[from] MetricsError),
}

impl From<Refusal> for BenchError {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::Machine(error) => Self::Gather(error),
            Refusal::Format(error) => Self::Local(error),
        }
    }
}

/// Photon maps of different seeds, query points, and the f64 reference of each at each. Traced
/// once, it serves any number of engines.
#[derive(Debug, Clone)]
pub struct ErrorBench {
    queries: Vec<QueryPoint>,
    maps: Vec<PhotonMap>,
    /// Luminance by map and query.
    references: Vec<Vec<f64>>,
}

impl ErrorBench {
    /// Traces the maps.
    ///
    /// # Errors
    /// Options that give no picture, no photons or no map.
    pub fn new(scene: &Scene, options: &BenchOptions) -> Result<Self, BenchError> {
        let queries = view_queries(scene, &options.view)?;
        let photons = options.photons;
        let radius = PhotonMap::radius_for(scene, photons, options.in_range);
        let map = |index: u64| -> Result<PhotonMap, BenchError> {
            let seed = options.seed.wrapping_add(index);
            let trace = trace(scene, &TraceOptions { photons, seed }, &|_| ())?;
            Ok(PhotonMap::new(scene, trace.photons, radius)?)
        };
        let maps = (0..options.maps).map(map).collect::<Result<Vec<_>, _>>()?;
        let references = maps.iter().map(|map| references(map, &queries)).collect();
        Ok(Self {
            queries,
            maps,
            references,
        })
    }

    /// The query points.
    #[must_use]
    pub fn queries(&self) -> &[QueryPoint] {
        &self.queries
    }

    /// The photon maps.
    #[must_use]
    pub fn maps(&self) -> &[PhotonMap] {
        &self.maps
    }

    /// The f64 reference on each map: reflected luminance at each query, in order.
    #[must_use]
    pub fn references(&self) -> &[Vec<f64>] {
        &self.references
    }

    /// The engine's error against the reference on the same photons, beside the noise.
    ///
    /// # Errors
    /// Formats that do not fit the maps, a query that the golden model refuses, or nothing to
    /// compare.
    pub fn measure(&self, engine: Engine<'_>) -> Result<ErrorReport, BenchError> {
        let mut study = ErrorStudy::new(self.queries.len());
        for (map, references) in self.maps.iter().zip(&self.references) {
            let prepared = Prepared::new(map, engine)?;
            let answers = self.queries.par_iter();
            let answers = answers.map(|query| answer(&prepared, map, query));
            let answers = answers.collect::<Result<Vec<_>, _>>()?;
            let mut counts = Misclassified::default();
            answers.iter().for_each(|(_, count)| counts += *count);
            let estimates: Vec<f64> = answers.iter().map(|(estimate, _)| *estimate).collect();
            study.push_map(&estimates, references, counts)?;
        }
        Ok(study.report()?)
    }
}

fn references(map: &PhotonMap, queries: &[QueryPoint]) -> Vec<f64> {
    let queries = queries.par_iter();
    let values = queries.map(|q| luminance(q.beta * estimate_f64(map, q).irradiance));
    values.collect()
}

/// Reflected luminance at the query, and the verdicts on its photons.
fn answer(
    prepared: &Prepared<'_>,
    map: &PhotonMap,
    query: &QueryPoint,
) -> Result<(f64, Misclassified), BenchError> {
    let estimate = prepared.estimate(map, query)?;
    let verdicts = match prepared {
        Prepared::F64 => f64_verdicts(map, query),
        Prepared::Model(quantised) => model_verdicts(map, quantised, query)?,
        Prepared::Format(quantised, _) => format_verdicts(quantised, query),
    };
    Ok((luminance(query.beta * estimate.irradiance), verdicts))
}

fn is_in_range(map: &PhotonMap, photon: &crate::Photon, query: &QueryPoint) -> bool {
    photon.position.distance_squared(query.position) <= map.radius() * map.radius()
}

fn f64_verdicts(map: &PhotonMap, query: &QueryPoint) -> Misclassified {
    let mut counts = Misclassified::default();
    for run in map.candidates(query.position, query.normal) {
        for photon in &map.photons()[run.photons] {
            let inside = is_in_range(map, photon, query);
            counts.push(inside, inside);
        }
    }
    counts
}

/// The golden model itself decides, photon by photon.
fn model_verdicts(
    map: &PhotonMap,
    quantised: &QuantisedMap<'_>,
    query: &QueryPoint,
) -> Result<Misclassified, GatherError> {
    let runs = map.candidates(query.position, query.normal);
    let floats = runs.flat_map(|run| &map.photons()[run.photons]);
    let integers = quantised.photons(query.position, query.normal);
    let centre = quantised.query(query.position);
    let mut counts = Misclassified::default();
    for (float, integer) in floats.zip(integers) {
        let sums = gather(quantised.machine(), &centre, [integer])?;
        counts.push(is_in_range(map, float, query), sums.count == 1);
    }
    Ok(counts)
}

fn format_verdicts(quantised: &FormatMap<'_>, query: &QueryPoint) -> Misclassified {
    let mut counts = Misclassified::default();
    for (photon, verdict) in quantised.verdicts(query.position, query.normal) {
        counts.push(is_in_range(quantised.map(), photon, query), verdict);
    }
    counts
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{PHOTON_FORMATS, find_machine};

    use super::*;

    fn options() -> BenchOptions {
        BenchOptions {
            photons: 20_000,
            in_range: 50.0,
            maps: 3,
            ..BenchOptions::default()
        }
    }

    fn bench() -> ErrorBench {
        ErrorBench::new(&Scene::built_in("cornell").unwrap(), &options()).unwrap()
    }

    #[test]
    fn the_reference_has_no_error() {
        let report = bench().measure(Engine::F64).unwrap();
        assert_eq!(
            (report.rms_relative_error, report.misclassified_photons),
            (0.0, 0)
        );
        assert!(report.noise_relative > 0.0 && report.photons_in_range > 10_000);
    }

    #[test]
    fn engines_share_photons_and_noise() {
        let bench = bench();
        let reference = bench.measure(Engine::F64).unwrap();
        let engines = [
            Engine::Model(find_machine("paper").unwrap()),
            Engine::Format(&PHOTON_FORMATS[0]),
        ];
        for engine in engines {
            let report = bench.measure(engine).unwrap();
            assert_eq!(report.noise_relative, reference.noise_relative);
            assert_eq!(report.photons_in_range, reference.photons_in_range);
            assert!(report.misclassified_photons > 0 && report.error_over_noise < 0.2);
        }
    }

    #[test]
    fn threads_do_not_matter() {
        let on = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
            let measure = || bench().measure(Engine::Format(&PHOTON_FORMATS[0])).unwrap();
            pool.build().unwrap().install(measure)
        };
        assert_eq!(on(1), on(3));
    }

    #[test]
    fn one_map_shows_no_noise() {
        let options = BenchOptions {
            maps: 1,
            ..options()
        };
        let scene = Scene::built_in("cornell").unwrap();
        let error = ErrorBench::new(&scene, &options)
            .unwrap()
            .measure(Engine::F64);
        let too_few = MetricsError::TooFewMaps { found: 1 };
        assert!(matches!(error, Err(BenchError::Metrics(e)) if e == too_few));
    }
}
