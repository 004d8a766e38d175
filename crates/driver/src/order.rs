//! The order of the leaves of a set.
//!
//! A chain compares the leaves of a set in pairs, in their order, with each batch. So the pairs that most batches want are first: a batch then
//! seldom waits for its first group. The last pair is played in any case; where no group of it is wanted, its clock is lost. So the
//! pair that most batches want of all is the last.

use photoncube_spec::Leaf;

use crate::cull::WantedLeaf;

/// Puts the leaves of a set into the order in which they should be compared with these batches. Both name a leaf by its index in the frame.
pub(crate) fn put_in_order(leaves: &mut [usize], batches: &[&[WantedLeaf]]) {
    // In an odd number of leaves, the last is a pair of its own.
    let is_odd = leaves.len() % Leaf::PAIR == 1;
    if is_odd {
        let wanted = wanted_parts(leaves, 1, batches);
        if let Some(most) = (0..leaves.len()).max_by_key(|&leaf| wanted[leaf]) {
            leaves[most..].rotate_left(1);
        }
    }
    let whole = leaves.len() - usize::from(is_odd);
    let wanted = wanted_parts(&leaves[..whole], Leaf::PAIR, batches);
    let mut pairs: Vec<_> = leaves[..whole].chunks(Leaf::PAIR).zip(wanted).collect();
    pairs.sort_by_key(|&(_, wanted)| std::cmp::Reverse(wanted));
    if !is_odd && !pairs.is_empty() {
        pairs.rotate_left(1);
    }
    let ordered: Vec<_> = pairs
        .into_iter()
        .flat_map(|(pair, _)| pair.to_vec())
        .collect();
    leaves[..whole].copy_from_slice(&ordered);
}

/// For each part of so many leaves, the batches that want one of them.
fn wanted_parts(leaves: &[usize], part: usize, batches: &[&[WantedLeaf]]) -> Vec<usize> {
    let end = leaves.iter().max().map_or(0, |last| last + 1);
    let mut part_of_leaf = vec![None; end];
    for (place, &leaf) in leaves.iter().enumerate() {
        part_of_leaf[leaf] = Some(place / part);
    }
    let mut wanted = vec![0; leaves.len().div_ceil(part)];
    for batch in batches {
        let parts = batch
            .iter()
            .map(|leaf| part_of_leaf.get(leaf.index).copied().flatten());
        let mut parts: Vec<_> = parts.flatten().collect();
        parts.sort_unstable();
        parts.dedup();
        for part in parts {
            wanted[part] += 1;
        }
    }
    wanted
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Batches that want these leaves, each one group.
    fn ordered(mut leaves: Vec<usize>, batches: &[&[usize]]) -> Vec<usize> {
        let wants = |batch: &&[usize]| {
            let leaves = batch.iter().map(|&index| WantedLeaf { index, groups: 1 });
            leaves.collect::<Vec<_>>()
        };
        let batches: Vec<_> = batches.iter().map(wants).collect();
        let batches: Vec<_> = batches.iter().map(Vec::as_slice).collect();
        put_in_order(&mut leaves, &batches);
        leaves
    }

    #[test]
    fn pairs_that_more_batches_want_are_earlier_and_the_most_wanted_is_last() {
        let batches: [&[usize]; 3] = [&[4], &[4, 7, 8], &[3, 5, 8]];
        assert_eq!(
            ordered(vec![1, 3, 4, 5, 7, 8], &batches),
            [7, 8, 1, 3, 4, 5]
        );
    }

    #[test]
    fn a_leaf_without_another_is_that_which_most_batches_want() {
        let batches: [&[usize]; 3] = [&[3], &[3, 8], &[4, 5]];
        assert_eq!(ordered(vec![1, 3, 4, 5, 8], &batches), [5, 8, 1, 4, 3]);
        assert_eq!(ordered(vec![6], &[&[6]]), [6]);
        assert_eq!(ordered(vec![], &[]), Vec::<usize>::new());
    }
}
