//! Quads: parallelograms with a front.

use glam::DVec3;

use super::Hit;
use crate::view::Ray;

/// The largest distance, as a fraction of the quad's size, of the fourth corner from its place by the other
/// three. The reference scene's single-precision transforms are off by 1e-7.
const CORNER_TOLERANCE: f64 = 1e-5;

/// A parallelogram. Its front is the side from which the corners run counter-clockwise.
#[derive(Debug, Clone, PartialEq)]
pub struct Quad {
    origin: DVec3,
    edges: [DVec3; 2],
    normal: DVec3,
    area: f64,
    /// Vectors whose dot product with `position - origin` gives the coordinates along `edges`.
    dual: [DVec3; 2],
}

impl Quad {
    /// The parallelogram with these corners in order; `None` where they do not span one (a
    /// fourth corner out of place by more than 1e-5 of the size, no area, not finite).
    #[must_use]
    pub fn from_corners(corners: [DVec3; 4]) -> Option<Self> {
        let origin = corners[0];
        let edges = [corners[1] - origin, corners[3] - origin];
        let cross = edges[0].cross(edges[1]);
        let area = cross.length();
        let size = edges[0].length() + edges[1].length();
        let gap = (origin + edges[0] + edges[1]).distance(corners[2]);
        let flat = gap <= CORNER_TOLERANCE * size;
        // 1e-12 is far below any intended quad and far above the rounding of a collinear one.
        if !flat || !area.is_finite() || area <= 1e-12 * size * size {
            return None;
        }
        let normal = cross / area;
        let dual = [edges[1].cross(normal) / area, normal.cross(edges[0]) / area];
        Some(Self {
            origin,
            edges,
            normal,
            area,
            dual,
        })
    }

    /// The unit normal of the front.
    #[must_use]
    pub fn normal(&self) -> DVec3 {
        self.normal
    }

    /// The area, in squared scene units.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.area
    }

    /// The point at `(u, v)` along the two edges, each from 0 to 1. Uniform numbers give
    /// points uniform over the area.
    #[must_use]
    pub fn point(&self, u: f64, v: f64) -> DVec3 {
        self.origin + u * self.edges[0] + v * self.edges[1]
    }

    /// The corners, counter-clockwise as seen from the front.
    #[must_use]
    pub fn corners(&self) -> [DVec3; 4] {
        [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(u, v)| self.point(u, v))
    }

    /// The distance of a point from the quad, in scene units.
    #[must_use]
    pub fn distance(&self, point: DVec3) -> f64 {
        let local = point - self.origin;
        let height = self.normal.dot(local);
        let [u, v] = self.dual.map(|d| d.dot(local));
        if (0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v) {
            return height.abs();
        }
        let corners = self.corners();
        let edges = (0..4).map(|i| from_segment(point, corners[i], corners[(i + 1) % 4]));
        edges.fold(f64::INFINITY, f64::min)
    }

    /// The point where `ray` meets the quad at a distance over `t_min` and below `t_max`.
    ///
    /// The position is computed from the edge coordinates and not from the distance, so that it lies on the
    /// quad's plane however far away the ray starts.
    #[must_use]
    pub fn intersect(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Hit> {
        let approach = ray.direction.dot(self.normal);
        let t = (self.origin - ray.origin).dot(self.normal) / approach;
        // The NaN or infinity of a parallel ray fails this comparison.
        if !(t > t_min && t < t_max) {
            return None;
        }
        let local = ray.origin + t * ray.direction - self.origin;
        let [u, v] = self.dual.map(|d| d.dot(local));
        let inside = (0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v);
        inside.then(|| Hit {
            t,
            position: self.point(u, v),
            normal: self.normal,
            front: approach < 0.0,
        })
    }
}

/// The distance of a point from the segment between `a` and `b`.
fn from_segment(point: DVec3, a: DVec3, b: DVec3) -> f64 {
    let way = b - a;
    let part = ((point - a).dot(way) / way.length_squared()).clamp(0.0, 1.0);
    point.distance(a + part * way)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn slanted() -> Quad {
        let [a, u, v] = [
            DVec3::new(1.0, 2.0, 3.0),
            DVec3::new(2.0, 0.5, 0.0),
            DVec3::new(0.0, 1.0, 1.5),
        ];
        Quad::from_corners([a, a + u, a + u + v, a + v]).expect("a parallelogram")
    }

    #[test]
    fn unit_square_faces_up() {
        let z = DVec3::ZERO;
        let quad = Quad::from_corners([z, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y]).unwrap();
        assert_eq!(quad.normal(), DVec3::Z);
        assert_eq!(quad.area(), 1.0);
    }

    #[test]
    fn distances_are_to_the_inside_an_edge_and_a_corner() {
        let corners = [(0.0, 1.0), (2.0, 1.0), (2.0, 0.0), (0.0, 0.0)];
        let quad = Quad::from_corners(corners.map(|(x, z)| DVec3::new(x, 0.0, z))).unwrap();
        let distance = |x, y, z| quad.distance(DVec3::new(x, y, z));
        assert_eq!(distance(0.5, 0.25, 0.5), 0.25);
        assert_eq!(distance(1.0, 3.0, -4.0), 5.0);
        assert_eq!(distance(4.0, 1.0, 3.0), 3.0);
    }

    #[test]
    fn what_is_no_parallelogram_is_refused() {
        let [z, x, y] = [DVec3::ZERO, DVec3::X, DVec3::Y];
        assert!(Quad::from_corners([z, x, 1.1 * (x + y), y]).is_none());
        assert!(Quad::from_corners([z, x, 3.0 * x, 2.0 * x]).is_none());
        assert!(Quad::from_corners([z; 4]).is_none());
        assert!(Quad::from_corners([z, x, x + y, DVec3::NAN]).is_none());
    }

    proptest! {
        /// A ray aimed at a point of the quad hits that point and reports the side.
        #[test]
        fn aimed_rays_hit(u in 0.001..0.999, v in 0.001..0.999, side in prop::bool::ANY) {
            let quad = slanted();
            let target = quad.point(u, v);
            let sign = if side { 1.0 } else { -1.0 };
            let origin = target + sign * (2.0 * quad.normal() + 0.3 * DVec3::X);
            let ray = Ray { origin, direction: (target - origin).normalize() };
            let hit = quad.intersect(&ray, 0.0, f64::INFINITY).expect("aimed at it");
            // 1e-12: a few roundings at coordinates of about 5.
            prop_assert!(hit.position.distance(target) < 1e-12);
            prop_assert_eq!(hit.front, side);
        }

        /// A ray aimed beside the quad misses.
        #[test]
        fn stray_rays_miss(u in 1.001..2.0f64, v in -1.0..2.0f64) {
            let quad = slanted();
            let origin = quad.point(u, v) + quad.normal();
            let ray = Ray { origin, direction: -quad.normal() };
            prop_assert!(quad.intersect(&ray, 0.0, f64::INFINITY).is_none());
        }
    }
}
