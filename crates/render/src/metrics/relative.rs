//! The relative error of a set of estimates.

use super::error::{MetricsError, check};
use super::moments::Moments;

/// The relative errors of queries, from one or more sets of estimates.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RelativeErrors {
    magnitudes: Vec<f64>,
    signed: Moments,
    unlit: u64,
    unlit_but_estimated: u64,
}

/// Statistics of relative errors; 1 is 100 %.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RelativeSummary {
    /// The number of errors: queries with light.
    pub compared: u64,
    /// The number of queries left out because they have no light.
    pub unlit: u64,
    /// The number of these queries where the estimate is over 0.
    pub unlit_but_estimated: u64,
    /// The root of the mean squared error.
    pub rms: f64,
    /// The median of the errors' magnitudes.
    pub median: f64,
    /// The 95 % quantile of the magnitudes.
    pub p95: f64,
    /// The 99 % quantile of the magnitudes.
    pub p99: f64,
    /// The largest magnitude.
    pub max: f64,
    /// The mean error, with its sign.
    pub bias: f64,
}

impl RelativeErrors {
    /// Computes the errors of `estimates` against `references`, query by query.
    ///
    /// # Errors
    /// Sets of different length, or values that are negative or not finite.
    pub fn between(estimates: &[f64], references: &[f64]) -> Result<Self, MetricsError> {
        check("estimates", estimates, references.len())?;
        check("references", references, references.len())?;
        let mut errors = Self::default();
        for (estimate, reference) in estimates.iter().zip(references) {
            // The difference is computed first, because it is exact where the two are close.
            errors.push(estimate - reference, *reference);
        }
        Ok(errors)
    }

    /// Adds the error `difference / scale`, or counts an unlit query where `scale` is 0. Both must be finite,
    /// and `scale` not negative.
    pub(super) fn push(&mut self, difference: f64, scale: f64) {
        if scale == 0.0 {
            self.unlit += 1;
            self.unlit_but_estimated += u64::from(difference > 0.0);
            return;
        }
        let error = difference / scale;
        self.signed.push(error);
        self.magnitudes.push(error.abs());
    }

    /// Adds the errors of another set.
    pub fn merge(&mut self, other: Self) {
        self.magnitudes.extend(other.magnitudes);
        self.signed.merge(&other.signed);
        self.unlit += other.unlit;
        self.unlit_but_estimated += other.unlit_but_estimated;
    }

    /// Only [`RelativeSummary::rms`], without the sorting that the quantiles need.
    pub(super) fn rms(&self) -> Result<f64, MetricsError> {
        match self.signed.count() {
            0 => Err(MetricsError::NothingCompared),
            _ => Ok(self.signed.rms()),
        }
    }

    /// The statistics over all errors.
    ///
    /// # Errors
    /// [`MetricsError::NothingCompared`] where no reference was over 0.
    pub fn summary(&self) -> Result<RelativeSummary, MetricsError> {
        let mut sorted = self.magnitudes.clone();
        sorted.sort_unstable_by(f64::total_cmp);
        let max = *sorted.last().ok_or(MetricsError::NothingCompared)?;
        Ok(RelativeSummary {
            compared: self.signed.count(),
            unlit: self.unlit,
            unlit_but_estimated: self.unlit_but_estimated,
            rms: self.signed.rms(),
            median: quantile(&sorted, 0.5),
            p95: quantile(&sorted, 0.95),
            p99: quantile(&sorted, 0.99),
            max,
            bias: self.signed.mean(),
        })
    }
}

/// The quantile of sorted values, of which there is at least one, with linear interpolation between
/// neighbours: type 7 of Hyndman and Fan (1996), numpy's default.
fn quantile(sorted: &[f64], part: f64) -> f64 {
    let place = part * (sorted.len() - 1) as f64;
    let low = place.floor() as usize;
    let high = (low + 1).min(sorted.len() - 1);
    sorted[low] + (place - low as f64) * (sorted[high] - sorted[low])
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn summary(estimates: &[f64], references: &[f64]) -> RelativeSummary {
        let errors = RelativeErrors::between(estimates, references).unwrap();
        errors.summary().unwrap()
    }

    #[test]
    fn a_set_by_hand() {
        let s = summary(&[1.5, 3.0, 0.0, 4.0, 1.0], &[1.0, 4.0, 2.0, 4.0, 0.0]);
        // Errors 0.5, -0.25, -1, 0; the last query is unlit.
        assert_eq!((s.compared, s.unlit, s.unlit_but_estimated), (4, 1, 1));
        assert_eq!((s.max, s.median, s.bias), (1.0, 0.375, -0.1875));
        // A few roundings.
        assert!((s.rms - (1.3125f64 / 4.0).sqrt()).abs() < 1e-15);
        assert!((s.p95 - (0.5 + 0.85 * 0.5)).abs() < 1e-15);
        assert!((s.p99 - (0.5 + 0.97 * 0.5)).abs() < 1e-15);
    }

    #[test]
    fn a_constant_factor_is_every_figure() {
        let references: Vec<f64> = (1..=1000).map(f64::from).collect();
        let estimates: Vec<f64> = references.iter().map(|r| r * 1.25).collect();
        let s = summary(&estimates, &references);
        for figure in [s.rms, s.median, s.p95, s.p99, s.max, s.bias] {
            // 1.25 is exact; the mean of equal numbers rounds a little.
            assert!((figure - 0.25).abs() < 1e-14);
        }
    }

    #[test]
    fn nothing_and_nonsense_are_errors() {
        let empty = RelativeErrors::between(&[], &[]).unwrap();
        assert_eq!(empty.summary(), Err(MetricsError::NothingCompared));
        let unlit = RelativeErrors::between(&[1.0], &[0.0]).unwrap();
        assert_eq!(unlit.summary(), Err(MetricsError::NothingCompared));
        let error = RelativeErrors::between(&[1.0], &[1.0, 2.0]).unwrap_err();
        assert!(matches!(
            error,
            MetricsError::Length {
                found: 1,
                expected: 2,
                ..
            }
        ));
        for bad in [f64::NAN, f64::INFINITY, -1.0] {
            for (a, b) in [(bad, 1.0), (1.0, bad)] {
                let error = RelativeErrors::between(&[1.0, a], &[1.0, b]).unwrap_err();
                assert!(
                    matches!(error, MetricsError::Value { query: 1, .. }),
                    "{error}"
                );
            }
        }
    }

    fn pairs() -> impl Strategy<Value = Vec<(f64, f64)>> {
        prop::collection::vec((0.0..10.0f64, 0.1..10.0f64), 1..50)
    }

    fn of(pairs: &[(f64, f64)], scale: f64) -> RelativeSummary {
        let (a, b): (Vec<f64>, Vec<f64>) =
            pairs.iter().map(|(a, b)| (a * scale, b * scale)).unzip();
        summary(&a, &b)
    }

    proptest! {
        #[test]
        fn equal_sets_have_no_error(pairs in pairs()) {
            let values: Vec<f64> = pairs.iter().map(|p| p.1).collect();
            let s = summary(&values, &values);
            prop_assert_eq!((s.rms, s.max, s.bias), (0.0, 0.0, 0.0));
        }

        #[test]
        fn a_power_of_two_on_both_changes_no_bit(pairs in pairs(), exponent in -40..40) {
            prop_assert_eq!(of(&pairs, 1.0), of(&pairs, f64::from(exponent).exp2()));
        }

        #[test]
        fn the_order_does_not_matter(pairs in pairs()) {
            let mut reversed = pairs.clone();
            reversed.reverse();
            let (a, b) = (of(&pairs, 1.0), of(&reversed, 1.0));
            prop_assert_eq!((a.median, a.p95, a.p99, a.max), (b.median, b.p95, b.p99, b.max));
            // Errors to 100 by 50 roundings in another order.
            prop_assert!((a.rms - b.rms).abs() < 1e-11 && (a.bias - b.bias).abs() < 1e-11);
        }

        #[test]
        fn figures_are_ordered(pairs in pairs()) {
            let s = of(&pairs, 1.0);
            prop_assert!(s.median <= s.p95 && s.p95 <= s.p99 && s.p99 <= s.max);
            // Equal where all errors are; then rounding decides.
            prop_assert!(s.bias.abs() <= s.rms * (1.0 + 1e-12));
            prop_assert!(s.rms <= s.max * (1.0 + 1e-12));
        }

        #[test]
        fn merged_sets_are_one_set(pairs in pairs(), cut in 0usize..50) {
            let cut = cut.min(pairs.len());
            let errors = |part: &[(f64, f64)]| {
                let (a, b): (Vec<f64>, Vec<f64>) = part.iter().copied().unzip();
                RelativeErrors::between(&a, &b).unwrap()
            };
            let mut merged = errors(&pairs[..cut]);
            merged.merge(errors(&pairs[cut..]));
            let (a, b) = (merged.summary().unwrap(), of(&pairs, 1.0));
            prop_assert_eq!((a.compared, a.p95, a.max), (b.compared, b.p95, b.max));
            prop_assert!((a.rms - b.rms).abs() < 1e-11);
        }
    }
}
