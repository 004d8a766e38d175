//! The photons in range of a query by where they lie: two rings of equal area, and in each the four quadrants of the signs of
//! their offset along two axes of the surface.

use glam::DVec3;

use crate::photon_map::PhotonMap;
use crate::view::QueryPoint;

/// The number of sectors, of equal area on a plane.
pub(crate) const SECTORS: usize = 8;

/// The number of photons in each sector.
pub(crate) type Sectors = [u32; SECTORS];

/// Counts the photons within `radius` of a query, at most the map's radius. The first four sectors are those of the inner ring, d^2 <=
/// r^2 / 2. On a wall that is parallel to two axes of the scene, the quadrants are those of the signs of two differences of coordinates.
pub(crate) fn sectors(map: &PhotonMap, query: &QueryPoint, radius: f64) -> Sectors {
    let (u, v) = query.normal.any_orthonormal_pair();
    let radius_sq = radius * radius;
    let mut found = Sectors::default();
    for run in map.candidates(query.position, query.front()) {
        for photon in &map.photons()[run.photons] {
            let offset = photon.position - query.position;
            let distance_sq = offset.length_squared();
            if distance_sq <= radius_sq {
                found[sector(offset, distance_sq, radius_sq, [u, v])] += 1;
            }
        }
    }
    found
}

fn sector(offset: DVec3, distance_sq: f64, radius_sq: f64, axes: [DVec3; 2]) -> usize {
    let [u, v] = axes.map(|axis| usize::from(axis.dot(offset) < 0.0));
    4 * usize::from(distance_sq > 0.5 * radius_sq) + 2 * u + v
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::fixtures::traced_cornell;
    use crate::view::ViewOptions;

    /// The axes of a wall that is parallel to those of the scene are axes of the scene.
    #[test]
    fn quadrants_of_a_wall_are_signs_of_coordinates() {
        for normal in [DVec3::X, DVec3::NEG_Y, DVec3::Z] {
            let (u, v) = normal.any_orthonormal_pair();
            for axis in [u, v] {
                assert_eq!(axis.abs().max_element(), 1.0, "{normal}: {axis}");
                assert_eq!(axis.length(), 1.0);
            }
        }
        let axes = [DVec3::X, DVec3::Z];
        let at = |x: f64, z: f64| sector(DVec3::new(x, 0.0, z), x * x + z * z, 1.0, axes);
        let inner = [at(0.1, 0.1), at(0.1, -0.1), at(-0.1, 0.1), at(-0.1, -0.1)];
        assert_eq!(inner, [0, 1, 2, 3]);
        let outer = [at(0.7, 0.7), at(0.8, -0.1), at(-0.8, 0.1), at(-0.6, -0.7)];
        assert_eq!(outer, [4, 5, 6, 7]);
    }

    #[test]
    fn the_sectors_hold_the_photons_in_range_and_the_inner_ring_those_of_the_half() {
        let (scene, map) = traced_cornell(20_000, 9, 0.15);
        let view = ViewOptions::default();
        let samples = view.samples(&scene, 128, 220);
        let query = samples.filter_map(|sample| sample.query).next().unwrap();
        let near = |radius: f64| {
            let of = crate::Neighbourhood::block_walk(&map, &query);
            let found = of.fixed_radius(radius, crate::Kernel::Rectangle);
            found.unwrap().in_range as u32
        };
        for radius in [0.15, 0.06] {
            let found = sectors(&map, &query, radius);
            assert_eq!(found.iter().sum::<u32>(), near(radius));
            let inner = radius * 0.5_f64.sqrt();
            assert_eq!(found[..4].iter().sum::<u32>(), near(inner));
        }
    }
}
