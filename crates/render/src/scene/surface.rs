//! Surfaces and their interaction with light.

use glam::DVec3;
use rand::RngExt;
use rand_pcg::Pcg64Mcg;

use super::fresnel::Border;
use crate::geometry::{Geometry, Hit};
use crate::trace::Facing;
use crate::trace::sample::cosine_direction;
use crate::view::Ray;

/// The scattering of light by a surface. Light that is not reflected is absorbed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bsdf {
    /// Equal radiance in all directions, from the front; the back is black.
    Diffuse {
        /// The reflectance of red, green, blue, each from 0 to 1.
        reflectance: DVec3,
    },
    /// A perfect mirror. It holds no photons, and view rays follow it.
    Mirror {
        /// The reflectance of red, green, blue, each from 0 to 1, at every angle.
        reflectance: DVec3,
        /// Whether its back is a mirror too, as of a thin sheet of metal; otherwise the back is black.
        two_sided: bool,
    },
    /// The smooth border of a clear medium behind the surface. Light that is not reflected continues,
    /// refracted. It holds no photons, and view rays follow it.
    Dielectric {
        /// The index of refraction behind the surface, over that before it; over 0.
        ratio: f64,
    },
}

/// A surface of the scene. Only the front of a quad emits.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    /// The name of the shape that the surface belongs to. A box is six surfaces of one name.
    pub shape: String,
    /// The form and place of the surface.
    pub geometry: Geometry,
    /// The scattering of light that arrives.
    pub bsdf: Bsdf,
    /// The emitted radiance of red, green, blue; zero for surfaces that are not lights, such as all but
    /// diffuse quads.
    pub radiance: DVec3,
}

impl Surface {
    /// The fraction of red, green and blue light that the surface does not absorb.
    #[must_use]
    pub fn reflectance(&self) -> DVec3 {
        match self.bsdf {
            Bsdf::Diffuse { reflectance } | Bsdf::Mirror { reflectance, .. } => reflectance,
            Bsdf::Dielectric { .. } => DVec3::ONE,
        }
    }

    /// Whether light of one direction leaves the surface in only one or two directions, so that it stores no
    /// photons.
    #[must_use]
    pub fn is_specular(&self) -> bool {
        !matches!(self.bsdf, Bsdf::Diffuse { .. })
    }

    /// The facing of the front at a hit, which a photon stores.
    pub(crate) fn facing(&self, hit: &Hit) -> Facing {
        match self.geometry.flat_normal() {
            Some(_) => Facing::FLAT,
            None => Facing::of(hit.normal),
        }
    }

    /// The unit normal by which photons of that facing are selected for a query.
    #[must_use]
    pub fn facing_normal(&self, facing: Facing) -> DVec3 {
        let flat = self.geometry.flat_normal();
        flat.unwrap_or_else(|| facing.normal())
    }

    /// Whether the side that was hit does anything but absorb light.
    pub(crate) fn is_lit(&self, hit: &Hit) -> bool {
        match self.bsdf {
            Bsdf::Diffuse { .. } => hit.front,
            Bsdf::Mirror { two_sided, .. } => hit.front || two_sided,
            Bsdf::Dielectric { .. } => true,
        }
    }

    /// The ray by which light that arrived by `ray` leaves. For a diffuse surface it is random with density
    /// cos / pi, for a mirror that of the law of reflection. At the border of a medium it is one of both ways
    /// by chance, with the shares of Fresnel's equations.
    pub(crate) fn scatter(&self, ray: &Ray, hit: &Hit, rng: &mut Pcg64Mcg) -> Scattered {
        match self.bsdf {
            Bsdf::Diffuse { .. } => Scattered::from(hit, cosine_direction(hit.normal, rng)),
            // d - 2 (d . n) n, which is independent of the side.
            Bsdf::Mirror { .. } => Scattered::from(hit, ray.direction.reflect(hit.normal)),
            Bsdf::Dielectric { ratio } => {
                let ways = Ways::of(ray, hit, ratio);
                let goes_on = rng.random::<f64>() >= ways.share;
                let refracted = ways.refracted.filter(|_| goes_on);
                refracted.unwrap_or(ways.reflected)
            }
        }
    }

    /// Both ways of light at the border of a medium; `None` elsewhere, and with total reflection.
    pub(crate) fn both_ways(&self, ray: &Ray, hit: &Hit) -> Option<[(f64, Scattered); 2]> {
        let Bsdf::Dielectric { ratio } = self.bsdf else {
            return None;
        };
        let ways = Ways::of(ray, hit, ratio);
        let refracted = (1.0 - ways.share, ways.refracted?);
        Some([(ways.share, ways.reflected), refracted])
    }
}

/// The ways of light at the border of a medium.
struct Ways {
    /// The share of the light that is reflected, from 0 to 1.
    share: f64,
    reflected: Scattered,
    /// `None` with total reflection.
    refracted: Option<Scattered>,
}

impl Ways {
    /// `ratio` is the index of refraction behind the surface, over that before it.
    fn of(ray: &Ray, hit: &Hit, ratio: f64) -> Self {
        let (normal, ratio) = match hit.front {
            true => (hit.normal, ratio),
            false => (-hit.normal, 1.0 / ratio),
        };
        let border = Border::new(ray.direction, normal, ratio);
        let refracted = border.refracted.map(|direction| Scattered {
            radiance: 1.0 / (ratio * ratio),
            ..Scattered::from(hit, direction)
        });
        Self {
            share: border.reflected,
            reflected: Scattered::from(hit, ray.direction.reflect(normal)),
            refracted,
        }
    }
}

/// The result of scattering light at a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Scattered {
    /// The ray of the scattered light.
    pub ray: Ray,
    /// For a view ray along this way, the factor from the radiance at its end to the radiance here. In a
    /// medium of index n a bundle of rays is n^2 times as narrow, so that L / n^2 is constant. The flux of
    /// photons has no such factor.
    pub radiance: f64,
}

impl Scattered {
    fn from(hit: &Hit, direction: DVec3) -> Self {
        Self {
            ray: Ray {
                origin: hit.position,
                direction,
            },
            radiance: 1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::geometry::Quad;
    use crate::trace::sample::{Purpose, stream};

    fn mirror(two_sided: bool) -> Surface {
        let [a, u, v] = [
            DVec3::new(1.0, 2.0, 3.0),
            DVec3::X,
            DVec3::new(0.0, 1.0, 1.5),
        ];
        Surface {
            shape: "mirror".to_owned(),
            geometry: Geometry::Quad(Quad::from_corners([a, a + u, a + u + v, a + v]).unwrap()),
            bsdf: Bsdf::Mirror {
                reflectance: DVec3::ONE,
                two_sided,
            },
            radiance: DVec3::ZERO,
        }
    }

    proptest! {
        /// The angles with the normal are equal, both rays lie in a plane with it, and the length of the
        /// direction is unchanged, on either side.
        #[test]
        fn mirrors_obey_the_law_of_reflection(x in -1.0..1.0f64, y in 0.1..1.0f64, back in prop::bool::ANY) {
            let mirror = mirror(true);
            let Geometry::Quad(quad) = &mirror.geometry else { unreachable!("made of one") };
            let n = quad.normal();
            let side = if back { -n } else { n };
            let tangent = quad.corners()[1] - quad.corners()[0];
            let direction = (x * tangent - y * side).normalize();
            let target = quad.point(0.4, 0.6);
            let ray = Ray { origin: target - direction, direction };
            let hit = quad.intersect(&ray, 0.0, f64::INFINITY).expect("aimed at it");
            let out = mirror.scatter(&ray, &hit, &mut stream(1, Purpose::Path, 0)).ray;
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
            normal: DVec3::Y,
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
