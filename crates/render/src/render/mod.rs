//! Stage 5 for a whole picture: the estimate at every query point, by the chosen engine.

mod band;
mod renderer;
mod workload;

use std::ops::AddAssign;

use photoncube_model::{GatherError, Gathered};
use photoncube_spec::{Machine, Numbers, PhotonFormat};
use serde::{Deserialize, Serialize};
use thiserror::Error;

pub(crate) use self::renderer::Renderer;
pub use self::workload::{WorkloadError, workload};

use crate::estimate::{Estimator, EstimatorError, Refusal, UnfitEstimator};
use crate::image::Image;
use crate::lighting::{Lighting, LightingError};
use crate::photon_map::PhotonMap;
use crate::quantise::{QuantiseError, QuantisedMap};
use crate::scene::Scene;
use crate::view::{QueryPoint, ViewError, ViewOptions};

/// The engine that makes the radiance estimates.
#[derive(Debug, Clone, Copy)]
pub enum Engine<'a> {
    /// The reference, in f64.
    F64,
    /// The golden model in these numbers, on photons rounded to them. Groups of photons are counted for the
    /// machine; numbers need not belong to one.
    Integers(Numbers, Option<&'a Machine>),
    /// A machine, or a simulation of its Verilog, which makes the gathers of a whole picture.
    Hardware(&'a Machine, &'a dyn Gatherer),
}

/// A machine that gathers all queries of a picture.
pub trait Gatherer: std::fmt::Debug + Sync {
    /// The sums of the queries, in their order, each with a squared radius in squared fine steps of at most the map's. They must equal
    /// those of [`QuantisedMap::gather_within`].
    ///
    /// # Errors
    /// The machine does not answer, or not as it should, or it has not these radii.
    fn gather_all(
        &self,
        map: &QuantisedMap<'_>,
        queries: &[QueryPoint],
        radii_sq: &[u32],
    ) -> Result<Vec<Gathered>, GathererError>;

    /// The sums of the queries within each of these squared radii: for each radius those of all queries. A machine may make all
    /// gathers of a query from one word.
    ///
    /// # Errors
    /// As for [`Self::gather_all`].
    fn gather_ladder(
        &self,
        map: &QuantisedMap<'_>,
        queries: &[QueryPoint],
        radii_sq: &[u32],
    ) -> Result<Vec<Vec<Gathered>>, GathererError> {
        gather_rungs(self, map, queries, radii_sq)
    }

    /// The k nearest photons of each query, where the machine finds them without more words. The renderer finds the others by
    /// [`Self::gather_all`].
    ///
    /// # Errors
    /// As for [`Self::gather_all`].
    fn k_nearest(
        &self,
        _map: &QuantisedMap<'_>,
        queries: &[QueryPoint],
        _k: u64,
    ) -> Result<Vec<Option<NearestGathered>>, GathererError> {
        Ok(vec![None; queries.len()])
    }
}

/// [`Gatherer::gather_ladder`] by a [`Gatherer::gather_all`] for each radius.
///
/// # Errors
/// Those of the gathers.
pub fn gather_rungs<G: Gatherer + ?Sized>(
    gatherer: &G,
    map: &QuantisedMap<'_>,
    queries: &[QueryPoint],
    radii_sq: &[u32],
) -> Result<Vec<Vec<Gathered>>, GathererError> {
    let gather = |&radius_sq| gatherer.gather_all(map, queries, &vec![radius_sq; queries.len()]);
    radii_sq.iter().map(gather).collect()
}

/// What a machine found of the k nearest photons of a query.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct NearestGathered {
    /// The smallest squared radius with k photons, in squared fine steps; the map's where no radius has as many.
    pub radius_sq: u32,
    /// The sums within one square step less; within the map's radius where no radius has k photons, and within 0 where that has.
    pub gathered: Gathered,
    /// The gathers that the machine made.
    pub gathers: u64,
}

/// The error of a machine that gathers.
pub type GathererError = Box<dyn std::error::Error + Send + Sync>;

/// The golden model of a machine.
impl<'a> From<&'a Machine> for Engine<'a> {
    fn from(machine: &'a Machine) -> Self {
        Self::Integers(machine.numbers, Some(machine))
    }
}

/// The golden model of a photon format, which no machine needs to have.
impl From<&PhotonFormat> for Engine<'_> {
    fn from(format: &PhotonFormat) -> Self {
        Self::Integers(format.into(), None)
    }
}

impl Engine<'_> {
    /// The map in the engine's integers; `None` for f64.
    pub(crate) fn quantised(
        self,
        map: &PhotonMap,
    ) -> Result<Option<QuantisedMap<'_>>, QuantiseError> {
        match self {
            Self::F64 => Ok(None),
            Self::Integers(numbers, _) => QuantisedMap::new(map, &numbers).map(Some),
            Self::Hardware(machine, _) => QuantisedMap::new(map, &machine.numbers).map(Some),
        }
    }

    /// The edge of the blocks (scene units) in which the engine gathers, for a search radius (scene units).
    #[must_use]
    pub fn edge(self, radius: f64) -> f64 {
        let format = match &self {
            Self::F64 => None,
            Self::Integers(numbers, _) => numbers.format(),
            Self::Hardware(machine, _) => machine.numbers.format(),
        };
        format.map_or(radius, |format| QuantisedMap::edge_for(format, radius))
    }

    /// The number of the machine's iterations for that many photons; 0 without a machine.
    fn groups(self, photons: u64) -> u64 {
        let (Self::Integers(_, Some(machine)) | Self::Hardware(machine, _)) = self else {
            return 0;
        };
        photons.div_ceil(machine.photons_per_iteration() as u64)
    }
}

/// The reason why a picture could not be rendered.
#[derive(Debug, Error)]
pub enum RenderError {
    /// The options describe no picture.
    #[error(transparent)]
    View(#[from] ViewError),
    /// The numbers do not fit.
    #[error(transparent)]
    Quantise(#[from] QuantiseError),
    /// The scene does not allow this lighting.
    #[error(transparent)]
    Lighting(#[from] LightingError),
    /// The engine cannot make that estimate.
    #[error(transparent)]
    Estimator(#[from] UnfitEstimator),
    /// The machine that gathers failed.
    #[error("the machine `{machine}` did not gather: {source}")]
    Gatherer {
        /// The name of the machine.
        machine: &'static str,
        /// The error of the machine.
        source: GathererError,
    },
    /// The f64 reference has no such estimate at a query.
    #[error("pixel ({x}, {y})")]
    Reference {
        /// Column, from the left.
        x: u32,
        /// Row, from the top.
        y: u32,
        /// The error of the estimator.
        source: EstimatorError,
    },
    /// The golden model refused a query.
    #[error("pixel ({x}, {y})")]
    Gather {
        /// Column, from the left.
        x: u32,
        /// Row, from the top.
        y: u32,
        /// The error of the golden model.
        source: GatherError,
    },
}

impl RenderError {
    /// Makes the error of a refused query, with its pixel.
    pub(crate) fn of(refusal: Refusal, x: u32, y: u32) -> Self {
        match refusal {
            Refusal::Gather(source) => Self::Gather { x, y, source },
            Refusal::Reference(source) => Self::Reference { x, y, source },
            Refusal::Estimator(source) => Self::Estimator(source),
        }
    }
}

/// Statistics of the work of rendering.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct RenderStats {
    /// The number of view rays that ended on a front; each is one query.
    pub query_points: u64,
    /// The number of estimates: one in each map for a query point, and with a final gather one in the global map for
    /// each gather ray that ends on a front.
    pub estimates: u64,
    /// The number of gathers. Integer engines make one for each step of a bisection and for each rung of a
    /// ladder.
    pub gathers: u64,
    /// The number of photons tested against a query in a gather: distance, compare, accumulate.
    pub photon_tests: u64,
    /// The number of these photons that the golden model decided by their block or leaf, which the query's
    /// sphere cannot touch. A machine tests them one by one. 0 for the reference, and where queries are
    /// gathered one at a time.
    pub photons_skipped: u64,
    /// The number of photons in range of the estimates. An estimate of several gathers counts those of the one that
    /// it takes: the largest rung of a ladder, or the gather that found the k nearest.
    pub photons_in_range: u64,
    /// The number of iterations of the machine: a gather's photons in groups of
    /// [`Machine::photons_per_iteration`], the last of which may be partly filled. 0 for the reference and
    /// for a photon format without a machine.
    pub photon_groups: u64,
    /// The largest number of photons that one query tested.
    pub largest_query: u64,
    /// The photons of the maps whose power rounds to 0, see [`QuantisedMap::photons_without_power`].
    #[serde(default)]
    pub photons_without_power: u64,
}

impl AddAssign for RenderStats {
    fn add_assign(&mut self, other: Self) {
        self.query_points += other.query_points;
        self.estimates += other.estimates;
        self.gathers += other.gathers;
        self.photon_tests += other.photon_tests;
        self.photons_skipped += other.photons_skipped;
        self.photons_in_range += other.photons_in_range;
        self.photon_groups += other.photon_groups;
        self.largest_query = self.largest_query.max(other.largest_query);
        self.photons_without_power += other.photons_without_power;
    }
}

impl RenderStats {
    /// The mean of [`Self::photons_in_range`] for an estimate; 0 where nothing was estimated.
    #[must_use]
    pub fn photons_in_range_mean(&self) -> f64 {
        self.photons_in_range as f64 / self.estimates.max(1) as f64
    }

    /// The mean number of gathers for an estimate; 0 where nothing was estimated.
    #[must_use]
    pub fn gathers_mean(&self) -> f64 {
        self.gathers as f64 / self.estimates.max(1) as f64
    }
}

/// A picture with the statistics of its rendering.
#[derive(Debug, Clone, PartialEq)]
pub struct Rendering {
    /// The radiance in linear RGB.
    pub image: Image,
    /// The statistics of the work.
    pub stats: RenderStats,
}

/// Renders the scene's view from one photon map of all light, with its search radius: [`render_lit`] with the
/// default lighting and [`Estimator::FixedRadius`].
///
/// # Errors
/// As for [`render_lit`].
pub fn render(
    scene: &Scene,
    map: &PhotonMap,
    engine: Engine<'_>,
    options: &ViewOptions,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Rendering, RenderError> {
    let light = Light {
        lighting: &Lighting::default(),
        global: map,
        caustic: None,
        estimator: &Estimator::FixedRadius,
    };
    render_lit(scene, light, engine, options, progress)
}

/// The light of a picture: photon maps and the way in which they are used.
#[derive(Debug, Clone, Copy)]
pub struct Light<'a> {
    /// The decision which part of the light comes from which source.
    pub lighting: &'a Lighting,
    /// The photons of the global map: [`crate::PhotonMaps::global`].
    pub global: &'a PhotonMap,
    /// The photons of the map of caustics: [`crate::PhotonMaps::caustic`].
    pub caustic: Option<&'a PhotonMap>,
    /// The form of the estimates in both maps.
    pub estimator: &'a Estimator,
}

/// Renders the scene's view. All engines see the same query points, shadow rays and gather rays.
///
/// `progress` receives the number of pixels done so far, from any thread, not always in order.
///
/// # Errors
/// Options without pixels, a lighting that the scene or the estimator cannot have ([`Lighting::check`]), formats
/// that do not fit the map, an estimate that the engine cannot make ([`Estimator::check`]), or a query that the
/// golden model refuses (more photons than [`Machine::max_photons`] or [`PhotonFormat::max_photons`]).
pub fn render_lit(
    scene: &Scene,
    light: Light<'_>,
    engine: Engine<'_>,
    options: &ViewOptions,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Rendering, RenderError> {
    light.estimator.check(engine)?;
    let renderer = Renderer::new(scene, light, engine, options)?;
    let estimators = std::slice::from_ref(light.estimator);
    let mut rendered = renderer.render(estimators, progress)?;
    let image = rendered.images.pop().expect("one estimator");
    let stats = rendered.stats;
    Ok(Rendering { image, stats })
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicU64, Ordering};

    use photoncube_spec::{PHOTON_FORMATS, PlainFormat, find_machine};

    use super::*;
    use crate::scene::fixtures::traced_cornell;

    const OPTIONS: ViewOptions = ViewOptions {
        width: 24,
        height: 16,
        samples_per_axis: 1,
        seed: 9,
    };

    fn scene_and_map() -> (Scene, PhotonMap) {
        traced_cornell(20_000, 9, 0.15)
    }

    #[test]
    fn threads_do_not_matter() {
        let (scene, map) = scene_and_map();
        let engines = [
            Engine::F64,
            Engine::from(find_machine("paper").unwrap()),
            Engine::from(&PHOTON_FORMATS[0]),
        ];
        for engine in engines {
            let on = |threads| {
                let pool = rayon::ThreadPoolBuilder::new()
                    .num_threads(threads)
                    .build()
                    .unwrap();
                pool.install(|| render(&scene, &map, engine, &OPTIONS, &|_| ()).unwrap())
            };
            assert_eq!(on(1), on(3));
        }
    }

    #[test]
    fn both_engines_test_the_same_photons() {
        let (scene, map) = scene_and_map();
        let machine = find_machine("paper").unwrap();
        let f64 = render(&scene, &map, Engine::F64, &OPTIONS, &|_| ())
            .unwrap()
            .stats;
        let model = render(&scene, &map, Engine::from(machine), &OPTIONS, &|_| ())
            .unwrap()
            .stats;
        assert_eq!(f64.photon_tests, model.photon_tests);
        assert_eq!(f64.query_points, model.query_points);
        assert!(f64.query_points <= 24 * 16 && f64.query_points > 24 * 16 / 2);
        assert_eq!(f64.photon_groups, 0);
        let groups = model.photon_groups;
        assert!(groups >= model.photon_tests / 4);
        assert!(groups < model.photon_tests / 4 + model.query_points);
    }

    #[test]
    fn a_format_sees_the_same_queries_and_about_the_same_photons() {
        let (scene, map) = scene_and_map();
        let stats = |engine| {
            render(&scene, &map, engine, &OPTIONS, &|_| ())
                .unwrap()
                .stats
        };
        let f64 = stats(Engine::F64);
        let format = stats(Engine::from(&PHOTON_FORMATS[0]));
        assert_eq!(f64.query_points, format.query_points);
        assert_eq!(format.photon_groups, 0);
        // 0.26 % of the photons are misclassified, about half of them in each direction.
        let ratio = format.photons_in_range as f64 / f64.photons_in_range as f64;
        assert!((ratio - 1.0).abs() < 0.001, "{ratio}");
    }

    #[test]
    fn a_format_too_small_for_a_query_says_which_pixel() {
        let (scene, map) = scene_and_map();
        let format = PhotonFormat {
            max_photons: 3,
            ..PHOTON_FORMATS[0]
        };
        let error = render(&scene, &map, Engine::from(&format), &OPTIONS, &|_| ()).unwrap_err();
        assert!(error.to_string().starts_with("pixel ("), "{error}");
        assert!(matches!(error, RenderError::Gather { .. }));
    }

    #[test]
    fn progress_counts_all_pixels() {
        let (scene, map) = scene_and_map();
        let last = AtomicU64::new(0);
        let progress = |pixels| {
            last.fetch_max(pixels, Ordering::Relaxed);
        };
        render(&scene, &map, Engine::F64, &OPTIONS, &progress).unwrap();
        assert_eq!(last.into_inner(), 24 * 16);
    }

    #[test]
    fn a_machine_too_small_for_a_query_says_which_pixel() {
        let (scene, map) = scene_and_map();
        let paper = find_machine("paper").unwrap();
        let machine = Machine {
            numbers: Numbers::Plain(PlainFormat {
                max_photons: 3,
                ..*paper.plain().unwrap()
            }),
            ..*paper
        };
        let error = render(&scene, &map, Engine::from(&machine), &OPTIONS, &|_| ()).unwrap_err();
        assert!(error.to_string().starts_with("pixel ("), "{error}");
        assert!(matches!(error, RenderError::Gather { .. }));
    }
}
