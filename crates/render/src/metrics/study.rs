//! Compares a machine's estimates with the reference, over several independent photon maps.

use serde::{Deserialize, Serialize};

use super::bias::Interval;
use super::error::{MetricsError, check};
use super::misclassified::Misclassified;
use super::noise::NoiseMeter;
use super::relative::{RelativeErrors, RelativeSummary};

/// Collects the data of an [`ErrorReport`], one photon map at a time.
///
/// Every map is traced with its own seed and has the same queries, radius and number of photons. Estimate and
/// reference of a map use the same photons, so their difference is the machine's error. The references of
/// different maps scatter by the noise.
///
/// # Relative to what
/// Error and noise are both relative to the query's expected light, the mean of its references over all maps.
/// Relative to the reference of its own map, an error would be large wherever that map happens to be dark: a
/// photon lost out of one is 100 %, a bright one gained by a query without any is infinite. Lost and gained
/// photons would have different weights. The quotient with the noise, whose denominator is the mean, would
/// then depend on the scene and not on the machine.
#[derive(Debug, Clone, PartialEq)]
pub struct ErrorStudy {
    pub(super) queries: usize,
    /// The estimate less the reference, by map and query.
    pub(super) differences: Vec<Vec<f64>>,
    pub(super) references: Vec<Vec<f64>>,
    pub(super) noise: NoiseMeter,
    misclassified: Misclassified,
}

/// The error of an engine beside the noise. The names are also the keys of the command line's JSON; 1 is 100
/// % wherever the name contains `relative`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ErrorReport {
    /// The number of query points of every map.
    pub query_points: u64,
    /// The number of independent photon maps.
    pub maps: u64,
    /// The number of pairs of estimate and reference compared: those of the queries from which the noise is
    /// measured.
    pub estimates_compared: u64,
    /// The number of pairs left out because the query's own noise is over [`crate::MAX_QUERY_NOISE`]. Their
    /// photons are still counted as tested and misclassified.
    pub estimates_too_noisy: u64,
    /// The number of pairs left out because all references of the query are 0.
    pub estimates_unlit: u64,
    /// The number of these pairs where the estimate is over 0.
    pub estimates_unlit_but_estimated: u64,
    /// The root of the mean squared relative error.
    pub rms_relative_error: f64,
    /// The lower end of its 95 % confidence interval, from the maps' mean squares. A wide interval shows that
    /// few queries make up the figure: a bright cluster at the radius is a single event.
    pub rms_relative_error_low: f64,
    /// The upper end of that interval.
    pub rms_relative_error_high: f64,
    /// The median magnitude of the relative error.
    pub median_relative_error: f64,
    /// The 95 % quantile of the magnitude of the relative error.
    pub p95_relative_error: f64,
    /// The 99 % quantile of the magnitude of the relative error.
    pub p99_relative_error: f64,
    /// The largest magnitude of the relative error.
    pub max_relative_error: f64,
    /// The mean over maps of the mean relative error, with its sign.
    pub bias_relative: f64,
    /// The lower end of the bias's 95 % confidence interval.
    pub bias_relative_low: f64,
    /// The upper end of that interval.
    pub bias_relative_high: f64,
    /// The scene's own Monte-Carlo noise.
    pub noise_relative: f64,
    /// `rms_relative_error` divided by `noise_relative`.
    pub error_over_noise: f64,
    /// The number of photons tested.
    pub photon_tests: u64,
    /// The number of photons in range by the reference.
    pub photons_in_range: u64,
    /// The number of photons that are in range by only one of reference and engine.
    pub misclassified_photons: u64,
    /// Misclassified photons in per cent of those in range by the reference.
    pub misclassified_percent: f64,
}

impl ErrorStudy {
    /// A study of `queries` queries.
    #[must_use]
    pub fn new(queries: usize) -> Self {
        Self {
            queries,
            differences: Vec::new(),
            references: Vec::new(),
            noise: NoiseMeter::new(queries),
            misclassified: Misclassified::default(),
        }
    }

    /// Adds one map: luminances in the order of the queries, and the counts of its photon tests. An error
    /// leaves the study unchanged.
    ///
    /// # Errors
    /// Sets of another length than the queries, or values that are negative or not finite.
    pub fn push_map(
        &mut self,
        estimates: &[f64],
        references: &[f64],
        misclassified: Misclassified,
    ) -> Result<(), MetricsError> {
        check("estimates", estimates, self.queries)?;
        self.noise.push_map(references)?;
        let pairs = estimates.iter().zip(references);
        self.differences.push(pairs.map(|(a, b)| a - b).collect());
        self.references.push(references.to_vec());
        self.misclassified += misclassified;
        Ok(())
    }

    /// All relative errors, with their mean and mean square over the maps.
    fn errors(&self) -> Result<(RelativeSummary, Interval, Interval), MetricsError> {
        let mut all = RelativeErrors::default();
        let (mut biases, mut squares) = (Vec::new(), Vec::new());
        for differences in &self.differences {
            let errors = self.errors_of(differences);
            let summary = errors.summary()?;
            biases.push(summary.bias);
            squares.push(summary.rms * summary.rms);
            all.merge(errors);
        }
        let bias = Interval::of_independent(&biases)?;
        Ok((all.summary()?, bias, Interval::of_independent(&squares)?))
    }

    pub(super) fn errors_of(&self, differences: &[f64]) -> RelativeErrors {
        let mut errors = RelativeErrors::default();
        for (query, difference) in differences.iter().enumerate() {
            let mean = self.noise.mean_of_query(query);
            if mean == 0.0 || self.noise.is_sampled(query) {
                errors.push(*difference, mean);
            }
        }
        errors
    }

    /// The figures over all maps.
    ///
    /// # Errors
    /// Fewer than two maps, no query with light and moderate noise, no photon in range, or no
    /// noise.
    pub fn report(&self) -> Result<ErrorReport, MetricsError> {
        let noise = self.noise.noise()?;
        if noise.relative == 0.0 {
            return Err(MetricsError::NoNoise);
        }
        let (errors, bias, square) = self.errors()?;
        Ok(ErrorReport {
            query_points: self.queries as u64,
            maps: noise.maps,
            estimates_compared: errors.compared,
            estimates_too_noisy: noise.queries_too_noisy * noise.maps,
            estimates_unlit: errors.unlit,
            estimates_unlit_but_estimated: errors.unlit_but_estimated,
            rms_relative_error: errors.rms,
            rms_relative_error_low: square.low.max(0.0).sqrt(),
            rms_relative_error_high: square.high.sqrt(),
            median_relative_error: errors.median,
            p95_relative_error: errors.p95,
            p99_relative_error: errors.p99,
            max_relative_error: errors.max,
            bias_relative: bias.mean,
            bias_relative_low: bias.low,
            bias_relative_high: bias.high,
            noise_relative: noise.relative,
            error_over_noise: errors.rms / noise.relative,
            photon_tests: self.misclassified.tests,
            photons_in_range: self.misclassified.in_range,
            misclassified_photons: self.misclassified.photons(),
            misclassified_percent: self.misclassified.percent()?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts() -> Misclassified {
        let mut counts = Misclassified::default();
        counts.push(true, true);
        counts.push(true, false);
        counts
    }

    fn study() -> ErrorStudy {
        let mut study = ErrorStudy::new(2);
        study.push_map(&[4.0, 4.0], &[3.0, 4.0], counts()).unwrap();
        study.push_map(&[5.0, 4.0], &[5.0, 4.0], counts()).unwrap();
        study
    }

    #[test]
    fn two_maps_by_hand() {
        let report = study().report().unwrap();
        assert_eq!(
            (report.query_points, report.maps, report.estimates_compared),
            (2, 2, 4)
        );
        // Errors 1 of a mean of 4, then 0, 0, 0; noise sqrt(2)/4 and 0. A few roundings.
        assert!((report.rms_relative_error - 0.125).abs() < 1e-15);
        assert!((report.noise_relative - 0.25).abs() < 1e-15);
        assert!((report.error_over_noise - 0.5).abs() < 1e-15);
        assert!((report.bias_relative - 0.0625).abs() < 1e-15);
        // Mean squares of the maps 0.03125 and 0: the mean by Student's t of one degree.
        assert_eq!(report.rms_relative_error_low, 0.0);
        let high = 0.015625 * (1.0 + 12.706_205);
        assert!((report.rms_relative_error_high - f64::sqrt(high)).abs() < 1e-12);
        assert!(report.bias_relative_low < 0.0 && report.bias_relative_high > 0.125);
        assert_eq!(
            (report.misclassified_photons, report.misclassified_percent),
            (2, 50.0)
        );
    }

    #[test]
    fn keys_are_snake_case_and_come_back() {
        let report = study().report().unwrap();
        let json = serde_json::to_value(report).unwrap();
        for key in [
            "query_points",
            "rms_relative_error",
            "noise_relative",
            "error_over_noise",
            "bias_relative",
        ] {
            assert!(json[key].is_number(), "{key}");
        }
        assert_eq!(serde_json::from_value::<ErrorReport>(json).unwrap(), report);
    }

    #[test]
    fn what_shows_nothing_is_refused() {
        let refused = |pairs: &[(f64, f64)], counts| {
            let mut study = ErrorStudy::new(1);
            for (estimate, reference) in pairs {
                study.push_map(&[*estimate], &[*reference], counts).unwrap();
            }
            study.report().unwrap_err()
        };
        let no_maps = MetricsError::TooFewMaps { found: 0 };
        assert_eq!(refused(&[], counts()), no_maps);
        let dark = [(0.0, 0.0), (1.0, 0.0)];
        assert_eq!(refused(&dark, counts()), MetricsError::NothingCompared);
        let one = MetricsError::TooFewMaps { found: 1 };
        assert_eq!(refused(&[(1.0, 2.0)], counts()), one);
        assert_eq!(refused(&[(1.0, 2.0); 2], counts()), MetricsError::NoNoise);
        let none = Misclassified::default();
        let two = [(1.0, 1.0), (1.0, 1.5)];
        assert_eq!(refused(&two, none), MetricsError::NothingInRange);
    }

    #[test]
    fn a_refused_map_leaves_no_trace() {
        let mut study = study();
        let before = study.clone();
        for (estimates, references) in [([1.0, f64::NAN], [1.0, 2.0]), ([1.0, 2.0], [-1.0, 2.0])] {
            assert!(study.push_map(&estimates, &references, counts()).is_err());
            assert!(
                study
                    .push_map(&estimates[..1], &[1.0, 2.0], counts())
                    .is_err()
            );
            assert!(
                study
                    .push_map(&[1.0, 2.0], &references[..1], counts())
                    .is_err()
            );
        }
        assert_eq!(study, before);
    }

    #[test]
    fn a_map_dark_by_chance_weighs_like_any_other() {
        // Fifteen maps at 1 and one at 0: a deviation of 0.27.
        let mut study = ErrorStudy::new(1);
        study.push_map(&[1.0], &[0.0], counts()).unwrap();
        study.push_map(&[0.0], &[1.0], counts()).unwrap();
        for _ in 0..14 {
            study.push_map(&[1.0], &[1.0], counts()).unwrap();
        }
        let report = study.report().unwrap();
        // One photon is gained and one lost, of equal weight.
        assert_eq!(report.bias_relative, 0.0);
        assert_eq!((report.estimates_compared, report.estimates_unlit), (16, 0));
        assert!((report.max_relative_error - 16.0 / 15.0).abs() < 1e-15);
    }

    #[test]
    fn what_one_map_in_many_lights_is_left_out() {
        let mut study = ErrorStudy::new(2);
        study.push_map(&[0.0, 2.0], &[9.0, 3.0], counts()).unwrap();
        for _ in 0..5 {
            study.push_map(&[0.0, 2.0], &[0.0, 2.0], counts()).unwrap();
        }
        let report = study.report().unwrap();
        assert_eq!(
            (report.estimates_compared, report.estimates_too_noisy),
            (6, 6)
        );
        assert!(report.max_relative_error < 0.5);
    }
}
