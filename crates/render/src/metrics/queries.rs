//! Where the measures are taken, and of what.

use glam::DVec3;

use crate::scene::Scene;
use crate::view::{QueryPoint, ViewError, ViewOptions};

/// The channels' weights in luminance (Rec. 709).
pub(super) const LUMINANCE: DVec3 = DVec3::new(0.2126, 0.7152, 0.0722);

/// The luminance of linear RGB with the primaries of Rec. ITU-R BT.709.
#[must_use]
pub fn luminance(rgb: DVec3) -> f64 {
    rgb.dot(LUMINANCE)
}

/// The query points of a picture, row by row: what [`crate::render`] gathers at, all of it. A
/// small picture of one sample a pixel is a stratified sample of the view.
///
/// # Errors
/// Options that give no picture.
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
