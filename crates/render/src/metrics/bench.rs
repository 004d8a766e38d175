//! The bench on which every engine is measured alike: several photon maps of a scene, and queries of its
//! view.

use glam::DVec3;
use photoncube_model::GatherError;
use rayon::prelude::*;
use thiserror::Error;

use super::error::MetricsError;
use super::light::{LightReport, LightStudy};
use super::misclassified::Misclassified;
use super::queries::{LUMINANCE, view_queries};
use super::study::{ErrorReport, ErrorStudy};
use super::verdicts::verdicts;
use crate::estimate::{Estimate, Estimator, EstimatorError, Refusal, UnfitEstimator, estimate_f64};
use crate::photon_map::{MapError, PhotonMap};
use crate::quantise::{QuantiseError, QuantisedMap};
use crate::render::Engine;
use crate::scene::Scene;
use crate::trace::{TraceError, TraceOptions, trace};
use crate::view::{QueryPoint, ViewError, ViewOptions};

/// The options of a bench.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BenchOptions {
    /// The number of photons of each map.
    pub photons: u64,
    /// Photons in range that the search radius is chosen for, by [`PhotonMap::radius_for`].
    pub in_range: f64,
    /// The number of independent photon maps, at least 2. Their seeds count up from `seed`.
    pub maps: u64,
    /// The seed of the first map.
    pub seed: u64,
    /// The picture whose query points are used.
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

/// The reason why an error cannot be measured.
#[derive(Debug, Error)]
pub enum BenchError {
    /// The picture has no pixels.
    #[error(transparent)]
    View(#[from] ViewError),
    /// Tracing gave no photons.
    #[error(transparent)]
    Trace(#[from] TraceError),
    /// The radius allows no map.
    #[error(transparent)]
    Map(#[from] MapError),
    /// The engine's numbers do not fit.
    #[error(transparent)]
    Quantise(#[from] QuantiseError),
    /// The golden model refused a query.
    #[error(transparent)]
    Gather(#[from] GatherError),
    /// The f64 reference has no such estimate at a query.
    #[error(transparent)]
    Reference(#[from] EstimatorError),
    /// The engine cannot make that estimate.
    #[error(transparent)]
    Estimator(#[from] UnfitEstimator),
    /// There is nothing to compare.
    #[error(transparent)]
    Metrics(#[from] MetricsError),
}

impl From<Refusal> for BenchError {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::Gather(error) => Self::Gather(error),
            Refusal::Reference(error) => Self::Reference(error),
            Refusal::Estimator(error) => Self::Estimator(error),
        }
    }
}

/// The error of a form of estimate, with its cost in gathers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EstimatorReport {
    /// The error against the estimator's reference, see [`ErrorBench::measure_estimator`].
    pub error: ErrorReport,
    /// The mean number of gathers of a query's photons for one estimate.
    pub gathers_per_query: f64,
}

/// Photon maps of different seeds, query points, and the f64 reference of each map at each query. Traced
/// once, a bench serves any number of engines.
#[derive(Debug, Clone)]
pub struct ErrorBench {
    queries: Vec<QueryPoint>,
    maps: Vec<PhotonMap>,
    /// The reflected light by map and query.
    lights: Vec<Vec<DVec3>>,
    /// The weights of the channels in the sum that is measured.
    weights: DVec3,
    /// The measured sum by map and query.
    references: Vec<Vec<f64>>,
}

impl ErrorBench {
    /// Traces the maps of a bench.
    ///
    /// # Errors
    /// The options describe no picture, or give no photons or no map.
    pub fn new(scene: &Scene, options: &BenchOptions) -> Result<Self, BenchError> {
        Self::traced(scene, options, &|_| ())
    }

    /// Traces the maps as [`Self::new`] does, and calls `progress` with the number of maps traced so far.
    ///
    /// # Errors
    /// As for [`Self::new`].
    pub fn traced(
        scene: &Scene,
        options: &BenchOptions,
        progress: &dyn Fn(u64),
    ) -> Result<Self, BenchError> {
        let queries = view_queries(scene, &options.view)?;
        let photons = options.photons;
        let radius = PhotonMap::radius_for(scene, photons, options.in_range);
        let map = |index: u64| -> Result<PhotonMap, BenchError> {
            let seed = options.seed.wrapping_add(index);
            let trace = trace(scene, &TraceOptions { photons, seed }, &|_| ())?;
            let map = PhotonMap::new(scene, trace.photons, radius)?;
            progress(index + 1);
            Ok(map)
        };
        let maps = (0..options.maps).map(map).collect::<Result<Vec<_>, _>>()?;
        let lights = maps.iter().map(|map| lights(map, &queries)).collect();
        let bench = Self {
            queries,
            maps,
            lights,
            weights: DVec3::ZERO,
            references: Vec::new(),
        };
        Ok(bench.weighted(LUMINANCE))
    }

    /// This bench with another weighted sum of the channels in place of luminance: `DVec3::Z`, for example,
    /// for blue alone.
    #[must_use]
    pub fn weighted(mut self, weights: DVec3) -> Self {
        self.weights = weights;
        let weighted = |lights: &Vec<DVec3>| lights.iter().map(|l| weights.dot(*l)).collect();
        self.references = self.lights.iter().map(weighted).collect();
        self
    }

    /// The query points of the view.
    #[must_use]
    pub fn queries(&self) -> &[QueryPoint] {
        &self.queries
    }

    /// The photon maps, one for each seed.
    #[must_use]
    pub fn maps(&self) -> &[PhotonMap] {
        &self.maps
    }

    /// The f64 reference on each map: reflected luminance (or what [`Self::weighted`] chose) at
    /// each query, in order.
    #[must_use]
    pub fn references(&self) -> &[Vec<f64>] {
        &self.references
    }

    /// The f64 reference on each map with all channels: reflected light at each query, in order.
    #[must_use]
    pub fn lights(&self) -> &[Vec<DVec3>] {
        &self.lights
    }

    /// Measures the engine's error against the reference on the bench's photons, and the noise.
    ///
    /// # Errors
    /// The engine's number formats do not fit the maps, the golden model refuses a query, or there is nothing
    /// to compare.
    pub fn measure(&self, engine: Engine<'_>) -> Result<ErrorReport, BenchError> {
        Ok(self.study(engine)?.report()?)
    }

    /// Measures the engine's error by luminance and by every channel, whatever weights [`Self::weighted`]
    /// set.
    ///
    /// # Errors
    /// As for [`Self::measure`].
    pub fn measure_light(&self, engine: Engine<'_>) -> Result<LightReport, BenchError> {
        let estimator = Estimator::FixedRadius;
        let mut study = LightStudy::new(self.queries.len());
        for (map, lights) in self.maps.iter().zip(&self.lights) {
            let answers = self.answers(&estimator, engine, map)?;
            study.push_map(&answers.lights, lights, answers.verdicts)?;
        }
        Ok(study.report()?)
    }

    /// The study from which [`Self::measure`] reports, for the intervals of further figures.
    ///
    /// # Errors
    /// The engine's number formats do not fit the maps, or the golden model refuses a query.
    pub fn study(&self, engine: Engine<'_>) -> Result<ErrorStudy, BenchError> {
        let (study, _) = self.compare(engine, &Estimator::FixedRadius, &self.references)?;
        Ok(study)
    }

    /// Measures the error of a form of estimate by the engine, against its f64 counterpart
    /// ([`Estimator::reference`]) on the bench's photons, and the noise of that reference. Misclassified
    /// photons are those of the engine at the map's search radius, whatever the estimator.
    ///
    /// # Errors
    /// As for [`Self::measure`], and an estimate that the engine or f64 cannot make.
    pub fn measure_estimator(
        &self,
        engine: Engine<'_>,
        estimator: &Estimator,
    ) -> Result<EstimatorReport, BenchError> {
        let exact = estimator.reference();
        exact.check(Engine::F64)?;
        let reference = |map: &PhotonMap| -> Result<Vec<f64>, Refusal> {
            let queries = self.queries.par_iter();
            let estimates = queries.map(|query| {
                let estimate = exact.estimate(map, None, query)?;
                Ok(self.weights.dot(reflected(query, &estimate)))
            });
            estimates.collect()
        };
        let references = self.maps.iter().map(reference);
        let references = references.collect::<Result<Vec<_>, _>>()?;
        let (study, gathers) = self.compare(engine, estimator, &references)?;
        let estimates = self.maps.len() * self.queries.len();
        Ok(EstimatorReport {
            // A study without an estimate gives no report.
            error: study.report()?,
            gathers_per_query: gathers as f64 / estimates as f64,
        })
    }

    /// The estimates of every map with `references`, by map and query, and the gathers that they took.
    fn compare(
        &self,
        engine: Engine<'_>,
        estimator: &Estimator,
        references: &[Vec<f64>],
    ) -> Result<(ErrorStudy, u64), BenchError> {
        estimator.check(engine)?;
        let mut study = ErrorStudy::new(self.queries.len());
        let mut gathers = 0;
        for (map, references) in self.maps.iter().zip(references) {
            let answers = self.answers(estimator, engine, map)?;
            gathers += answers.gathers;
            let estimates = answers.lights.iter().map(|light| self.weights.dot(*light));
            study.push_map(&estimates.collect::<Vec<_>>(), references, answers.verdicts)?;
        }
        Ok((study, gathers))
    }

    /// The engine's estimates at every query of a map.
    fn answers(
        &self,
        estimator: &Estimator,
        engine: Engine<'_>,
        map: &PhotonMap,
    ) -> Result<Answers, BenchError> {
        let quantised = engine.quantised(map)?;
        let answers = self.queries.par_iter();
        let answers = answers.map(|query| answer(estimator, map, quantised.as_ref(), query));
        // All are made first, so that the error is that of the first query, whatever the threads.
        let answers: Vec<_> = answers.collect();
        let answers = answers.into_iter().collect::<Result<Vec<_>, _>>()?;
        let mut verdicts = Misclassified::default();
        answers
            .iter()
            .for_each(|answer| verdicts += answer.verdicts);
        Ok(Answers {
            lights: answers.iter().map(|answer| answer.light).collect(),
            gathers: answers.iter().map(|answer| answer.gathers).sum(),
            verdicts,
        })
    }
}

fn lights(map: &PhotonMap, queries: &[QueryPoint]) -> Vec<DVec3> {
    let queries = queries.par_iter();
    let values = queries.map(|query| reflected(query, &estimate_f64(map, query)));
    values.collect()
}

/// The light that the query reflects.
fn reflected(query: &QueryPoint, estimate: &Estimate) -> DVec3 {
    query.beta * estimate.irradiance
}

/// The engine's estimates at all queries of a map.
struct Answers {
    lights: Vec<DVec3>,
    gathers: u64,
    verdicts: Misclassified,
}

/// The engine's estimate at one query.
struct Answer {
    light: DVec3,
    gathers: u64,
    /// The in-range decisions about the query's photons.
    verdicts: Misclassified,
}

fn answer(
    estimator: &Estimator,
    map: &PhotonMap,
    quantised: Option<&QuantisedMap<'_>>,
    query: &QueryPoint,
) -> Result<Answer, BenchError> {
    let estimate = estimator.estimate(map, quantised, query)?;
    Ok(Answer {
        light: reflected(query, &estimate),
        gathers: estimate.gathers,
        verdicts: verdicts(map, quantised, query),
    })
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
            Engine::from(find_machine("paper").unwrap()),
            Engine::from(&PHOTON_FORMATS[0]),
        ];
        for engine in engines {
            let report = bench.measure(engine).unwrap();
            assert_eq!(report.noise_relative, reference.noise_relative);
            assert_eq!(report.photons_in_range, reference.photons_in_range);
            assert!(report.misclassified_photons > 0 && report.error_over_noise < 0.2);
        }
    }

    #[test]
    fn luminance_is_the_sum_of_its_channels() {
        let bench = bench();
        let total = bench.references()[0][7];
        let channel = |weights| bench.clone().weighted(weights).references()[0][7];
        let [red, green, blue] = DVec3::AXES.map(channel);
        let sum = DVec3::new(red, green, blue).dot(LUMINANCE);
        // A few roundings.
        assert!(red != blue && (sum / total - 1.0).abs() < 1e-14);
    }

    #[test]
    fn threads_do_not_matter() {
        let on = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
            let measure = || bench().measure(Engine::from(&PHOTON_FORMATS[0])).unwrap();
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
