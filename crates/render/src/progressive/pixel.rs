//! The statistics of a pixel over the passes.

use glam::DVec3;
use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

use crate::metrics::Moments;

/// A bias is significant where it is this many times its standard deviation, or as improbable where few passes make the
/// deviation uncertain.
///
/// Correction more than doubles a pixel's noise, so it must be rare where there is no bias. On `cornell` lit by the map alone, 2 to
/// 64 passes, the relMSE rose by up to 2.4 % with 3, by 1.3 % with 3.5 and by 0.5 % with 4. On `ring` after 16 passes it fell to
/// 30, 36 and 55 %.
const SIGNIFICANT: f64 = 3.5;

/// The distance from the mean, in standard deviations of the mean of `passes` values, within which a value lies with the probability
/// `confidence`: Student's two-sided quantile. Infinite for fewer than two passes.
pub(super) fn student(passes: u64, confidence: f64) -> f64 {
    match passes {
        0 | 1 => f64::INFINITY,
        passes => {
            let student = StudentsT::new(0.0, 1.0, (passes - 1) as f64);
            let student = student.expect("at least one degree of freedom");
            student.inverse_cdf(0.5 + 0.5 * confidence)
        }
    }
}

/// The least ratio of a pixel's bias to the standard deviation of that bias at which the pixel is corrected, after `passes` passes.
pub(super) fn significant_ratio(passes: u64) -> f64 {
    student(passes, 2.0 * Normal::standard().cdf(SIGNIFICANT) - 1.0)
}

/// The statistics of a pixel over all passes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pixel {
    /// The radiance at the search radius, summed over the passes.
    pub sum: DVec3,
    /// The radiance at half the squared search radius, summed over the passes.
    pub inner_sum: DVec3,
    /// The luminance at the search radius, x.
    pub plain: Moments,
    /// The luminance without bias, c = 2 y - x.
    pub corrected: Moments,
    /// The bias of the luminance, b = 2 (x - y).
    pub bias: Moments,
}

impl Pixel {
    /// Whether the bias is at least `ratio` standard deviations, so that the picture has the corrected radiance.
    pub fn is_corrected(&self, ratio: f64) -> bool {
        let noise = deviation(&self.bias);
        // A bias that all passes agree on has no deviation. Where there is no bias, both are 0.
        self.bias.mean() != 0.0 && self.bias.mean().abs() >= ratio * noise
    }

    /// The mean radiance over the passes: x, or c where the bias is significant. No channel is negative.
    pub fn radiance(&self, ratio: f64) -> DVec3 {
        let passes = self.plain.count().max(1) as f64;
        match self.is_corrected(ratio) {
            true => ((2.0 * self.inner_sum - self.sum) / passes).max(DVec3::ZERO),
            false => self.sum / passes,
        }
    }
}

/// The standard deviation of the mean of the values; infinite for fewer than two.
pub(super) fn deviation(moments: &Moments) -> f64 {
    (moments.variance().unwrap_or(f64::INFINITY) / moments.count() as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::super::sums::pixels;
    use super::*;

    fn pixel(passes: &[(f64, f64)]) -> Pixel {
        pixels(&[passes]).iter().next().unwrap()
    }

    #[test]
    fn students_quantiles() {
        // One degree of freedom: tan(pi C / 2). Tables of the normal and of Student's distribution: 3.5 and, for 15 degrees, 4.4.
        let one = (0.45 * std::f64::consts::PI).tan();
        assert!((student(2, 0.9) / one - 1.0).abs() < 1e-6);
        assert_eq!(student(1, 0.9), f64::INFINITY);
        assert!((significant_ratio(1_000_000) - 3.5).abs() < 1e-3);
        assert!((significant_ratio(16) - 4.53).abs() < 0.1);
    }

    #[test]
    fn a_significant_bias_is_taken_off_and_another_is_not() {
        // The truth is 2; the whole disc gives 0.3 too much, the half disc 0.15, with noise of 0.01.
        let noisy = |whole, inner, noise| [(whole + noise, inner), (whole - noise, inner)];
        let biased: Vec<_> = (0..8).flat_map(|_| noisy(2.3, 2.15, 0.01)).collect();
        let ratio = significant_ratio(16);
        // 1e-12: roundings of sums of 16 values near 2.
        assert!((pixel(&biased).radiance(ratio) - DVec3::splat(2.0)).length() < 1e-12);
        let even: Vec<_> = (0..8).flat_map(|_| noisy(2.3, 2.3, 0.01)).collect();
        assert!((pixel(&even).radiance(ratio) - DVec3::splat(2.3)).length() < 1e-12);
        assert!(!pixel(&[(0.0, 0.0); 4]).is_corrected(ratio));
    }

    #[test]
    fn a_corrected_pixel_is_not_negative() {
        // Light that reaches only the outer ring: the correction would be below black.
        let leaking = pixel(&[(1.0, 0.0), (1.01, 0.0), (0.99, 0.0), (1.0, 0.0)]);
        assert_eq!(leaking.radiance(significant_ratio(4)), DVec3::ZERO);
    }
}
