//! Estimates the error of the mean of progressive passes.

use glam::DVec3;
use statrs::distribution::{ContinuousCDF, StudentsT};

use crate::image::relative_scale;
use crate::metrics::{Moments, luminance};

/// The statistics of a pixel over all passes.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Pixel {
    pub sum: DVec3,
    /// The luminance at the search radius, x.
    pub plain: Moments,
    /// The luminance without bias, c = 2 y - x.
    pub corrected: Moments,
    /// The bias of the luminance, b = 2 (x - y).
    pub bias: Moments,
}

impl Pixel {
    /// Adds a pass: the radiance at the search radius and at half the squared radius.
    pub fn push(&mut self, whole: DVec3, inner: DVec3) {
        self.sum += whole;
        let [x, y] = [whole, inner].map(luminance);
        self.plain.push(x);
        self.corrected.push(2.0 * y - x);
        self.bias.push(2.0 * (x - y));
    }

    /// The mean radiance over the passes.
    pub fn radiance(&self) -> DVec3 {
        self.sum / self.plain.count().max(1) as f64
    }

    /// The bound of the pixel's error; `quantile` is Student's.
    fn bound(&self, quantile: f64) -> PixelBound {
        let deviation = |moments: &Moments| {
            (moments.variance().unwrap_or(f64::INFINITY) / moments.count() as f64).sqrt()
        };
        PixelBound {
            luminance: self.plain.mean(),
            bias: self.bias.mean(),
            bias_noise: deviation(&self.bias),
            noise: deviation(&self.plain),
            margin: quantile * deviation(&self.corrected),
        }
    }
}

/// The error bound of a pixel, in luminance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PixelBound {
    /// The luminance in the picture.
    pub luminance: f64,
    /// The estimated bias of that luminance.
    pub bias: f64,
    /// The standard deviation of the bias estimate: twice that of the luminance, where light is even.
    pub bias_noise: f64,
    /// The standard deviation of the luminance.
    pub noise: f64,
    /// The largest distance of the bias-corrected luminance from the truth, with the given confidence.
    pub margin: f64,
}

impl PixelBound {
    /// The bound of the error, with the given confidence: |bias| + margin.
    #[must_use]
    pub fn error(&self) -> f64 {
        self.bias.abs() + self.margin
    }

    /// The bound of the error over the luminance, as in relMSE.
    #[must_use]
    pub fn relative_error(&self) -> f64 {
        self.error() / relative_scale(self.luminance)
    }
}

/// The error estimate of a picture.
#[derive(Debug, Clone, PartialEq)]
pub struct ErrorEstimate {
    /// The probability with which a pixel's error is below its bound.
    pub confidence: f64,
    /// The factor on the noise for that confidence: Student's quantile for the number of passes.
    pub quantile: f64,
    /// The bounds of the pixels, row by row.
    pub pixels: Vec<PixelBound>,
}

impl ErrorEstimate {
    pub(super) fn of(pixels: &[Pixel], passes: u64, confidence: f64) -> Option<Self> {
        if passes < 2 || !(confidence > 0.0 && confidence < 1.0) {
            return None;
        }
        let student = StudentsT::new(0.0, 1.0, (passes - 1) as f64).ok()?;
        let quantile = student.inverse_cdf(0.5 + 0.5 * confidence);
        Some(Self {
            confidence,
            quantile,
            pixels: pixels.iter().map(|pixel| pixel.bound(quantile)).collect(),
        })
    }

    /// The bound of the picture: the root of the mean square of the pixels' bounds, each over its luminance,
    /// as in relMSE ([`crate::rel_mse`]). It bounds the root of the relMSE.
    #[must_use]
    pub fn bound(&self) -> f64 {
        self.rms(PixelBound::error)
    }

    /// The estimated bias of the picture, in that measure. The part of the mean square that the noise of the
    /// bias estimates causes is subtracted; the result is at least 0.
    #[must_use]
    pub fn bias(&self) -> f64 {
        let found = self.rms(|pixel| pixel.bias);
        let noise = self.rms(|pixel| pixel.bias_noise);
        (found * found - noise * noise).max(0.0).sqrt()
    }

    /// The standard deviation of the picture, in that measure.
    #[must_use]
    pub fn noise(&self) -> f64 {
        self.rms(|pixel| pixel.noise)
    }

    fn rms(&self, of: impl Fn(&PixelBound) -> f64) -> f64 {
        let relative = |pixel: &PixelBound| of(pixel) / relative_scale(pixel.luminance);
        self.pixels.iter().map(relative).collect::<Moments>().rms()
    }

    /// The fraction of the pixels whose error against `reference` (luminance, row by row) is at most their
    /// bound. `None` where the numbers of pixels differ, or there are none.
    #[must_use]
    pub fn bounded(&self, reference: &[f64]) -> Option<f64> {
        if reference.len() != self.pixels.len() || reference.is_empty() {
            return None;
        }
        let pairs = self.pixels.iter().zip(reference);
        let within =
            pairs.filter(|(pixel, truth)| (pixel.luminance - *truth).abs() <= pixel.error());
        Some(within.count() as f64 / reference.len() as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn estimate(passes: &[(f64, f64)], confidence: f64) -> Option<ErrorEstimate> {
        let mut pixel = Pixel::default();
        for (whole, inner) in passes {
            pixel.push(DVec3::splat(*whole), DVec3::splat(*inner));
        }
        ErrorEstimate::of(&[pixel], passes.len() as u64, confidence)
    }

    #[test]
    fn a_bias_proportional_to_the_squared_radius_is_found_exactly() {
        // The truth is 2; the whole disc gives 0.3 too much, the half disc 0.15.
        let found = estimate(&[(2.3, 2.15); 5], 0.9).unwrap();
        let pixel = found.pixels[0];
        // 1e-12: roundings; the luminance weights add up to 1.
        assert!((pixel.bias - 0.3).abs() < 1e-12);
        assert!(pixel.noise < 1e-12 && pixel.margin < 1e-12);
        assert!((found.bias() - 0.3 / (2.3f64.powi(2) + 1e-4).sqrt()).abs() < 1e-12);
        assert_eq!(found.bounded(&[2.0 + 1e-9]), Some(1.0));
        assert_eq!(found.bounded(&[1.9]), Some(0.0));
        assert_eq!(found.bounded(&[]), None);
    }

    #[test]
    fn the_margin_is_students() {
        let found = estimate(&[(1.0, 1.0), (3.0, 3.0)], 0.9).unwrap();
        // One degree of freedom: t = tan(0.45 pi); s = sqrt 2, over sqrt 2.
        let expected = (0.45 * std::f64::consts::PI).tan();
        assert!((found.pixels[0].margin / expected - 1.0).abs() < 1e-6);
        assert!((found.quantile / expected - 1.0).abs() < 1e-6);
        assert!((found.pixels[0].noise - 1.0).abs() < 1e-12);
    }

    #[test]
    fn one_pass_and_impossible_confidences_tell_nothing() {
        assert_eq!(estimate(&[(1.0, 1.0)], 0.9), None);
        for confidence in [0.0, 1.0, f64::NAN] {
            assert_eq!(estimate(&[(1.0, 1.0); 3], confidence), None);
        }
    }
}
