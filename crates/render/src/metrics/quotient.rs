//! The confidence interval of the quotient of error and noise.

use super::bias::Interval;
use super::error::MetricsError;
use super::noise::NoiseMeter;
use super::relative::RelativeErrors;
use super::study::ErrorStudy;

impl ErrorStudy {
    /// [`super::study::ErrorReport::error_over_noise`] with its 95 % confidence interval. Unlike the interval
    /// of the rms error, it takes into account that the noise is estimated too, and from the same maps.
    ///
    /// Method: the jackknife (Tukey, 1958) on the squared quotient. With q of all n maps and q_i of all but
    /// the i-th, the values n q - (n - 1) q_i are nearly independent. Their interval is that of
    /// [`Interval::of_independent`]; it is then centred on q, and the roots of its ends are taken.
    ///
    /// # Errors
    /// As for [`Self::report`], or fewer than three maps.
    pub fn error_over_noise(&self) -> Result<Interval, MetricsError> {
        let all = self.squared_quotient()?;
        let maps = self.differences.len();
        let pseudo_value = |map| -> Result<f64, MetricsError> {
            let rest = self.without(map).squared_quotient()?;
            Ok(all * maps as f64 - rest * (maps - 1) as f64)
        };
        let values: Result<Vec<_>, _> = (0..maps).map(pseudo_value).collect();
        let found = Interval::of_independent(&values?)?;
        let half = 0.5 * (found.high - found.low);
        Ok(Interval {
            mean: all.sqrt(),
            low: (all - half).max(0.0).sqrt(),
            high: (all + half).sqrt(),
        })
    }

    fn squared_quotient(&self) -> Result<f64, MetricsError> {
        let noise = self.noise.noise()?.relative;
        if noise == 0.0 {
            return Err(MetricsError::NoNoise);
        }
        let mut errors = RelativeErrors::default();
        for differences in &self.differences {
            errors.merge(self.errors_of(differences));
        }
        Ok((errors.rms()? / noise).powi(2))
    }

    /// The study without one map. Photon counts are not stored by map, so they are unchanged.
    fn without(&self, map: usize) -> Self {
        let mut rest = self.clone();
        rest.differences.remove(map);
        rest.references.remove(map);
        rest.noise = NoiseMeter::new(self.queries);
        for references in &rest.references {
            rest.noise
                .push_map(references)
                .expect("checked when the map was pushed");
        }
        rest
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;
    use crate::Misclassified;

    fn counts() -> Misclassified {
        let mut counts = Misclassified::default();
        counts.push(true, true);
        counts
    }

    #[test]
    fn the_quotients_interval_is_around_it() {
        let mut study = ErrorStudy::new(2);
        study.push_map(&[4.0, 4.0], &[3.0, 4.0], counts()).unwrap();
        study.push_map(&[5.0, 4.0], &[5.0, 4.0], counts()).unwrap();
        let two = study.error_over_noise().unwrap_err();
        assert_eq!(two, MetricsError::TooFewMaps { found: 1 });
        study.push_map(&[4.0, 4.5], &[4.0, 4.0], counts()).unwrap();
        let (found, report) = (study.error_over_noise().unwrap(), study.report().unwrap());
        // A few roundings.
        assert!((found.mean - report.error_over_noise).abs() < 1e-15);
        assert!(found.low < found.mean && found.mean < found.high);
    }

    /// Noise of 10 % and an error of 1 %, both of uniform numbers: the quotient is 0.1.
    #[test]
    fn the_quotients_interval_covers_it() {
        let mut rng = Pcg64Mcg::seed_from_u64(6);
        let (trials, queries) = (400, 20);
        let mut held = 0;
        for _ in 0..trials {
            let mut study = ErrorStudy::new(queries);
            for _ in 0..8 {
                let mut uniform = |width: f64| width * 12f64.sqrt() * (rng.random::<f64>() - 0.5);
                let references: Vec<f64> = (0..queries).map(|_| 1.0 + uniform(0.1)).collect();
                let estimates: Vec<f64> = references.iter().map(|r| r + uniform(0.01)).collect();
                study.push_map(&estimates, &references, counts()).unwrap();
            }
            held += i32::from(study.error_over_noise().unwrap().holds(0.1));
        }
        // The binomial's deviation is 0.011; four of them.
        let covered = f64::from(held) / f64::from(trials);
        assert!((covered - 0.95).abs() < 0.044, "{covered}");
    }
}
