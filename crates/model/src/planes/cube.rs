//! Cubes of blocks: the photons of a cube share leaves, and the queries of a cube share a lookup.

use photoncube_spec::PhotonFormat;

/// The blocks on an edge of a cube, as a power of two.
///
/// In a format of bytes a cube is 4 blocks wide. Where blocks hold a photon or none, a leaf has the photons of
/// some dozen blocks, and one lookup serves the queries of as many. The frame of three cubes is 3072 fine steps
/// wide, whose squares the kernel can sum. In a format of words a block is wider than that, and a cube is a block.
pub(super) const fn edge_bits(wide: bool) -> u32 {
    if wide { 0 } else { 2 }
}

/// The cubes on an edge of the frame; the queries are in the middle one.
pub(super) const FRAME_CUBES: u32 = 3;

/// The blocks of photons in a cube, two bits an axis, as the planes store them.
pub(super) fn packed(block: [u16; 3]) -> u8 {
    let [x, y, z] = block;
    (x | y << 2 | z << 4) as u8
}

/// The block of a photon on an axis, from its packed form.
#[inline(always)]
pub(super) fn block_on(packed: u8, axis: usize) -> u8 {
    packed >> (2 * axis) & 3
}

/// The centre of a photon's cell, in fine steps from the corner of the block or cube that its index counts
/// from: the cell's index, or the grid line through its middle.
pub(super) fn centre(format: &PhotonFormat, cell: u32) -> u32 {
    let extra = format.query_extra_bits;
    (cell << extra) + ((1 << extra) >> 1)
}
