//! Finds which surfaces are joined, so that light on one tells of the light on the other.

use glam::DVec3;

use super::Surface;
use crate::geometry::{Geometry, Quad};

/// The largest gap between joined surfaces, as a fraction of the scene's diagonal: far above the rounding of single-precision corners,
/// and far below any wall.
const GAP: f64 = 1e-5;

/// For each surface, the surfaces that touch it along an edge.
///
/// Two quads are joined where they share a piece of an edge, or where an edge of one lies on the other. So two of their corners at
/// different places lie on the other quad, or one of each. Quads that touch in one corner are not joined. A curved surface is joined with
/// those whose boxes touch its own.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Joins {
    /// The indices of the joined surfaces, in order, without the surface itself.
    of: Vec<Vec<u32>>,
    /// The bounding boxes of the surfaces.
    boxes: Vec<[DVec3; 2]>,
}

impl Joins {
    /// The joins of the surfaces of a scene with that diagonal.
    pub fn of(surfaces: &[Surface], diagonal: f64) -> Self {
        let gap = GAP * diagonal;
        let boxes: Vec<_> = surfaces.iter().map(|s| s.geometry.bounds()).collect();
        let mut of = vec![Vec::new(); surfaces.len()];
        for (a, first) in surfaces.iter().enumerate() {
            for (b, second) in surfaces.iter().enumerate().skip(a + 1) {
                let store = !first.is_specular() && !second.is_specular();
                if store
                    && distance(boxes[a], boxes[b]) <= gap
                    && touch(&first.geometry, &second.geometry, gap)
                {
                    of[a].push(b as u32);
                    of[b].push(a as u32);
                }
            }
        }
        of.iter_mut().for_each(|joined| joined.sort_unstable());
        Self { of, boxes }
    }

    /// The surfaces, in order, whose photons may count for a query on `surface`: itself, those that `faces` allows and that are joined with
    /// it, and those joined with one of these that is shorter than the search sphere, so that a floor of small tiles is one floor. Surfaces
    /// further away than `radius` (scene units) are left out.
    pub fn around(&self, surface: u32, radius: f64, faces: impl Fn(u32) -> bool) -> Vec<u32> {
        let own = self.boxes[surface as usize];
        let (mut found, mut next) = (vec![surface], 0);
        while next < found.len() {
            let through = found[next] as usize;
            next += 1;
            let [low, high] = self.boxes[through];
            if next > 1 && low.distance(high) > 2.0 * radius {
                continue;
            }
            for &joined in &self.of[through] {
                let is_near = distance(own, self.boxes[joined as usize]) <= radius;
                if is_near && !found.contains(&joined) && faces(joined) {
                    found.push(joined);
                }
            }
        }
        found.sort_unstable();
        found
    }
}

/// The distance between two boxes.
fn distance([low, high]: [DVec3; 2], [other_low, other_high]: [DVec3; 2]) -> f64 {
    (other_low - high)
        .max(low - other_high)
        .max(DVec3::ZERO)
        .length()
}

/// Whether two surfaces touch along an edge, with at most `gap` between.
fn touch(first: &Geometry, second: &Geometry, gap: f64) -> bool {
    let (Geometry::Quad(first), Geometry::Quad(second)) = (first, second) else {
        // Their boxes touch, and no edge is known.
        return true;
    };
    let on = |corners: &Quad, quad: &Quad| {
        let corners = corners.corners().into_iter();
        let quad = quad.clone();
        corners.filter(move |corner| quad.distance(*corner) <= gap)
    };
    let mut contacts = on(first, second).chain(on(second, first));
    let Some(contact) = contacts.next() else {
        return false;
    };
    contacts.any(|other| other.distance(contact) > 2.0 * gap)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Bsdf;

    /// A quad that faces up, at that height.
    fn flat(x: [f64; 2], z: [f64; 2], y: f64) -> Surface {
        let corner = |x, z| DVec3::new(x, y, z);
        let corners = [
            corner(x[0], z[1]),
            corner(x[1], z[1]),
            corner(x[1], z[0]),
            corner(x[0], z[0]),
        ];
        Surface {
            shape: "floor".to_owned(),
            geometry: Geometry::Quad(Quad::from_corners(corners).unwrap()),
            bsdf: Bsdf::Diffuse {
                reflectance: DVec3::ONE,
            },
            radiance: DVec3::ZERO,
        }
    }

    fn around(surfaces: &[Surface], surface: u32, radius: f64) -> Vec<u32> {
        Joins::of(surfaces, 4.0).around(surface, radius, |_| true)
    }

    #[test]
    fn surfaces_are_joined_along_edges_and_not_across_gaps_or_corners() {
        let unit = flat([0.0, 1.0], [0.0, 1.0], 0.0);
        let joined = |other: Surface| around(&[unit.clone(), other], 0, 0.5) == [0, 1];
        assert!(joined(flat([1.0, 2.0], [0.0, 1.0], 0.0)), "a whole edge");
        assert!(
            joined(flat([1.0, 2.0], [0.5, 3.0], 0.0)),
            "a piece of an edge"
        );
        assert!(joined(flat([0.2, 0.4], [0.2, 0.4], 0.0)), "a rug");
        assert!(joined(flat([1.00002, 2.0], [0.0, 1.0], 1e-6)), "roundings");
        assert!(!joined(flat([1.0, 2.0], [1.0, 2.0], 0.0)), "one corner");
        assert!(
            !joined(flat([1.002, 2.0], [0.0, 1.0], 0.0)),
            "a wall between"
        );
        assert!(!joined(flat([0.0, 1.0], [0.0, 1.0], 0.01)), "a shelf");
    }

    /// Ten tiles in a row: a query reaches across those that are smaller than its sphere, as far as its radius.
    #[test]
    fn small_tiles_are_one_floor_and_large_ones_join_their_neighbours_only() {
        let tile = |index: i32| flat([f64::from(index), f64::from(index + 1)], [0.0, 1.0], 0.0);
        let tiles: Vec<_> = (0..10).map(tile).collect();
        assert_eq!(around(&tiles, 4, 0.5), [3, 4, 5]);
        assert_eq!(around(&tiles, 4, 2.5), [1, 2, 3, 4, 5, 6, 7]);
        let found = Joins::of(&tiles, 4.0).around(4, 2.5, |surface| surface != 5);
        assert_eq!(found, [1, 2, 3, 4], "what faces elsewhere joins nothing");
    }
}
