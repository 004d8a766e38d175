//! Leaves: groups of up to [`LEAF`] neighbouring photons with a bounding box.

use std::ops::Range;

use photoncube_spec::PhotonRecord;

/// The most photons of a leaf, which is the number that the kernel tests at a time.
pub const LEAF: usize = 32;

/// Bits of a box's bounds. Longer positions are rounded outwards.
const BOX_BITS: u32 = 8;

/// The bits of an exponent; the three above are the flat axes. An exponent is at most 24.
const EXPONENT_BITS: u32 = 5;

/// A leaf of the photon planes. Its cells are those of a cube of blocks.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Leaf {
    /// The index of the leaf's first byte.
    pub start: u32,
    /// The number of photons.
    pub photons: u8,
    /// The exponent that all photons of the leaf share, below the flat axes.
    exponent_and_flat: u8,
    /// The lowest and the highest cell on each axis, in 8 bits.
    low: [u8; 3],
    high: [u8; 3],
}

impl Leaf {
    /// Makes the leaf of `records`, of one exponent, with cells of `cell_bits` bits; its first byte has the
    /// index `start`.
    pub fn new(records: &[PhotonRecord], start: u32, cell_bits: u32) -> Self {
        let bounds: [_; 3] = std::array::from_fn(|axis| bounds(records, axis));
        let flat = (0..3).fold(0, |flat, axis| {
            let [low, high] = bounds[axis];
            flat | u8::from(low == high) << axis
        });
        let shift = cell_bits.saturating_sub(BOX_BITS);
        let rounded = bounds.map(|bounds| bounds.map(|cell| (cell >> shift) as u8));
        Self {
            start,
            photons: records.len() as u8,
            exponent_and_flat: flat << EXPONENT_BITS | records[0].exponent,
            low: rounded.map(|[low, _]| low),
            high: rounded.map(|[_, high]| high),
        }
    }

    /// This leaf with its start moved by `bytes`, for planes with that many more bytes before it.
    pub fn moved(self, bytes: u32) -> Self {
        Self {
            start: self.start + bytes,
            ..self
        }
    }

    /// The exponent that all photons of the leaf share.
    pub fn exponent(&self) -> u8 {
        self.exponent_and_flat & ((1 << EXPONENT_BITS) - 1)
    }

    /// A mask with a bit for each axis on which all photons are in one cell.
    pub fn flat(&self) -> u8 {
        self.exponent_and_flat >> EXPONENT_BITS
    }

    /// The range of cells that the box spans on an axis. It contains all photons of the leaf.
    pub fn cells(&self, axis: usize, cell_bits: u32) -> [u32; 2] {
        let shift = cell_bits.saturating_sub(BOX_BITS);
        let low = u32::from(self.low[axis]) << shift;
        let high = u32::from(self.high[axis]) << shift | ((1 << shift) - 1);
        [low, high]
    }
}

fn bounds(records: &[PhotonRecord], axis: usize) -> [u16; 2] {
    let cells = records.iter().map(|record| record.position[axis]);
    cells.fold([u16::MAX, 0], |[low, high], cell| {
        [low.min(cell), high.max(cell)]
    })
}

/// Sorts the records of a cube so that leaves are contiguous, and returns the range of each leaf.
///
/// Records of one exponent are contiguous. Where they are more than a leaf holds, they are split across the
/// axis on which they spread widest, into full leaves where possible.
pub(super) fn into_leaves(records: &mut [PhotonRecord]) -> Vec<Range<usize>> {
    records.sort_unstable_by_key(|record| record.exponent);
    let mut leaves = Vec::new();
    let mut start = 0;
    for group in records.chunk_by_mut(|a, b| a.exponent == b.exponent) {
        part(group, start, &mut leaves);
        start += group.len();
    }
    leaves
}

fn part(records: &mut [PhotonRecord], start: usize, leaves: &mut Vec<Range<usize>>) {
    if records.len() <= LEAF {
        leaves.push(start..start + records.len());
        return;
    }
    let spread = |axis: &usize| {
        let [low, high] = bounds(records, *axis);
        high - low
    };
    let widest = (0..3).max_by_key(spread).expect("three axes");
    // Half of the records, rounded up to whole leaves. There are over LEAF records, so both parts are
    // non-empty.
    let middle = (records.len() / 2).next_multiple_of(LEAF);
    records.select_nth_unstable_by_key(middle, |record| record.position[widest]);
    let (below, above) = records.split_at_mut(middle);
    part(below, start, leaves);
    part(above, start + middle, leaves);
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn records() -> impl Strategy<Value = Vec<PhotonRecord>> {
        let record =
            (prop::array::uniform3(0_u16..4096), 0_u8..3).prop_map(|(position, exponent)| {
                PhotonRecord {
                    position,
                    mantissa: [1, 2, 3],
                    exponent,
                }
            });
        prop::collection::vec(record, 0..300)
    }

    fn sorted(mut records: Vec<PhotonRecord>) -> Vec<PhotonRecord> {
        records.sort_unstable_by_key(|r| (r.exponent, r.position));
        records
    }

    proptest! {
        /// Every record is in exactly one leaf, each leaf has one exponent, and its box contains its records.
        #[test]
        fn leaves_hold_every_record_once(given in records(), bits in 8_u32..=12) {
            let mut ordered = given.clone();
            ordered.iter_mut().for_each(|r| r.position = r.position.map(|cell| cell >> (12 - bits)));
            let given = ordered.clone();
            let leaves = into_leaves(&mut ordered);
            let mut next = 0;
            for place in leaves {
                prop_assert_eq!(place.start, next);
                next = place.end;
                let held = &ordered[place];
                prop_assert!((1..=LEAF).contains(&held.len()));
                let leaf = Leaf::new(held, 0, bits);
                for record in held {
                    prop_assert_eq!(record.exponent, leaf.exponent());
                    for axis in 0..3 {
                        let [low, high] = leaf.cells(axis, bits);
                        prop_assert!((low..=high).contains(&record.position[axis].into()));
                    }
                }
                for axis in 0..3 {
                    let alike = held.iter().all(|record| record.position[axis] == held[0].position[axis]);
                    prop_assert_eq!(leaf.flat() >> axis & 1 == 1, alike);
                }
            }
            prop_assert_eq!(next, ordered.len());
            prop_assert_eq!(sorted(ordered), sorted(given));
        }
    }

    #[test]
    fn photons_in_one_place_are_parted_too() {
        let mut records = vec![PhotonRecord::default(); 100];
        let sizes: Vec<_> = into_leaves(&mut records).iter().map(Range::len).collect();
        assert_eq!(sizes, [32, 32, 32, 4]);
    }
}
