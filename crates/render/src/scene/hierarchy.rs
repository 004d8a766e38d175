//! Finds the parts of a scene that a ray may meet, with a bounding volume hierarchy over all parts.
//!
//! The crate `bvh` builds the hierarchy and tests its boxes, all in f64. The traversal is our own. The
//! crate's iterators have room for 32 levels, which a mesh with one far larger triangle may exceed, and they
//! do not use the hits found so far.

use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::{BHShape, BoundingHierarchy};
use bvh::bvh::{Bvh, BvhNode};
use glam::DVec3;
use nalgebra::{Point3, Vector3};

use super::Surface;
use crate::geometry::Hit;
use crate::view::Ray;

/// The margin of a box around its part, as a fraction of the longest path of a ray. A ray's distance to a
/// box's side is off by a few roundings of that path (2^-53, 1e-16 of it), a thousandth of the margin.
const MARGIN: f64 = 1e-12;

/// The limit of boxes, so that no product of three sides overflows. Light never gets that far.
const FAR: f64 = 1e90;

/// The hierarchy of the boxes of all parts of all surfaces.
#[derive(Debug, Clone)]
pub(super) struct Hierarchy {
    tree: Bvh<f64, 3>,
    /// The parts, which the leaves of the tree refer to.
    parts: Vec<Part>,
}

/// A part of a surface to test a ray against. The order of parts decides among hits at one distance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Part {
    surface: u32,
    part: u32,
}

/// A part with its box, for the builder.
struct Boxed {
    bounds: Aabb<f64, 3>,
    node: usize,
}

impl Bounded<f64, 3> for Boxed {
    fn aabb(&self) -> Aabb<f64, 3> {
        self.bounds
    }
}

impl BHShape<f64, 3> for Boxed {
    fn set_bh_node_index(&mut self, index: usize) {
        self.node = index;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

impl Hierarchy {
    /// Builds the hierarchy of `surfaces`, for rays that start at one of them or at `camera`.
    pub fn new(surfaces: &[Surface], camera: DVec3) -> Self {
        let parts: Vec<_> = (0_u32..)
            .zip(surfaces)
            .flat_map(|(surface, s)| {
                (0..s.geometry.parts()).map(move |part| Part {
                    surface,
                    part: part as u32,
                })
            })
            .collect();
        let bounds = |part: &Part| {
            let geometry = &surfaces[part.surface as usize].geometry;
            geometry.part_bounds(part.part as usize)
        };
        let margin = margin(parts.iter().map(bounds), camera);
        let boxed = |part| {
            // The boxes are on a grid of that margin. Otherwise a mesh of ever smaller triangles would make a
            // tree as deep as the exponents of the numbers.
            let [low, high] = bounds(part).map(|corner| corner / margin);
            let [low, high] = [low.floor() - 1.0, high.ceil() + 1.0].map(|corner| margin * corner);
            Boxed {
                bounds: Aabb::with_bounds(point(low), point(high)),
                node: 0,
            }
        };
        let mut boxes: Vec<_> = parts.iter().map(boxed).collect();
        Self {
            tree: Bvh::build_par(&mut boxes),
            parts,
        }
    }

    /// The nearest hit over `t_min` and its surface's index. Of several hits at one distance it is that of
    /// the first surface, and of its first part. The result equals a test of all parts, one by one, to the
    /// last bit.
    pub fn nearest(&self, surfaces: &[Surface], ray: &Ray, t_min: f64) -> Option<(usize, Hit)> {
        let direction = Vector3::from(ray.direction.to_array());
        let mut cast = Cast {
            hierarchy: self,
            surfaces,
            ray,
            slabs: bvh::ray::Ray {
                origin: Point3::from(ray.origin.to_array()),
                direction,
                inv_direction: direction.map(f64::recip),
            },
            t_min,
            nearest: None,
        };
        cast.visit(0);
        cast.nearest.map(|(part, hit)| (part.surface as usize, hit))
    }
}

/// The margin of [`MARGIN`] in scene units. A scene may be far from the origin, where its own coordinates are
/// rounded.
fn margin(bounds: impl Iterator<Item = [DVec3; 2]>, camera: DVec3) -> f64 {
    let [low, high] = bounds.fold([camera; 2], |[low, high], part| {
        [low.min(part[0]), high.max(part[1])]
    });
    let way = low.distance(high) + low.abs().max(high.abs()).max_element();
    MARGIN * way.clamp(1.0 / FAR, FAR)
}

fn point(p: DVec3) -> Point3<f64> {
    Point3::from(p.clamp(DVec3::splat(-FAR), DVec3::splat(FAR)).to_array())
}

/// A ray during its traversal of the boxes.
struct Cast<'a> {
    hierarchy: &'a Hierarchy,
    surfaces: &'a [Surface],
    ray: &'a Ray,
    /// The ray in the form that the box tests need.
    slabs: bvh::ray::Ray<f64, 3>,
    t_min: f64,
    nearest: Option<(Part, Hit)>,
}

impl Cast<'_> {
    /// The largest distance at which a hit still counts.
    fn limit(&self) -> f64 {
        self.nearest.map_or(f64::INFINITY, |(_, hit)| hit.t)
    }

    /// Visits the boxes of a node, the nearer box first. Each box takes a sixth of its node's room or half of
    /// its parts, and boxes are on a grid, so the recursion has at most some 200 levels.
    fn visit(&mut self, node: usize) {
        match &self.hierarchy.tree.nodes[node] {
            BvhNode::Leaf { shape_index, .. } => self.meet(self.hierarchy.parts[*shape_index]),
            BvhNode::Node {
                child_l_index,
                child_l_aabb,
                child_r_index,
                child_r_aabb,
                ..
            } => {
                let left = (self.entry(child_l_aabb), *child_l_index);
                let right = (self.entry(child_r_aabb), *child_r_index);
                let (first, second) = if right.0 < left.0 {
                    (right, left)
                } else {
                    (left, right)
                };
                for (entry, child) in [first, second] {
                    // Equal distances are visited too, because of hits at one distance that of the first part
                    // counts.
                    if entry.is_finite() && entry <= self.limit() {
                        self.visit(child);
                    }
                }
            }
        }
    }

    /// The distance at which the ray enters a box; infinite where it misses.
    fn entry(&self, bounds: &Aabb<f64, 3>) -> f64 {
        let slice = self.slabs.intersection_slice_for_aabb(bounds);
        slice.map_or(f64::INFINITY, |(entry, _)| entry)
    }

    fn meet(&mut self, part: Part) {
        let geometry = &self.surfaces[part.surface as usize].geometry;
        let t_max = self.limit().next_up();
        let Some(hit) = geometry.meet_part(part.part as usize, self.ray, self.t_min, t_max) else {
            return;
        };
        let nearer = |(other, found): &(Part, Hit)| hit.t < found.t || part < *other;
        if self.nearest.as_ref().is_none_or(nearer) {
            self.nearest = Some((part, hit));
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::geometry::{Geometry, Mesh, Quad, Sphere};
    use crate::scene::Bsdf;

    /// Tests every part, one after another: the definition.
    fn one_by_one(surfaces: &[Surface], ray: &Ray, t_min: f64) -> Option<(usize, Hit)> {
        let mut nearest: Option<(usize, Hit)> = None;
        for (index, surface) in surfaces.iter().enumerate() {
            let t_max = nearest.map_or(f64::INFINITY, |(_, hit)| hit.t);
            if let Some(hit) = surface.geometry.intersect(ray, t_min, t_max) {
                nearest = Some((index, hit));
            }
        }
        nearest
    }

    /// Multiples of a quarter, which make hits at equal distances, rays in planes and rays along the sides of
    /// boxes.
    fn coordinate() -> impl Strategy<Value = f64> {
        prop_oneof![-2.0..2.0f64, (-8..=8_i32).prop_map(|i| f64::from(i) / 4.0)]
    }

    fn position() -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(coordinate()).prop_map(DVec3::from)
    }

    fn geometry() -> impl Strategy<Value = Geometry> {
        let quad = (position(), position(), position()).prop_filter_map("no area", |(a, u, v)| {
            Quad::from_corners([a, a + u, a + u + v, a + v]).map(Geometry::Quad)
        });
        let sphere = (position(), 0.01..1.0f64)
            .prop_map(|(centre, radius)| Geometry::Sphere(Sphere::new(centre, radius).unwrap()));
        let corners = prop::collection::vec(position(), 3..12);
        let triangles = prop::collection::vec(prop::array::uniform3(0..12_u32), 1..40);
        let mesh = (corners, triangles).prop_filter_map("no area", |(corners, triangles)| {
            let count = corners.len() as u32;
            let inside = triangles.iter().map(|t| t.map(|index| index % count));
            Mesh::new(corners, inside.collect())
                .ok()
                .map(Geometry::Mesh)
        });
        prop_oneof![quad, sphere, mesh]
    }

    fn surface(geometry: Geometry) -> Surface {
        Surface {
            shape: "any".to_owned(),
            geometry,
            bsdf: Bsdf::Diffuse {
                reflectance: DVec3::ONE,
            },
            radiance: DVec3::ZERO,
        }
    }

    proptest! {
        /// Requires the surface and the bits of the one-by-one test, also from far away and along axes.
        #[test]
        fn hits_are_those_of_trying_all(
            shapes in prop::collection::vec(geometry(), 1..12),
            rays in prop::collection::vec((position(), position(), prop_oneof![Just(1.0), Just(1e3)]), 20),
            moved in prop_oneof![Just(0.0), Just(1e4)],
        ) {
            let surfaces: Vec<_> = shapes.into_iter().map(surface).collect();
            let camera = DVec3::splat(moved - 2e3);
            let hierarchy = Hierarchy::new(&surfaces, camera);
            for (origin, target, away) in rays {
                let Some(direction) = (target - origin).try_normalize() else { continue };
                let ray = Ray { origin: origin - (away - 1.0) * direction, direction };
                for t_min in [0.0, 1e-6] {
                    prop_assert_eq!(
                        hierarchy.nearest(&surfaces, &ray, t_min),
                        one_by_one(&surfaces, &ray, t_min)
                    );
                }
            }
        }
    }

    /// Every triangle is somewhat larger than the one before, over as many exponents as areas have: the
    /// deepest possible tree, built and traversed on a thread's stack.
    #[test]
    fn lopsided_meshes_are_walked() {
        let count = 1500;
        let size = |i: u32| 1.25_f64.powi(i as i32 - 750);
        let corners = |i| [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| size(i) * axis);
        let triangles = (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
        let vertices = (0..count).flat_map(corners).collect();
        let mesh = Mesh::new(vertices, triangles.collect()).unwrap();
        assert_eq!(mesh.dropped(), 0);
        let surfaces = [surface(Geometry::Mesh(mesh))];
        let hierarchy = Hierarchy::new(&surfaces, DVec3::ZERO);
        for i in (0..count).step_by(100) {
            let ray = Ray {
                origin: DVec3::splat(0.5 * size(i)),
                direction: DVec3::NEG_ONE.normalize(),
            };
            let hit = hierarchy.nearest(&surfaces, &ray, 0.0);
            assert_eq!(hit, one_by_one(&surfaces, &ray, 0.0));
            assert!(hit.is_some());
        }
    }

    /// Numbers whose squares overflow neither hang nor panic.
    #[test]
    fn huge_things_are_boxed() {
        let sphere = |radius| {
            let centre = DVec3::new(radius, 0.0, 0.0);
            surface(Geometry::Sphere(Sphere::new(centre, radius).unwrap()))
        };
        let surfaces: Vec<_> = [1.0, 1e100, 1e200, 1e308].map(sphere).into();
        let hierarchy = Hierarchy::new(&surfaces, DVec3::ZERO);
        let ray = Ray {
            origin: DVec3::NEG_X,
            direction: DVec3::X,
        };
        assert!(hierarchy.nearest(&surfaces, &ray, 0.0).is_some());
    }
}
