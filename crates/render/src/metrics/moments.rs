//! Mean and variance of a sequence of values.

/// Count, mean and spread of a sequence of values, by Welford's recurrence (1962), which has no cancellation.
/// Two of them merge by Chan, Golub and LeVeque (1979).
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Moments {
    count: u64,
    mean: f64,
    /// The sum of squared distances from the mean.
    squares: f64,
}

impl Moments {
    /// The moments of `count` values with that mean and that sum of squared distances from it.
    pub(crate) fn of(count: u64, mean: f64, squares: f64) -> Self {
        Self {
            count,
            mean,
            squares,
        }
    }

    /// Adds one value.
    pub fn push(&mut self, value: f64) {
        self.count += 1;
        let distance = value - self.mean;
        self.mean += distance / self.count as f64;
        self.squares += distance * (value - self.mean);
    }

    /// Adds all values of `other`.
    pub fn merge(&mut self, other: &Self) {
        if other.count == 0 {
            return;
        }
        let (a, b) = (self.count as f64, other.count as f64);
        let distance = other.mean - self.mean;
        self.count += other.count;
        self.mean += distance * b / (a + b);
        self.squares += other.squares + distance * distance * a * b / (a + b);
    }

    /// The number of values.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count
    }

    /// The mean of the values; 0 where there are none.
    #[must_use]
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// The unbiased variance, divided by count - 1; `None` for fewer than two values.
    #[must_use]
    pub fn variance(&self) -> Option<f64> {
        (self.count >= 2).then(|| self.squares / (self.count - 1) as f64)
    }

    /// The root of the mean square of the values.
    #[must_use]
    pub fn rms(&self) -> f64 {
        let variance = self.squares / self.count.max(1) as f64;
        (self.mean * self.mean + variance).sqrt()
    }
}

impl FromIterator<f64> for Moments {
    fn from_iter<I: IntoIterator<Item = f64>>(values: I) -> Self {
        let mut moments = Self::default();
        values.into_iter().for_each(|value| moments.push(value));
        moments
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn small_sets_by_hand() {
        let moments = Moments::from_iter([1.0, 2.0, 6.0]);
        assert_eq!((moments.count(), moments.mean()), (3, 3.0));
        assert_eq!(moments.variance(), Some(7.0));
        // One rounding each of a square, a sum and a root.
        assert!((moments.rms() - (41.0f64 / 3.0).sqrt()).abs() < 1e-15 * 4.0);
        assert_eq!(Moments::from_iter([5.0]).variance(), None);
    }

    #[test]
    fn a_large_offset_does_not_cancel() {
        // The textbook formula, mean of squares less square of mean, loses all digits here.
        let moments = Moments::from_iter([1e9 + 4.0, 1e9 + 7.0, 1e9 + 13.0, 1e9 + 16.0]);
        assert_eq!(moments.variance(), Some(30.0));
    }

    proptest! {
        #[test]
        fn merging_is_as_good_as_one_stream(
            a in prop::collection::vec(-1e3..1e3f64, 0..40),
            b in prop::collection::vec(-1e3..1e3f64, 1..40),
        ) {
            let mut merged = Moments::from_iter(a.iter().copied());
            merged.merge(&Moments::from_iter(b.iter().copied()));
            let all = Moments::from_iter(a.iter().chain(&b).copied());
            prop_assert_eq!(merged.count(), all.count());
            // 80 roundings of values to 1e3, and of their squares.
            prop_assert!((merged.mean() - all.mean()).abs() < 1e-10);
            prop_assert!((merged.rms() - all.rms()).abs() < 1e-9);
        }
    }
}
