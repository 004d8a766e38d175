//! The chi-square rule: the radius of a pixel, by a test whether the photons in its range are spread evenly.
//!
//! After Lin, Li, Zeng, Zhang, Jia, Wang and Manocha, "CPPM: Chi-squared Progressive Photon Mapping" (2020): where photons are spread
//! evenly over the disc, the estimate has no bias, and a smaller radius would only add noise. So the photons of a pixel are counted over
//! the passes by sectors of equal area, and the squared radius is halved when a chi-square test says that they are not even. The counts
//! then start anew, and the next test needs more photons, so that each radius is decided with more certainty than the one before.
//!
//! The sectors are two rings of four quadrants ([`crate::estimate::Sectors`]), which do as well as the paper's six sectors in two rings. A test
//! that finds nothing waits until there are twice as many photons: a test after each pass would reject even light in the end.

use std::sync::LazyLock;

use serde::{Deserialize, Serialize};
use statrs::distribution::{ChiSquared, ContinuousCDF};

use crate::estimate::{SECTORS, Sectors};

/// The probability with which a test rejects photons that are spread evenly.
const SIGNIFICANCE: f64 = 0.01;

/// The photons of the first test: five in each sector, from which the sum is distributed as chi-square (Cochran, 1952).
const FIRST: f64 = 5.0 * SECTORS as f64;

/// The factor on the photons of the first test at each next radius; the paper's.
const GROWTH: f64 = 1.5625;

/// The most times that a squared radius is halved: to a radius of 1/32.
const MOST: u8 = 10;

/// The chi-square that is exceeded with the probability [`SIGNIFICANCE`].
static LIMIT: LazyLock<f64> = LazyLock::new(|| {
    let freedom = (SECTORS - 1) as f64;
    let distribution = ChiSquared::new(freedom).expect("more than one sector");
    distribution.inverse_cdf(1.0 - SIGNIFICANCE)
});

/// The radius of a pixel, and the photons in range since it has that radius.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Uniformity {
    /// How many times the squared radius is halved.
    pub halvings: u8,
    counts: [u64; SECTORS],
    /// How many tests at this radius found nothing; each doubles the photons of the next.
    even: u8,
}

impl Uniformity {
    /// Adds the photons of a pass. Halves the squared radius, if it was halved less than `most` times, where a test says so.
    pub fn push(&mut self, sectors: &Sectors, most: u8) {
        for (count, new) in self.counts.iter_mut().zip(sectors) {
            *count += u64::from(*new);
        }
        let total: u64 = self.counts.iter().sum();
        let needed = FIRST * GROWTH.powi(self.halvings.into()) * 2f64.powi(self.even.into());
        if self.halvings >= most.min(MOST) || (total as f64) < needed {
            return;
        }
        match chi_square(&self.counts) > *LIMIT {
            true => {
                *self = Self {
                    halvings: self.halvings + 1,
                    ..Self::default()
                }
            }
            false => self.even += 1,
        }
    }
}

/// The sum of (n - e)^2 / e over the sectors, with e the mean of the counts n; 0 without photons.
fn chi_square(counts: &[u64; SECTORS]) -> f64 {
    let total = counts.iter().sum::<u64>() as f64;
    let expected = total / SECTORS as f64;
    let squares = counts
        .iter()
        .map(|count| (*count as f64 - expected).powi(2));
    squares.sum::<f64>() / expected.max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;

    #[test]
    fn the_statistic_and_its_limit_are_those_of_the_tables() {
        // 10 expected: (25 + 25) / 10.
        assert_eq!(chi_square(&[15, 5, 10, 10, 10, 10, 10, 10]), 5.0);
        assert_eq!(chi_square(&[7; SECTORS]), 0.0);
        assert_eq!(chi_square(&[0; SECTORS]), 0.0);
        // Tables of chi-square with 7 degrees of freedom, 1 %: 18.475.
        assert!((*LIMIT - 18.475).abs() < 5e-4, "{}", *LIMIT);
    }

    /// Photons spread over the sectors, each with the share `shares` of them.
    fn spread(rng: &mut Pcg64Mcg, photons: u32, shares: [f64; SECTORS]) -> Sectors {
        let mut counts = Sectors::default();
        for _ in 0..photons {
            let mut at = rng.random::<f64>();
            let sector = shares.iter().position(|share| {
                at -= share;
                at < 0.0
            });
            counts[sector.unwrap_or(SECTORS - 1)] += 1;
        }
        counts
    }

    const EVEN: [f64; SECTORS] = [1.0 / SECTORS as f64; SECTORS];

    #[test]
    fn even_photons_are_rejected_as_often_as_the_significance_says() {
        const PIXELS: u32 = 40_000;
        let mut rng = Pcg64Mcg::seed_from_u64(1);
        for photons in [40, 1000] {
            let rejected = (0..PIXELS).filter(|_| {
                let mut pixel = Uniformity::default();
                pixel.push(&spread(&mut rng, photons, EVEN), MOST);
                pixel.halvings == 1
            });
            let rate = rejected.count() as f64 / f64::from(PIXELS);
            // The deviation of the rate is 5 %; five expected in a sector make the distribution itself a few percent off.
            assert!((rate / SIGNIFICANCE - 1.0).abs() < 0.2, "{photons}: {rate}");
        }
    }

    #[test]
    fn uneven_photons_halve_the_squared_radius_and_the_next_test_needs_more() {
        // A border through the middle: no photons in two of the quadrants.
        let border = [10, 10, 0, 0, 10, 10, 0, 0];
        let mut pixel = Uniformity::default();
        pixel.push(&border.map(|count| count / 2), MOST);
        assert_eq!(pixel.halvings, 0, "20 photons are no test");
        pixel.push(&border.map(|count| count / 2), MOST);
        assert_eq!(pixel.halvings, 1);
        // 62.5 photons.
        pixel.push(&border, MOST);
        assert_eq!(pixel.halvings, 1);
        pixel.push(&border, MOST);
        assert_eq!(pixel.halvings, 2);
        (0..100).for_each(|_| pixel.push(&border, 3));
        assert_eq!(pixel.halvings, 3, "no more than are allowed");
    }

    #[test]
    fn a_small_unevenness_is_found_in_the_end() {
        // A tenth more in the inner ring than in the outer.
        let shares = [0, 1, 2, 3, 4, 5, 6, 7].map(|sector| (21 - 2 * (sector / 4)) as f64 / 160.0);
        let mut rng = Pcg64Mcg::seed_from_u64(2);
        let mut pixel = Uniformity::default();
        pixel.push(&spread(&mut rng, 100, shares), MOST);
        assert_eq!(pixel.halvings, 0);
        // Its chi-square grows as the photons by 400: 18 after some 7400.
        (0..500).for_each(|_| pixel.push(&spread(&mut rng, 100, shares), 1));
        assert_eq!(pixel.halvings, 1);
    }
}
