//! Estimates from the machine's own gather, at any squared radius up to the search radius.
//!
//! A gather of a machine sums, for a `radius_sq`, power and number of the photons with d^2 <= radius_sq. The
//! estimates here combine the sums of one or several gathers.

use glam::DVec3;
use photoncube_model::Gathered;

use super::bisection::Search;
use super::gather::{Estimate, disc_area};
use super::ladder::Ladder;
use crate::quantise::QuantisedMap;

/// The result of one gather.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Disc {
    /// The flux of the photons in range.
    pub power: DVec3,
    /// The number of photons tested.
    pub tests: u64,
    /// The least number of these photons that the fast gather decided by their block or leaf.
    pub skipped: u64,
    /// The number of photons in range.
    pub count: u64,
}

impl Disc {
    /// The sums of a gather, converted to floats.
    pub fn of(map: &QuantisedMap<'_>, gathered: &Gathered) -> Self {
        Self {
            power: map.flux(gathered.sums.power),
            tests: gathered.photons,
            // Leaves that were tested may have photons beyond the blocks around the query.
            skipped: gathered.photons.saturating_sub(gathered.tests),
            count: gathered.sums.count,
        }
    }
}

/// The result of the search for the k-th nearest photon, in a machine's steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct KNearest {
    /// The squared radius of the disc whose area the estimate divides by: d_k^2, rounded up to a whole step.
    pub radius_sq: u32,
    /// The photons with d^2 < d_k^2.
    pub disc: Disc,
    /// The number of gathers made.
    pub gathers: u64,
}

/// The search radius of a query in the steps of its engine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Steps {
    /// The largest `radius_sq` of a gather.
    pub radius_sq: u32,
    /// The search radius squared, not rounded to a whole step.
    pub exact_radius_sq: f64,
    /// The area of the disc of the search radius (scene units squared).
    pub disc_area: f64,
}

impl Steps {
    /// The search radius of the queries of a map.
    pub fn of(map: &QuantisedMap<'_>) -> Self {
        Self {
            radius_sq: map.radius_sq(),
            exact_radius_sq: map.exact_radius_sq(),
            disc_area: disc_area(map.map()),
        }
    }

    /// The area of the disc of `radius_sq` in scene units squared. At the search radius it equals
    /// `disc_area`, bit for bit.
    fn area_of(&self, radius_sq: u32) -> f64 {
        self.disc_area * (f64::from(radius_sq) / self.exact_radius_sq)
    }

    /// Estimates from one gather at the search radius.
    ///
    /// # Errors
    /// The error of `gather`.
    pub fn fixed_radius<E>(
        &self,
        gather: impl FnMut(u32) -> Result<Disc, E>,
    ) -> Result<Estimate, E> {
        at(self.radius_sq, self.disc_area, gather)
    }

    /// Estimates from one gather at the squared search radius, halved `times` times.
    ///
    /// # Errors
    /// The error of `gather`.
    pub fn halved<E>(
        &self,
        times: u32,
        gather: impl FnMut(u32) -> Result<Disc, E>,
    ) -> Result<Estimate, E> {
        let radius_sq = self.halved_radius_sq(times);
        at(radius_sq, self.area_of(radius_sq), gather)
    }

    /// The squared search radius, halved `times` times, in whole steps, at least one.
    pub fn halved_radius_sq(&self, times: u32) -> u32 {
        self.radius_sq.checked_shr(times).unwrap_or(0).max(1)
    }

    /// Estimates at the k-th photon.
    ///
    /// # Errors
    /// The error of `gather`.
    pub fn k_nearest<E>(
        &self,
        k: u64,
        gather: impl FnMut(u32) -> Result<Disc, E>,
    ) -> Result<Estimate, E> {
        Ok(self.of_nearest(&k_nearest(k, self.radius_sq, gather)?))
    }

    /// The estimate at the k-th photon that was found.
    pub fn of_nearest(&self, found: &KNearest) -> Estimate {
        Estimate {
            irradiance: found.disc.power / self.area_of(found.radius_sq),
            tests: found.disc.tests,
            skipped: 0,
            in_range: found.disc.count,
            gathers: found.gathers,
        }
    }

    /// Estimates with a ladder. Each rung is divided by the area of its own rounded radius, so that the
    /// rounding causes no bias.
    ///
    /// # Errors
    /// The error of `gather`.
    pub fn ladder<E>(
        &self,
        ladder: &Ladder,
        mut gather: impl FnMut(u32) -> Result<Disc, E>,
    ) -> Result<Estimate, E> {
        let mut sum = Estimate::default();
        let radii = ladder.radii_sq(self.radius_sq);
        for (rung, radius_sq) in ladder.rungs().iter().zip(radii) {
            let disc = gather(radius_sq)?;
            sum.irradiance += rung.weight * (disc.power / self.area_of(radius_sq));
            (sum.tests, sum.in_range) = (disc.tests, disc.count);
            sum.skipped += disc.skipped;
            sum.gathers += 1;
        }
        Ok(sum)
    }
}

/// Estimates from one gather, divided by `area`.
fn at<E>(
    radius_sq: u32,
    area: f64,
    mut gather: impl FnMut(u32) -> Result<Disc, E>,
) -> Result<Estimate, E> {
    let disc = gather(radius_sq)?;
    Ok(Estimate {
        irradiance: disc.power / area,
        tests: disc.tests,
        skipped: disc.skipped,
        in_range: disc.count,
        gathers: 1,
    })
}

/// The k-th photon by bisection on the count, up to `max` (squared steps).
///
/// As in f64 ([`crate::Neighbourhood::k_nearest`]), the k-th photon and those that tie with it set the radius
/// and are not summed. The last gather with fewer than k, at one step less, has the sums of the nearer
/// photons, so no further gather is needed. Where `max` holds fewer than k, it is the radius and all photons
/// are summed. A disc without area has no density: where k photons are at distance 0, the radius is one step,
/// and they are summed.
///
/// # Errors
/// The error of `gather`.
pub(crate) fn k_nearest<E>(
    k: u64,
    max: u32,
    mut gather: impl FnMut(u32) -> Result<Disc, E>,
) -> Result<KNearest, E> {
    let mut search = NearestSearch::new(k, max);
    while let Some(radius_sq) = search.next() {
        search.tell(gather(radius_sq)?);
    }
    Ok(search.found())
}

/// The search of [`k_nearest`], gather by gather.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NearestSearch {
    search: Search,
    max: u32,
    /// The last gather with fewer than k photons, and the last with k or more.
    fewer: Disc,
    enough: Disc,
    gathers: u64,
}

impl NearestSearch {
    /// A search for the k-th photon, up to `max` (squared steps).
    pub fn new(k: u64, max: u32) -> Self {
        Self {
            search: Search::new(k, max.into()),
            max,
            fewer: Disc::default(),
            enough: Disc::default(),
            gathers: 0,
        }
    }

    /// The squared radius of the next gather; none where the search is over.
    pub fn next(&self) -> Option<u32> {
        // At most `max`, so it fits.
        self.search.next().map(|radius_sq| radius_sq as u32)
    }

    /// Tells what the next gather found.
    pub fn tell(&mut self, disc: Disc) {
        *(match self.search.is_enough(disc.count) {
            true => &mut self.enough,
            false => &mut self.fewer,
        }) = disc;
        self.gathers += 1;
        self.search.tell(disc.count);
    }

    /// What was found when the search is over.
    pub fn found(&self) -> KNearest {
        let found = self.search.found();
        let (radius_sq, disc) = match found.map(|found| found.radius_sq as u32) {
            None => (self.max, self.fewer),
            Some(0) => (1, self.enough),
            // The bisection ends only after a gather with fewer than k at one step less.
            Some(radius_sq) => (radius_sq, self.fewer),
        };
        KNearest {
            radius_sq,
            disc,
            gathers: self.gathers,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use proptest::prelude::*;

    use super::*;
    use crate::Kernel;

    const STEPS: Steps = Steps {
        radius_sq: 64516,
        exact_radius_sq: 64516.0,
        disc_area: 0.7,
    };

    /// A gather of photons of power 1 at these squared distances.
    fn among(distances: &[u32]) -> impl FnMut(u32) -> Result<Disc, Infallible> {
        move |radius_sq| {
            let count = distances.iter().filter(|d| **d <= radius_sq).count() as u64;
            Ok(Disc {
                power: DVec3::splat(count as f64),
                tests: distances.len() as u64,
                skipped: 0,
                count,
            })
        }
    }

    fn nearest(distances: &[u32], k: u64, max: u32) -> (u32, u64) {
        let found = k_nearest(k, max, among(distances)).unwrap();
        (found.radius_sq, found.disc.count)
    }

    #[test]
    fn the_kth_and_its_ties_are_not_summed() {
        let distances = [9, 4, 4, 25, 1];
        assert_eq!(nearest(&distances, 1, 30), (1, 0));
        assert_eq!(nearest(&distances, 2, 30), (4, 1));
        assert_eq!(nearest(&distances, 3, 30), (4, 1));
        assert_eq!(nearest(&distances, 5, 30), (25, 4));
    }

    #[test]
    fn too_few_are_the_search_radius_and_none_apart_are_one_step() {
        let too_few = k_nearest(3, 30, among(&[4, 30, 31])).unwrap();
        assert_eq!((too_few.radius_sq, too_few.disc.count), (30, 2));
        assert_eq!(too_few.gathers, 1);
        assert_eq!(nearest(&[0, 0, 5], 2, 30), (1, 2));
        assert_eq!(nearest(&[0, 0, 5], 2, 0), (1, 2));
    }

    #[test]
    fn a_refused_gather_is_passed_on() {
        let refuse = |_| Err::<Disc, _>("refused");
        assert_eq!(STEPS.k_nearest(1, refuse), Err("refused"));
        let ladder = Ladder::new(Kernel::Cone, 2).unwrap();
        assert_eq!(STEPS.ladder(&ladder, refuse), Err("refused"));
    }

    /// A ladder of one rung with the full radius equals the fixed radius, bit for bit.
    #[test]
    fn one_rung_is_the_fixed_radius() {
        let distances = [0, 17, 60000, 64516, 64517];
        let ladder = Ladder::new(Kernel::Rectangle, 1).unwrap();
        let sum = STEPS.ladder(&ladder, among(&distances)).unwrap();
        assert_eq!((sum.tests, sum.in_range, sum.gathers), (5, 4, 1));
        assert_eq!(sum.irradiance, DVec3::splat(4.0) / 0.7);
    }

    /// A photon on every squared step: a uniform density of 64516 on the search disc.
    #[test]
    fn a_uniform_field_is_its_density() {
        let distances: Vec<u32> = (1..=64516).collect();
        let ladder = Ladder::new(Kernel::Epanechnikov, 8).unwrap();
        let rungs = STEPS.ladder(&ladder, among(&distances)).unwrap();
        // Weights that add to 1 but for rounding.
        assert!((rungs.irradiance.x * 0.7 / 64516.0 - 1.0).abs() < 1e-12);
        let nearest = STEPS.k_nearest(101, among(&distances)).unwrap();
        // A few roundings. The disc of 100 steps with 100 photons is counted as one of 101.
        let density = nearest.irradiance.x * 0.7 / 64516.0;
        assert!((density - 100.0 / 101.0).abs() < 1e-12);
    }

    proptest! {
        /// The radius is the k-th of the sorted distances; the distances have few values, so that many tie.
        #[test]
        fn it_is_the_kth_of_the_sorted(
            distances in prop::collection::vec(1u32..60, 1..80),
            k in 1u64..80,
            max in 1u32..60,
        ) {
            let mut sorted = distances.clone();
            sorted.sort_unstable();
            let kth = sorted.get(k as usize - 1).copied().filter(|d| *d <= max);
            let found = k_nearest(k, max, among(&distances)).unwrap();
            prop_assert_eq!(found.radius_sq, kth.unwrap_or(max));
            let inside = |d: &&u32| kth.map_or(**d <= max, |kth| **d < kth);
            prop_assert_eq!(found.disc.count, distances.iter().filter(inside).count() as u64);
            prop_assert!(found.gathers <= u64::from(u32::BITS - max.leading_zeros() + 1));
        }
    }
}
