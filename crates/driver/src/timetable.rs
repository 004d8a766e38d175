//! In which order the streams of a core bring the words of sets, and when its chains work on them.
//!
//! A stream's words reach the chains in their order, so a word for a chain without room holds back those behind it. The timetable forecasts when
//! each chain has room for the next batch ([`ChainTimes`]). Of the chains that have, the one is sent its batch that can take it
//! first. The leaves of a set are sent from when their bank is free, spread over the time in which the chain works on the set before, so that
//! the leaves for other chains come between them.
//!
//! No chain waits for ever. In the timetable each word leaves its stream after everything that it waits for: a query after the queries
//! before it in the chain's queue were taken, these after the chain played a group of the batch before them, and that after the leaves
//! of its set had left their stream; a leaf after the last group on the set before in its bank was played. In the core words
//! wait for the same things, whenever they happen. A round of words that wait for each other would have to go back in the timetable's time.

use photoncube_spec::{Core, Leaf};

use crate::chain::{ChainTimes, loaded};
use crate::shares::{SetWork, Shares};

/// The part of the time of a set in which the leaves of the next are sent. At the earliest they would hold back those of other chains where a
/// bank is free later than in the timetable, and over the whole time the set would often be late.
const SPREAD: (u64, u64) = (4, 5);

/// A leaf of a set, in the order of its stream.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct LeafTurn {
    pub(crate) chain: usize,
    pub(crate) set: usize,
    pub(crate) leaf: usize,
}

/// A batch of a set, in the order of its stream.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct BatchTurn {
    pub(crate) chain: usize,
    pub(crate) set: usize,
    pub(crate) batch: usize,
}

/// The order of leaves and batches.
#[derive(Debug, Default)]
pub(crate) struct Timetable {
    pub(crate) leaves: Vec<LeafTurn>,
    pub(crate) batches: Vec<BatchTurn>,
    /// The clocks until the last group is played.
    pub(crate) clocks: u64,
}

impl Timetable {
    /// The timetable of a core for sets.
    pub(crate) fn of(core: &Core, sets: &[SetWork]) -> Self {
        let chains = 0..core.chains as usize;
        let mut sender = Sender {
            core,
            sets,
            shares: Shares::of(sets, chains.len()),
            chains: chains.map(|chain| Chain::new(core, chain)).collect(),
            leaves: Vec::new(),
            batches: Vec::new(),
            clock: 0,
        };
        for chain in 0..sender.chains.len() {
            // The first set, and the one behind it.
            sender.begin_set(chain);
            sender.begin_set(chain);
        }
        while let Some(chain) = sender.next_chain() {
            sender.send_batch(chain);
        }
        // Stable: the leaves of a set keep their order.
        sender.leaves.sort_by_key(|(clock, _)| *clock);
        Self {
            leaves: sender.leaves.into_iter().map(|(_, turn)| turn).collect(),
            batches: sender.batches,
            clocks: sender
                .chains
                .iter()
                .map(|chain| chain.times.ends())
                .max()
                .unwrap_or(0),
        }
    }
}

/// A set of a chain.
#[derive(Copy, Clone, Debug)]
struct ChainSet {
    set: usize,
    /// The clock in which its last leaf is sent.
    sent: u64,
}

/// A chain at the clock of its last batch.
#[derive(Debug)]
struct Chain {
    times: ChainTimes,
    /// The set whose batches are sent, and the next of them.
    sending: Option<(ChainSet, usize)>,
    /// The set behind it, whose leaves are in the timetable.
    following: Option<ChainSet>,
}

impl Chain {
    fn new(core: &Core, chain: usize) -> Self {
        Self {
            times: ChainTimes::new(core, chain),
            sending: None,
            following: None,
        }
    }
}

/// Sends words in the order of the clocks in which they can be sent.
struct Sender<'a> {
    core: &'a Core,
    sets: &'a [SetWork],
    shares: Shares,
    chains: Vec<Chain>,
    /// Each with the clock in which it is sent.
    leaves: Vec<(u64, LeafTurn)>,
    batches: Vec<BatchTurn>,
    /// The clock in which the stream of queries is free.
    clock: u64,
}

impl Sender<'_> {
    /// The chain that is sent the next batch: of those with room the one that can take it first, else the one that has room first.
    fn next_chain(&self) -> Option<usize> {
        let chains = 0..self.chains.len();
        let sends = chains.filter(|&chain| self.chains[chain].sending.is_some());
        sends.min_by_key(|&chain| {
            let times = &self.chains[chain].times;
            (times.has_room().max(self.clock), times.wants())
        })
    }

    fn send_batch(&mut self, number: usize) {
        let chain = &mut self.chains[number];
        let Some((ChainSet { set, sent }, batch)) = chain.sending else {
            return;
        };
        let work = &self.sets[set].batches[batch];
        let clock = self.clock.max(chain.times.has_room());
        self.clock = clock + work.queries;
        let loaded = loaded(self.core, number, sent);
        chain.times.add(work, clock, loaded);
        self.batches.push(BatchTurn {
            chain: number,
            set,
            batch,
        });
        match batch + 1 < self.sets[set].batches.len() {
            true => chain.sending = Some((ChainSet { set, sent }, batch + 1)),
            false => self.begin_set(number),
        }
    }

    /// Lets the batches of the chain's following set be sent, and sends the leaves of the set behind it. These go into the bank of the set
    /// before, from when its last batch ends.
    fn begin_set(&mut self, number: usize) {
        let chain = &mut self.chains[number];
        let bank_is_free = chain.times.ends();
        let before = chain.following.take();
        chain.sending = before.map(|set| (set, 0));
        let clocks_before = before.map_or(0, |before| self.sets[before.set].clocks());
        let Some(set) = self.shares.take(number, clocks_before) else {
            return;
        };
        let work = &self.sets[set];
        let pace = Leaf::GROUPS as u64;
        let begins = bank_is_free.max(before.map_or(0, |before| before.sent + pace));
        let (part, whole) = SPREAD;
        let sent = |leaf: u64| {
            let spread = leaf * clocks_before * part / (whole * work.leaves);
            begins + spread.max(leaf * pace)
        };
        for leaf in 0..work.leaves {
            let turn = LeafTurn {
                chain: number,
                set,
                leaf: leaf as usize,
            };
            self.leaves.push((sent(leaf), turn));
        }
        chain.following = Some(ChainSet {
            set,
            sent: sent(work.leaves - 1),
        });
    }
}

#[cfg(test)]
mod tests {
    use std::collections::VecDeque;

    use photoncube_spec::find_machine;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64;

    use super::*;
    use crate::chain::BatchWork;

    fn core(chains: u32) -> Core {
        Core::new(find_machine("leaf-5-local7-rgb6d-n64").unwrap(), chains).unwrap()
    }

    fn batch(rng: &mut Pcg64, engines: u64, leaves: u64) -> BatchWork {
        let pairs = leaves.div_ceil(Leaf::PAIR as u64);
        let plays = rng.random_range(1..=leaves * Leaf::GROUPS as u64);
        BatchWork {
            queries: rng.random_range(1..=engines),
            plays,
            pairs,
            before: rng.random_range(0..pairs),
            clocks: plays.max(20),
        }
    }

    fn sets(rng: &mut Pcg64, core: &Core) -> Vec<SetWork> {
        let number = rng.random_range(0..60);
        let mut set = || {
            let leaves = rng.random_range(1..=u64::from(core.set_leaves()));
            let batches = 0..rng.random_range(1..12);
            let batches = batches.map(|_| batch(rng, core.engines() as u64, leaves));
            SetWork {
                leaves,
                batches: batches.collect(),
            }
        };
        (0..number).map(|_| set()).collect()
    }

    /// What a chain holds, without a clock.
    #[derive(Default)]
    struct Held {
        /// The batch of each query in the queue.
        queries: VecDeque<BatchTurn>,
        /// The batch that the engines are given, and how many of its queries they have.
        taken: Option<(BatchTurn, u64)>,
        leaves: VecDeque<LeafTurn>,
        /// The sets in the banks, and how many leaves of each are read in.
        banks: VecDeque<(usize, u64)>,
    }

    impl Held {
        /// Moves a query or a leaf on, or plays a batch. Returns whether there was any.
        fn moves(&mut self, sets: &[SetWork]) -> bool {
            if let Some((turn, queries)) = self.taken {
                let set = &sets[turn.set];
                let is_loaded = self.banks.front() == Some(&(turn.set, set.leaves));
                if is_loaded && queries == set.batches[turn.batch].queries {
                    self.taken = None;
                    if turn.batch + 1 == set.batches.len() {
                        self.banks.pop_front();
                    }
                    return true;
                }
            }
            if let Some(&next) = self.queries.front() {
                let queries = match self.taken {
                    None => Some(0),
                    Some((turn, queries)) => (turn == next).then_some(queries),
                };
                if let Some(queries) = queries {
                    self.queries.pop_front();
                    self.taken = Some((next, queries + 1));
                    return true;
                }
            }
            self.reads_in(sets)
        }

        fn reads_in(&mut self, sets: &[SetWork]) -> bool {
            let Some(&LeafTurn { set, leaf, .. }) = self.leaves.front() else {
                return false;
            };
            if leaf == 0 && self.banks.len() < 2 {
                self.banks.push_back((set, 0));
            }
            let reads = self.banks.back_mut().filter(|(bank, _)| *bank == set);
            let Some((_, read)) = reads else { return false };
            assert_eq!(*read, leaf as u64, "the leaves of a set have an order");
            assert!(*read < sets[set].leaves);
            *read += 1;
            self.leaves.pop_front();
            true
        }
    }

    /// Lets the streams and chains of a core move until nothing does. Returns the queries and leaves that have not left the streams, and
    /// what the chains hold.
    fn run(core: &Core, sets: &[SetWork], timetable: &Timetable) -> (usize, usize, usize) {
        let turns = timetable.batches.iter();
        let words = turns.flat_map(|turn| {
            let queries = sets[turn.set].batches[turn.batch].queries;
            std::iter::repeat_n(*turn, queries as usize)
        });
        let mut queries: VecDeque<_> = words.collect();
        let mut leaves: VecDeque<_> = timetable.leaves.iter().copied().collect();
        let mut chains: Vec<Held> = (0..core.chains).map(|_| Held::default()).collect();
        loop {
            let mut moved = false;
            if let Some(&turn) = queries.front()
                && chains[turn.chain].queries.len() < Core::QUERY_PLACES as usize
            {
                chains[turn.chain].queries.extend(queries.pop_front());
                moved = true;
            }
            if let Some(&turn) = leaves.front()
                && chains[turn.chain].leaves.len() < Core::LEAF_PLACES as usize
            {
                chains[turn.chain].leaves.extend(leaves.pop_front());
                moved = true;
            }
            for chain in &mut chains {
                moved |= chain.moves(sets);
            }
            if !moved {
                let held =
                    |chain: &Held| chain.queries.len() + chain.leaves.len() + chain.banks.len();
                return (queries.len(), leaves.len(), chains.iter().map(held).sum());
            }
        }
    }

    #[test]
    fn no_chain_waits_for_ever() {
        let mut rng = Pcg64::seed_from_u64(1);
        for chains in (1..=6).cycle().take(300) {
            let core = core(chains);
            let sets = sets(&mut rng, &core);
            let timetable = Timetable::of(&core, &sets);
            assert_eq!(run(&core, &sets, &timetable), (0, 0, 0));
            let leaves: u64 = sets.iter().map(|set| set.leaves).sum();
            let batches: usize = sets.iter().map(|set| set.batches.len()).sum();
            let found = (timetable.leaves.len(), timetable.batches.len());
            assert_eq!(found, (leaves as usize, batches));
        }
    }

    /// A stream brings all queries of one chain before those of the other, and the leaves in the other order.
    #[test]
    fn an_order_in_which_chains_wait_for_ever_is_found() {
        let core = core(2);
        let batch = BatchWork {
            queries: 8,
            plays: 1,
            pairs: 1,
            ..BatchWork::default()
        };
        let set = SetWork {
            leaves: 1,
            batches: vec![batch],
        };
        let sets = vec![set; 80];
        let sets_of = |chain: usize| (0..40).map(move |number| (chain, 40 * chain + number));
        let leaf = |(chain, set)| LeafTurn {
            chain,
            set,
            leaf: 0,
        };
        let batch = |(chain, set)| BatchTurn {
            chain,
            set,
            batch: 0,
        };
        let timetable = Timetable {
            leaves: sets_of(1).chain(sets_of(0)).map(leaf).collect(),
            batches: sets_of(0).chain(sets_of(1)).map(batch).collect(),
            clocks: 0,
        };
        let (queries, leaves, _) = run(&core, &sets, &timetable);
        assert!(
            queries > 0 && leaves > 0,
            "{queries} queries, {leaves} leaves"
        );
    }

    /// On chains whose sets are alike, the timetable takes no more clocks than the work of a chain, a first load and a last set.
    #[test]
    fn chains_with_equal_work_are_busy_until_the_end() {
        let core = core(4);
        let batch = BatchWork {
            queries: core.engines() as u64,
            plays: 30,
            pairs: 4,
            before: 0,
            clocks: 30,
        };
        let set = SetWork {
            leaves: 8,
            batches: vec![batch; 10],
        };
        let timetable = Timetable::of(&core, &vec![set; 400]);
        let work = 100 * 10 * 30;
        let clocks = timetable.clocks;
        assert!((work..work + 300 + 100).contains(&clocks), "{clocks}");
    }
}
