//! Computes direct light by shadow rays.

use glam::DVec3;

use crate::geometry::Quad;
use crate::scene::{Scene, emitters};
use crate::trace::sample::Apart;
use crate::view::{QueryPoint, Ray};

/// The lights of a scene as targets of shadow rays. Every light gets its own rays, so that a weak one is not
/// lost beside one a million times as strong.
pub(super) struct Shadows<'a> {
    scene: &'a Scene,
    lights: Vec<Light<'a>>,
}

struct Light<'a> {
    surface: usize,
    quad: &'a Quad,
    radiance: DVec3,
}

impl<'a> Shadows<'a> {
    pub fn of(scene: &'a Scene) -> Self {
        let lights = emitters(scene).map(|(surface, light, quad)| Light {
            surface,
            quad,
            radiance: light.radiance,
        });
        Self {
            scene,
            lights: lights.collect(),
        }
    }

    /// The irradiance at the query point that comes straight from the lights: the mean, over `rays` points on
    /// each light, of L A cos cos' / d^2, which is 0 where something is between. The estimate has no bias.
    pub fn irradiance(&self, query: &QueryPoint, rays: u32, points: &mut Apart) -> DVec3 {
        let lights = self.lights.iter();
        let sum = lights.map(|light| {
            let rays = (0..rays).map(|_| {
                let [u, v] = points.next();
                let target = light.quad.point(u, v);
                self.form_factor(query, light, target)
            });
            light.radiance * rays.sum::<f64>()
        });
        sum.sum::<DVec3>() / f64::from(rays)
    }

    /// A cos cos' / d^2 for a light and its point `target`.
    fn form_factor(&self, query: &QueryPoint, light: &Light<'_>, target: DVec3) -> f64 {
        let way = target - query.position;
        let distance_sq = way.length_squared();
        let direction = way / distance_sq.sqrt();
        let cosines =
            query.normal.dot(direction).max(0.0) * -light.quad.normal().dot(direction).min(0.0);
        // The comparison is also false where the query point is on the light, which makes a NaN.
        if cosines > 0.0 && self.sees(query.position, direction, light) {
            cosines * light.quad.area() / distance_sq
        } else {
            0.0
        }
    }

    /// Whether nothing is in front of the light. Glass casts a shadow, because light through glass is a
    /// caustic.
    fn sees(&self, origin: DVec3, direction: DVec3, light: &Light<'_>) -> bool {
        let hit = self.scene.intersect(&Ray { origin, direction });
        hit.is_some_and(|(index, hit)| index == light.surface && hit.front)
    }
}
