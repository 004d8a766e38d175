//! The queries at which measures are taken, and the measures of a light.

use glam::DVec3;
use serde::Serialize;

use crate::scene::Scene;
use crate::view::{QueryPoint, ViewError, ViewOptions};

/// The channels' weights in luminance (Rec. 709).
pub(super) const LUMINANCE: DVec3 = DVec3::new(0.2126, 0.7152, 0.0722);

/// The luminance of linear RGB with the primaries of Rec. ITU-R BT.709.
#[must_use]
pub fn luminance(rgb: DVec3) -> f64 {
    rgb.dot(LUMINANCE)
}

/// A measure of a light. An error in a channel that luminance hardly contains, such as blue, is a wrong
/// colour nevertheless.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Measure {
    /// The [`luminance`].
    Luminance,
    /// The red channel, the first.
    Red,
    /// The green channel, the second.
    Green,
    /// The blue channel, the third.
    Blue,
}

impl Measure {
    /// All measures; luminance is the first.
    pub const ALL: [Self; 4] = [Self::Luminance, Self::Red, Self::Green, Self::Blue];

    /// The measure with the largest figure. Where figures differ only by rounding, as with light of one
    /// colour, it is the first of them; `None` for no figures.
    pub fn worst<T>(
        figures: impl Iterator<Item = (Self, T)>,
        of: impl Fn(&T) -> f64,
    ) -> Option<(Self, T)> {
        let larger = |a: f64, b: f64| a > b * (1.0 + 1e-9);
        figures.reduce(|worst, found| match larger(of(&found.1), of(&worst.1)) {
            true => found,
            false => worst,
        })
    }

    /// The name of the measure in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Luminance => "luminance",
            Self::Red => "red",
            Self::Green => "green",
            Self::Blue => "blue",
        }
    }

    /// The value of the measure for linear RGB.
    #[must_use]
    pub fn of(self, rgb: DVec3) -> f64 {
        match self {
            Self::Luminance => luminance(rgb),
            Self::Red => rgb.x,
            Self::Green => rgb.y,
            Self::Blue => rgb.z,
        }
    }
}

/// The query points of a picture, row by row: all points at which [`crate::render`] gathers. A small picture
/// of one sample a pixel is a stratified sample of the view.
///
/// # Errors
/// The options describe no picture.
pub fn view_queries(scene: &Scene, options: &ViewOptions) -> Result<Vec<QueryPoint>, ViewError> {
    options.check()?;
    let pixels = (0..options.height).flat_map(|y| (0..options.width).map(move |x| (x, y)));
    let samples = pixels.flat_map(|(x, y)| options.samples(scene, x, y));
    Ok(samples.filter_map(|sample| sample.query).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn white_is_one() {
        // The weights' rounding.
        assert!((luminance(DVec3::ONE) - 1.0).abs() < 1e-15);
        assert_eq!(luminance(DVec3::Y), 0.7152);
    }

    #[test]
    fn a_view_has_its_samples_and_repeats() {
        let scene = Scene::built_in("cornell").unwrap();
        let options = ViewOptions {
            width: 8,
            height: 8,
            samples_per_axis: 2,
            seed: 1,
        };
        let queries = view_queries(&scene, &options).unwrap();
        // The picture is the box's open front, give or take its border.
        assert!((200..=256).contains(&queries.len()), "{}", queries.len());
        assert_eq!(view_queries(&scene, &options), Ok(queries));
        let none = ViewOptions {
            width: 0,
            ..options
        };
        assert!(view_queries(&scene, &none).is_err());
    }
}
