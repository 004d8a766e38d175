//! The smooth border of two media: the shares and the directions of reflected and refracted light.

use glam::DVec3;

/// The reflection and refraction of light of one direction at a smooth border.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Border {
    /// The reflected fraction F, from 0 to 1; 1 with total reflection.
    pub reflected: f64,
    /// The unit direction of the refracted light; `None` with total reflection.
    pub refracted: Option<DVec3>,
}

impl Border {
    /// Light that goes in the unit direction `direction` and meets the unit normal `normal`, which points
    /// against it, where the index of refraction behind the border is `ratio` times that before it.
    ///
    /// Snell's law, and Fresnel's equations for light that is not polarised: F is the mean of the squares
    /// of (cos - ratio cos') / (cos + ratio cos') and (ratio cos - cos') / (ratio cos + cos').
    pub fn new(direction: DVec3, normal: DVec3, ratio: f64) -> Self {
        let cos = -direction.dot(normal);
        let tangent = (direction + cos * normal) / ratio;
        let cos_sq = 1.0 - tangent.length_squared();
        if cos_sq <= 0.0 {
            return Self {
                reflected: 1.0,
                refracted: None,
            };
        }
        let behind = cos_sq.sqrt();
        let across = (cos - ratio * behind) / (cos + ratio * behind);
        let along = (ratio * cos - behind) / (ratio * cos + behind);
        Self {
            reflected: 0.5 * (across * across + along * along),
            refracted: Some(tangent - behind * normal),
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const UP: DVec3 = DVec3::Y;

    fn down(sine: f64) -> DVec3 {
        DVec3::new(sine, -(1.0 - sine * sine).sqrt(), 0.0)
    }

    #[test]
    fn straight_light_is_reflected_as_the_indices_say() {
        // ((n - 1) / (n + 1))^2: 4 % for glass, from either side.
        for ratio in [1.5, 1.0 / 1.5] {
            let border = Border::new(-UP, UP, ratio);
            assert!((border.reflected - 0.04).abs() < 1e-15);
            assert_eq!(border.refracted, Some(-UP));
        }
    }

    #[test]
    fn at_brewsters_angle_half_the_light_knows_of_the_border() {
        // tan = n: the component along the plane passes, the other reflects ((n^2 - 1) / (n^2 + 1))^2.
        let n = 1.5_f64;
        let border = Border::new(down(n / (1.0 + n * n).sqrt()), UP, n);
        let across = (n * n - 1.0) / (n * n + 1.0);
        assert!((border.reflected - 0.5 * across * across).abs() < 1e-15);
    }

    #[test]
    fn past_the_critical_angle_all_is_reflected() {
        let critical = 1.0 / 1.5;
        let inside = |sine| Border::new(down(sine), UP, 1.0 / 1.5);
        assert!(inside(critical - 1e-9).refracted.is_some());
        assert_eq!(inside(critical + 1e-9).refracted, None);
        assert_eq!(inside(critical + 1e-9).reflected, 1.0);
    }

    proptest! {
        /// Snell's law is symmetric: the way back is the way in, with an equal share.
        #[test]
        fn light_goes_back_as_it_came(sine in 0.0..0.999f64, ratio in 1.01..3.0f64) {
            let direction = down(sine);
            let border = Border::new(direction, UP, ratio);
            let refracted = border.refracted.expect("into the denser medium");
            // 1e-12: a few roundings, with cosines down to 0.04.
            prop_assert!((refracted.length() - 1.0).abs() < 1e-12);
            prop_assert!((ratio * refracted.x - sine).abs() < 1e-12);
            let back = Border::new(-refracted, -UP, 1.0 / ratio);
            prop_assert!((back.reflected - border.reflected).abs() < 1e-10);
            prop_assert!(back.refracted.expect("by the way it came").distance(-direction) < 1e-10);
        }
    }
}
