//! Cuts the batches of a frame into sets, each with no other leaves than its batches want.
//!
//! A chain compares all leaves of a set with each batch, so smaller sets take fewer clocks where a batch wants few of them. But each set
//! is read in for itself, and all chains share the stream of photons. So batches are cut in halves for as long as the
//! forecast clocks become fewer.

use std::ops::Range;

use photoncube_spec::Core;

use crate::cull::{WantedLeaf, wanted};
use crate::forecast::Forecaster;
use crate::frames::{PhotonLeaf, Set, SetBatch};
use crate::order::put_in_order;

/// The most clocks of a round of a set with several batches, about. Where sets are longer, the chains of a core end their last sets at
/// different times. Where they have so few batches that no rounds of several are under way at once, the engines wait.
const LONGEST_SET: u64 = 1 << 12;

/// Cuts the batches of frames into sets.
#[derive(Debug)]
pub(crate) struct Cutter {
    forecaster: Forecaster,
    /// The most leaves of a set.
    set_leaves: usize,
    /// Each batch should have all leaves that it wants in one set.
    is_whole: bool,
}

/// Batches of a frame, and which of the frame's leaves each wants.
struct Wanted {
    leaves: usize,
    of_batch: Vec<Vec<WantedLeaf>>,
}

impl Wanted {
    /// The leaves that some of these batches want, in the order of the frame.
    fn by(&self, batches: &Range<usize>) -> Vec<usize> {
        let mut is_wanted = vec![false; self.leaves];
        for leaf in self.of_batch[batches.clone()].iter().flatten() {
            is_wanted[leaf.index] = true;
        }
        (0..self.leaves).filter(|&leaf| is_wanted[leaf]).collect()
    }
}

impl Cutter {
    /// Cuts for the chains of a core.
    pub(crate) fn new(core: &Core) -> Self {
        Self {
            forecaster: Forecaster::new(core),
            set_leaves: core.set_leaves() as usize,
            is_whole: false,
        }
    }

    /// A cutter for batches of so many rounds. Where they are `is_whole`, each has all leaves that it wants in one set, if a bank holds them.
    pub(crate) fn with_rounds(self, rounds: u32, is_whole: bool) -> Self {
        Self {
            forecaster: self.forecaster.with_rounds(rounds),
            is_whole,
            ..self
        }
    }

    /// The sets of the batches of a frame that gather from these leaves. A batch that wants no leaf is in no set: its sums are 0.
    pub(crate) fn sets(&self, leaves: &[PhotonLeaf], batches: &[SetBatch]) -> Vec<Set> {
        let wanted = Wanted {
            leaves: leaves.len(),
            of_batch: wanted(self.forecaster.format(), leaves, batches),
        };
        let mut all = Vec::new();
        for part in self.cut(&wanted, 0..batches.len()) {
            for chunk in wanted.by(&part).chunks(self.set_leaves) {
                let is_in = |leaf: &WantedLeaf| chunk.binary_search(&leaf.index).is_ok();
                let gathers = |batch: &usize| wanted.of_batch[*batch].iter().any(is_in);
                let gathering: Vec<_> = part.clone().filter(gathers).collect();
                let wanted_by: Vec<_> = gathering
                    .iter()
                    .map(|&batch| &*wanted.of_batch[batch])
                    .collect();
                let mut chunk = chunk.to_vec();
                put_in_order(&mut chunk, &wanted_by);
                all.push(Set {
                    leaves: chunk.iter().map(|&leaf| leaves[leaf].clone()).collect(),
                    batches: gathering
                        .iter()
                        .map(|&batch| batches[batch].clone())
                        .collect(),
                });
            }
        }
        all
    }

    /// Cuts batches in halves for as long as that takes fewer clocks, or a round of them takes more than
    /// [`LONGEST_SET`].
    fn cut(&self, wanted: &Wanted, batches: Range<usize>) -> Vec<Range<usize>> {
        let middle = batches.start.midpoint(batches.end);
        let halves = [batches.start..middle, middle..batches.end];
        let clocks = |batches: &Range<usize>| self.clocks(wanted, batches);
        let whole = clocks(&batches);
        let is_too_large = self.is_whole && wanted.by(&batches).len() > self.set_leaves;
        let takes_fewer = || halves.iter().map(clocks).sum::<u64>() < whole;
        if batches.len() < 2
            || !(is_too_large || whole > self.forecaster.rounds() * LONGEST_SET || takes_fewer())
        {
            return vec![batches];
        }
        let halves = halves.into_iter();
        halves.flat_map(|half| self.cut(wanted, half)).collect()
    }

    /// The clocks of batches in a set of their own; in several sets, where a bank does not hold all leaves that they want.
    fn clocks(&self, wanted: &Wanted, batches: &Range<usize>) -> u64 {
        let leaves = wanted.by(batches).len();
        let sets = leaves.div_ceil(self.set_leaves).max(1);
        let clocks = |wanted: &Vec<WantedLeaf>| {
            let groups: usize = wanted.iter().map(|leaf| leaf.groups).sum();
            self.forecaster
                .batch(groups.div_ceil(sets), leaves.div_ceil(sets))
        };
        let all: u64 = wanted.of_batch[batches.clone()].iter().map(clocks).sum();
        self.forecaster.set(sets as u64 * all, leaves)
    }
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{Photon, Query, find_machine};

    use super::*;
    use crate::frames::SetQuery;

    /// A cutter for so many chains.
    fn cutter(machine: &str, chains: u32) -> Cutter {
        let machine = find_machine(machine).unwrap();
        Cutter::new(&Core::new(machine, chains).unwrap())
    }

    /// A cutter for a chain whose banks hold 16 leaves.
    fn small() -> Cutter {
        cutter("leaf-4-local7-rgb6d-n128", 1)
    }

    /// A leaf of one photon at this place of a plane, in steps of position.
    fn leaf([x, y]: [u32; 2]) -> PhotonLeaf {
        let photon = Photon {
            position: [x, y, 100],
            ..Photon::default()
        };
        PhotonLeaf {
            facing: 1,
            photons: vec![photon],
        }
    }

    /// A batch of one query at the place of such a photon.
    fn batch(cutter: &Cutter, [x, y]: [u32; 2]) -> SetBatch {
        let place = |step: u32| step << cutter.forecaster.format().query_extra_bits;
        let query = Query {
            position: [x, y, 100].map(place),
            ..Query::default()
        };
        let index = (y << 16 | x) as usize;
        SetBatch {
            queries: vec![SetQuery { index, query }],
            facings: 1 << 1,
        }
    }

    /// Leaves in rows and columns all over the plane, and batches along its diagonal.
    fn plane(cutter: &Cutter) -> (Vec<PhotonLeaf>, Vec<SetBatch>) {
        let end = 4 << cutter.forecaster.format().position_bits;
        let places = || (0..end).step_by(end as usize / 16);
        let leaves = places().flat_map(|y| places().map(move |x| leaf([x, y])));
        let batches = places().map(|place| batch(cutter, [place, place]));
        (leaves.collect(), batches.collect())
    }

    #[test]
    fn each_batch_has_each_leaf_that_it_wants_in_one_set_and_each_leaf_is_wanted() {
        let cutter = small();
        let (leaves, batches) = plane(&cutter);
        let format = cutter.forecaster.format();
        // Leaves of the plane, in its order.
        let place = |leaf: &PhotonLeaf| leaves.iter().position(|other| other == leaf).unwrap();
        let mut pairs = 0;
        let mut found = vec![Vec::new(); batches.len()];
        for set in cutter.sets(&leaves, &batches) {
            assert!(
                set.leaves.len() <= cutter.set_leaves,
                "{}",
                set.leaves.len()
            );
            let wanted = wanted(format, &set.leaves, &set.batches);
            for (place, leaf) in set.leaves.iter().enumerate() {
                assert!(
                    wanted.iter().flatten().any(|wanted| wanted.index == place),
                    "{leaf:?}"
                );
            }
            for (batch, wanted) in set.batches.iter().zip(wanted) {
                pairs += wanted.len();
                let number = batches.iter().position(|other| other == batch).unwrap();
                found[number].extend(wanted.iter().map(|leaf| place(&set.leaves[leaf.index])));
            }
        }
        assert!(pairs > batches.len());
        for (batch, mut found) in batches.iter().zip(found) {
            let wanted = wanted(format, &leaves, std::slice::from_ref(batch));
            let expected: Vec<_> = wanted[0].iter().map(|leaf| leaf.index).collect();
            found.sort_unstable();
            assert_eq!(found, expected);
        }
    }

    #[test]
    fn fewer_cuts_are_worth_their_leaves_where_more_chains_share_the_stream() {
        let read_in = |chains: u32| {
            let cutter = cutter("leaf-7-local7-rgb6d-n4096", chains);
            let (leaves, batches) = plane(&cutter);
            let sets = cutter.sets(&leaves, &batches);
            sets.iter().map(|set| set.leaves.len()).sum::<usize>()
        };
        let [one, sixteen] = [1, 16].map(read_in);
        assert!(
            one > sixteen,
            "{one} leaves for one chain, {sixteen} for sixteen"
        );
    }

    #[test]
    fn a_batch_that_wants_no_leaf_is_in_no_set() {
        let cutter = small();
        let far = 3 << cutter.forecaster.format().position_bits;
        let batches = [batch(&cutter, [0, 0]), batch(&cutter, [far, 0])];
        let sets = cutter.sets(&[leaf([0, 0])], &batches);
        assert_eq!(sets.len(), 1);
        assert_eq!(sets[0].batches, batches[..1]);
        assert_eq!(cutter.sets(&[leaf([0, 0])], &batches[1..]), []);
    }
}
