//! The power's part of an error: powers rounded by a format, positions exact.

use std::ops::Range;

use glam::DVec3;
use photoncube_spec::{PHOTON_FORMATS, PhotonFormat, PowerFormat};
use rayon::prelude::*;

use super::pilot::{Part, Pilot};
use crate::estimate::disc_area;
use crate::metrics::BenchError;
use crate::photon_map::PhotonMap;
use crate::quantise::QuantisedMap;
use crate::view::QueryPoint;

/// The photons in range of every query of the pilot, found once for any number of power formats.
///
/// Dither depends on the stored position, and a block's exponent on the block; both use the default format's
/// positions.
pub(super) struct Gathered {
    maps: Vec<GatheredMap>,
}

struct GatheredMap {
    map: PhotonMap,
    /// The indices of the photons in range, query after query.
    photons: Vec<u32>,
    /// The slice of `photons` for each query.
    slices: Vec<Range<usize>>,
}

impl Gathered {
    pub fn new(pilot: &Pilot) -> Result<Self, BenchError> {
        let gathered = |map: &PhotonMap| -> Result<GatheredMap, BenchError> {
            let map = QuantisedMap::blocked(map, &PHOTON_FORMATS[0].into())?;
            Ok(GatheredMap::new(map.into_owned(), pilot.bench.queries()))
        };
        let maps = pilot.bench.maps().iter().map(gathered);
        Ok(Self {
            maps: maps.collect::<Result<_, _>>()?,
        })
    }

    /// The error that the format of powers alone causes.
    pub fn power_part(&self, pilot: &Pilot, power: &PowerFormat) -> Result<Part, BenchError> {
        self.part_of(self.maps.len(), pilot, power)
    }

    /// The error that the format of powers alone causes, on one map only: a rough figure in a fraction of the
    /// time.
    pub fn rough_part(&self, pilot: &Pilot, power: &PowerFormat) -> Result<Part, BenchError> {
        self.part_of(1, pilot, power)
    }

    fn part_of(&self, maps: usize, pilot: &Pilot, power: &PowerFormat) -> Result<Part, BenchError> {
        let format = PhotonFormat {
            power: *power,
            ..PHOTON_FORMATS[0]
        };
        let mut part = Part::default();
        for (index, gathered) in self.maps.iter().take(maps).enumerate() {
            let rounded = QuantisedMap::new(&gathered.map, &format.into())?;
            let photons = (0..gathered.map.photons().len()).into_par_iter();
            let powers: Vec<DVec3> = photons.map(|photon| rounded.power(photon)).collect();
            let estimates = gathered.lights(&powers, pilot.bench.queries());
            pilot.push(&mut part, index, &estimates);
        }
        Ok(part)
    }
}

impl GatheredMap {
    fn new(map: PhotonMap, queries: &[QueryPoint]) -> Self {
        let found = queries.par_iter().map(|query| in_range(&map, query));
        let found: Vec<Vec<u32>> = found.collect();
        let (mut photons, mut slices) = (Vec::new(), Vec::new());
        for query in found {
            slices.push(photons.len()..photons.len() + query.len());
            photons.extend(query);
        }
        Self {
            map,
            photons,
            slices,
        }
    }

    /// The reflected light at each query with these powers.
    fn lights(&self, powers: &[DVec3], queries: &[QueryPoint]) -> Vec<DVec3> {
        let disc = disc_area(&self.map);
        let queries = queries.par_iter().zip(&self.slices);
        let lights = queries.map(|(query, slice)| {
            let photons = &self.photons[slice.clone()];
            let power: DVec3 = photons.iter().map(|photon| powers[*photon as usize]).sum();
            query.beta * power / disc
        });
        lights.collect()
    }
}

fn in_range(map: &PhotonMap, query: &QueryPoint) -> Vec<u32> {
    let radius_sq = map.radius() * map.radius();
    let runs = map.candidates(query.position, query.front());
    let photons = runs.flat_map(|run| run.photons);
    let inside = photons.filter(|photon| {
        let position = map.photons()[*photon].position;
        position.distance_squared(query.position) <= radius_sq
    });
    inside.map(|photon| photon as u32).collect()
}
