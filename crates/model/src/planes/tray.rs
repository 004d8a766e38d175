//! Trays: leaves laid out for the test against many queries.

use super::frame::Frame;
use super::lanes::{Boxes, Lanes, Positions};
use super::store::Planes;
use super::windows::Seen;

/// The most leaves of a tray: one for each bit of a word. They fit the first-level cache.
pub(super) const TRAY: usize = 32;

/// A leaf laid out in the frame of the queries.
#[derive(Copy, Clone)]
pub(super) struct Opened<L: Lanes, P: Positions<L>, const PLANES: usize> {
    pub positions: P::Photons,
    pub powers: L::Powers<PLANES>,
    pub photons: u64,
}

/// Leaves of one exponent that all queries of a block are tested against before the next leaves are laid out.
pub(super) struct Tray<L: Lanes, P: Positions<L>, const PLANES: usize> {
    pub leaves: Vec<Opened<L, P, PLANES>>,
    pub boxes: Boxes,
    /// The order of the axes on this tray.
    pub axes: [usize; 3],
}

impl<L: Lanes, P: Positions<L>, const PLANES: usize> Tray<L, P, PLANES> {
    #[inline(always)]
    pub fn new(shift: u32, largest: u32) -> Self {
        Self {
            leaves: Vec::new(),
            boxes: Boxes {
                low: [[0; TRAY]; 3],
                high: [[0; TRAY]; 3],
                shift,
                // The value is less than 2^16, because a radius has 8 bits after the shift.
                largest: (largest >> (2 * shift)) as u16,
            },
            axes: [0, 1, 2],
        }
    }

    /// Replaces the tray's leaves by up to [`TRAY`] others, with the axes in this order.
    #[inline(always)]
    pub fn lay(
        &mut self,
        lanes: L,
        planes: &Planes,
        frame: &Frame,
        axes: [usize; 3],
        seen: &[Seen],
    ) {
        self.axes = axes;
        self.leaves.clear();
        self.leaves.reserve(seen.len());
        for (index, seen) in seen.iter().enumerate().take(TRAY) {
            let planes = planes.planes(&seen.leaf);
            let corner = ordered(frame.corner(seen.offset), axes);
            self.leaves.push(Opened {
                positions: P::photons(lanes, frame, &planes, axes, corner),
                powers: lanes.powers(&planes),
                photons: planes.photons() as u64,
            });
            for axis in 0..3 {
                self.boxes.low[axis][index] = seen.low[axis];
                self.boxes.high[axis][index] = seen.high[axis];
            }
        }
    }

    /// A mask with a bit for each leaf of the tray.
    #[inline(always)]
    pub fn present(&self) -> u32 {
        u32::MAX
            .checked_shr((TRAY - self.leaves.len()) as u32)
            .unwrap_or(0)
    }
}

/// Permutes the values of the three axes into this order.
#[inline(always)]
pub(super) fn ordered(on: [i16; 3], axes: [usize; 3]) -> [i16; 3] {
    [on[axes[0]], on[axes[1]], on[axes[2]]]
}
