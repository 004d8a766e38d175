//! Some rows of a picture whose queries are gathered together, by the fast gather.

use glam::DVec3;
use photoncube_model::{Gathered, LocalError};

use crate::estimate::disc_area;
use crate::format_map::FormatMap;
use crate::render::RenderStats;
use crate::scene::Scene;
use crate::view::{QueryPoint, ViewOptions, ViewSample};

/// Rows of a band: enough that the queries of a block meet in it.
pub(crate) const BAND_ROWS: u32 = 16;

/// The queries of a band, and what is seen besides.
pub(crate) struct Band {
    /// Of the band's pixels, row by row, all samples of each.
    samples: Vec<ViewSample>,
    samples_per_pixel: usize,
}

/// What a band's queries found.
pub(crate) struct Found {
    /// Of each sample, flux per area; 0 where it has no query.
    irradiance: Vec<DVec3>,
    pub stats: RenderStats,
}

impl Band {
    /// What the view rays of rows `first` to `end` see.
    pub fn new(scene: &Scene, options: &ViewOptions, first: u32, end: u32) -> Self {
        let pixels = (first..end).flat_map(|y| (0..options.width).map(move |x| (x, y)));
        Self {
            samples: pixels
                .flat_map(|(x, y)| options.samples(scene, x, y))
                .collect(),
            samples_per_pixel: options.samples_per_pixel() as usize,
        }
    }

    /// Gathers all queries at the search radius; `groups` says how many iterations of a machine so
    /// many photons are.
    ///
    /// # Errors
    /// What the golden model refuses, of one of the queries.
    pub fn gather(
        &self,
        map: &FormatMap<'_>,
        groups: impl Fn(u64) -> u64,
    ) -> Result<Found, LocalError> {
        let queries = self.samples.iter().enumerate();
        let queries = queries.filter_map(|(index, sample)| Some((index, sample.query?)));
        let mut queries: Vec<(usize, QueryPoint)> = queries.collect();
        queries.sort_by_cached_key(|(_, query)| map.map().sort_key(query));
        let points: Vec<_> = queries.iter().map(|(_, query)| *query).collect();
        let mut found = Found {
            irradiance: vec![DVec3::ZERO; self.samples.len()],
            stats: RenderStats::default(),
        };
        let area = disc_area(map.map());
        for (gathered, (index, _)) in map.gather_all(&points)?.iter().zip(queries) {
            found.irradiance[index] = map.flux(gathered.sums.power) / area;
            found.stats += stats_of(gathered, groups(gathered.photons));
        }
        Ok(found)
    }

    /// The mean radiance of each pixel's view rays.
    pub fn pixels(&self, found: &Found) -> Vec<DVec3> {
        let samples = self.samples.chunks(self.samples_per_pixel);
        let irradiance = found.irradiance.chunks(self.samples_per_pixel);
        let radiance = |(samples, irradiance): (&[ViewSample], &[DVec3])| {
            let mut radiance = DVec3::ZERO;
            for (sample, irradiance) in samples.iter().zip(irradiance) {
                radiance += sample.emitted;
                if let Some(query) = sample.query {
                    radiance += query.beta * *irradiance;
                }
            }
            radiance / self.samples_per_pixel as f64
        };
        samples.zip(irradiance).map(radiance).collect()
    }
}

fn stats_of(gathered: &Gathered, photon_groups: u64) -> RenderStats {
    RenderStats {
        query_points: 1,
        gathers: 1,
        photon_tests: gathered.photons,
        photons_skipped: gathered.photons - gathered.tests,
        photons_in_range: gathered.sums.count,
        photon_groups,
        largest_query: gathered.photons,
    }
}
