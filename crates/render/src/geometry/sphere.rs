//! Spheres with a front outside.

use glam::DVec3;

use super::Hit;
use crate::view::Ray;

/// A sphere. Its front is its outside.
#[derive(Debug, Clone, PartialEq)]
pub struct Sphere {
    centre: DVec3,
    radius: f64,
}

impl Sphere {
    /// The sphere with that centre and radius in scene units; `None` for a radius that is not over 0, or
    /// numbers that are not finite.
    #[must_use]
    pub fn new(centre: DVec3, radius: f64) -> Option<Self> {
        let possible = centre.is_finite() && radius.is_finite() && radius > 0.0;
        possible.then_some(Self { centre, radius })
    }

    /// The area, in squared scene units.
    #[must_use]
    pub fn area(&self) -> f64 {
        4.0 * std::f64::consts::PI * self.radius * self.radius
    }

    /// The radius, in scene units.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The smallest and the largest corner of the bounding box, in scene units.
    #[must_use]
    pub fn bounds(&self) -> [DVec3; 2] {
        [self.centre - self.radius, self.centre + self.radius]
    }

    /// The first point where `ray` meets the sphere at a distance over `t_min` and below `t_max`, from
    /// outside or from inside.
    ///
    /// The position is placed on the sphere along its normal, so that it lies there however far away the ray
    /// starts.
    #[must_use]
    pub fn intersect(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Hit> {
        let length_sq = ray.direction.length_squared();
        let to_centre = self.centre - ray.origin;
        // The distance to the point of the ray nearest to the centre, and the distance of that point from the
        // centre; no large squares are subtracted.
        let nearest = to_centre.dot(ray.direction) / length_sq;
        let beside = (to_centre - nearest * ray.direction).length_squared();
        let half_chord_sq = (self.radius * self.radius - beside) / length_sq;
        // A ray that misses gives NaN, which fails every comparison.
        let half_chord = half_chord_sq.sqrt();
        let t = [nearest - half_chord, nearest + half_chord]
            .into_iter()
            .find(|t| *t > t_min && *t < t_max)?;
        let normal = (t * ray.direction - to_centre).normalize();
        Some(Hit {
            t,
            position: self.centre + self.radius * normal,
            normal,
            front: normal.dot(ray.direction) < 0.0,
        })
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn sphere() -> Sphere {
        Sphere::new(DVec3::new(1.0, -2.0, 0.5), 0.7).unwrap()
    }

    fn direction() -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-1.0..1.0f64)
            .prop_map(DVec3::from)
            .prop_filter("long enough to have a direction", |d| d.length() > 0.1)
            .prop_map(DVec3::normalize)
    }

    proptest! {
        /// A ray at a point of the near side meets that point from outside. Continued, it meets the far side
        /// from inside, at the angle at which it entered.
        #[test]
        fn a_ray_goes_in_and_out_at_one_angle(n in direction(), d in direction(), away in 0.01..50.0f64) {
            prop_assume!(n.dot(d) < -0.05);
            let sphere = sphere();
            let target = sphere.centre + sphere.radius * n;
            let ray = Ray { origin: target - away * d, direction: d };
            let hit = sphere.intersect(&ray, 0.0, f64::INFINITY).expect("aimed at it");
            // 1e-12: a few roundings at coordinates of about 50.
            prop_assert!(hit.position.distance(target) < 1e-12);
            prop_assert!(hit.front && (hit.t - away).abs() < 1e-12);
            let inside = Ray { origin: hit.position, direction: d };
            let out = sphere.intersect(&inside, 1e-6, f64::INFINITY).expect("from inside");
            prop_assert!(!out.front);
            prop_assert!((out.normal.dot(d) + hit.normal.dot(d)).abs() < 1e-12);
        }

        /// A ray that passes the centre further away than the radius misses.
        #[test]
        fn stray_rays_miss(d in direction(), beside in 0.7001..3.0f64) {
            let sphere = sphere();
            let side = d.any_orthonormal_vector();
            let ray = Ray { origin: sphere.centre + beside * side - 2.0 * d, direction: d };
            prop_assert!(sphere.intersect(&ray, 0.0, f64::INFINITY).is_none());
        }
    }

    #[test]
    fn what_is_behind_is_not_met() {
        let sphere = sphere();
        let ray = Ray {
            origin: sphere.centre + 2.0 * DVec3::X,
            direction: DVec3::X,
        };
        assert_eq!(sphere.intersect(&ray, 0.0, f64::INFINITY), None);
    }

    #[test]
    fn impossible_spheres_are_refused() {
        for radius in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(Sphere::new(DVec3::ZERO, radius), None);
        }
        assert_eq!(Sphere::new(DVec3::NAN, 1.0), None);
    }
}
