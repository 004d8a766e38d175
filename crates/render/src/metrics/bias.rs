//! Means with their confidence intervals.

use serde::{Deserialize, Serialize};

use super::error::MetricsError;
use super::moments::Moments;

/// A mean with its 95 % confidence interval.
///
/// Method: Student's t on independent values, mean -+ t s / sqrt(n) with n - 1 degrees of freedom. Queries of
/// one photon map share photons and are *not* independent. So the values are one mean for each of several
/// independently traced maps (the method of batch means).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Interval {
    /// The mean of the values.
    pub mean: f64,
    /// The lower end of the interval.
    pub low: f64,
    /// The upper end of the interval.
    pub high: f64,
}

impl Interval {
    /// The interval of the mean of independent values.
    ///
    /// # Errors
    /// [`MetricsError::TooFewMaps`] below two values.
    pub fn of_independent(values: &[f64]) -> Result<Self, MetricsError> {
        let moments = Moments::from_iter(values.iter().copied());
        let found = moments.count();
        let variance = (moments.variance()).ok_or(MetricsError::TooFewMaps { found })?;
        let half = student_t_975(found - 1) * (variance / found as f64).sqrt();
        Ok(Self {
            mean: moments.mean(),
            low: moments.mean() - half,
            high: moments.mean() + half,
        })
    }

    /// Whether the interval contains `value`.
    #[must_use]
    pub fn holds(&self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }
}

/// The 97.5 % point of the normal distribution.
const NORMAL_975: f64 = 1.959_963_984_540_054;

/// The 97.5 % points of Student's t with 1 to 10 degrees of freedom, from tables.
const STUDENT_975: [f64; 10] = [
    12.706_205, 4.302_653, 3.182_446, 2.776_445, 2.570_582, 2.446_912, 2.364_624, 2.306_004,
    2.262_157, 2.228_139,
];

/// The 97.5 % point of Student's t for at least one degree of freedom. Beyond the table it is the normal's
/// point with three terms of the expansion by Fisher and Cornish (Abramowitz and Stegun 26.7.5), which is
/// accurate to 2e-4 from 11 on.
fn student_t_975(degrees: u64) -> f64 {
    if let Some(t) = STUDENT_975.get(degrees as usize - 1) {
        return *t;
    }
    let (z, n) = (NORMAL_975, degrees as f64);
    let g1 = (z.powi(3) + z) / 4.0;
    let g2 = (5.0 * z.powi(5) + 16.0 * z.powi(3) + 3.0 * z) / 96.0;
    let g3 = (3.0 * z.powi(7) + 19.0 * z.powi(5) + 17.0 * z.powi(3) - 15.0 * z) / 384.0;
    z + g1 / n + g2 / (n * n) + g3 / (n * n * n)
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;

    #[test]
    fn students_t_is_the_tables() {
        // Tabulated values; the first term left out is 1.1e-4 at 11.
        for (degrees, t) in [
            (11, 2.200_985),
            (20, 2.085_963),
            (30, 2.042_272),
            (120, 1.979_930),
        ] {
            assert!((student_t_975(degrees) - t).abs() < 2e-4, "{degrees}");
        }
        assert!((1..500).all(|n| student_t_975(n) > student_t_975(n + 1)));
    }

    #[test]
    fn a_set_by_hand() {
        let interval = Interval::of_independent(&[1.0, 3.0]).unwrap();
        // s = sqrt 2, so the half width is t(1) itself.
        assert!((interval.high - 2.0 - 12.706_205).abs() < 1e-12);
        assert!((interval.low - 2.0 + 12.706_205).abs() < 1e-12);
        assert!(interval.holds(0.0) && !interval.holds(20.0));
        let error = Interval::of_independent(&[1.0]).unwrap_err();
        assert_eq!(error, MetricsError::TooFewMaps { found: 1 });
    }

    #[test]
    fn it_covers_the_true_mean_19_times_in_20() {
        let mut rng = Pcg64Mcg::seed_from_u64(5);
        let trials = 4000;
        let mut held = 0;
        for _ in 0..trials {
            // Sums of 12 uniform numbers: normal but for a thin tail, mean 0.
            let mut normal = || (0..12).map(|_| rng.random::<f64>()).sum::<f64>() - 6.0;
            let values: Vec<f64> = (0..5).map(|_| normal()).collect();
            held += i32::from(Interval::of_independent(&values).unwrap().holds(0.0));
        }
        // The binomial's deviation is 0.0034; four of them.
        let covered = f64::from(held) / f64::from(trials);
        assert!((covered - 0.95).abs() < 0.014, "{covered}");
    }
}
