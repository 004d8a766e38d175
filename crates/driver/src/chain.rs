//! When a chain works on its batches.
//!
//! A chain plays the groups of a batch while it compares the boxes of the leaves with the next batch, and its queue holds
//! the queries of two more. The rules of every register are those of [`photoncube_spec::LeafRegister`]; here they are clocks of batches, for a
//! chain whose results leave as they are found. docs/machines.md compares such forecasts with counted clocks.

use photoncube_spec::{Core, Leaf, LeafSizes};

/// Clocks from a group's address to the chain's first register: those of `Read` and `Word`.
const MEMORY_CLOCKS: u64 = 2;
/// Clocks from a batch's start to its first group, beside those of the comparison: `Scanning`, `Look`, `Found`, the queue of pairs and `Entry`.
const SCAN_CLOCKS: u64 = 5;
/// Clocks from a query in its stream's slice to the chain's pins, beside the stages on the way.
const QUEUE_CLOCKS: u64 = 2;

/// Clocks of a chain's pipeline.
#[derive(Copy, Clone, Debug)]
pub(crate) struct ChainClocks {
    /// Those in which a batch's queries are taken, one for each engine.
    engines: u64,
    /// Those from a batch's start to its first group, where the first pair has it.
    compares: u64,
    /// The fewest from one last group to the next.
    spacing: u64,
}

impl ChainClocks {
    pub(crate) fn of(core: &Core) -> Self {
        let sizes = LeafSizes::of(core.leaf());
        Self {
            engines: sizes.engines.into(),
            compares: SCAN_CLOCKS + u64::from(sizes.cull_clocks),
            spacing: sizes.least_spacing.into(),
        }
    }

    /// The fewest clocks of a batch among others that play few groups.
    pub(crate) fn least(self) -> u64 {
        let taken = MEMORY_CLOCKS + self.engines + 1;
        (taken + self.compares).max(self.spacing)
    }
}

/// The work of a batch.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct BatchWork {
    pub(crate) queries: u64,
    /// Clocks in which groups are played: at least one. In rounds, those of all of them.
    pub(crate) plays: u64,
    /// Pairs of leaves that are compared in a round.
    pub(crate) pairs: u64,
    /// The pairs in front of the first of which a group is played.
    pub(crate) before: u64,
    /// The clocks that the batch takes among others like it.
    pub(crate) clocks: u64,
}

/// The times of the last batches of a chain, in clocks.
#[derive(Copy, Clone, Debug)]
pub(crate) struct ChainTimes {
    clocks: ChainClocks,
    /// The stages from a stream's slice to the chain's queue.
    stages: u64,
    /// When the chain began to take the queries of the batch before the last, and of the last.
    taken: [u64; 2],
    /// When the last pair of the last batch is issued.
    compared: u64,
    /// When its first group is played, and its last.
    plays: u64,
    ends: u64,
}

impl ChainTimes {
    /// The times of a chain without a batch.
    pub(crate) fn new(core: &Core, chain: usize) -> Self {
        Self {
            clocks: ChainClocks::of(core),
            stages: core.stages(chain as u32).into(),
            taken: [0; 2],
            compared: 0,
            plays: 0,
            ends: 0,
        }
    }

    /// The clock from which a word of the next batch may leave the stream: the queue has room for two batches, and the credit of a place comes
    /// back by the stages.
    pub(crate) fn has_room(&self) -> u64 {
        self.taken[0] + self.stages + 1
    }

    /// The clock from which the chain can take the queries of the next batch: the engines begin to work on the last.
    pub(crate) fn wants(&self) -> u64 {
        self.plays + MEMORY_CLOCKS
    }

    /// The clock in which the last group of the last batch is played.
    pub(crate) fn ends(&self) -> u64 {
        self.ends
    }

    /// Adds a batch whose first word leaves the stream in the clock `sent`, on a set that is complete in the clock `loaded`.
    pub(crate) fn add(&mut self, batch: &BatchWork, sent: u64, loaded: u64) {
        let arrives = sent + self.stages + QUEUE_CLOCKS;
        let taken = arrives.max(self.wants());
        let starts = (taken + self.clocks.engines + 1)
            .max(self.compared)
            .max(loaded);
        let compares = starts + self.clocks.compares;
        self.plays = (self.ends + 1).max(compares + batch.before);
        self.ends = (self.plays + batch.plays - 1)
            .max(compares + batch.pairs - 1)
            .max(self.ends + self.clocks.spacing);
        self.compared = starts + batch.pairs;
        self.taken = [self.taken[1], taken];
    }
}

/// The clock in which a set is complete whose last leaf leaves the stream in the clock `sent`: the leaf passes the stages, the chain takes
/// its groups, and the boxes around them are written.
pub(crate) fn loaded(core: &Core, chain: usize, sent: u64) -> u64 {
    // `Write`, `Half`, `Group`, `Box` and `Full`.
    let boxes = 5;
    sent + u64::from(core.stages(chain as u32)) + QUEUE_CLOCKS + Leaf::GROUPS as u64 + boxes
}

#[cfg(test)]
mod tests {
    use photoncube_spec::find_machine;

    use super::*;

    fn core() -> Core {
        Core::new(find_machine("leaf-7-local7-rgb6d-n4096").unwrap(), 6).unwrap()
    }

    /// A batch that plays so many groups of a set of so many pairs, from the first on.
    fn batch(plays: u64, pairs: u64) -> BatchWork {
        BatchWork {
            queries: 8,
            plays,
            pairs,
            ..BatchWork::default()
        }
    }

    /// The clocks between the last batches of many of a kind, whose words come as early as there is room, on a complete set.
    fn between(batch: &BatchWork) -> u64 {
        let mut times = ChainTimes::new(&core(), 0);
        let ends: Vec<_> = (0..20)
            .map(|_| {
                times.add(batch, times.has_room(), 0);
                times.ends()
            })
            .collect();
        ends[19] - ends[18]
    }

    #[test]
    fn batches_take_the_clocks_of_their_groups_or_pairs_or_the_least() {
        let least = ChainClocks::of(&core()).least();
        assert_eq!(between(&batch(8, 4)), least);
        assert_eq!(between(&batch(60, 30)), 60);
        assert_eq!(between(&batch(30, 60)), 60);
        // With its first group in its last pair, a batch waits for the comparison.
        let late = BatchWork {
            before: 29,
            ..batch(1, 30)
        };
        assert_eq!(between(&late), least + 29);
    }

    #[test]
    fn a_batch_waits_for_its_set_and_for_its_words() {
        let mut times = ChainTimes::new(&core(), 5);
        times.add(&batch(10, 4), 0, 500);
        let compares = ChainClocks::of(&core()).compares;
        assert_eq!(times.ends(), 500 + compares + 9);
        times.add(&batch(10, 4), 1_000, 500);
        let on_the_way = u64::from(core().stages(5)) + QUEUE_CLOCKS;
        assert_eq!(times.ends(), 1_000 + on_the_way + 9 + compares + 9);
        // The queue has room for the third batch before the chain can take its queries.
        assert!(times.has_room() < times.wants());
    }
}
