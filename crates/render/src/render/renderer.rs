//! Stage 5: renders bands of a picture, with every map and every requested estimator.

use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;
use rayon::prelude::*;

use super::band::{BAND_ROWS, Band, Queries};
use super::{Engine, Light, RenderError, RenderStats};
use crate::estimate::{Estimate, Estimator};
use crate::image::Image;
use crate::lighting::{Area, Fronts, Lit};
use crate::photon_map::PhotonMap;
use crate::quantise::QuantisedMap;
use crate::scene::Scene;
use crate::view::ViewOptions;

/// A photon map with its photons in the engine's integers.
struct Source<'a> {
    map: &'a PhotonMap,
    quantised: Option<QuantisedMap<'a>>,
}

impl<'a> Source<'a> {
    fn new(map: &'a PhotonMap, engine: Engine<'_>) -> Result<Self, RenderError> {
        let quantised = engine.quantised(map)?;
        Ok(Self { map, quantised })
    }
}

/// The inputs of a picture.
pub(crate) struct Renderer<'a> {
    lit: Lit<'a>,
    /// The flat fronts that the covered area consists of, where the lighting divides by it.
    fronts: Option<Fronts>,
    engine: Engine<'a>,
    global: Source<'a>,
    caustic: Option<Source<'a>>,
    options: &'a ViewOptions,
}

/// Pictures from the same view rays, one for each estimator.
pub(crate) struct Rendered {
    pub images: Vec<Image>,
    pub stats: RenderStats,
}

/// The pixels of a band, for each estimator.
type Pixels = Vec<Vec<DVec3>>;

impl<'a> Renderer<'a> {
    /// # Errors
    /// The options, the lighting or the number formats do not fit.
    pub fn new(
        scene: &'a Scene,
        light: Light<'a>,
        engine: Engine<'a>,
        options: &'a ViewOptions,
    ) -> Result<Self, RenderError> {
        options.check()?;
        light.lighting.check(scene, light.estimator)?;
        let caustic = light.caustic.map(|map| Source::new(map, engine));
        let covered = light.lighting.area == Area::Covered;
        Ok(Self {
            lit: Lit::new(scene, *light.lighting),
            fronts: covered.then(|| Fronts::of(scene)),
            engine,
            global: Source::new(light.global, engine)?,
            caustic: caustic.transpose()?,
            options,
        })
    }

    /// Renders a picture with each of `estimators`.
    ///
    /// # Errors
    /// An engine refuses a query.
    pub fn render(
        &self,
        estimators: &[Estimator],
        progress: &(dyn Fn(u64) + Sync),
    ) -> Result<Rendered, RenderError> {
        let (rows, height) = (self.band_rows(), self.options.height);
        let starts = (0..height.div_ceil(rows)).map(|band| band * rows);
        let bands = starts.map(|first| first..height.min(first + rows));
        self.render_bands(bands.collect(), estimators, progress)
    }

    /// Renders every `stride`-th row only. The images consist of these rows.
    ///
    /// # Errors
    /// An engine refuses a query.
    pub fn render_rows(
        &self,
        stride: u32,
        estimators: &[Estimator],
    ) -> Result<Vec<Image>, RenderError> {
        let rows = (stride / 2..self.options.height).step_by(stride as usize);
        let bands = rows.map(|row| row..row + 1).collect();
        Ok(self.render_bands(bands, estimators, &|_| ())?.images)
    }

    fn render_bands(
        &self,
        bands: Vec<Range<u32>>,
        estimators: &[Estimator],
        progress: &(dyn Fn(u64) + Sync),
    ) -> Result<Rendered, RenderError> {
        let done = AtomicU64::new(0);
        let band = |rows: Range<u32>| {
            let count = rows.len() as u64 * u64::from(self.options.width);
            let found = self.band(rows.start, rows.end, estimators)?;
            progress(done.fetch_add(count, Ordering::Relaxed) + count);
            Ok(found)
        };
        let bands: Result<Vec<_>, RenderError> = bands.into_par_iter().map(band).collect();
        let mut pixels: Pixels = vec![Vec::new(); estimators.len()];
        let mut stats = RenderStats {
            photons_without_power: self.photons_without_power(),
            ..RenderStats::default()
        };
        for (band, band_stats) in bands? {
            for (all, band) in pixels.iter_mut().zip(band) {
                all.extend(band);
            }
            stats += band_stats;
        }
        let images = pixels.into_iter();
        let images = images.map(|pixels| Image::from_rows(self.options.width, pixels));
        Ok(Rendered {
            images: images.collect(),
            stats,
        })
    }

    fn photons_without_power(&self) -> u64 {
        let sources = [Some(&self.global), self.caustic.as_ref()];
        let maps = sources.into_iter().flatten();
        let maps = maps.filter_map(|source| source.quantised.as_ref());
        maps.map(QuantisedMap::photons_without_power).sum()
    }

    /// The rows of a band. A machine is given the whole picture, so that queries that are close together share its photons.
    fn band_rows(&self) -> u32 {
        match self.engine {
            Engine::Hardware(..) => self.options.height,
            _ => BAND_ROWS,
        }
    }

    /// Renders rows `first` to `end`.
    fn band(
        &self,
        first: u32,
        end: u32,
        estimators: &[Estimator],
    ) -> Result<(Pixels, RenderStats), RenderError> {
        let band = Band::new(&self.lit, self.options, first, end);
        let mut stats = RenderStats {
            query_points: band.query_points,
            ..RenderStats::default()
        };
        let mut pixels = Vec::new();
        for estimator in estimators {
            let mut radiance = band.known.clone();
            let caustic = self
                .caustic
                .as_ref()
                .map(|caustic| (caustic, &band.caustic));
            for (source, queries) in [(&self.global, &band.global)].into_iter().chain(caustic) {
                let found = self.estimates(estimator, source, queries, first)?;
                self.shade(estimator, source, queries, &found, &mut radiance);
                found.iter().for_each(|found| stats += self.stats_of(found));
            }
            let samples = f64::from(self.options.samples_per_pixel());
            radiance.iter_mut().for_each(|pixel| *pixel /= samples);
            pixels.push(radiance);
        }
        Ok((pixels, stats))
    }

    /// The estimates at the queries of a band whose first row is `first`.
    fn estimates(
        &self,
        estimator: &Estimator,
        source: &Source<'_>,
        queries: &Queries,
        first: u32,
    ) -> Result<Vec<Estimate>, RenderError> {
        let quantised = source.quantised.as_ref();
        // A machine whose queries all have the format's radius cannot gather at another: the processor does, in the map's integers.
        let is_fixed = *estimator == Estimator::FixedRadius;
        if let (Engine::Hardware(machine, gatherer), Some(map)) = (self.engine, quantised)
            && (is_fixed || machine.fixed_radius_sq().is_none())
        {
            let found = estimator.estimate_by(gatherer, map, queries.points());
            return found.map_err(|source| RenderError::Gatherer {
                machine: machine.name,
                source,
            });
        }
        let found = estimator.estimate_all(source.map, quantised, queries.points());
        found.map_err(|(query, refusal)| {
            let pixel = queries.pixel(query);
            let (x, y) = (pixel % self.options.width, pixel / self.options.width);
            RenderError::of(refusal, x, first + y)
        })
    }

    /// Adds the estimates to the pixels, divided by the disc's area or by the covered area.
    fn shade(
        &self,
        estimator: &Estimator,
        source: &Source<'_>,
        queries: &Queries,
        found: &[Estimate],
        radiance: &mut [DVec3],
    ) {
        let radius = estimator.radius(source.map.radius());
        match (&self.fronts, radius) {
            (Some(fronts), Some(radius)) => queries.shade(
                found,
                |query| {
                    fronts.disc_over_covered(source.map, query.position, &query.front(), radius)
                },
                radiance,
            ),
            _ => queries.shade(found, |_| 1.0, radiance),
        }
    }

    fn stats_of(&self, found: &Estimate) -> RenderStats {
        RenderStats {
            query_points: 0,
            estimates: 1,
            gathers: found.gathers,
            photon_tests: found.gathers * found.tests,
            photons_skipped: found.skipped,
            photons_in_range: found.in_range,
            photon_groups: found.gathers * self.engine.groups(found.tests),
            largest_query: found.tests,
            ..RenderStats::default()
        }
    }
}
