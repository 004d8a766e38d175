//! The scene's area lights: the choice of the light that emits the next photon, and the targets of shadow
//! rays.

use glam::DVec3;
use rand::RngExt;
use rand_pcg::Pcg64Mcg;

use super::{LightChoice, Scene, Surface};
use crate::geometry::{Geometry, Quad};

/// The lights, for a random choice in proportion to their weights.
pub(crate) struct Lights<'a> {
    /// For each light: the surface, its form, and the sum of the weights up to it.
    cumulative: Vec<(&'a Surface, &'a Quad, f64)>,
    total: f64,
    choice: LightChoice,
}

/// The surfaces that emit, each with its index in the scene and its form. Only quads emit.
pub(crate) fn emitters(scene: &Scene) -> impl Iterator<Item = (usize, &Surface, &Quad)> {
    let surfaces = scene.surfaces().iter().enumerate();
    surfaces.filter_map(|(index, surface)| match &surface.geometry {
        Geometry::Quad(quad) if flux(surface).element_sum() > 0.0 => Some((index, surface, quad)),
        _ => None,
    })
}

/// The weight of a light in the choice: its flux with all channels added, or 1 for every light.
fn weight(light: &Surface, choice: LightChoice) -> f64 {
    match choice {
        LightChoice::Flux => flux(light).element_sum(),
        LightChoice::Uniform => 1.0,
    }
}

impl<'a> Lights<'a> {
    /// The lights of a scene.
    pub fn of(scene: &'a Scene) -> Self {
        let mut total = 0.0;
        let mut cumulative = Vec::new();
        let choice = scene.light_choice();
        for (_, surface, quad) in emitters(scene) {
            total += weight(surface, choice);
            cumulative.push((surface, quad, total));
        }
        Self {
            cumulative,
            total,
            choice,
        }
    }

    /// A randomly chosen light, and the power of a path from it: its flux over the probability of the choice.
    pub fn choose(&self, rng: &mut Pcg64Mcg) -> (&'a Quad, DVec3) {
        let wanted = rng.random::<f64>() * self.total;
        let index = self.cumulative.partition_point(|(.., sum)| *sum <= wanted);
        let (light, quad, _) = self.cumulative[index.min(self.cumulative.len() - 1)];
        let power = flux(light) * (self.total / weight(light, self.choice));
        (quad, power)
    }
}

/// The flux of a light, Phi = pi A L.
fn flux(light: &Surface) -> DVec3 {
    std::f64::consts::PI * light.geometry.area() * light.radiance
}
