//! The k nearest photons in integers: bisection on the squared radius with the count channel.
//!
//! A gather at `radius_sq` returns the number of photons with d^2 <= radius_sq. This count never falls as
//! `radius_sq` grows. So the smallest `radius_sq` with a count of at least k is exactly the squared distance
//! of the k-th photon. The search takes one gather for each bit of `radius_sq`, plus one.

/// The result of a bisection.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Bisection {
    /// The smallest squared radius whose count is at least k: d_k^2 in the machine's steps.
    pub radius_sq: u64,
    /// The count at this radius: k, or more where several photons are at the distance of the k-th.
    pub count: u64,
    /// The number of gathers made.
    pub gathers: u32,
}

/// The search for the k nearest, gather by gather: gather at [`Self::next`], tell the count, and so on until there is no next.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Search {
    k: u64,
    /// The count at each radius below is less than k.
    low: u64,
    /// The count at this radius is `at_high`.
    high: u64,
    /// At least k; none before the first gather, and where even the largest radius has fewer.
    at_high: Option<u64>,
    gathers: u32,
}

impl Search {
    /// A search for k photons with a squared radius of at most `max_radius_sq`.
    pub(crate) fn new(k: u64, max_radius_sq: u64) -> Self {
        Self {
            k,
            low: 0,
            high: max_radius_sq,
            at_high: None,
            gathers: 0,
        }
    }

    /// The squared radius of the next gather; none where the search is over.
    pub(crate) fn next(&self) -> Option<u64> {
        match self.at_high {
            None => (self.gathers == 0).then_some(self.high),
            Some(_) => (self.low < self.high).then(|| self.low.midpoint(self.high)),
        }
    }

    /// Whether a gather with that count has k photons.
    pub(crate) fn is_enough(&self, count: u64) -> bool {
        count >= self.k
    }

    /// Tells the count of the next gather.
    pub(crate) fn tell(&mut self, count: u64) {
        let Some(radius_sq) = self.next() else {
            return;
        };
        self.gathers += 1;
        if self.is_enough(count) {
            (self.high, self.at_high) = (radius_sq, Some(count));
        } else if self.at_high.is_some() {
            self.low = radius_sq + 1;
        }
    }

    /// What was found when the search is over; `None` where even the largest radius has fewer than k photons.
    pub(crate) fn found(&self) -> Option<Bisection> {
        self.at_high.map(|count| Bisection {
            radius_sq: self.high,
            count,
            gathers: self.gathers,
        })
    }
}

/// The smallest `radius_sq` from 0 to `max_radius_sq` with `count(radius_sq) >= k`, in at most
/// 1 + bits gathers (bits: the length of `max_radius_sq` in binary); `None`, after one
/// gather, where even the largest has fewer photons.
///
/// `count` must not fall as its argument grows, as is true of any gather. For the open disc
/// that [`crate::Neighbourhood::k_nearest`] sums, keep the sums of the last gather with fewer than
/// k: it was at the result less 1, unless that is 0.
///
/// # Errors
/// The error of `count`, at once.
pub fn smallest_radius_sq<E>(
    k: u64,
    max_radius_sq: u64,
    mut count: impl FnMut(u64) -> Result<u64, E>,
) -> Result<Option<Bisection>, E> {
    let mut search = Search::new(k, max_radius_sq);
    while let Some(radius_sq) = search.next() {
        search.tell(count(radius_sq)?);
    }
    Ok(search.found())
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use proptest::prelude::*;

    use super::*;

    fn bisect(distances_sq: &[u64], k: u64, max: u64) -> Option<Bisection> {
        let count = |radius_sq| {
            let inside = distances_sq.iter().filter(|d| **d <= radius_sq);
            Ok::<_, Infallible>(inside.count() as u64)
        };
        smallest_radius_sq(k, max, count).unwrap()
    }

    #[test]
    fn the_kth_distance_is_found_and_ties_are_counted() {
        let distances = [9, 4, 4, 25, 0];
        let found = |k| bisect(&distances, k, 30).map(|b| (b.radius_sq, b.count));
        assert_eq!(found(1), Some((0, 1)));
        assert_eq!(found(2), Some((4, 3)));
        assert_eq!(found(3), Some((4, 3)));
        assert_eq!(found(5), Some((25, 5)));
        assert_eq!(found(6), None);
    }

    #[test]
    fn the_ends_of_the_range_work() {
        let max = u64::MAX;
        assert_eq!(bisect(&[max], 1, max).unwrap().radius_sq, max);
        assert_eq!(bisect(&[0], 1, max).unwrap().radius_sq, 0);
        let one = bisect(&[0], 1, 0).unwrap();
        assert_eq!((one.radius_sq, one.gathers), (0, 1));
        assert_eq!(bisect(&[1], 1, 0), None);
        assert_eq!(bisect(&[], 0, 7).unwrap().radius_sq, 0);
    }

    #[test]
    fn a_refused_gather_is_passed_on() {
        let result = smallest_radius_sq(1, 7, |_| Err("refused"));
        assert_eq!(result, Err("refused"));
    }

    proptest! {
        #[test]
        fn it_is_minimal_within_bits_plus_one_gathers(
            distances in prop::collection::vec(0u64..5000, 1..60),
            k in 1u64..60,
            max in 0u64..5000,
        ) {
            let mut sorted = distances.clone();
            sorted.sort_unstable();
            let kth = sorted.get(k as usize - 1).copied().filter(|d| *d <= max);
            let found = bisect(&distances, k, max);
            prop_assert_eq!(found.map(|b| b.radius_sq), kth);
            if let Some(found) = found {
                let bits = u64::BITS - max.leading_zeros();
                prop_assert!(found.gathers <= bits + 1);
                let inside = distances.iter().filter(|d| **d <= found.radius_sq);
                prop_assert_eq!(found.count, inside.count() as u64);
            }
        }
    }
}
