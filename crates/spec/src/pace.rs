//! Forecasts how many clocks a workload takes while no stream waits.

use crate::machine::Machine;
use crate::overlap::Program;
use crate::sequential::Microprogram;
use crate::spatial::{HeadSizes, Spatial};

/// A set of queries that are tested against one list of photons.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct SharedGroups {
    /// The number of queries in the set.
    pub queries: u64,
    /// The number of groups of [`Machine::photons_per_iteration`] photons that each query is tested against.
    pub groups: u64,
}

/// The data that the number of clocks follows from, for each organisation.
#[derive(Clone, Debug, PartialEq)]
pub enum Pace {
    /// A sequential machine: one op a clock for all cells, one query after another.
    Sequential(Microprogram),
    /// An overlapped machine: groups overlap, queries do not.
    Overlapped(Program),
    /// A spatial machine: one group a clock for all engines of the chain.
    Chain {
        /// The number of engines, which is the number of queries in a batch.
        engines: u64,
        /// The fewest clocks from one batch's last group to that of the next batch. It keeps the results of
        /// two batches apart on the result chain.
        spacing: u64,
        /// Clocks from a batch's last group to its first result.
        latency_clocks: u64,
        /// Clocks between two batches that a photon memory plays.
        between_batches: u64,
    },
}

impl Pace {
    /// The pace of a machine; `None` where its program cannot be made.
    pub fn of(machine: &Machine) -> Option<Self> {
        if let Some(spatial) = machine.spatial() {
            return Some(Self::of_chain(spatial));
        }
        let sequential = machine.microprogram().map(Self::Sequential);
        sequential.or_else(|| machine.overlap_program().map(Self::Overlapped))
    }

    fn of_chain(spatial: &Spatial) -> Self {
        Self::Chain {
            engines: spatial.engines() as u64,
            spacing: HeadSizes::of(spatial).spacing.into(),
            latency_clocks: spatial.latency_clocks().into(),
            between_batches: spatial.batch_gap_clocks().into(),
        }
    }

    /// Clocks from the first query to the last result, without the clock that takes the first query. For a
    /// chain the true number may be larger by up to the spacing. A chain is given no query without photons.
    /// Where fewer queries than engines share photons, the remaining engines of the batch have no useful
    /// work.
    pub fn clocks(&self, lists: impl IntoIterator<Item = SharedGroups>) -> u64 {
        let lists = lists.into_iter();
        match self {
            Self::Sequential(program) => lists
                .map(|list| list.queries * program.occupied_clocks(list.groups))
                .sum(),
            Self::Overlapped(program) => lists
                .map(|list| list.queries * program.occupied_clocks(list.groups))
                .sum(),
            Self::Chain {
                engines,
                spacing,
                latency_clocks,
                between_batches,
            } => {
                let lists = lists.filter(|list| list.groups > 0);
                let clocks = lists.map(|list| {
                    let batches = list.queries.div_ceil(*engines);
                    batches * (list.groups.max(*spacing) + between_batches)
                });
                // The first queries come before the first group, and results leave the chain two clocks
                // apart.
                clocks.sum::<u64>() + latency_clocks + 3 * (engines - 1)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machines::{MACHINES, find_machine};

    fn clocks(machine: &str, lists: &[(u64, u64)]) -> u64 {
        let pace = Pace::of(find_machine(machine).unwrap()).unwrap();
        let lists = lists.iter();
        pace.clocks(lists.map(|&(queries, groups)| SharedGroups { queries, groups }))
    }

    #[test]
    fn every_machine_has_a_pace() {
        assert!(MACHINES.iter().all(|machine| Pace::of(machine).is_some()));
    }

    #[test]
    fn the_paper_takes_nine_clocks_a_group_and_two_a_query() {
        assert_eq!(
            clocks("paper", &[(3, 10), (2, 0)]),
            3 * (9 * 10 + 2) + 2 * 2
        );
    }

    #[test]
    fn a_stream_takes_a_clock_a_group() {
        let latency = find_machine("stream")
            .unwrap()
            .spatial()
            .unwrap()
            .latency_clocks();
        assert_eq!(
            clocks("stream", &[(3, 10), (2, 0)]),
            30 + u64::from(latency)
        );
    }

    #[test]
    fn queries_that_share_photons_fill_a_tile_and_others_do_not() {
        let base = clocks("tile-6", &[(4, 100)]);
        assert_eq!(clocks("tile-6", &[(8, 100)]), base + 100);
        assert_eq!(clocks("tile-6", &[(1, 100); 8]), base + 7 * 100);
        // A short batch costs the spacing, 2 N - 1 clocks.
        assert_eq!(clocks("tile-6", &[(4, 100), (4, 1)]), base + 7);
    }
}
