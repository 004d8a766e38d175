//! A quad and what it does with light.

use glam::DVec3;
use rand_pcg::Pcg64Mcg;

use crate::camera::Ray;
use crate::geometry::{Hit, Quad};
use crate::sample::cosine_direction;

/// How a surface scatters light; what it does not reflect it absorbs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bsdf {
    /// Equal radiance in all directions, from the front; the back is black.
    Diffuse {
        /// Of red, green, blue, each from 0 to 1.
        reflectance: DVec3,
    },
    /// A perfect mirror. It holds no photons, and view rays follow it.
    Mirror {
        /// Of red, green, blue, each from 0 to 1, at every angle.
        reflectance: DVec3,
        /// Whether its back is a mirror too, as of a thin sheet of metal, or black.
        two_sided: bool,
    },
}

/// One quad and what it does with light. Only its front emits.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    /// The shape that it belongs to; a box gives six surfaces of one name.
    pub shape: String,
    /// Where it is.
    pub quad: Quad,
    /// What it does with light that arrives.
    pub bsdf: Bsdf,
    /// Emitted radiance of red, green, blue; zero for what is no light, as for every mirror.
    pub radiance: DVec3,
}

impl Surface {
    /// The part of the light that it reflects, for red, green, blue.
    #[must_use]
    pub fn reflectance(&self) -> DVec3 {
        match self.bsdf {
            Bsdf::Diffuse { reflectance } | Bsdf::Mirror { reflectance, .. } => reflectance,
        }
    }

    /// Whether it is a mirror, which stores no photons.
    #[must_use]
    pub fn is_mirror(&self) -> bool {
        matches!(self.bsdf, Bsdf::Mirror { .. })
    }

    /// Whether the side that was hit does anything with light but absorb it.
    pub(crate) fn is_lit(&self, hit: &Hit) -> bool {
        let two_sided = matches!(
            self.bsdf,
            Bsdf::Mirror {
                two_sided: true,
                ..
            }
        );
        hit.front || two_sided
    }

    /// The ray on which light that arrived by `ray` leaves: for a diffuse surface a random one of
    /// density cos / pi, for a mirror the one of the law of reflection.
    pub(crate) fn scatter(&self, ray: &Ray, hit: &Hit, rng: &mut Pcg64Mcg) -> Ray {
        match self.bsdf {
            Bsdf::Diffuse { .. } => Ray {
                origin: hit.position,
                direction: cosine_direction(self.quad.normal(), rng),
            },
            Bsdf::Mirror { .. } => self.mirrored(ray, hit),
        }
    }

    /// d - 2 (d . n) n, which does not care for the side.
    pub(crate) fn mirrored(&self, ray: &Ray, hit: &Hit) -> Ray {
        Ray {
            origin: hit.position,
            direction: ray.direction.reflect(self.quad.normal()),
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::sample::{Purpose, stream};

    fn mirror(two_sided: bool) -> Surface {
        let [a, u, v] = [
            DVec3::new(1.0, 2.0, 3.0),
            DVec3::X,
            DVec3::new(0.0, 1.0, 1.5),
        ];
        Surface {
            shape: "mirror".to_owned(),
            quad: Quad::from_corners([a, a + u, a + u + v, a + v]).unwrap(),
            bsdf: Bsdf::Mirror {
                reflectance: DVec3::ONE,
                two_sided,
            },
            radiance: DVec3::ZERO,
        }
    }

    proptest! {
        /// The angles with the normal are equal, both rays lie in a plane with it, and nothing
        /// is added to the direction's length, on either side.
        #[test]
        fn mirrors_obey_the_law_of_reflection(x in -1.0..1.0f64, y in 0.1..1.0f64, back in prop::bool::ANY) {
            let mirror = mirror(true);
            let n = mirror.quad.normal();
            let side = if back { -n } else { n };
            let tangent = mirror.quad.corners()[1] - mirror.quad.corners()[0];
            let direction = (x * tangent - y * side).normalize();
            let target = mirror.quad.point(0.4, 0.6);
            let ray = Ray { origin: target - direction, direction };
            let hit = mirror.quad.intersect(&ray, 0.0, f64::INFINITY).expect("aimed at it");
            let out = mirror.scatter(&ray, &hit, &mut stream(1, Purpose::Path, 0));
            // 1e-12: a few roundings at coordinates of about 3.
            prop_assert!((out.direction.dot(n) + direction.dot(n)).abs() < 1e-12);
            prop_assert!(out.direction.dot(direction.cross(n)).abs() < 1e-12);
            prop_assert!((out.direction.dot(tangent) - direction.dot(tangent)).abs() < 1e-12);
            prop_assert!((out.direction.length() - 1.0).abs() < 1e-12);
            prop_assert!(out.origin.distance(target) < 1e-12);
        }
    }

    #[test]
    fn only_a_two_sided_mirrors_back_is_lit() {
        let mut surface = mirror(true);
        let hit = |front| Hit {
            t: 1.0,
            position: DVec3::ZERO,
            front,
        };
        assert!(surface.is_lit(&hit(true)) && surface.is_lit(&hit(false)));
        surface = mirror(false);
        assert!(surface.is_lit(&hit(true)) && !surface.is_lit(&hit(false)));
        surface.bsdf = Bsdf::Diffuse {
            reflectance: DVec3::ONE,
        };
        assert!(surface.is_lit(&hit(true)) && !surface.is_lit(&hit(false)));
    }
}
