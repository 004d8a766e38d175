//! The scene's own Monte-Carlo noise.

use super::error::{MetricsError, check};
use super::moments::Moments;

/// Measures the scatter of the queries' estimates between independently traced photon maps (different seeds,
/// with equal radius and number of photons).
#[derive(Debug, Clone, PartialEq)]
pub struct NoiseMeter {
    queries: Vec<Moments>,
}

/// The largest relative noise of a query that is not left out. With fewer than some 4 photons in range a
/// query has no meaningful estimate. On a scene with large dark parts, such as a caustic's, these queries
/// would dominate both the noise and the error (a query that one of n maps lights has a relative deviation of
/// sqrt(n) and, where that photon is misclassified, an error of n), and a handful of photons would decide the
/// quotient.
pub const MAX_QUERY_NOISE: f64 = 0.5;

/// The noise of a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Noise {
    /// The rms over sampled queries of standard deviation by mean; 1 is 100 %.
    ///
    /// The variance is unbiased. Its quotient by the squared mean of the same n maps is too large
    /// by about 3 relative^2 / n of itself: below 1 % for 8 maps at 15 %.
    pub relative: f64,
    /// The number of queries measured: those with light whose deviation is at most [`MAX_QUERY_NOISE`].
    pub queries: u64,
    /// The number of queries left out because their deviation is larger.
    pub queries_too_noisy: u64,
    /// The number of independent maps.
    pub maps: u64,
}

impl NoiseMeter {
    /// A meter for `queries` queries.
    #[must_use]
    pub fn new(queries: usize) -> Self {
        Self {
            queries: vec![Moments::default(); queries],
        }
    }

    /// Adds one map's estimates, in the order of the queries.
    ///
    /// # Errors
    /// Another number of queries, or a value that is negative or not finite.
    pub fn push_map(&mut self, estimates: &[f64]) -> Result<(), MetricsError> {
        check("estimates", estimates, self.queries.len())?;
        for (moments, estimate) in self.queries.iter_mut().zip(estimates) {
            moments.push(*estimate);
        }
        Ok(())
    }

    /// The standard deviation of one query over its mean, 1 is 100 %. `None` for fewer than two maps, without
    /// light, or without such a query.
    #[must_use]
    pub fn of_query(&self, query: usize) -> Option<f64> {
        self.queries.get(query).and_then(relative_deviation)
    }

    /// The mean of one query over the maps, which is its expected light; 0 where there is no map.
    ///
    /// # Panics
    /// Where there is no such query.
    #[must_use]
    pub fn mean_of_query(&self, query: usize) -> f64 {
        self.queries[query].mean()
    }

    /// Whether the query has light and is known well enough: its deviation over its mean is at most
    /// [`MAX_QUERY_NOISE`].
    #[must_use]
    pub fn is_sampled(&self, query: usize) -> bool {
        self.of_query(query).is_some_and(is_moderate)
    }

    /// The noise over the sampled queries.
    ///
    /// # Errors
    /// Fewer than two maps, or no sampled query.
    pub fn noise(&self) -> Result<Noise, MetricsError> {
        let maps = self.queries.first().map_or(0, Moments::count);
        if !self.queries.is_empty() && maps < 2 {
            return Err(MetricsError::TooFewMaps { found: maps });
        }
        let deviations = || self.queries.iter().filter_map(relative_deviation);
        let pooled: Moments = deviations().filter(|d| is_moderate(*d)).collect();
        if pooled.count() == 0 {
            return Err(MetricsError::NothingCompared);
        }
        Ok(Noise {
            relative: pooled.rms(),
            queries: pooled.count(),
            queries_too_noisy: deviations().count() as u64 - pooled.count(),
            maps,
        })
    }
}

fn is_moderate(deviation: f64) -> bool {
    deviation <= MAX_QUERY_NOISE
}

fn relative_deviation(moments: &Moments) -> Option<f64> {
    let variance = moments.variance().filter(|_| moments.mean() > 0.0)?;
    Some(variance.sqrt() / moments.mean())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn noise(maps: &[Vec<f64>]) -> Result<Noise, MetricsError> {
        let mut meter = NoiseMeter::new(maps[0].len());
        for map in maps {
            meter.push_map(map)?;
        }
        meter.noise()
    }

    #[test]
    fn two_maps_by_hand() {
        // Deviations sqrt 2 / 4 of the mean and 0; one over the limit; one without light.
        let found = noise(&[vec![3.0, 5.0, 1.0, 0.0], vec![5.0, 5.0, 3.0, 0.0]]).unwrap();
        assert_eq!(
            (found.queries, found.queries_too_noisy, found.maps),
            (2, 1, 2)
        );
        // The rms of the first two, a quarter.
        assert!((found.relative - 0.25).abs() < 1e-15);
    }

    #[test]
    fn one_map_or_no_light_is_an_error() {
        let error = |maps: &[Vec<f64>]| noise(maps).unwrap_err();
        assert_eq!(error(&[vec![1.0]]), MetricsError::TooFewMaps { found: 1 });
        assert_eq!(
            error(&[vec![0.0], vec![0.0]]),
            MetricsError::NothingCompared
        );
        assert_eq!(error(&[vec![], vec![]]), MetricsError::NothingCompared);
        let lengths = noise(&[vec![1.0], vec![1.0, 2.0]]);
        assert!(matches!(lengths, Err(MetricsError::Length { .. })));
        assert_eq!(NoiseMeter::new(1).of_query(1), None);
    }

    proptest! {
        #[test]
        fn scale_and_order_of_maps_do_not_matter(
            maps in prop::collection::vec(prop::collection::vec(1.0..1.5f64, 6), 2..10),
            scale in 1e-6..1e6f64,
        ) {
            let base = noise(&maps).unwrap().relative;
            let mut other: Vec<Vec<f64>> = maps
                .iter()
                .map(|map| map.iter().map(|value| value * scale).collect())
                .collect();
            other.reverse();
            // Ten roundings relative to values about 1.
            prop_assert!((noise(&other).unwrap().relative - base).abs() < 1e-13);
        }
    }
}
