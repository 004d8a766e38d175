//! Makes the photon maps of a lighting.

use std::collections::HashMap;

use serde::{Deserialize, Serialize};

use super::{Caustics, Lighting};
use crate::photon_map::{MapError, PhotonMap};
use crate::render::Engine;
use crate::scene::Scene;
use crate::trace::{PathKind, Photon, PhotonTrace};

/// The search radii of the maps (scene units).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Radii {
    /// The search radius of the global map.
    pub global: f64,
    /// The search radius of the map of caustics; `None` where there is no such map or no caustic photon.
    pub caustic: Option<f64>,
}

impl Radii {
    /// Finds the radii. With the global radius a query has `in_range` photons in range, on average over the
    /// scene ([`PhotonMap::radius_for`]). With the caustics' radius a caustic photon has as many in range as
    /// the lighting states, on average over the caustic photons.
    #[must_use]
    pub fn of(scene: &Scene, trace: &PhotonTrace, lighting: &Lighting, in_range: f64) -> Self {
        let mapped = trace.kinds.iter().filter(|kind| lighting.maps(**kind));
        let global = PhotonMap::radius_for(scene, mapped.count().max(1) as u64, in_range);
        let caustic = caustic_radius(trace, lighting, global);
        Self { global, caustic }
    }

    /// Finds the radius of the caustics, where these have their own map and no radius was found before.
    pub(crate) fn find_caustic(&mut self, trace: &PhotonTrace, lighting: &Lighting) {
        if self.caustic.is_none() {
            self.caustic = caustic_radius(trace, lighting, self.global);
        }
    }

    /// Both radii times `factor`.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        Self {
            global: factor * self.global,
            caustic: self.caustic.map(|radius| factor * radius),
        }
    }
}

/// The radius of the caustics' own map; `None` where they have none, or where there is no caustic photon.
fn caustic_radius(trace: &PhotonTrace, lighting: &Lighting, widest: f64) -> Option<f64> {
    match lighting.caustics {
        Caustics::Map => None,
        Caustics::Own(in_range) => {
            let photons = trace.of(|kind| kind == PathKind::Caustic);
            radius_among(&photons, in_range, widest)
        }
    }
}

/// The radius, at most `widest`, at which a photon has about `in_range` photons in range, on average. They
/// are counted in cells: N photons, n of them in a photon's own cell of edge e, have a density of n / e^2.
/// `None` where there are no photons.
fn radius_among(photons: &[Photon], in_range: f64, widest: f64) -> Option<f64> {
    /// The number of steps. Each radius gives the next; with an even density the first does not change.
    const STEPS: usize = 8;
    if photons.is_empty() {
        return None;
    }
    let next = |radius: f64| {
        let density = own_cell(photons, radius) / (radius * radius);
        (in_range / (std::f64::consts::PI * density))
            .sqrt()
            .min(widest)
    };
    Some((0..STEPS).fold(widest, |radius, _| next(radius)))
}

/// The mean number of photons in the cell of a photon, this photon included.
fn own_cell(photons: &[Photon], edge: f64) -> f64 {
    let mut cells: HashMap<_, u64> = HashMap::new();
    for photon in photons {
        let cell = (photon.position / edge).floor().as_i64vec3();
        *cells.entry((cell, photon.surface)).or_default() += 1;
    }
    let squares: f64 = cells.values().map(|count| (count * count) as f64).sum();
    squares / photons.len() as f64
}

/// The photon maps of a picture: one, or two where caustics have their own.
#[derive(Debug, Clone, PartialEq)]
pub struct PhotonMaps {
    /// The photons of the kinds that [`Lighting::maps`] selects.
    pub global: PhotonMap,
    /// The map of caustics; `None` where they have no map of their own or there is no caustic photon.
    pub caustic: Option<PhotonMap>,
}

impl PhotonMaps {
    /// Makes the maps of a trace, in blocks whose edge is the radius.
    ///
    /// # Errors
    /// As for [`PhotonMap::new`].
    pub fn new(
        scene: &Scene,
        trace: PhotonTrace,
        lighting: &Lighting,
        radii: Radii,
    ) -> Result<Self, MapError> {
        Self::in_blocks(scene, trace, lighting, radii, |radius| radius)
    }

    /// Makes the maps of a trace in the blocks of an engine's numbers, so that the engine needs no other copy of the photons. A
    /// picture by that engine is the same, bit for bit, as from [`Self::new`].
    ///
    /// # Errors
    /// As for [`PhotonMap::new_reblocked`].
    pub fn for_engine(
        scene: &Scene,
        trace: PhotonTrace,
        lighting: &Lighting,
        radii: Radii,
        engine: Engine<'_>,
    ) -> Result<Self, MapError> {
        Self::in_blocks(scene, trace, lighting, radii, |radius| engine.edge(radius))
    }

    /// Makes the maps with blocks of the `edge` of their radius.
    fn in_blocks(
        scene: &Scene,
        trace: PhotonTrace,
        lighting: &Lighting,
        radii: Radii,
        edge: impl Fn(f64) -> f64,
    ) -> Result<Self, MapError> {
        let caustic = radii.caustic.map(|radius| {
            let photons = trace.of(|kind| kind == PathKind::Caustic);
            PhotonMap::new_reblocked(scene, photons, radius, edge(radius))
        });
        let photons = trace.into_those(|kind| lighting.maps(kind));
        Ok(Self {
            global: PhotonMap::new_reblocked(scene, photons, radii.global, edge(radii.global))?,
            caustic: caustic.transpose()?,
        })
    }

    /// Makes one map of all light.
    #[must_use]
    pub fn of_one(global: PhotonMap) -> Self {
        Self {
            global,
            caustic: None,
        }
    }

    /// The number of photons in both maps.
    #[must_use]
    pub fn photons(&self) -> usize {
        let caustic = self.caustic.as_ref();
        self.global.photons().len() + caustic.map_or(0, |map| map.photons().len())
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    fn lattice(side: u32, step: f64) -> Vec<Photon> {
        let places = (0..side).flat_map(|x| (0..side).map(move |z| (x, z)));
        let photon = |(x, z)| Photon {
            position: step * DVec3::new(f64::from(x), 0.0, f64::from(z)),
            power: DVec3::ONE,
            surface: 0,
            facing: crate::trace::Facing::FLAT,
        };
        places.map(photon).collect()
    }

    #[test]
    fn the_radius_among_even_photons_is_that_of_their_density() {
        let radius = radius_among(&lattice(200, 0.01), 50.0, 1.0).unwrap();
        let expected = (50.0 / std::f64::consts::PI).sqrt() * 0.01;
        // Cells of some 16 photons have borders somewhere in the lattice.
        assert!((radius / expected - 1.0).abs() < 0.1, "{radius} {expected}");
    }

    #[test]
    fn few_photons_have_the_widest_radius_and_none_have_none() {
        assert_eq!(radius_among(&lattice(3, 1.0), 50.0, 0.5), Some(0.5));
        assert_eq!(radius_among(&[], 50.0, 0.5), None);
    }
}
