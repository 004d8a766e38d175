//! Finds what estimates get wrong on diffuse balls.

use super::{Area, DirectLight, Lighting};
use crate::geometry::Geometry;
use crate::scene::Scene;

/// The search radius, over a ball's own, from which a leak is worth telling: light then reaches 6 degrees round the dark side, which
/// is a fifth too bright where no other light arrives.
const LEAKS: f64 = 0.1;

/// The search radius, over a ball's own, from which the rule of [`crate::PhotonMap`] may leave out photons in range.
const CUT: f64 = 0.75;

/// The error of the estimates on a diffuse ball.
#[derive(Debug, Clone, PartialEq)]
pub struct BallError {
    /// The name of the shape.
    pub shape: String,
    /// The search radius over the ball's own.
    pub radius: f64,
    /// The angle, in degrees, by which direct light reaches round the ball's dark side; `None` where it comes from shadow rays, or
    /// hardly any does.
    pub leak: Option<f64>,
    /// The part of its light that the ball shows, since the sum over a part of the ball is divided by the whole disc. `None` where it is
    /// divided by the part.
    pub too_dark: Option<f64>,
}

/// The errors on the diffuse balls of a scene, for a search radius in scene units. Balls without an error are left out.
#[must_use]
pub fn ball_errors(scene: &Scene, lighting: &Lighting, radius: f64) -> Vec<BallError> {
    let diffuse = scene.surfaces().iter().filter(|s| !s.is_specular());
    let balls = diffuse.filter_map(|surface| match &surface.geometry {
        Geometry::Sphere(sphere) => Some((surface, radius / sphere.radius())),
        _ => None,
    });
    let errors = balls.map(|(surface, ratio)| BallError {
        shape: surface.shape.clone(),
        radius: ratio,
        leak: (lighting.direct == DirectLight::Map && ratio >= LEAKS)
            .then(|| ratio.min(1.0).asin().to_degrees()),
        too_dark: (lighting.area == Area::Disc && ratio > CUT)
            .then(|| disc_over_cap(ratio).recip()),
    });
    errors
        .filter(|error| error.leak.is_some() || error.too_dark.is_some())
        .collect()
}

/// The area of the disc over that of the part of a ball whose photons count, for a search radius of `ratio` of the ball's own.
///
/// The part in range is a cap of the disc's area, pi r^2, for any radius up to the ball's diameter. The rule of [`crate::PhotonMap`]
/// leaves of it what is within 60 degrees of the query, pi R^2, on average over the rounding of facings.
pub(super) fn disc_over_cap(ratio: f64) -> f64 {
    (ratio * ratio).max(1.0)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    const BALL: &str = r#"
[camera]
position = [0, 0, 3]
target = [0, 0, 0]
fov_deg = 40
[materials.white]
type = "diffuse"
reflectance = [0.5, 0.5, 0.5]
[[shapes]]
name = "ball"
type = "sphere"
center = [0, 0, 0]
radius = 0.5
material = "white"
[[shapes]]
name = "lamp"
type = "quad"
material = "white"
emission = [1, 1, 1]
corners = [[-1, 2, -1], [1, 2, -1], [1, 2, 1], [-1, 2, 1]]
"#;

    #[test]
    fn a_ball_leaks_by_its_angle_and_is_dark_where_it_is_small() {
        let scene = Scene::from_toml("ball.toml", BALL, Path::new("")).unwrap();
        let rays = Lighting {
            direct: DirectLight::Rays(1),
            area: Area::Covered,
            ..Lighting::default()
        };
        let of = |lighting: &Lighting, radius| ball_errors(&scene, lighting, radius);
        assert_eq!(of(&Lighting::default(), 0.04), []);
        let near = &of(&Lighting::default(), 0.25)[0];
        assert_eq!((near.shape.as_str(), near.too_dark), ("ball", None));
        assert!((near.leak.unwrap() - 30.0).abs() < 1e-9);
        let far = &of(&Lighting::default(), 1.0)[0];
        assert_eq!((far.leak, far.too_dark), (Some(90.0), Some(0.25)));
        assert_eq!(of(&rays, 1.0), []);
    }
}
