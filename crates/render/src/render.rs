//! Stage 5 for a whole picture: every query point, by the engine asked for.

use std::ops::AddAssign;
use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;
use photoncube_model::{GatherError, LocalError};
use photoncube_spec::{Machine, PhotonFormat};
use rayon::prelude::*;
use thiserror::Error;

use crate::band::{BAND_ROWS, Band};
use crate::estimate::{Estimate, Refusal};
use crate::estimators::{Estimator, EstimatorError, Method, UnfitEstimator};
use crate::format_map::{FormatMap, FormatMapError};
use crate::image::Image;
use crate::machine_map::MachineMap;
use crate::photon_map::PhotonMap;
use crate::quantise::{QuantiseError, QuantisedMap};
use crate::scene::Scene;
use crate::view::{QueryPoint, ViewError, ViewOptions};

/// What makes the radiance estimates.
#[derive(Debug, Clone, Copy)]
pub enum Engine<'a> {
    /// The reference, in f64.
    F64,
    /// The golden model of this machine, on photons rounded to its formats.
    Model(&'a Machine),
    /// The golden model of this photon format, for which there need be no machine.
    Format(&'a PhotonFormat),
}

/// Why a picture could not be rendered.
#[derive(Debug, Error)]
pub enum RenderError {
    /// The options give no picture.
    #[error(transparent)]
    View(#[from] ViewError),
    /// The machine's formats do not fit.
    #[error(transparent)]
    Quantise(#[from] QuantiseError),
    /// The photon format does not fit.
    #[error(transparent)]
    Format(#[from] FormatMapError),
    /// The engine cannot make that estimate.
    #[error(transparent)]
    Estimator(#[from] UnfitEstimator),
    /// There is no such estimate at a query, in f64.
    #[error("pixel ({x}, {y}): {source}")]
    Reference {
        /// Column, from the left.
        x: u32,
        /// Row, from the top.
        y: u32,
        /// Why.
        source: EstimatorError,
    },
    /// The golden model of a machine refused a query.
    #[error("pixel ({x}, {y}): {source}")]
    Gather {
        /// Column, from the left.
        x: u32,
        /// Row, from the top.
        y: u32,
        /// What the model found.
        source: GatherError,
    },
    /// The golden model of a photon format refused a query.
    #[error("pixel ({x}, {y}): {source}")]
    LocalGather {
        /// Column, from the left.
        x: u32,
        /// Row, from the top.
        y: u32,
        /// What the model found.
        source: LocalError,
    },
}

impl RenderError {
    /// A query's refusal, with its pixel.
    pub(crate) fn of(refusal: Refusal, x: u32, y: u32) -> Self {
        match refusal {
            Refusal::Machine(source) => Self::Gather { x, y, source },
            Refusal::Format(source) => Self::LocalGather { x, y, source },
            Refusal::Reference(source) => Self::Reference { x, y, source },
            Refusal::Estimator(source) => Self::Estimator(source),
        }
    }
}

/// What rendering did.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct RenderStats {
    /// View rays that ended on a front, each one query.
    pub query_points: u64,
    /// Gathers made: of integer engines, one for each bisection and each rung.
    pub gathers: u64,
    /// Photons tested against a query in a gather: distance, compare, accumulate.
    pub photon_tests: u64,
    /// Those of them that the golden model decided by the block or leaf that they are in, which the query's
    /// sphere cannot touch: a machine tests them one by one. 0 for the reference, and where
    /// queries are gathered one at a time.
    pub photons_skipped: u64,
    /// Those of them in range.
    pub photons_in_range: u64,
    /// Iterations of the machine: a gather's photons in groups of
    /// [`Machine::photons_per_iteration`], the last perhaps not full. 0 for the
    /// reference and for a photon format, which have none.
    pub photon_groups: u64,
    /// The most photons that one query tested.
    pub largest_query: u64,
}

impl AddAssign for RenderStats {
    fn add_assign(&mut self, other: Self) {
        self.query_points += other.query_points;
        self.gathers += other.gathers;
        self.photon_tests += other.photon_tests;
        self.photons_skipped += other.photons_skipped;
        self.photons_in_range += other.photons_in_range;
        self.photon_groups += other.photon_groups;
        self.largest_query = self.largest_query.max(other.largest_query);
    }
}

/// A picture and what it took.
#[derive(Debug, Clone, PartialEq)]
pub struct Rendering {
    /// Radiance, linear RGB.
    pub image: Image,
    /// The work's figures.
    pub stats: RenderStats,
}

/// Renders the scene's view from the photon map with its search radius: [`render_with`] and
/// [`Estimator::FixedRadius`].
///
/// # Errors
/// As for [`render_with`].
pub fn render(
    scene: &Scene,
    map: &PhotonMap,
    engine: Engine<'_>,
    options: &ViewOptions,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Rendering, RenderError> {
    let estimator = Estimator::FixedRadius;
    render_with(scene, map, engine, estimator, options, progress)
}

/// Renders the scene's view from the photon map. All engines see the same query points.
///
/// `progress` gets the number of pixels done so far, from any thread, not always in order.
///
/// # Errors
/// Options without pixels, formats that do not fit the map, an estimate that the engine cannot make
/// ([`Estimator::check`]), or a query that the golden model refuses (more photons than
/// [`Machine::max_photons`] or [`PhotonFormat::max_photons`]).
pub fn render_with(
    scene: &Scene,
    map: &PhotonMap,
    engine: Engine<'_>,
    estimator: Estimator,
    options: &ViewOptions,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Rendering, RenderError> {
    options.check()?;
    let renderer = Renderer {
        scene,
        map,
        method: Method::new(estimator, engine)?,
        engine: Prepared::new(map, engine)?,
        options,
    };
    let done = AtomicU64::new(0);
    let band = |band: u32| {
        let first = band * BAND_ROWS;
        let (pixels, stats) = renderer.band(first, options.height.min(first + BAND_ROWS))?;
        let count = pixels.len() as u64;
        progress(done.fetch_add(count, Ordering::Relaxed) + count);
        Ok((pixels, stats))
    };
    let bands = (0..options.height.div_ceil(BAND_ROWS)).into_par_iter();
    let bands: Result<Vec<_>, RenderError> = bands.map(band).collect();
    let mut pixels = Vec::new();
    let mut stats = RenderStats::default();
    for (band, band_stats) in bands? {
        pixels.extend(band);
        stats += band_stats;
    }
    let image = Image::from_rows(options.width, pixels);
    Ok(Rendering { image, stats })
}

pub(crate) enum Prepared<'a> {
    F64,
    Model(QuantisedMap<'a>),
    /// In a photon format; with the machine, if it is one's.
    Format(Box<FormatMap<'a>>, Option<&'a Machine>),
}

impl<'a> Prepared<'a> {
    pub(crate) fn new(map: &'a PhotonMap, engine: Engine<'a>) -> Result<Self, RenderError> {
        Ok(match engine {
            Engine::F64 => Self::F64,
            Engine::Model(machine) => match MachineMap::new(map, machine)? {
                MachineMap::Plain(quantised) => Self::Model(quantised),
                MachineMap::Local(quantised) => Self::Format(quantised, Some(machine)),
            },
            Engine::Format(format) => Self::Format(Box::new(FormatMap::new(map, format)?), None),
        })
    }

    /// The estimate at the map's search radius.
    pub(crate) fn estimate(
        &self,
        map: &PhotonMap,
        query: &QueryPoint,
    ) -> Result<Estimate, Refusal> {
        Method::FixedRadius.estimate(self, map, query)
    }

    fn groups(&self, photons: u64) -> u64 {
        let machine = match self {
            Self::F64 => None,
            Self::Model(quantised) => Some(quantised.machine()),
            Self::Format(_, machine) => *machine,
        };
        machine.map_or(0, |m| photons.div_ceil(m.photons_per_iteration() as u64))
    }
}

struct Renderer<'a> {
    scene: &'a Scene,
    map: &'a PhotonMap,
    method: Method,
    engine: Prepared<'a>,
    options: &'a ViewOptions,
}

impl Renderer<'_> {
    /// The pixels of rows `first` to `end`.
    fn band(&self, first: u32, end: u32) -> Result<(Vec<DVec3>, RenderStats), RenderError> {
        if let (Prepared::Format(map, _), Method::FixedRadius) = (&self.engine, &self.method) {
            let band = Band::new(self.scene, self.options, first, end);
            if let Ok(found) = band.gather(map, |photons| self.engine.groups(photons)) {
                return Ok((band.pixels(&found), found.stats));
            }
            // One query was refused: going on one at a time says which.
        }
        self.rows(first, end)
    }

    /// The same, query by query.
    fn rows(&self, first: u32, end: u32) -> Result<(Vec<DVec3>, RenderStats), RenderError> {
        let mut stats = RenderStats::default();
        let pixel = |(x, y)| {
            let pixel = self.pixel(x, y, &mut stats);
            pixel.map_err(|refusal| RenderError::of(refusal, x, y))
        };
        let pixels = (first..end).flat_map(|y| (0..self.options.width).map(move |x| (x, y)));
        let pixels: Result<Vec<_>, _> = pixels.map(pixel).collect();
        Ok((pixels?, stats))
    }

    /// The mean radiance of a pixel's view rays.
    fn pixel(&self, x: u32, y: u32, stats: &mut RenderStats) -> Result<DVec3, Refusal> {
        let mut radiance = DVec3::ZERO;
        for sample in self.options.samples(self.scene, x, y) {
            radiance += sample.emitted;
            if let Some(query) = sample.query {
                let estimate = self.method.estimate(&self.engine, self.map, &query)?;
                radiance += query.beta * estimate.irradiance;
                *stats += self.stats_of(&estimate);
            }
        }
        Ok(radiance / f64::from(self.options.samples_per_pixel()))
    }

    fn stats_of(&self, estimate: &Estimate) -> RenderStats {
        RenderStats {
            query_points: 1,
            gathers: estimate.gathers,
            photon_tests: estimate.gathers * estimate.tests,
            photons_skipped: 0,
            photons_in_range: estimate.in_range,
            photon_groups: estimate.gathers * self.engine.groups(estimate.tests),
            largest_query: estimate.tests,
        }
    }
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{Numbers, PHOTON_FORMATS, PlainFormat, find_machine};

    use super::*;
    use crate::{TraceOptions, trace};

    const OPTIONS: ViewOptions = ViewOptions {
        width: 24,
        height: 16,
        samples_per_axis: 1,
        seed: 9,
    };

    fn scene_and_map() -> (Scene, PhotonMap) {
        let scene = Scene::built_in("cornell").unwrap();
        let options = TraceOptions {
            photons: 20_000,
            seed: 9,
        };
        let photons = trace(&scene, &options, &|_| ()).unwrap().photons;
        let map = PhotonMap::new(&scene, photons, 0.15).unwrap();
        (scene, map)
    }

    #[test]
    fn threads_do_not_matter() {
        let (scene, map) = scene_and_map();
        let engines = [
            Engine::F64,
            Engine::Model(find_machine("paper").unwrap()),
            Engine::Format(&PHOTON_FORMATS[0]),
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
        let model = render(&scene, &map, Engine::Model(machine), &OPTIONS, &|_| ())
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
        let format = stats(Engine::Format(&PHOTON_FORMATS[0]));
        assert_eq!(f64.query_points, format.query_points);
        assert_eq!(format.photon_groups, 0);
        // 0.26 % of the photons change sides, about half of them each way.
        let ratio = format.photons_in_range as f64 / f64.photons_in_range as f64;
        assert!((ratio - 1.0).abs() < 0.001, "{ratio}");
    }

    /// In bands by the fast gather, and query by query by the plain one: the same to the last bit.
    #[test]
    fn bands_are_what_single_queries_give() {
        let (scene, map) = scene_and_map();
        for format in PHOTON_FORMATS {
            let renderer = Renderer {
                scene: &scene,
                map: &map,
                method: Method::FixedRadius,
                engine: Prepared::new(&map, Engine::Format(format)).unwrap(),
                options: &OPTIONS,
            };
            let (band, stats) = renderer.band(3, 9).unwrap();
            let (rows, expected) = renderer.rows(3, 9).unwrap();
            assert_eq!(band, rows, "{format}");
            assert!(stats.photons_skipped > 0, "{format}");
            let stats = RenderStats {
                photons_skipped: 0,
                ..stats
            };
            assert_eq!(stats, expected, "{format}");
        }
    }

    #[test]
    fn a_format_too_small_for_a_query_says_which_pixel() {
        let (scene, map) = scene_and_map();
        let format = PhotonFormat {
            max_photons: 3,
            ..PHOTON_FORMATS[0]
        };
        let error = render(&scene, &map, Engine::Format(&format), &OPTIONS, &|_| ()).unwrap_err();
        assert!(error.to_string().starts_with("pixel ("), "{error}");
        assert!(matches!(error, RenderError::LocalGather { .. }));
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
        let error = render(&scene, &map, Engine::Model(&machine), &OPTIONS, &|_| ()).unwrap_err();
        assert!(error.to_string().starts_with("pixel ("), "{error}");
        assert!(matches!(error, RenderError::Gather { .. }));
    }
}
