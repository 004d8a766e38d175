//! The number of photons in the 27 blocks around the queries of a span, which a machine tests one by one.

use super::lanes::Lanes;
use super::leaf::LEAF;
use super::store::{Planes, Words};
use super::tray::{TRAY, Tray};
use super::windows::{Region, Seen};

/// The blocks of the photons of the leaves around a cube, in one place: most spans count most leaves.
#[derive(Default)]
pub(super) struct Around {
    /// The blocks of each leaf; none where a cube is a block.
    blocks: Vec<Words>,
}

impl Around {
    /// Replaces the leaves by others.
    #[inline(always)]
    pub fn lay(&mut self, planes: &Planes, seen: &[Seen]) {
        self.blocks.clear();
        if planes.layout.edge_bits() > 0 {
            let blocks = seen.iter().map(|seen| *planes.planes(&seen.leaf).blocks());
            self.blocks.extend(blocks);
        }
    }

    /// The number of the tray's photons in a region, whose lowest and highest coordinates are `steps`.
    #[inline(always)]
    pub fn count<L: Lanes>(
        &self,
        lanes: L,
        tray: &Tray,
        seen: &[Seen],
        region: &Region,
        edge: u32,
        [low, high]: [[u16; 3]; 2],
    ) -> u64 {
        let parts = region.parts(edge);
        let mut meeting = lanes.meeting(&tray.boxes, low, high) & tray.present;
        let mut around = 0;
        while meeting != 0 {
            let index = tray.leaves[meeting.trailing_zeros() as usize % TRAY] as usize;
            let seen = &seen[index];
            meeting &= meeting - 1;
            around += if self.blocks.is_empty() {
                u64::from(seen.leaf.photons)
            } else {
                // Lanes without a photon have any block.
                let present = u32::MAX >> (LEAF - usize::from(seen.leaf.photons));
                let inside = lanes.inside(parts.of(seen.offset), &self.blocks[index]) & present;
                inside.count_ones().into()
            };
        }
        around
    }
}
