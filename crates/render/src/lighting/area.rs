//! Computes the area of the flat fronts that a search sphere contains.

use glam::{DVec2, DVec3};

use super::balls::disc_over_cap;
use crate::geometry::{Geometry, Quad};
use crate::photon_map::PhotonMap;
use crate::scene::Scene;
use crate::view::Front;

/// The largest distance from a front, as a fraction of the radius, of a query point on it; positions are
/// rounded.
const ON_FRONT: f64 = 1e-6;

/// The flat fronts of a scene that store photons.
pub(crate) struct Fronts {
    /// Each with the index of its surface.
    quads: Vec<(u32, Quad)>,
    /// The radius of each surface that is a ball, in scene units.
    balls: Vec<Option<f64>>,
}

impl Fronts {
    pub fn of(scene: &Scene) -> Self {
        let surfaces = (0..).zip(scene.surfaces());
        let diffuse = surfaces.filter(|(_, surface)| !surface.is_specular());
        let quads = diffuse.filter_map(|(index, surface)| match &surface.geometry {
            Geometry::Quad(quad) => Some((index, quad.clone())),
            _ => None,
        });
        let balls = scene
            .surfaces()
            .iter()
            .map(|surface| match &surface.geometry {
                Geometry::Sphere(sphere) => Some(sphere.radius()),
                _ => None,
            });
        Self {
            quads: quads.collect(),
            balls: balls.collect(),
        }
    }

    /// The area of the disc over the area, inside the search sphere of `radius`, of the fronts whose photons
    /// a query at `position` on `front` gathers from `map`, by the rule of [`PhotonMap`]. The ratio is at least 1 where only one
    /// front is near. On a ball the front is the part of it whose photons count. The ratio is 1 where the query is on none of the fronts,
    /// since it is then on another curved surface.
    pub fn disc_over_covered(
        &self,
        map: &PhotonMap,
        position: DVec3,
        front: &Front,
        radius: f64,
    ) -> f64 {
        let surface = front.surface.map(|surface| surface as usize);
        if let Some(ball) = surface.and_then(|surface| self.balls[surface]) {
            return disc_over_cap(radius / ball);
        }
        let joined = front.surface.map(|surface| map.joined_surfaces(surface));
        let counts = |surface: &u32| joined.is_none_or(|joined| joined.contains(surface));
        let (mut covered, mut on_front) = (0.0, false);
        for (surface, quad) in &self.quads {
            if quad.normal().dot(front.normal) > PhotonMap::MIN_FACING_COSINE && counts(surface) {
                let (height, area) = cut(quad, position, radius);
                covered += area;
                on_front |= height < ON_FRONT * radius && area > 0.0;
            }
        }
        match on_front {
            true => std::f64::consts::PI * radius * radius / covered,
            false => 1.0,
        }
    }
}

/// The distance of the plane of `quad` from `centre`, and the area of `quad` in the sphere of `radius` around
/// `centre`.
fn cut(quad: &Quad, centre: DVec3, radius: f64) -> (f64, f64) {
    let corners = quad.corners();
    let height = quad.normal().dot(centre - corners[0]);
    let disc_sq = radius * radius - height * height;
    if disc_sq <= 0.0 {
        return (height.abs(), 0.0);
    }
    let (x, y) = quad.normal().any_orthonormal_pair();
    let flat = corners.map(|corner| {
        let offset = corner - centre;
        DVec2::new(offset.dot(x), offset.dot(y))
    });
    let edges = (0..4).map(|i| edge_area(flat[i], flat[(i + 1) % 4], disc_sq));
    (height.abs(), edges.sum::<f64>().abs())
}

/// The signed area between the origin and the edge from `a` to `b`, inside the disc of squared radius
/// `disc_sq`: the sector before the edge enters the disc, the triangle inside, and the sector behind.
fn edge_area(a: DVec2, b: DVec2, disc_sq: f64) -> f64 {
    let sector = |from: DVec2, to: DVec2| 0.5 * disc_sq * from.angle_to(to);
    let way = b - a;
    let (length_sq, middle) = (way.length_squared(), -a.dot(way));
    let discriminant = middle * middle - length_sq * (a.length_squared() - disc_sq);
    if discriminant <= 0.0 {
        return sector(a, b);
    }
    let root = discriminant.sqrt();
    let [enter, leave] = [middle - root, middle + root].map(|t| (t / length_sq).clamp(0.0, 1.0));
    let [first, last] = [enter, leave].map(|t| a + t * way);
    let before = if enter > 0.0 { sector(a, first) } else { 0.0 };
    let behind = if leave < 1.0 { sector(last, b) } else { 0.0 };
    before + 0.5 * first.perp_dot(last) + behind
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use proptest::prelude::*;

    use super::*;
    use crate::scene::fixtures::traced_cornell;

    fn floor() -> Quad {
        let corners = [(0.0, 0.0), (0.0, 1.0), (2.0, 1.0), (2.0, 0.0)];
        Quad::from_corners(corners.map(|(x, z)| DVec3::new(x, 0.0, z))).unwrap()
    }

    fn area(x: f64, y: f64, z: f64, radius: f64) -> f64 {
        cut(&floor(), DVec3::new(x, y, z), radius).1
    }

    #[test]
    fn discs_inside_across_an_edge_and_at_a_corner() {
        // 1e-12: a few roundings of numbers near 1.
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} {b}");
        near(area(1.0, 0.0, 0.5, 0.25), PI * 0.0625);
        near(area(1.0, 0.0, 0.0, 0.25), PI * 0.0625 / 2.0);
        near(area(0.0, 0.0, 0.0, 0.25), PI * 0.0625 / 4.0);
        near(area(1.0, 0.0, 0.5, 10.0), 2.0);
        near(area(5.0, 0.0, 0.5, 0.25), 0.0);
        // Off the plane the sphere contains a smaller disc, or none.
        near(area(1.0, 0.15, 0.5, 0.25), PI * 0.04);
        near(area(1.0, 0.3, 0.5, 0.25), 0.0);
    }

    proptest! {
        /// Compares the area with a fine grid of cells, each of which counts by its middle.
        #[test]
        fn areas_are_those_of_counted_cells(x in -0.5..2.5f64, z in -0.5..1.5f64, radius in 0.1..1.5f64) {
            const CELLS: u32 = 400;
            let step = 2.0 * radius / f64::from(CELLS);
            let middle = |i: u32| -radius + (f64::from(i) + 0.5) * step;
            let mut counted = 0.0;
            for (i, j) in (0..CELLS).flat_map(|i| (0..CELLS).map(move |j| (i, j))) {
                let (u, v) = (middle(i), middle(j));
                let inside = (0.0..2.0).contains(&(x + u)) && (0.0..1.0).contains(&(z + v));
                counted += if inside && u * u + v * v <= radius * radius { step * step } else { 0.0 };
            }
            // The border, at most 2 pi r and four edges of 2 r long, is wrong by half a cell at most.
            let bound = 8.0 * radius * step;
            prop_assert!((area(x, 0.0, z, radius) - counted).abs() <= bound);
        }
    }

    #[test]
    fn a_query_in_the_middle_of_a_wall_has_the_disc_and_at_its_edge_half() {
        let (scene, map) = traced_cornell(1000, 1, 0.05);
        let fronts = Fronts::of(&scene);
        let floor = Front::of_any(DVec3::Y);
        let factor = |x| {
            let position = DVec3::new(x, -1.0, 0.9);
            fronts.disc_over_covered(&map, position, &floor, map.radius())
        };
        // 1e-5: the reference's single-precision corners.
        assert!((factor(-0.8) - 1.0).abs() < 1e-5);
        assert!((factor(-1.0) - 2.0).abs() < 1e-3, "{}", factor(-1.0));
        // The point is on no front, as on a curved surface, so the factor is 1.
        let off = fronts.disc_over_covered(&map, DVec3::ZERO, &floor, map.radius());
        assert_eq!(off, 1.0);
    }
}
