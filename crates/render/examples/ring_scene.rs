//! Writes `scenes/ring.json`, a ring of flat mirrors:
//! `cargo run -p photoncube-render --example ring_scene > crates/render/scenes/ring.json`. A test compares
//! the committed file with this program's output.

use std::f64::consts::TAU;
use std::fmt::Write;

use glam::DVec3;

/// Flat mirrors in the ring: each casts a beam 0.065 wide, fine enough for a smooth caustic.
const FACETS: usize = 96;
/// The height of the ring, in units of its radius.
const HEIGHT: f64 = 0.5;
/// Half the side of the square floor.
const FLOOR: f64 = 2.6;
/// The centre of the light, a square that faces the ring's middle.
const LIGHT: DVec3 = DVec3::new(-1.9, 2.5, 2.3);
const LIGHT_SIDE: f64 = 0.12;
/// The position of the camera, and the point that it looks at.
const EYE: DVec3 = DVec3::new(0.55, 4.3, 2.6);
const TARGET: DVec3 = DVec3::new(0.1, 0.0, 0.0);

#[allow(dead_code)] // the test that includes this file only wants `text`
fn main() {
    print!("{}", text());
}

/// The scene file.
pub fn text() -> String {
    format!(
        r#"{{
 "name": "ring",
 "generator": "cargo run -p photoncube-render --example ring_scene",
 "camera": {{
  "fov_deg": 34,
  "fov_axis": "smaller",
  "to_world": [
   {}
  ]
 }},
 "shapes": {{
  "floor": {{
   "kind": "quad",
   "vertices": [[-{FLOOR}, 0, {FLOOR}], [{FLOOR}, 0, {FLOOR}], [{FLOOR}, 0, -{FLOOR}], [-{FLOOR}, 0, -{FLOOR}]],
   "normal": [0, 1, 0],
   "bsdf": {{"type": "diffuse", "reflectance": {{"type": "rgb", "value": [0.75, 0.75, 0.75]}}}}
  }},
  "light": {{
   "kind": "quad",
   "vertices": [{}],
   "bsdf": {{"type": "diffuse", "reflectance": {{"type": "rgb", "value": [0, 0, 0]}}}},
   "emitter": {{"type": "area", "radiance": {{"type": "rgb", "value": [2000, 1500, 900]}}}}
  }},
  "ring": {{
   "kind": "quads",
   "vertices": [
    {}
   ],
   "quads_ccw_outward": [
    {}
   ],
   "bsdf": {{"type": "twosided", "bsdf": {{"type": "conductor", "material": "none",
    "specular_reflectance": {{"type": "rgb", "value": [0.95, 0.95, 0.95]}}}}}}
  }}
 }}
}}
"#,
        camera_rows(),
        list(&light_corners(), ", "),
        list(&ring_corners(), ",\n    "),
        faces(),
    )
}

/// A point with six decimals, so that the text is equal on all platforms, whose sines may differ in the last
/// place.
fn point(p: DVec3) -> String {
    // Adding 0 turns a negative zero into a positive one.
    let [x, y, z] = p.to_array().map(|c| (c * 1e6).round() / 1e6 + 0.0);
    format!("[{x}, {y}, {z}]")
}

fn list(points: &[DVec3], separator: &str) -> String {
    let points: Vec<_> = points.iter().map(|p| point(*p)).collect();
    points.join(separator)
}

/// The rows of the matrix whose columns are left, up, forward and the eye.
fn camera_rows() -> String {
    let forward = (TARGET - EYE).normalize();
    let left = DVec3::Y.cross(forward).normalize();
    let up = forward.cross(left);
    let mut rows = String::new();
    for axis in 0..3 {
        let row = [left, up, forward, EYE].map(|column| column[axis]);
        let [a, b, c, d] = row.map(|v| (v * 1e6).round() / 1e6 + 0.0);
        writeln!(rows, "[{a}, {b}, {c}, {d}],").expect("a string grows");
        rows.push_str("   ");
    }
    rows + "[0, 0, 0, 1]"
}

fn light_corners() -> [DVec3; 4] {
    let normal = -LIGHT.normalize();
    let right = normal.cross(DVec3::Y).normalize() * LIGHT_SIDE / 2.0;
    let up = right.cross(normal);
    [
        LIGHT - right - up,
        LIGHT - right + up,
        LIGHT + right + up,
        LIGHT + right - up,
    ]
}

/// The ring's corners, alternately one on the floor and the one above it.
fn ring_corners() -> Vec<DVec3> {
    let corner = |i: usize| {
        let (z, x) = (TAU * i as f64 / FACETS as f64).sin_cos();
        [DVec3::new(x, 0.0, z), DVec3::new(x, HEIGHT, z)]
    };
    (0..FACETS).flat_map(corner).collect()
}

/// The faces of the ring, with their fronts inwards.
fn faces() -> String {
    let face = |i: usize| {
        let (a, b) = (2 * i, 2 * ((i + 1) % FACETS));
        format!("[{a}, {b}, {}, {}]", b + 1, a + 1)
    };
    let faces: Vec<_> = (0..FACETS).map(face).collect();
    let rows: Vec<_> = faces.chunks(6).map(|row| row.join(", ")).collect();
    rows.join(",\n    ")
}
