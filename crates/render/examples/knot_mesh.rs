//! Writes `docs/scenes/knot.obj`, a tube along a trefoil knot:
//! `cargo run -p photoncube-render --example knot_mesh > docs/scenes/knot.obj`.
//! Two numbers after `--` set other numbers of steps: along the knot, and around the tube. Each pair of steps
//! is two triangles. A test compares the committed file with this program's output.

use std::f64::consts::TAU;
use std::fmt::Write;

use glam::DVec3;

/// The steps along the knot in the committed file.
pub const ALONG: usize = 60;
/// The steps around the tube in the committed file.
pub const AROUND: usize = 8;
/// The knot winds around a torus of this radius, all in a cube of about -1 to 1.
const TORUS: f64 = 0.58;
/// The torus's tube, on which the knot lies.
const WINDING: f64 = 0.27;
/// The knot's own tube.
const TUBE: f64 = 0.13;

#[allow(dead_code)] // the tests that include this file only want `text`
fn main() {
    let steps: Vec<usize> = std::env::args().skip(1).flat_map(|s| s.parse()).collect();
    match steps[..] {
        [along, around] if along >= 3 && around >= 3 => print!("{}", text(along, around)),
        _ => print!("{}", text(ALONG, AROUND)),
    }
}

/// The OBJ file.
pub fn text(along: usize, around: usize) -> String {
    let mut text = "# cargo run -p photoncube-render --example knot_mesh\no knot\n".to_owned();
    for i in 0..along * around {
        let p = vertex(fraction(i / around, along), fraction(i % around, around));
        writeln!(text, "v {:.6} {:.6} {:.6}", p.x, p.y, p.z).expect("text grows");
    }
    for (i, j) in (0..along).flat_map(|i| (0..around).map(move |j| (i, j))) {
        let index = |i: usize, j: usize| 1 + i % along * around + j % around;
        let [a, b] = [index(i, j), index(i + 1, j)];
        let [c, d] = [index(i + 1, j + 1), index(i, j + 1)];
        writeln!(text, "f {a} {d} {c} {b}").expect("text grows");
    }
    text
}

fn fraction(step: usize, steps: usize) -> f64 {
    TAU * step as f64 / steps as f64
}

/// The point of the tube at the angle `t` of the knot and `s` of the tube.
fn vertex(t: f64, s: f64) -> DVec3 {
    // The direction outwards on the torus is perpendicular to the knot, because the knot lies on the torus.
    let (ahead, out) = (knot(t + 1e-6) - knot(t - 1e-6), outwards(t));
    let side = ahead.normalize().cross(out);
    knot(t) + TUBE * (s.cos() * out + s.sin() * side)
}

/// The knot's curve: twice around the torus while three times around the torus's tube.
fn knot(t: f64) -> DVec3 {
    let (sin, cos) = (2.0 * t).sin_cos();
    TORUS * DVec3::new(cos, sin, 0.0) + WINDING * outwards(t)
}

fn outwards(t: f64) -> DVec3 {
    let (sin, cos) = (2.0 * t).sin_cos();
    let (up, out) = (3.0 * t).sin_cos();
    DVec3::new(out * cos, out * sin, up)
}
