//! Shares the sets of a picture among the chains of a core.
//!
//! Each stream has a word a clock for all chains. A chain whose batches take few clocks asks for many queries, and where all chains did so at
//! once, they would wait. So the sets are put into the order of their queries a clock and divided into as many parts as there are chains, of
//! equal clocks. Each chain works on a part of its own: one on the sets with the most queries a clock, one on those with the fewest.
//! At any time the chains then ask for as many queries together as on average.

use std::collections::VecDeque;

use photoncube_spec::Leaf;

use crate::chain::BatchWork;

/// The next sets of a chain among which one is chosen that can be read in while the chain works on the one before. Of fewer, often none can.
const CHOICE: usize = 16;

/// The work of a set.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct SetWork {
    pub(crate) leaves: u64,
    pub(crate) batches: Vec<BatchWork>,
}

impl SetWork {
    /// The clocks of its batches.
    pub(crate) fn clocks(&self) -> u64 {
        self.batches.iter().map(|batch| batch.clocks).sum()
    }

    /// The clocks in which a chain reads in its leaves.
    pub(crate) fn loads(&self) -> u64 {
        self.leaves * Leaf::GROUPS as u64
    }

    fn queries(&self) -> u64 {
        self.batches.iter().map(|batch| batch.queries).sum()
    }
}

/// A set of a share.
#[derive(Copy, Clone, Debug)]
struct Member {
    set: usize,
    clocks: u64,
    loads: u64,
}

/// The sets that no chain has taken yet, for each chain.
#[derive(Debug)]
pub(crate) struct Shares(Vec<VecDeque<Member>>);

impl Shares {
    /// Shares sets among so many chains. The sets of a chain keep their order.
    pub(crate) fn of(sets: &[SetWork], chains: usize) -> Self {
        let mut by_rate: Vec<_> = sets.iter().enumerate().collect();
        by_rate.sort_by_cached_key(|(_, set)| {
            // A fraction as an integer.
            (set.clocks() << 16) / set.queries().max(1)
        });
        let all: u64 = sets.iter().map(SetWork::clocks).sum();
        let mut shares = vec![Vec::new(); chains];
        let mut before = 0;
        for (number, set) in by_rate {
            let member = Member {
                set: number,
                clocks: set.clocks(),
                loads: set.loads(),
            };
            let share = before * chains as u64 / all.max(1);
            shares[(share as usize).min(chains - 1)].push(member);
            before += member.clocks;
        }
        let in_order = |mut share: Vec<Member>| {
            share.sort_by_key(|member| member.set);
            share.into()
        };
        Self(shares.into_iter().map(in_order).collect())
    }

    /// Takes the next set of a chain, whose set before that takes so many clocks. A chain without sets takes one of the chain that has the
    /// most work left; `None` where no chain has one.
    pub(crate) fn take(&mut self, chain: usize, clocks_before: u64) -> Option<usize> {
        let work_left = |share: &VecDeque<Member>| share.iter().map(|member| member.clocks).sum();
        let share = match self.0[chain].is_empty() {
            false => chain,
            true => (0..self.0.len()).max_by_key(|&chain| -> u64 { work_left(&self.0[chain]) })?,
        };
        let share = &mut self.0[share];
        let waits = |&place: &usize| share[place].loads.saturating_sub(clocks_before);
        let place = (0..share.len().min(CHOICE)).min_by_key(waits)?;
        share.remove(place).map(|member| member.set)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A set of so many leaves, with a batch of so many queries that takes so many clocks.
    fn set(leaves: u64, queries: u64, clocks: u64) -> SetWork {
        SetWork {
            leaves,
            batches: vec![BatchWork {
                queries,
                clocks,
                ..BatchWork::default()
            }],
        }
    }

    /// All that a chain takes, in its order, as long as it has sets of its own.
    fn own(shares: &mut Shares, chain: usize) -> Vec<usize> {
        let mut own = Vec::new();
        while !shares.0[chain].is_empty() {
            own.extend(shares.take(chain, u64::MAX));
        }
        own
    }

    #[test]
    fn chains_have_sets_of_unlike_rates_and_equal_clocks() {
        let mut shares = Shares::of(&[4, 1, 8, 4, 1, 8].map(|queries| set(1, queries, 50)), 3);
        let all: Vec<_> = (0..3).map(|chain| own(&mut shares, chain)).collect();
        assert_eq!(all, [[2, 5], [0, 3], [1, 4]]);
        // The second chain has twice as many sets, because each takes half as many clocks.
        let sets = [(8, 100), (1, 50), (1, 50)].map(|(queries, clocks)| set(1, queries, clocks));
        let mut shares = Shares::of(&sets, 2);
        let own = [0, 1].map(|chain| own(&mut shares, chain));
        assert_eq!(own, [vec![0], vec![1, 2]]);
    }

    #[test]
    fn a_chain_takes_first_what_is_read_in_while_it_works() {
        let sets = [set(40, 8, 100), set(20, 8, 100), set(30, 8, 100)];
        let mut shares = Shares::of(&sets, 1);
        // 60 clocks are enough for 20 and for 30 leaves; of these the first in order is taken.
        assert_eq!(shares.take(0, 60), Some(1));
        assert_eq!(shares.take(0, 60), Some(2));
        assert_eq!(shares.take(0, 60), Some(0));
        assert_eq!(shares.take(0, 60), None);
    }

    #[test]
    fn a_chain_that_is_done_takes_from_the_one_with_the_most_work() {
        let sets: Vec<_> = (1..=6).map(|queries| set(1, queries, 10)).collect();
        let mut shares = Shares::of(&sets, 2);
        let mut taken = own(&mut shares, 0);
        taken.extend(std::iter::from_fn(|| shares.take(0, 10)));
        taken.sort_unstable();
        assert_eq!(taken, [0, 1, 2, 3, 4, 5]);
    }
}
