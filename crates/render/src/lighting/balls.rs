//! Finds what estimates get wrong on diffuse balls.

use super::{Area, DirectLight, Lighting};
use crate::geometry::Geometry;
use crate::scene::Scene;

/// The search radius, over a ball's own, from which a leak is worth telling: light then reaches 6 degrees round the dark side.
const LEAKS: f64 = 0.1;

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
        too_dark: Some(disc_over_cap(ratio).recip())
            .filter(|part| lighting.area == Area::Disc && *part < 1.0),
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

    #[test]
    fn a_ball_leaks_by_its_angle_and_is_dark_where_it_is_small() {
        // Two balls of the radii 0.6 and 0.3.
        let text = include_str!("../../../../docs/scenes/balls.toml");
        let scene = Scene::from_toml("balls.toml", text, Path::new("")).unwrap();
        let rays = Lighting {
            direct: DirectLight::Rays(1),
            area: Area::Covered,
            ..Lighting::default()
        };
        let of = |lighting: &Lighting, radius| ball_errors(&scene, lighting, radius);
        assert_eq!(of(&Lighting::default(), 0.029), []);
        let [large, small] = &of(&Lighting::default(), 0.3)[..] else {
            panic!("both balls leak");
        };
        assert_eq!([&large.shape, &small.shape], ["large", "small"]);
        assert!((large.leak.unwrap() - 30.0).abs() < 1e-9);
        assert_eq!((large.too_dark, small.too_dark), (None, None));
        let far = &of(&Lighting::default(), 0.6)[1];
        // Roundings of a division and a square.
        assert!((far.too_dark.unwrap() - 0.25).abs() < 1e-12);
        assert_eq!(far.leak, Some(90.0));
        assert_eq!(of(&rays, 0.6), []);
    }
}
