//! Cubes of blocks: the photons of a cube share leaves, and the queries of a cube share a lookup.

use photoncube_spec::PhotonFormat;

/// The blocks on an edge of a cube, as a power of two.
///
/// In a format of bytes a cube is 8 blocks wide. Where blocks hold a photon or none, a leaf has the photons of
/// some dozen blocks, and one lookup serves the queries of as many. The frame of three cubes is 6144 fine steps
/// wide, whose squares the kernel can sum. In a format of words a block is wider than that, and a cube is a block.
pub(super) const fn edge_bits(wide: bool) -> u32 {
    if wide { 0 } else { BLOCK_BITS }
}

/// The bits of a block's index in a cube, on an axis.
const BLOCK_BITS: u32 = 3;

/// The cubes on an edge of the frame; the queries are in the middle one.
pub(super) const FRAME_CUBES: u32 = 3;

/// The bits between the axes of a packed block: an index, and two bits more in which a difference may carry.
const STRIDE: u32 = BLOCK_BITS + 2;

/// The block of a photon in its cube, as the planes store it.
#[inline(always)]
pub(super) fn packed(block: [u16; 3]) -> u16 {
    let [x, y, z] = block;
    on_axis(x, 0) | on_axis(y, 1) | on_axis(z, 2)
}

/// The bits of a block's index on one axis, in a packed block.
#[inline(always)]
pub(super) fn on_axis(index: u16, axis: usize) -> u16 {
    index << below(axis)
}

/// The number of bits below an axis in a packed block.
pub(super) const fn below(axis: usize) -> u32 {
    axis as u32 * STRIDE
}

/// A mask of the bits of one axis.
pub(super) const ON_AXIS: u16 = (1 << BLOCK_BITS) - 1;

/// The block of a photon on an axis, from its packed form.
#[inline(always)]
pub(super) fn block_on(packed: u16, axis: usize) -> u16 {
    packed >> below(axis) & ON_AXIS
}

/// Blocks of one cube, from the first to the last on each axis.
#[derive(Copy, Clone, Debug)]
pub(super) struct Part {
    /// The first block, packed.
    pub first: u16,
    /// The last block, packed, with [`Self::GUARDS`].
    pub last_and_guards: u16,
}

impl Part {
    /// The highest bit of each axis.
    pub const GUARDS: u16 = 1 << (STRIDE - 1) | 1 << (2 * STRIDE - 1) | 1 << (3 * STRIDE - 1);

    /// The blocks from `first` to `last`, which are packed.
    #[inline(always)]
    pub fn new(first: u16, last: u16) -> Self {
        Self {
            first,
            last_and_guards: last | Self::GUARDS,
        }
    }

    /// Whether a packed block is one of these. A difference on an axis clears the guard where it is negative. Words
    /// that are no blocks have any result.
    #[inline(always)]
    pub fn contains(self, block: u16) -> bool {
        let from_first = (block | Self::GUARDS).wrapping_sub(self.first);
        let to_last = self.last_and_guards.wrapping_sub(block);
        from_first & to_last & Self::GUARDS == Self::GUARDS
    }
}

/// The centre of a photon's cell, in fine steps from the corner of the block or cube that its index counts
/// from: the cell's index, or the grid line through its middle.
pub(super) fn centre(format: &PhotonFormat, cell: u32) -> u32 {
    let extra = format.query_extra_bits;
    (cell << extra) + ((1 << extra) >> 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares with the definition on one axis at a time, the others at both ends.
    #[test]
    fn a_part_contains_the_blocks_between_its_first_and_last() {
        let all = 0..=ON_AXIS;
        for axis in 0..3 {
            for (first, last) in all
                .clone()
                .flat_map(|first| all.clone().map(move |last| (first, last)))
            {
                for (at, other) in all.clone().flat_map(|at| [(at, 0), (at, ON_AXIS)]) {
                    let with = |value, on_axis| {
                        let mut block = [value; 3];
                        block[axis] = on_axis;
                        block
                    };
                    let part = Part::new(packed(with(0, first)), packed(with(ON_AXIS, last)));
                    let block = packed(with(other, at));
                    assert_eq!(part.contains(block), (first..=last).contains(&at));
                    assert_eq!(block_on(block, axis), at);
                }
            }
        }
    }
}
