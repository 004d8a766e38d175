//! Meshes: triangles with shared corners.

use glam::DVec3;
use thiserror::Error;

use super::Hit;
use crate::view::Ray;

/// A triangle with less area than this fraction of its squared size has no usable normal. The limit is far
/// below any intended triangle, and far above the rounding of three corners in a line.
const MIN_AREA: f64 = 1e-12;

/// The error of corners and indices that make no mesh.
#[derive(Debug, Error, PartialEq, Eq)]
#[error("{place}: found {found}, expected {expected}")]
pub struct MeshError {
    /// The vertex or triangle that is wrong, counted from 0.
    pub place: String,
    /// The value found there.
    pub found: String,
    /// The value that is legal there.
    pub expected: String,
}

/// A mesh of triangles. The front of a triangle is the side from which its corners run counter-clockwise. The
/// normal is that of the triangle's plane, everywhere.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    vertices: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    dropped: usize,
    area: f64,
}

impl Mesh {
    /// Makes the mesh of these triangles, each given by the indices of its corners. Triangles without an area
    /// are dropped; [`Self::dropped`] returns their number.
    ///
    /// # Errors
    /// For a vertex that is not finite, an index past the vertices, or no triangle with an area.
    pub fn new(vertices: Vec<DVec3>, mut triangles: Vec<[u32; 3]>) -> Result<Self, MeshError> {
        if let Some(index) = vertices.iter().position(|vertex| !vertex.is_finite()) {
            return Err(MeshError {
                place: format!("vertex {index}"),
                found: vertices[index].to_string(),
                expected: "finite numbers".to_owned(),
            });
        }
        for (index, corner) in triangles.iter().flatten().enumerate() {
            if *corner as usize >= vertices.len() {
                return Err(MeshError {
                    place: format!("triangle {}", index / 3),
                    found: format!("vertex {corner}"),
                    expected: format!("one of the {} vertices", vertices.len()),
                });
            }
        }
        let all = triangles.len();
        triangles.retain(|corners| area(corners.map(|i| vertices[i as usize])).is_some());
        let mut mesh = Self {
            vertices,
            dropped: all - triangles.len(),
            triangles,
            area: 0.0,
        };
        if mesh.triangles.is_empty() {
            return Err(MeshError {
                place: "triangles".to_owned(),
                found: format!("{all}, none with an area"),
                expected: "at least one with an area".to_owned(),
            });
        }
        let areas = (0..mesh.triangles.len()).filter_map(|index| area(mesh.corners(index)));
        mesh.area = areas.sum();
        Ok(mesh)
    }

    /// The number of triangles.
    #[must_use]
    pub fn triangles(&self) -> usize {
        self.triangles.len()
    }

    /// The number of triangles without an area that were dropped.
    #[must_use]
    pub fn dropped(&self) -> usize {
        self.dropped
    }

    /// The area of all triangles, in squared scene units.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.area
    }

    /// The corners of a triangle, counter-clockwise as seen from the front.
    #[must_use]
    pub fn corners(&self, triangle: usize) -> [DVec3; 3] {
        self.triangles[triangle].map(|index| self.vertices[index as usize])
    }

    /// Where `ray` meets a triangle at a distance over `t_min` and below `t_max`.
    ///
    /// Each edge is decided by the sign of the volume that it spans with the ray. Two triangles that share an
    /// edge compute the same volume with opposite signs, to the last bit, so no ray passes between them. The
    /// position is a weighted mean of the corners, so that it lies on the triangle however far away the ray
    /// starts.
    pub(super) fn meet(&self, triangle: usize, ray: &Ray, t_min: f64, t_max: f64) -> Option<Hit> {
        let corners = self.corners(triangle);
        let [a, b, c] = corners.map(|corner| corner - ray.origin);
        let volumes = [c.cross(b), a.cross(c), b.cross(a)].map(|n| ray.direction.dot(n));
        let all = |is: fn(&f64) -> bool| volumes.iter().all(is);
        // From the front the volumes are negative, because the ray comes against the normal.
        let front = all(|volume| *volume >= 0.0);
        if !front && !all(|volume| *volume <= 0.0) {
            return None;
        }
        let sum: f64 = volumes.iter().sum();
        let [u, v, w] = volumes.map(|volume| volume / sum);
        let position = u * corners[0] + v * corners[1] + w * corners[2];
        let t = (u * a + v * b + w * c).dot(ray.direction) / ray.direction.length_squared();
        // The NaN of a ray in the triangle's plane fails this comparison.
        if !(t > t_min && t < t_max) {
            return None;
        }
        let normal = normal(corners)?;
        Some(Hit {
            t,
            position,
            normal,
            front: normal.dot(ray.direction) < 0.0,
        })
    }
}

/// The area of a triangle; `None` where it has none, or where it overflows.
fn area([a, b, c]: [DVec3; 3]) -> Option<f64> {
    let twice = (b - a).cross(c - a).length();
    let size = a.distance(b) + b.distance(c);
    (twice.is_finite() && twice > MIN_AREA * size * size).then_some(0.5 * twice)
}

/// The unit normal of the front.
fn normal([a, b, c]: [DVec3; 3]) -> Option<DVec3> {
    (b - a).cross(c - a).try_normalize()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// A pyramid's four sides: its apex at (0, 0, 1), its corners at distance 1 of the axis.
    fn pyramid() -> Mesh {
        let vertices = vec![DVec3::Z, DVec3::X, DVec3::Y, DVec3::NEG_X, DVec3::NEG_Y];
        let triangles = vec![[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]];
        Mesh::new(vertices, triangles).unwrap()
    }

    fn nearest(mesh: &Mesh, ray: &Ray) -> Option<Hit> {
        let hits = (0..mesh.triangles()).filter_map(|i| mesh.meet(i, ray, 0.0, f64::INFINITY));
        hits.min_by(|a, b| a.t.total_cmp(&b.t))
    }

    #[test]
    fn corners_counter_clockwise_make_the_front() {
        let mesh = pyramid();
        let down = |from| Ray {
            origin: from,
            direction: DVec3::NEG_Z,
        };
        let hit = nearest(&mesh, &down(DVec3::new(0.2, 0.2, 3.0))).unwrap();
        assert!(hit.front && hit.normal.z > 0.0);
        assert!(hit.position.distance(DVec3::new(0.2, 0.2, 0.6)) < 1e-15);
        let hit = nearest(&mesh, &down(DVec3::new(0.2, 0.2, -3.0)));
        assert_eq!(hit, None, "what is behind is not met");
        // Four sides of sqrt(3) / 2.
        assert!((mesh.area() - 2.0 * 3.0_f64.sqrt()).abs() < 1e-14);
    }

    #[test]
    fn triangles_without_area_are_dropped_and_counted() {
        let vertices = vec![DVec3::ZERO, DVec3::X, DVec3::Y, 0.3 * DVec3::X];
        let flat = vec![[0, 1, 2], [0, 3, 1], [1, 1, 2]];
        let mesh = Mesh::new(vertices.clone(), flat).unwrap();
        assert_eq!((mesh.triangles(), mesh.dropped()), (1, 2));
        let error = |triangles| {
            Mesh::new(vertices.clone(), triangles)
                .unwrap_err()
                .to_string()
        };
        let expected = "triangles: found 1, none with an area, expected at least one with an area";
        assert_eq!(error(vec![[0, 3, 1]]), expected);
        let expected = "triangle 1: found vertex 4, expected one of the 4 vertices";
        assert_eq!(error(vec![[0, 1, 2], [0, 1, 4]]), expected);
        let error = Mesh::new(vec![DVec3::ZERO, DVec3::NAN], vec![]).unwrap_err();
        assert!(error.to_string().starts_with("vertex 1: found"), "{error}");
    }

    proptest! {
        /// Rays at the edges and corners that triangles share meet one of the triangles, from either side.
        #[test]
        fn nothing_passes_between_triangles(
            edge in 0..4_usize, along in 0.0..=1.0f64,
            // The rays start where every edge has the fronts of both its triangles, or both backs.
            from in prop::array::uniform2(-0.45..0.45f64), below in prop::bool::ANY,
        ) {
            let mesh = pyramid();
            let [apex, corner, _] = mesh.corners(edge);
            // The target is not at the rim, past which there is no triangle.
            let target = apex.lerp(corner, 0.999 * along);
            let origin = DVec3::new(from[0], from[1], if below { -2.0 } else { 2.0 });
            let ray = Ray { origin, direction: (target - origin).normalize() };
            let hit = nearest(&mesh, &ray).expect("aimed at an edge");
            prop_assert_eq!(hit.front, !below);
            // 1e-12: a few roundings.
            prop_assert!(hit.position.distance(target) < 1e-12);
        }

        /// A ray aimed at a point of a triangle meets that point.
        #[test]
        fn aimed_rays_hit(u in 0.01..0.98f64, v in 0.0..1.0f64, from in prop::array::uniform3(1.0..3.0f64)) {
            let mesh = pyramid();
            let [a, b, c] = mesh.corners(0);
            let v = 0.01 + v * (0.98 - u);
            let target = a + u * (b - a) + v * (c - a);
            let origin = DVec3::from(from);
            let ray = Ray { origin, direction: (target - origin).normalize() };
            let hit = nearest(&mesh, &ray).expect("aimed at it");
            prop_assert!(hit.front && hit.position.distance(target) < 1e-12);
            prop_assert!((hit.t - origin.distance(target)).abs() < 1e-12);
        }
    }
}
