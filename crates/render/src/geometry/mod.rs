//! The forms of surfaces, and the points where a ray meets them.

mod mesh;
mod morton;
mod quad;
mod sphere;

use glam::DVec3;

pub use mesh::{Mesh, MeshError};
pub(crate) use morton::morton;
pub use quad::Quad;
pub use sphere::Sphere;

use crate::view::Ray;

/// The point where a ray meets a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// Distance along the ray, in lengths of its direction.
    pub t: f64,
    /// The point on the surface, in scene units.
    pub position: DVec3,
    /// The unit normal of the front at the point.
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
    /// A mesh of triangles.
    Mesh(Mesh),
}

impl Geometry {
    /// The area, in squared scene units.
    #[must_use]
    pub fn area(&self) -> f64 {
        match self {
            Self::Quad(quad) => quad.area(),
            Self::Sphere(sphere) => sphere.area(),
            Self::Mesh(mesh) => mesh.area(),
        }
    }

    /// The normal of the front; `None` where the surface is not flat.
    #[must_use]
    pub fn flat_normal(&self) -> Option<DVec3> {
        match self {
            Self::Quad(quad) => Some(quad.normal()),
            Self::Sphere(_) | Self::Mesh(_) => None,
        }
    }

    /// The smallest and the largest corner of the bounding box, in scene units.
    #[must_use]
    pub fn bounds(&self) -> [DVec3; 2] {
        let parts = (0..self.parts()).map(|part| self.part_bounds(part));
        parts.fold(
            [DVec3::INFINITY, DVec3::NEG_INFINITY],
            |[low, high], part| [low.min(part[0]), high.max(part[1])],
        )
    }

    /// The number of parts that rays are tested against: the triangles of a mesh, else one.
    pub(crate) fn parts(&self) -> usize {
        match self {
            Self::Quad(_) | Self::Sphere(_) => 1,
            Self::Mesh(mesh) => mesh.triangles(),
        }
    }

    /// The smallest and the largest corner of the bounding box of one part, in scene units.
    pub(crate) fn part_bounds(&self, part: usize) -> [DVec3; 2] {
        match self {
            Self::Quad(quad) => around(&quad.corners()),
            Self::Sphere(sphere) => sphere.bounds(),
            Self::Mesh(mesh) => around(&mesh.corners(part)),
        }
    }

    /// The first point where `ray` meets a part at a distance over `t_min` and below `t_max`.
    pub(crate) fn meet_part(&self, part: usize, ray: &Ray, t_min: f64, t_max: f64) -> Option<Hit> {
        match self {
            Self::Quad(quad) => quad.intersect(ray, t_min, t_max),
            Self::Sphere(sphere) => sphere.intersect(ray, t_min, t_max),
            Self::Mesh(mesh) => mesh.meet(part, ray, t_min, t_max),
        }
    }

    /// The first point where `ray` meets the surface at a distance over `t_min` and below `t_max`. Tries
    /// every triangle of a mesh.
    #[must_use]
    pub fn intersect(&self, ray: &Ray, t_min: f64, t_max: f64) -> Option<Hit> {
        let mut nearest: Option<Hit> = None;
        for part in 0..self.parts() {
            let t_max = nearest.map_or(t_max, |hit| hit.t);
            nearest = self.meet_part(part, ray, t_min, t_max).or(nearest);
        }
        nearest
    }
}

/// The smallest and the largest corner of the bounding box of some points.
fn around(points: &[DVec3]) -> [DVec3; 2] {
    let start = [points[0]; 2];
    let rest = &points[1..];
    rest.iter()
        .fold(start, |[low, high], p| [low.min(*p), high.max(*p)])
}
