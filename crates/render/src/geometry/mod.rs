//! What surfaces are made of, and where a ray meets it.

mod quad;
mod sphere;

use glam::DVec3;

pub use quad::Quad;
pub use sphere::Sphere;

use crate::camera::Ray;

/// Where a ray meets a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// Distance along the ray, in lengths of its direction.
    pub t: f64,
    /// The point, on the surface (scene units).
    pub position: DVec3,
    /// The unit normal of the front there.
    pub normal: DVec3,
    /// Whether the ray comes from the front.
    pub front: bool,
}

/// The form of a surface.
#[derive(Debug, Clone, PartialEq)]
pub enum Geometry {
    /// A parallelogram.
    Quad(Quad),
    /// A sphere, whose front is its outside.
    Sphere(Sphere),
}

impl Geometry {
    /// The area, in squared scene units.
    #[must_use]
    pub fn area(&self) -> f64 {
        match self {
            Self::Quad(quad) => quad.area(),
            Self::Sphere(sphere) => sphere.area(),
        }
    }

    /// The one normal of its front, if it is flat.
    #[must_use]
    pub fn flat_normal(&self) -> Option<DVec3> {
        match self {
            Self::Quad(quad) => Some(quad.normal()),
            Self::Sphere(_) => None,
        }
    }

    /// The smallest and the largest corner of the box around it (scene units).
    #[must_use]
    pub fn bounds(&self) -> [DVec3; 2] {
        match self {
            Self::Quad(quad) => {
                let [a, b, c, d] = quad.corners();
                [a.min(b).min(c).min(d), a.max(b).max(c).max(d)]
            }
            Self::Sphere(sphere) => sphere.bounds(),
        }
    }

    /// Where `ray` meets it first at a distance over `t_min` and below `t_max`.
    #[must_use]
    pub fn intersect(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Hit> {
        match self {
            Self::Quad(quad) => quad.intersect(ray, t_min, t_max),
            Self::Sphere(sphere) => sphere.intersect(ray, t_min, t_max),
        }
    }
}
