//! Stage 5: renders bands of a picture, with every map and every requested estimator.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;
use rayon::prelude::*;

use super::band::{BAND_ROWS, Band, Queries};
use super::{Engine, Light, RenderError, RenderStats};
use crate::estimate::{Estimate, Estimator, Sectors, halved, sectors};
use crate::image::Image;
use crate::lighting::{Area, Fronts, Lit};
use crate::photon_map::PhotonMap;
use crate::quantise::QuantisedMap;
use crate::scene::Scene;
use crate::view::ViewOptions;

/// The least squared radius, in squared steps, of a radius that is halved: a disc of this or a larger one has as many grid points as
/// its area, within a thirtieth.
const LEAST_RADIUS_SQ: u32 = 128;

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
    /// For each pixel, how many times its squared radius in the global map is halved; `None` where all have the map's radius.
    halvings: Option<&'a [u8]>,
}

/// Pictures from the same view rays, one for each estimator.
pub(crate) struct Rendered {
    pub images: Vec<Image>,
    /// The photons of the global map in range of the first query of each pixel; empty where all pixels have the map's radius.
    pub sectors: Vec<Sectors>,
    pub stats: RenderStats,
}

/// The pixels of a band, for each estimator.
type Pixels = Vec<Vec<DVec3>>;

/// What is rendered of a band.
struct Part {
    pixels: Pixels,
    sectors: Vec<Sectors>,
    stats: RenderStats,
}

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
            halvings: None,
        })
    }

    /// Gives each pixel a radius of its own in the global map: its squared radius is halved as often as `halvings` says, row by row.
    pub fn with_halvings(self, halvings: &'a [u8]) -> Self {
        let halvings = Some(halvings);
        Self { halvings, ..self }
    }

    /// The most times that a squared radius may be halved, with a gather at half of that.
    pub fn most_halvings(&self) -> u8 {
        let quantised = self.global.quantised.as_ref();
        quantised.map_or(u8::MAX, |map| {
            let factor = map.radius_sq() / LEAST_RADIUS_SQ;
            factor.checked_ilog2().unwrap_or(0).saturating_sub(1) as u8
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
        let mut sectors = Vec::new();
        let mut stats = RenderStats {
            photons_without_power: self.photons_without_power(),
            ..RenderStats::default()
        };
        for band in bands? {
            for (all, band) in pixels.iter_mut().zip(band.pixels) {
                all.extend(band);
            }
            sectors.extend(band.sectors);
            stats += band.stats;
        }
        let images = pixels.into_iter();
        let images = images.map(|pixels| Image::from_rows(self.options.width, pixels));
        Ok(Rendered {
            images: images.collect(),
            sectors,
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
    fn band(&self, first: u32, end: u32, estimators: &[Estimator]) -> Result<Part, RenderError> {
        let band = Band::new(&self.lit, self.options, first, end);
        let mut stats = RenderStats {
            query_points: band.query_points,
            ..RenderStats::default()
        };
        let parts = self.parts(&band.global, first);
        let mut pixels = Vec::new();
        for estimator in estimators {
            let mut radiance = band.known.clone();
            let caustic = self
                .caustic
                .as_ref()
                .map(|caustic| (caustic, 0, &band.caustic));
            let global = parts
                .iter()
                .map(|(halvings, queries)| (&self.global, *halvings, &**queries));
            for (source, halvings, queries) in global.chain(caustic) {
                let estimator = &estimator.halved(halvings);
                let found = self.estimates(estimator, source, queries, first)?;
                self.shade(estimator, source, queries, &found, &mut radiance);
                found.iter().for_each(|found| stats += self.stats_of(found));
            }
            let samples = f64::from(self.options.samples_per_pixel());
            radiance.iter_mut().for_each(|pixel| *pixel /= samples);
            pixels.push(radiance);
        }
        let sectors = self.sectors(&band, first);
        Ok(Part {
            pixels,
            sectors,
            stats,
        })
    }

    /// The halvings of the pixels of a band whose first row is `first`.
    fn halvings(&self, first: u32) -> Option<&[u8]> {
        let before = first as usize * self.options.width as usize;
        self.halvings.map(|all| &all[before..])
    }

    /// The queries of a band by the halvings of their pixels.
    fn parts<'q>(&self, queries: &'q Queries, first: u32) -> Vec<(u32, Cow<'q, Queries>)> {
        let Some(halvings) = self.halvings(first) else {
            return vec![(0, Cow::Borrowed(queries))];
        };
        let of = |pixel: u32| halvings[pixel as usize];
        let found: BTreeSet<u8> = queries.firsts().map(|(pixel, _)| of(pixel)).collect();
        let part = |times: u8| {
            let queries = queries.of_pixels(|pixel| of(pixel) == times);
            (u32::from(times), Cow::Owned(queries))
        };
        found.into_iter().map(part).collect()
    }

    /// The photons in range of the first query of each pixel of a band.
    fn sectors(&self, band: &Band, first: u32) -> Vec<Sectors> {
        let Some(halvings) = self.halvings(first) else {
            return Vec::new();
        };
        let map = self.global.map;
        let mut found = vec![Sectors::default(); band.known.len()];
        for (pixel, query) in band.global.firsts() {
            let times = u32::from(halvings[pixel as usize]);
            found[pixel as usize] = sectors(map, query, halved(map.radius(), times));
        }
        found
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
