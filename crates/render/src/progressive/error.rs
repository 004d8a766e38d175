//! Estimates the error of the mean of progressive passes.

use statrs::distribution::{ContinuousCDF, Normal};

use super::pixel::{Pixel, deviation, significant_ratio, student};
use super::sums::Pixels;
use crate::image::relative_scale;
use crate::metrics::Moments;

/// The factor on the squared bias in a bound. Where light jumps within the radius, b = 2 (x - y) shows only a part of the bias. With
/// this factor nine of ten pixels were within their bounds of 90 % (`scripts/accuracy.sh confidence`).
const UNSEEN: f64 = 2.0;

/// The part of the squared bias that is taken to remain in a corrected pixel: half of the bias. A correction takes off all of a bias
/// proportional to the squared radius, and less of one from a jump.
const REMAINING: f64 = 0.25;

/// The ratio of the bound to the noise from which bias rules. On `ring`, whose error is up to twice the bound, it is 5 and more; on scenes without
/// black beside light at most 2.4 (`scripts/accuracy.sh target`).
const RULED: f64 = 3.0;

/// The ratio of the squared bias around a pixel to its noise from which the pixel's true luminance is taken to be less by that bias:
/// three standard deviations.
const CLEAR: f64 = 9.0;

/// The error of a pixel of the picture, in luminance, and its bound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PixelBound {
    /// The luminance in the picture.
    pub luminance: f64,
    /// The standard deviation of that luminance.
    pub noise: f64,
    /// The squared bias of that luminance: the mean over the 3 x 3 pixels around of the squared bias over the squared luminance, without
    /// the part that noise causes, times the pixel's squared luminance. Below 0 where the noise exceeds what is found.
    pub bias_sq: f64,
    /// The number that relates the error to the pixel's true luminance, as in relMSE.
    pub scale: f64,
    /// The bound of the error, with the estimate's confidence.
    pub error: f64,
}

impl PixelBound {
    /// The bound of the error over the luminance, as in relMSE.
    #[must_use]
    pub fn relative_error(&self) -> f64 {
        self.error / self.scale
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
    /// The estimate for a picture of rows of `width` pixels.
    pub(super) fn of(pixels: &Pixels, width: usize, confidence: f64) -> Option<Self> {
        let passes = pixels.passes;
        if passes < 2 || !(confidence > 0.0 && confidence < 1.0) {
            return None;
        }
        let bias_sq = |pixel: Pixel| {
            let gathers = pixel.bias != Moments::of(passes, 0.0, 0.0);
            let scale = relative_scale(pixel.plain.mean());
            let both = [pixel.bias.mean(), deviation(&pixel.bias)];
            gathers.then(|| both.map(|value| (value / scale).powi(2)))
        };
        let biases: Vec<_> = pixels.iter().map(bias_sq).collect();
        let factors = Factors {
            significant: significant_ratio(passes),
            student: student(passes, confidence),
            normal: Normal::standard().inverse_cdf(0.5 + 0.5 * confidence),
        };
        let found = pixels.iter().zip(around(width, &biases));
        let found = found.map(|(pixel, bias)| factors.bound(&pixel, bias));
        Some(Self {
            confidence,
            quantile: factors.student,
            pixels: found.collect(),
        })
    }

    /// The bound of the picture: sqrt(noise^2 + 2 bias^2). It estimates the root of the relMSE ([`crate::rel_mse`]) from above.
    #[must_use]
    pub fn bound(&self) -> f64 {
        (self.noise().powi(2) + UNSEEN * self.bias().powi(2)).sqrt()
    }

    /// Whether bias rules the bound, so that the error may be above it: then light jumps within the radius at many pixels, as at
    /// sharp shadows, and the bias is known less well than elsewhere.
    #[must_use]
    pub fn is_ruled_by_bias(&self) -> bool {
        self.bound() > RULED * self.noise()
    }

    /// The estimated bias of the picture: the root of the mean square over the pixels, each over its luminance, as in relMSE.
    #[must_use]
    pub fn bias(&self) -> f64 {
        let squares = self.pixels.iter();
        let squares = squares.map(|pixel| pixel.bias_sq / pixel.scale.powi(2));
        squares.collect::<Moments>().mean().max(0.0).sqrt()
    }

    /// The standard deviation of the picture, in that measure.
    #[must_use]
    pub fn noise(&self) -> f64 {
        let noises = self.pixels.iter().map(|pixel| pixel.noise / pixel.scale);
        noises.collect::<Moments>().rms()
    }

    /// The fraction of the pixels whose error against `reference` (luminance, row by row) is at most their
    /// bound. `None` where the numbers of pixels differ, or there are none.
    #[must_use]
    pub fn bounded(&self, reference: &[f64]) -> Option<f64> {
        if reference.len() != self.pixels.len() || reference.is_empty() {
            return None;
        }
        let pairs = self.pixels.iter().zip(reference);
        let within = pairs.filter(|(pixel, truth)| (pixel.luminance - *truth).abs() <= pixel.error);
        Some(within.count() as f64 / reference.len() as f64)
    }
}

/// The quantiles of an estimate.
struct Factors {
    /// The ratio from which a bias is significant.
    significant: f64,
    /// On the noise, whose deviation is estimated from the passes.
    student: f64,
    /// On the bias.
    normal: f64,
}

impl Factors {
    /// The bound of a pixel with that mean squared bias around it, and the part of it that is noise; both over the squared luminance
    /// of their pixels.
    fn bound(&self, pixel: &Pixel, [square, noise_sq]: [f64; 2]) -> PixelBound {
        let is_corrected = pixel.is_corrected(self.significant);
        let found_sq = (square - noise_sq) * relative_scale(pixel.plain.mean()).powi(2);
        let (mean, bias_sq) = match is_corrected {
            true => (&pixel.corrected, REMAINING * found_sq),
            false => (&pixel.plain, found_sq),
        };
        // A corrected picture has no pixel below black.
        let luminance = mean.mean().max(0.0);
        let leaked = match !is_corrected && square >= CLEAR * noise_sq {
            true => found_sq.max(0.0).sqrt(),
            false => 0.0,
        };
        let noise = deviation(mean);
        let bias = (UNSEEN * bias_sq.max(0.0)).sqrt();
        PixelBound {
            luminance,
            noise,
            bias_sq,
            scale: relative_scale((luminance - leaked).max(0.0)),
            error: (self.student * noise).hypot(self.normal * bias),
        }
    }
}

/// The means over those of the 3 x 3 pixels around each pixel that have values: the pixels in the picture whose estimates are not 0 in
/// every pass. A pixel without values has neither bias nor noise.
fn around(width: usize, values: &[Option<[f64; 2]>]) -> Vec<[f64; 2]> {
    let height = values.len() / width.max(1);
    let mean = |index: usize| {
        if values[index].is_none() {
            return [0.0; 2];
        }
        let (x, y) = (index % width, index / width);
        let rows = y.saturating_sub(1)..(y + 2).min(height);
        let columns = x.saturating_sub(1)..(x + 2).min(width);
        let rows = rows.map(|row| &values[row * width..][columns.clone()]);
        let near: Vec<_> = rows.flatten().flatten().collect();
        let mean =
            |which: usize| near.iter().map(|pair| pair[which]).sum::<f64>() / near.len() as f64;
        [mean(0), mean(1)]
    };
    (0..values.len()).map(mean).collect()
}

#[cfg(test)]
mod tests {
    use super::super::sums::pixels;
    use super::*;

    fn estimate(passes: &[(f64, f64)], confidence: f64) -> Option<ErrorEstimate> {
        ErrorEstimate::of(&pixels(&[passes]), 1, confidence)
    }

    #[test]
    fn a_bias_that_is_taken_off_remains_by_half() {
        // The truth is 2; the whole disc gives 0.3 too much, the half disc 0.15.
        let found = estimate(&[(2.3, 2.15); 5], 0.9).unwrap();
        let pixel = found.pixels[0];
        // 1e-12: roundings; the luminance weights add up to 1.
        assert!((pixel.luminance - 2.0).abs() < 1e-12);
        assert!((pixel.bias_sq.sqrt() - 0.15).abs() < 1e-12);
        assert!(pixel.noise < 1e-12);
        assert!((found.bias() - 0.15 / (2.0f64.powi(2) + 1e-4).sqrt()).abs() < 1e-12);
        assert!(found.is_ruled_by_bias());
        // 1.645: the normal distribution's quantile of 90 %, from a table.
        let bound = 1.645 * 2f64.sqrt() * 0.15;
        assert!((pixel.error - bound).abs() < 1e-4, "{}", pixel.error);
        assert_eq!(found.bounded(&[2.0 + 0.99 * bound]), Some(1.0));
        assert_eq!(found.bounded(&[2.0 + 1.01 * bound]), Some(0.0));
        assert_eq!(found.bounded(&[]), None);
    }

    #[test]
    fn the_bound_of_noise_is_students() {
        let found = estimate(&[(1.0, 1.0), (3.0, 3.0)], 0.9).unwrap();
        // One degree of freedom: t = tan(0.45 pi); s = sqrt 2, over sqrt 2.
        let expected = (0.45 * std::f64::consts::PI).tan();
        assert!((found.pixels[0].error / expected - 1.0).abs() < 1e-6);
        assert!((found.quantile / expected - 1.0).abs() < 1e-6);
        assert!((found.pixels[0].noise - 1.0).abs() < 1e-12);
        assert!(!found.is_ruled_by_bias());
    }

    /// A black pixel that light leaks into, beside pixels where the leak shows. Its own passes show no bias.
    #[test]
    fn a_leak_beside_a_pixel_widens_its_bound_and_its_relative_error() {
        let leaking = [(0.5, 0.3), (0.51, 0.29), (0.49, 0.3), (0.5, 0.31)];
        let even = [(0.5, 0.5), (0.52, 0.51), (0.48, 0.49), (0.5, 0.5)];
        let among = |neighbour: &[(f64, f64)]| {
            let pixels = pixels(&[neighbour, &even, neighbour]);
            ErrorEstimate::of(&pixels, 3, 0.9).unwrap().pixels[1]
        };
        let (alone, beside) = (among(&even), among(&leaking));
        assert_eq!(alone.luminance, beside.luminance);
        assert!(alone.error < 0.05 && beside.error > 0.5);
        assert!(beside.scale < 0.5 * alone.scale, "{beside:?} {alone:?}");
    }

    #[test]
    fn means_around_are_those_of_the_pixels_that_exist() {
        let values = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0].map(|value| Some([value, -value]));
        let expected = [3.0, 3.5, 4.0, 3.0, 3.5, 4.0].map(|value| [value, -value]);
        assert_eq!(around(3, &values), expected);
        assert_eq!(around(1, &values[5..]), [[6.0, -6.0]]);
        // The first pixel gathers nothing.
        let values = [None, values[0], values[2]];
        assert_eq!(around(3, &values), [[0.0; 2], [2.0, -2.0], [2.0, -2.0]]);
    }

    #[test]
    fn one_pass_and_impossible_confidences_tell_nothing() {
        assert_eq!(estimate(&[(1.0, 1.0)], 0.9), None);
        for confidence in [0.0, 1.0, f64::NAN] {
            assert_eq!(estimate(&[(1.0, 1.0); 3], confidence), None);
        }
    }
}
