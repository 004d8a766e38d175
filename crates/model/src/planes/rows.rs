//! Finds what lies in a box of cells: blocks of photons, or cubes of blocks.

use std::ops::Range;

/// The bits of a cell's index on one axis: two indices and a sign bit fit 64 bits, three fit 63.
pub const INDEX_BITS: u32 = 21;

/// The largest index of a cell on one axis.
pub const INDEX_MASK: u64 = (1 << INDEX_BITS) - 1;

/// Entries by rows of cells along x, in few bytes. A lookup takes few steps in little memory, however far
/// apart the entries are.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Rows {
    /// The rows that have entries, sorted by z and then y.
    keys: Vec<u64>,
    /// The first entry of each row.
    starts: Vec<u32>,
    /// The index of each entry's cell on the x axis.
    xs: Vec<u32>,
}

impl Rows {
    /// Appends an entry. Cells are in ascending order by z, y, x; a cell may have several entries.
    ///
    /// # Panics
    /// Where the cell is before the last one, or an index has over [`INDEX_BITS`] bits.
    pub fn push(&mut self, [x, y, z]: [u64; 3]) {
        assert!(x.max(y).max(z) <= INDEX_MASK, "a cell of the grid");
        let key = z << INDEX_BITS | y;
        let last = self.keys.last().copied();
        assert!(
            last < Some(key) || (last == Some(key) && self.xs.last() <= Some(&(x as u32))),
            "cells in ascending order"
        );
        if last != Some(key) {
            self.keys.push(key);
            self.starts.push(self.xs.len() as u32);
        }
        self.xs.push(x as u32);
    }

    /// Appends the entries of `other`, all of whose cells are behind those of this one.
    ///
    /// # Panics
    /// Where a cell of `other` is before the last one.
    pub fn append(&mut self, other: &Self) {
        for (row, key) in other.keys.iter().enumerate() {
            for x in &other.xs[other.row(row)] {
                self.push([u64::from(*x), key & INDEX_MASK, key >> INDEX_BITS]);
            }
        }
    }

    /// Gives back the memory that the index does not use.
    pub fn shrink_to_fit(&mut self) {
        self.keys.shrink_to_fit();
        self.starts.shrink_to_fit();
        self.xs.shrink_to_fit();
    }

    /// The number of bytes of the index.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of_val(self.keys.as_slice())
            + size_of_val(self.starts.as_slice())
            + size_of_val(self.xs.as_slice())
    }

    /// Calls `found` for each entry whose cell is in the box from `low` to `high`, with the cell's offset from
    /// `low` and the entry's index, in the order of the entries.
    ///
    /// # Panics
    /// Where the box is over 2^32 cells wide.
    #[inline]
    pub fn within(&self, low: [i64; 3], high: [i64; 3], mut found: impl FnMut([u32; 3], usize)) {
        let [Some(xs), Some(ys), Some(zs)] = [0, 1, 2].map(|axis| clipped(low[axis], high[axis]))
        else {
            return;
        };
        let offset = |index: u64, axis: usize| (index as i64 - low[axis]) as u32;
        let mut first = 0;
        for z in zs[0]..=zs[1] {
            let key = |y: u64| z << INDEX_BITS | y;
            // The rows of the next z are not far.
            first = match z == zs[0] {
                true => self.keys.partition_point(|row| *row < key(ys[0])),
                false => lower_bound(&self.keys, key(ys[0]), first),
            };
            while first < self.keys.len() && self.keys[first] <= key(ys[1]) {
                let y = offset(self.keys[first] & INDEX_MASK, 1);
                self.in_row(first, xs, |x, entry| {
                    found([offset(x.into(), 0), y, offset(z, 2)], entry);
                });
                first += 1;
            }
        }
    }

    /// Calls `found` for the entries of a row between two indices on the x axis, with their own indices.
    #[inline]
    fn in_row(&self, row: usize, [low, high]: [u64; 2], mut found: impl FnMut(u32, usize)) {
        let entries = self.row(row);
        let xs = &self.xs[entries.clone()];
        // Where entries are spread evenly, they are near the place of their x in the row.
        let (first, last) = (u64::from(xs[0]), u64::from(xs[xs.len() - 1]));
        let place = low.saturating_sub(first) * xs.len() as u64 / (last - first + 1);
        let start = lower_bound(xs, low as u32, place as usize);
        for (x, entry) in xs[start..].iter().zip(entries.start + start..) {
            if u64::from(*x) > high {
                break;
            }
            found(*x, entry);
        }
    }

    /// The entries of a row.
    fn row(&self, row: usize) -> Range<usize> {
        let end = self.starts.get(row + 1).copied();
        self.starts[row] as usize..end.map_or(self.xs.len(), |end| end as usize)
    }
}

/// The first index whose value is at least `value`, in steps that double from index `near` on.
#[inline]
fn lower_bound<T: Copy + Ord>(sorted: &[T], value: T, near: usize) -> usize {
    let near = near.min(sorted.len());
    let mut step = 1;
    let (mut low, mut high) = (near, near);
    while low > 0 && sorted[low - 1] >= value {
        high = low;
        low = low.saturating_sub(step);
        step *= 2;
    }
    while high < sorted.len() && sorted[high] < value {
        low = high + 1;
        high = (high + step).min(sorted.len());
        step *= 2;
    }
    low + sorted[low..high].partition_point(|other| *other < value)
}

/// The indices from `low` to `high` that are in the grid; `None` where there are none.
fn clipped(low: i64, high: i64) -> Option<[u64; 2]> {
    let last = INDEX_MASK as i64;
    let clipped = [low.max(0), high.min(last)];
    (clipped[0] <= clipped[1]).then_some(clipped.map(|index| index as u64))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Indices near a corner of the grid, so that cells have neighbours.
    fn index() -> impl Strategy<Value = u64> {
        prop_oneof![0_u64..5, INDEX_MASK - 4..=INDEX_MASK]
    }

    proptest! {
        /// Compares the lookup with the definition: every entry whose cell is in the box.
        #[test]
        fn the_entries_within_are_those_of_cells_in_the_box(
            mut cells in prop::collection::vec(prop::array::uniform3(index()), 0..60),
            low in prop::array::uniform3(prop_oneof![index().prop_map(|i| i as i64), -3_i64..3, i64::MIN..i64::MAX - 3]),
            size in prop::array::uniform3(0_i64..4),
            split in 0_usize..60,
        ) {
            cells.sort_unstable_by_key(|[x, y, z]| [*z, *y, *x]);
            let rows = |cells: &[[u64; 3]]| {
                let mut rows = Rows::default();
                cells.iter().for_each(|cell| rows.push(*cell));
                rows
            };
            let (first, rest) = cells.split_at(split.min(cells.len()));
            let mut joined = rows(first);
            joined.append(&rows(rest));
            prop_assert_eq!(&joined, &rows(&cells));
            let high = std::array::from_fn(|axis| low[axis] + size[axis]);
            let mut found = Vec::new();
            joined.within(low, high, |offset, entry| found.push((offset, entry)));
            let offset = |cell: [u64; 3]| {
                let offsets: [i128; 3] = std::array::from_fn(|axis| i128::from(cell[axis]) - i128::from(low[axis]));
                let inside = (0..3).all(|axis| (0..=i128::from(size[axis])).contains(&offsets[axis]));
                inside.then(|| offsets.map(|o| o as u32))
            };
            let expected = cells.iter().enumerate();
            let expected = expected.filter_map(|(i, cell)| Some((offset(*cell)?, i)));
            prop_assert_eq!(found, expected.collect::<Vec<_>>());
        }
    }
}
