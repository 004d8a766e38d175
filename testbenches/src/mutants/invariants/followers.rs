//! Flags that follow another flag: a guess that is refuted for a pair at one stage of a pipeline is refuted
//! for the pairs at later stages.

use std::collections::{BTreeMap, BTreeSet};

use super::Never;

/// For each flag, the flags whose next value depends on it and on no other flag but a reset.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Followers(BTreeMap<usize, Vec<usize>>);

impl Followers {
    /// Finds the followers of flags. Each flag is given with the flags that its next value depends on.
    pub fn of(depends_on: impl IntoIterator<Item = (usize, Vec<usize>)>) -> Self {
        let mut followers: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (flag, before) in depends_on {
            if let [leader] = before[..]
                && leader != flag
            {
                followers.entry(leader).or_default().push(flag);
            }
        }
        Self(followers)
    }

    /// The refuted guesses about two flags, with the guesses about all pairs that follow them. Guesses about
    /// other numbers of flags are returned alone.
    pub fn behind(&self, refuted: impl IntoIterator<Item = Never>) -> BTreeSet<Never> {
        let mut open: Vec<_> = refuted.into_iter().collect();
        let mut all = BTreeSet::new();
        let none = Vec::new();
        while let Some(never) = open.pop() {
            if let [(a, of_a), (b, of_b)] = never.0[..] {
                let behind = |flag| self.0.get(&flag).unwrap_or(&none);
                for &next_a in behind(a) {
                    let pairs = behind(b).iter().map(|&next_b| {
                        let mut pair = [(next_a, of_a), (next_b, of_b)];
                        pair.sort_unstable();
                        Never(pair.to_vec())
                    });
                    open.extend(pairs.filter(|pair| !all.contains(pair)));
                }
            }
            all.insert(never);
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pair_takes_those_that_follow_with_it() {
        // The chains 0 -> 1 -> 2 and 10 -> 11 -> 12; 3 depends on two flags, 4 on itself.
        let flags = [
            (1, vec![0]),
            (2, vec![1]),
            (11, vec![10]),
            (12, vec![11]),
            (3, vec![0, 10]),
            (4, vec![4]),
        ];
        let followers = Followers::of(flags);
        let pair = |a, b| Never(vec![(a, 1), (b, 0)]);
        let alone = Never(vec![(0, 1), (4, 0), (10, 1)]);
        let behind = followers.behind([pair(0, 10), alone.clone()]);
        let expected = [pair(0, 10), pair(1, 11), pair(2, 12), alone];
        assert_eq!(behind, BTreeSet::from(expected));
        assert_eq!(followers.behind([pair(1, 4)]), BTreeSet::from([pair(1, 4)]));
    }
}
