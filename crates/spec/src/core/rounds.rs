//! Rounds: a core whose queries each have a radius gathers a batch several times without the host.
//!
//! In such a core a *store of batches* is in front of each chain. It has [`Rounds::BATCHES`] places, each for a batch. It gives a
//! batch to the chain once for each of the batch's *rounds*, each time with other radii. Rounds of several batches may alternate, so that the
//! engines work on one batch while the results of another come back.
//!
//! # What the rounds are
//! R is the largest radius, [`crate::Numbers::largest_radius_word`], and B is the bits of R. [`super::CoreRegister::Nearest`] and
//! [`super::CoreRegister::Rungs`] decide in the clock in which the batch's last query is taken:
//! - *Nearest*, where `Nearest` is not 0: the batch has B rounds. k is `Nearest`. Each query has a number, which is at first 0. The
//!   *bit* of the first round is 2^(B-1), and of each further round half of that of the round before. The radius of a round is the
//!   number + the bit - 1, but at most R. Where the result has fewer than k photons, the number := the radius + 1, and the result's
//!   sums are kept. Only the last round gives a result. Its radius is the number, but at most R. Its sums are those that were kept
//!   last, or those of the last round where the number is 0.
//! - *Ladder*, where `Nearest` is 0 and `Rungs` is not: the batch has as many rounds as `Rungs` says, but at most
//!   [`Rounds::RUNGS`]. The radius of round i is [`super::CoreRegister::Rung`] i, but at most R. Each round gives a result.
//! - *Own*, where both are 0: the batch has one round. The radius is the query's own, but at most R, and the round gives a result.
//!
//! So the radius of a *nearest* result is the smallest with k photons, or R where no radius has as many. Its sums are those of one
//! step less, or of R. Where even the radius 0 has k photons, they are those of the radius 0.
//!
//! k and the rungs are read in each round, so they must not change while a query is under way. A query that is outside of its frame
//! has some radius in its result.
//!
//! # Each clock
//! The words of [`super`] hold. The places are numbered, and behind the last comes the first.
//! - *Taking.* The store takes the oldest query of the link to the chain where the place `fill` is empty, the store is not *held*, and there
//!   is no reset. The query goes behind those in that place. A batch is *complete* with a query that has `tlast`, and with as many queries
//!   as engines. `fill` := the next place with the last query. A batch *releases* where one of its queries has `release`. The store is
//!   held from the clock behind the last query of a batch that releases.
//! - *Giving.* The batch in the place `turn` *goes* where it is complete, a round of it is left, and it is of one of these:
//!   - the oldest with a round left, and a ladder, or none of its rounds is under way;
//!   - a nearest, none of its rounds is under way, its last is not the next, and it was given fewer rounds than the batch in the place
//!     before.
//!
//!   So rounds of a ladder follow each other, and those of nearests alternate. Of two batches, the older gives its last results first.
//!   The queries of a batch that goes are offered, one after the other, with the radius of the round, to a slice between the store and the chain.
//!   They have their `release` in the last round only. A round is under way with the last of its queries. `turn` := the next place with
//!   it, but not within a ladder. With the last round of a batch that releases, the store is no longer held. Where the batch in `turn`
//!   does not go, `turn` := the next place.
//! - *Results.* Behind each chain is a place for one result, then the store, then a second such place. The result in the first place
//!   is of the oldest round under way. It leaves that place where it gives no result or the second place is ready. With the last result
//!   of a round, the round is no longer under way. With that of the batch's last round, the batch's place is empty.
//! - A `reset` empties the store. It is then not held, and `fill` and `turn` are 0.

use super::{Core, CoreRegister};
use crate::formats::bits_for;

/// The numbers of the rounds of a core.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Rounds {
    /// R: the largest radius.
    pub largest: u32,
    /// B: the rounds of the k nearest.
    pub nearest: u32,
}

impl Rounds {
    /// Batches that the store in front of a chain has room for, a power of two.
    pub const BATCHES: usize = 4;
    /// The most rungs of a ladder, a power of two.
    pub const RUNGS: u32 = 8;
    /// Bits of the number of a round.
    pub const ROUND_BITS: u32 = 5;
    /// Bits of the number of rungs.
    pub const RUNGS_BITS: u32 = Self::RUNGS.ilog2() + 1;

    /// Those of a core; `None` where all queries have the format's radius.
    pub fn of(core: &Core) -> Option<Self> {
        let largest = core.machine.numbers.largest_radius_word();
        core.has_radii().then(|| Self {
            largest,
            nearest: bits_for(largest.into()),
        })
    }

    /// The most rounds of a batch.
    pub fn most(&self) -> u32 {
        self.nearest.max(Self::RUNGS)
    }
}

/// The rounds of all batches of some words.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum QueryRounds {
    /// One round, with the query's own radius, or the format's where queries have none.
    #[default]
    Own,
    /// A round for each of these radii, 1 to [`Rounds::RUNGS`] of them.
    Ladder(Vec<u32>),
    /// The rounds that find the radius with this number of photons.
    Nearest(u32),
}

impl QueryRounds {
    /// The results of each query.
    pub fn results(&self) -> usize {
        match self {
            Self::Own | Self::Nearest(_) => 1,
            Self::Ladder(radii) => radii.len(),
        }
    }

    /// The rounds of each batch of a core.
    pub fn rounds(&self, core: &Core) -> u32 {
        match (self, Rounds::of(core)) {
            (Self::Nearest(_), Some(rounds)) => rounds.nearest,
            _ => self.results() as u32,
        }
    }

    /// The words that a core's registers must have; none where the core has no rounds.
    pub fn registers(&self, core: &Core) -> Vec<(CoreRegister, u32)> {
        let (nearest, radii) = match self {
            Self::Own => (0, &[][..]),
            Self::Ladder(radii) => (0, &radii[..]),
            Self::Nearest(k) => (*k, &[][..]),
        };
        let of_rungs = (0..).map(CoreRegister::Rung).zip(radii.iter().copied());
        let modes = [
            (CoreRegister::Nearest, nearest),
            (CoreRegister::Rungs, radii.len() as u32),
        ];
        let all = of_rungs.chain(modes);
        all.filter(|_| core.has_radii()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machines::find_machine;

    #[test]
    fn a_core_has_rounds_where_queries_have_radii() {
        let rounds = |name: &str| Rounds::of(&Core::new(find_machine(name).unwrap(), 1).unwrap());
        assert_eq!(rounds("leaf-5-local7-rgb6d-n64"), None);
        let found = rounds("leaf-5-radii-local7-rgb6d-n64").unwrap();
        assert_eq!((found.largest, found.nearest), (126 * 126, 14));
        let half = rounds("leaf-4-radii-local6x2-rgb4d-n64").unwrap();
        assert_eq!((half.largest, half.nearest), (254 * 254 - 1, 16));
    }

    /// The bisection tests no radius above the number of all ones, less one. That must be the largest at least. And the number of a round
    /// must fit its bits.
    #[test]
    fn the_largest_radius_of_no_format_is_all_ones_and_all_rounds_have_numbers() {
        for radius_bits in 4..=14 {
            let radius: u64 = (1 << radius_bits) - 2;
            for largest in [radius * radius, radius * radius - 1] {
                assert!(!(largest + 1).is_power_of_two(), "{radius_bits}");
                let rounds = Rounds {
                    largest: u32::try_from(largest).unwrap(),
                    nearest: bits_for(largest.into()),
                };
                assert!(rounds.most() < 1 << Rounds::ROUND_BITS, "{radius_bits}");
            }
        }
    }
}
