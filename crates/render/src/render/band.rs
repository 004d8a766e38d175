//! Bands: consecutive rows of a picture, whose queries are gathered together.

use glam::DVec3;

use crate::estimate::Estimate;
use crate::lighting::{Chances, Lit};
use crate::trace::sample::{Purpose, stream};
use crate::view::{QueryPoint, ViewOptions};

/// The rows of a band, enough for a block to have many queries in it.
pub(crate) const BAND_ROWS: u32 = 16;

/// Query points, each with the index of its pixel in the band.
#[derive(Debug, Clone, Default)]
pub(crate) struct Queries {
    pixels: Vec<u32>,
    points: Vec<QueryPoint>,
}

impl Queries {
    /// The query points, in the order of their pixels.
    pub fn points(&self) -> &[QueryPoint] {
        &self.points
    }

    /// The index in the band of the pixel of a query.
    pub fn pixel(&self, query: usize) -> u32 {
        self.pixels[query]
    }

    /// The queries of the pixels that `is_taken`, in their order.
    pub fn of_pixels(&self, is_taken: impl Fn(u32) -> bool) -> Self {
        let mut taken = Self::default();
        for (pixel, point) in self.pixels.iter().zip(&self.points) {
            if is_taken(*pixel) {
                taken.push(*pixel, *point);
            }
        }
        taken
    }

    /// The first query of each pixel that has one, with its pixel.
    pub fn firsts(&self) -> impl Iterator<Item = (u32, &QueryPoint)> {
        let is_first = |index: &usize| *index == 0 || self.pixels[index - 1] != self.pixels[*index];
        let firsts = (0..self.pixels.len()).filter(is_first);
        firsts.map(|index| (self.pixels[index], &self.points[index]))
    }

    fn push(&mut self, pixel: u32, point: QueryPoint) {
        self.pixels.push(pixel);
        self.points.push(point);
    }

    /// Adds the radiance that the queries reflect of their estimates to their pixels. `scale` returns a
    /// factor for each query.
    pub fn shade(&self, found: &[Estimate], scale: impl Fn(&QueryPoint) -> f64, to: &mut [DVec3]) {
        for ((pixel, query), found) in self.pixels.iter().zip(&self.points).zip(found) {
            to[*pixel as usize] += query.beta * (scale(query) * found.irradiance);
        }
    }
}

/// The rows of a band, before anything is gathered.
pub(crate) struct Band {
    /// For each pixel, row by row, the radiance that needs no gather, summed over its view rays.
    pub known: Vec<DVec3>,
    /// The number of view rays that ended on a front.
    pub query_points: u64,
    /// The queries of the global map.
    pub global: Queries,
    /// The queries of the map of caustics.
    pub caustic: Queries,
}

impl Band {
    /// Follows the view rays of rows `first` to `end`.
    pub fn new(lit: &Lit<'_>, options: &ViewOptions, first: u32, end: u32) -> Self {
        let mut band = Self {
            known: Vec::new(),
            query_points: 0,
            global: Queries::default(),
            caustic: Queries::default(),
        };
        for (x, y) in (first..end).flat_map(|y| (0..options.width).map(move |x| (x, y))) {
            band.push_pixel(lit, options, x, y);
        }
        band
    }

    fn push_pixel(&mut self, lit: &Lit<'_>, options: &ViewOptions, x: u32, y: u32) {
        let pixel = self.known.len() as u32;
        let rng = stream(options.seed, Purpose::Light, options.index(x, y));
        let mut chances = Chances::new(rng);
        let mut known = DVec3::ZERO;
        for sample in options.samples(lit.scene(), x, y) {
            self.query_points += u64::from(sample.query.is_some());
            let parts = lit.ungathered(&sample, &mut chances);
            known += parts.known;
            let (global, caustic) = (&mut self.global, &mut self.caustic);
            parts.global.iter().for_each(|q| global.push(pixel, *q));
            parts.caustic.iter().for_each(|q| caustic.push(pixel, *q));
        }
        self.known.push(known);
    }
}
