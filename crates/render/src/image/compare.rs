//! Measures the difference of two images.

use glam::DVec3;
use thiserror::Error;

use super::Image;

/// The constant of the reference's definition, which keeps the quotient of black pixels finite.
const EPSILON: f64 = 1e-4;

/// Radiance over which a pixel sees a light itself, by the reference image's own rule: the limit for
/// [`light_mask`]. The walls of the Cornell box stay below 2.
pub const LIGHT_RADIANCE: f64 = 5.0;

/// The error of images that cannot be compared.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum CompareError {
    /// The images differ in size.
    #[error("images to compare: found {found:?} pixels, expected {expected:?} as in the reference")]
    Size {
        /// Width and height of the image.
        found: (u32, u32),
        /// Width and height of the reference.
        expected: (u32, u32),
    },
    /// The mask has more or fewer entries than the images have pixels.
    #[error("mask: found {found} entries, expected one for each of {expected} pixels")]
    Mask {
        /// The number of entries of the mask.
        found: usize,
        /// The number of pixels of the images.
        expected: usize,
    },
    /// The mask excludes every pixel. A comparison of nothing is an error.
    #[error("mask: found no pixel to compare, expected at least one")]
    NothingCompared,
}

/// A mask of the pixels to compare, row by row. It excludes pixels with a channel over `limit` and the eight
/// neighbours of each, which the border of a light may touch.
#[must_use]
pub fn light_mask(image: &Image, limit: f64) -> Vec<bool> {
    let (width, height) = (i64::from(image.width()), i64::from(image.height()));
    let bright = |x: i64, y: i64| {
        let inside = (0..width).contains(&x) && (0..height).contains(&y);
        inside && image.pixels()[(y * width + x) as usize].max_element() > limit
    };
    let keep = |index: i64| {
        let (x, y) = (index % width, index / width);
        !(-1..=1).any(|dy| (-1..=1).any(|dx| bright(x + dx, y + dy)))
    };
    (0..width * height).map(keep).collect()
}

/// The scale of relMSE for an error at `value`: sqrt(value^2 + 1e-4).
pub(crate) fn relative_scale(value: f64) -> f64 {
    (value * value + EPSILON).sqrt()
}

/// relMSE: the mean of (a - ref)^2 / (ref^2 + 1e-4) over the channels of the pixels that the
/// mask keeps.
///
/// # Errors
/// Images of different size, a mask of another size, or one that keeps nothing.
pub fn rel_mse(image: &Image, reference: &Image, mask: &[bool]) -> Result<f64, CompareError> {
    mean(image, reference, mask, |a, b| {
        (a - b) * (a - b) / (b * b + EPSILON)
    })
}

/// RMSE: sqrt(mean((a - ref)^2)), in radiance, over the channels of the pixels that the mask keeps.
///
/// # Errors
/// As for [`rel_mse`].
pub fn rmse(image: &Image, reference: &Image, mask: &[bool]) -> Result<f64, CompareError> {
    let square = mean(image, reference, mask, |a, b| (a - b) * (a - b))?;
    Ok(square.sqrt())
}

/// The root of the mean squared relative difference, sqrt(mean((a/ref - 1)^2)), over the
/// channels that the mask keeps and that are over 0 in the reference: the measure for two engines
/// on the same photons, where nothing but the number format differs.
///
/// # Errors
/// As for [`rel_mse`].
pub fn rms_relative_difference(
    image: &Image,
    reference: &Image,
    mask: &[bool],
) -> Result<f64, CompareError> {
    let lit = mean(image, reference, mask, |_, b| {
        DVec3::from(b.cmpgt(DVec3::ZERO))
    })?;
    if lit == 0.0 {
        return Err(CompareError::NothingCompared);
    }
    let squares = mean(image, reference, mask, |a, b| {
        let relative = a / b - 1.0;
        DVec3::select(b.cmpgt(DVec3::ZERO), relative * relative, DVec3::ZERO)
    })?;
    Ok((squares / lit).sqrt())
}

/// The mean of `measure` over pixels and channels.
fn mean(
    image: &Image,
    reference: &Image,
    mask: &[bool],
    measure: impl Fn(DVec3, DVec3) -> DVec3,
) -> Result<f64, CompareError> {
    let size = |image: &Image| (image.width(), image.height());
    if size(image) != size(reference) {
        return Err(CompareError::Size {
            found: size(image),
            expected: size(reference),
        });
    }
    if mask.len() != reference.pixels().len() {
        return Err(CompareError::Mask {
            found: mask.len(),
            expected: reference.pixels().len(),
        });
    }
    let (mut sum, mut count) = (0.0, 0u64);
    for ((a, b), _) in image
        .pixels()
        .iter()
        .zip(reference.pixels())
        .zip(mask)
        .filter(|(_, keep)| **keep)
    {
        sum += measure(*a, *b).element_sum();
        count += 3;
    }
    if count == 0 {
        return Err(CompareError::NothingCompared);
    }
    Ok(sum / count as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image(values: &[f64]) -> Image {
        let pixels = values.iter().map(|v| DVec3::splat(*v)).collect();
        Image::new(values.len() as u32, 1, pixels).unwrap()
    }

    #[test]
    fn rel_mse_is_the_reference_definition() {
        let (a, b) = (image(&[1.0, 2.0, 9.0]), image(&[1.5, 2.0, 0.0]));
        let got = rel_mse(&a, &b, &[true, true, false]).unwrap();
        // Exact up to rounding.
        assert!((got - 0.25 / 2.2501 / 2.0).abs() < 1e-15);
        assert_eq!(rel_mse(&b, &b, &[true; 3]), Ok(0.0));
    }

    #[test]
    fn rmse_is_in_radiance() {
        let (a, b) = (image(&[1.0, 2.0, 9.0]), image(&[1.5, 2.0, 0.0]));
        let got = rmse(&a, &b, &[true, true, false]).unwrap();
        // Exact up to rounding.
        assert!((got - (0.25_f64 / 2.0).sqrt()).abs() < 1e-15);
    }

    #[test]
    fn rms_leaves_black_channels_out() {
        let (a, b) = (image(&[1.1, 5.0]), image(&[1.0, 0.0]));
        let got = rms_relative_difference(&a, &b, &[true; 2]).unwrap();
        assert!((got - 0.1).abs() < 1e-12);
        assert_eq!(
            rms_relative_difference(&a, &image(&[0.0, 0.0]), &[true; 2]),
            Err(CompareError::NothingCompared)
        );
    }

    #[test]
    fn the_mask_covers_light_and_neighbours() {
        let mut values = [0.0; 25];
        values[12] = 6.0;
        let pixels = values.iter().map(|v| DVec3::new(0.0, *v, 0.0)).collect();
        let mask = light_mask(&Image::new(5, 5, pixels).unwrap(), 5.0);
        assert_eq!(mask.iter().filter(|keep| !**keep).count(), 9);
        assert!(!mask[6] && !mask[18] && mask[5] && mask[2]);
    }

    #[test]
    fn comparing_nothing_is_an_error() {
        let a = image(&[1.0]);
        assert_eq!(
            rel_mse(&a, &a, &[false]),
            Err(CompareError::NothingCompared)
        );
        assert!(matches!(
            rel_mse(&a, &a, &[]),
            Err(CompareError::Mask { .. })
        ));
        assert!(matches!(
            rel_mse(&a, &image(&[1.0, 1.0]), &[true]),
            Err(CompareError::Size { .. })
        ));
    }
}
