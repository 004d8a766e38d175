//! Finds the runs of the blocks around a query.

use std::ops::Range;

use glam::I64Vec3;

use super::{INDEX_BITS, INDEX_MASK, Run};

/// The runs by rows of blocks along x, in few bytes. A lookup takes few steps in little memory, however far
/// apart the runs are.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Rows {
    /// The rows that have runs, sorted by z and then y.
    keys: Vec<u64>,
    /// The first run of each row, and the number of all runs.
    starts: Vec<u32>,
    /// The index of each run's block on the x axis.
    xs: Vec<u32>,
}

/// The runs of three blocks along x.
#[derive(Debug, Clone, Default)]
struct Row {
    /// The row's y offset from the lowest of the 27 blocks; the z offset follows.
    y: u32,
    z: u32,
    runs: Range<usize>,
}

impl Rows {
    /// Indexes runs in the map's order.
    pub fn of(runs: &[Run]) -> Self {
        let mut rows = Self::default();
        for row in runs.chunk_by(|a, b| a.row() == b.row()) {
            rows.keys.push(row[0].row());
            rows.starts.push(rows.xs.len() as u32);
            rows.xs.extend(row.iter().map(|run| run.x() as u32));
        }
        rows.starts.push(rows.xs.len() as u32);
        rows
    }

    /// The number of bytes of the index.
    pub fn bytes(&self) -> usize {
        size_of_val(self.keys.as_slice())
            + size_of_val(self.starts.as_slice())
            + size_of_val(self.xs.as_slice())
    }

    /// The indices of the runs of the 27 blocks around `centre`, each with its block's offset from the lowest
    /// of the 27, in the map's order.
    pub fn around(&self, centre: I64Vec3) -> impl Iterator<Item = ([u32; 3], usize)> {
        // No block is further out, so a query beyond has no blocks around it.
        let last = INDEX_MASK as i64 + 1;
        let near = centre.cmpge(I64Vec3::NEG_ONE).all() && centre.cmple(I64Vec3::splat(last)).all();
        let corner = if near { centre - 1 } else { I64Vec3::MAX - 2 };
        // One level of iterators: the lookups of all rows are done first.
        let (rows, count) = self.rows_from(corner);
        rows.into_iter().take(count).flat_map(move |row| {
            let xs = &self.xs[row.runs.clone()];
            let offset = move |x: u32| [(i64::from(x) - corner.x) as u32, row.y, row.z];
            xs.iter().map(move |x| offset(*x)).zip(row.runs)
        })
    }

    /// The rows of the 27 blocks from `corner` on, and their number.
    fn rows_from(&self, corner: I64Vec3) -> ([Row; 9], usize) {
        let (mut rows, mut count) = (<[Row; 9]>::default(), 0);
        let [first, last] = within(corner.y);
        for z in 0..3 {
            let at = corner.z.wrapping_add(z);
            if !(0..=INDEX_MASK as i64).contains(&at) {
                continue;
            }
            let key = |y: u64| (at as u64) << INDEX_BITS | y;
            let start = self.keys.partition_point(|row| *row < key(first));
            for (row, found) in (start..).zip(&self.keys[start..]) {
                if *found > key(last) {
                    break;
                }
                rows[count] = Row {
                    y: ((found & INDEX_MASK) as i64 - corner.y) as u32,
                    z: z as u32,
                    runs: self.row(row, within(corner.x)),
                };
                count += 1;
            }
        }
        (rows, count)
    }

    /// The runs of a row between two indices on the x axis.
    fn row(&self, row: usize, [first, last]: [u64; 2]) -> Range<usize> {
        let (start, end) = (self.starts[row] as usize, self.starts[row + 1] as usize);
        let xs = &self.xs[start..end];
        let before = xs.partition_point(|x| u64::from(*x) < first);
        // Three blocks hold few runs, so counting them is faster than a second search.
        let count = xs[before..]
            .iter()
            .take_while(|x| u64::from(**x) <= last)
            .count();
        start + before..start + before + count
    }
}

/// The three indices from `first` on, clipped to the grid; empty where the first exceeds the last.
fn within(first: i64) -> [u64; 2] {
    let last = INDEX_MASK as i64;
    if first > last {
        return [1, 0];
    }
    [first.max(0) as u64, (first + 2).min(last) as u64]
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn run(block: [u64; 3]) -> Run {
        let [x, y, z] = block;
        Run {
            block: z << (2 * INDEX_BITS) | y << INDEX_BITS | x,
            group: 0,
            photons: 0..1,
        }
    }

    /// Indices near a corner of the grid, so that blocks have neighbours.
    fn index() -> impl Strategy<Value = u64> {
        prop_oneof![0_u64..5, INDEX_MASK - 4..=INDEX_MASK]
    }

    proptest! {
        /// Compares the lookup with the definition: every run whose block is at most one away on each axis.
        #[test]
        fn the_runs_around_are_those_next_to_the_centre(
            mut blocks in prop::collection::vec(prop::array::uniform3(index()), 0..60),
            centre in prop::array::uniform3(prop_oneof![index().prop_map(|i| i as i64), -3_i64..3, any::<i64>()]),
        ) {
            blocks.sort_unstable_by_key(|block| run(*block).block);
            let runs: Vec<_> = blocks.iter().map(|block| run(*block)).collect();
            let found: Vec<_> = Rows::of(&runs).around(I64Vec3::from_array(centre)).collect();
            let offset = |block: [u64; 3]| {
                let offsets = std::array::from_fn(|axis| i128::from(block[axis]) - i128::from(centre[axis]) + 1);
                offsets.iter().all(|offset: &i128| (0..3).contains(offset)).then(|| offsets.map(|o| o as u32))
            };
            let expected = blocks.iter().enumerate();
            let expected = expected.filter_map(|(i, block)| Some((offset(*block)?, i)));
            prop_assert_eq!(found, expected.collect::<Vec<_>>());
        }
    }
}
