//! Counts photons that two engines decide differently.

use std::ops::AddAssign;

use super::error::MetricsError;

/// The share of the photons in range that u steps per radius misclassify, times u, for evenly spread photons;
/// measured on a uniform scene.
pub const MISCLASSIFIED_TIMES_STEPS: f64 = 0.67;

/// Counts of photon tests and of the disagreements among them.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Misclassified {
    /// The number of photon tests.
    pub tests: u64,
    /// The number of photons in range by the reference.
    pub in_range: u64,
    /// The number of photons in range only by the machine.
    pub gained: u64,
    /// The number of photons in range only by the reference.
    pub lost: u64,
}

impl Misclassified {
    /// Adds one photon test: whether it is in range by the reference, and by the machine.
    pub fn push(&mut self, by_reference: bool, by_machine: bool) {
        self.tests += 1;
        self.in_range += u64::from(by_reference);
        self.gained += u64::from(by_machine && !by_reference);
        self.lost += u64::from(by_reference && !by_machine);
    }

    /// The number of photons that are in range by only one of the two.
    #[must_use]
    pub fn photons(&self) -> u64 {
        self.gained + self.lost
    }

    /// Misclassified photons in per cent of those in range by the reference.
    ///
    /// # Errors
    /// [`MetricsError::NothingInRange`] where the reference has no photon in range.
    pub fn percent(&self) -> Result<f64, MetricsError> {
        match self.in_range {
            0 => Err(MetricsError::NothingInRange),
            in_range => Ok(100.0 * self.photons() as f64 / in_range as f64),
        }
    }
}

impl AddAssign for Misclassified {
    fn add_assign(&mut self, other: Self) {
        self.tests += other.tests;
        self.in_range += other.in_range;
        self.gained += other.gained;
        self.lost += other.lost;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_kind_is_counted() {
        let mut counts = Misclassified::default();
        assert_eq!(counts.percent(), Err(MetricsError::NothingInRange));
        for (reference, machine) in [(true, true), (true, false), (false, true), (false, false)] {
            counts.push(reference, machine);
        }
        assert_eq!((counts.tests, counts.in_range, counts.photons()), (4, 2, 2));
        counts += counts;
        assert_eq!((counts.gained, counts.lost), (2, 2));
        assert_eq!(counts.percent(), Ok(100.0));
    }
}
