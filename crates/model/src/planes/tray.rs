//! Leaves laid out for the test against many queries, and trays of them.

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

/// The leaves around a cube of queries, laid out.
pub(super) struct Laid<L: Lanes, P: Positions<L>, const PLANES: usize> {
    pub leaves: Vec<Opened<L, P, PLANES>>,
    /// The order of the axes.
    pub axes: [usize; 3],
    /// The coordinate that all photons share on the last of them, if they do.
    pub shared: i16,
}

impl<L: Lanes, P: Positions<L>, const PLANES: usize> Laid<L, P, PLANES> {
    pub fn new() -> Self {
        Self {
            leaves: Vec::new(),
            axes: [0, 1, 2],
            shared: 0,
        }
    }

    /// Replaces the leaves by others, with the axes in this order, on the last of which photons share a coordinate
    /// if there is one.
    #[inline(always)]
    pub fn lay(
        &mut self,
        lanes: L,
        planes: &Planes,
        frame: &Frame,
        (axes, shared): ([usize; 3], i16),
        seen: &[Seen],
    ) {
        (self.axes, self.shared) = (axes, shared);
        self.leaves.clear();
        self.leaves.reserve(seen.len());
        for seen in seen {
            let planes = planes.planes(&seen.leaf);
            let corner = ordered(frame.corner(seen.offset), axes);
            self.leaves.push(Opened {
                positions: P::photons(lanes, frame, &planes, axes, corner),
                powers: lanes.powers(&planes),
                photons: planes.photons() as u64,
            });
        }
    }
}

/// Leaves of one exponent that all queries of a window are tested against before the next leaves.
pub(super) struct Tray {
    pub boxes: Boxes,
    /// The indices of the leaves in [`Laid::leaves`].
    pub leaves: [u32; TRAY],
    /// A mask with a bit for each leaf of the tray.
    pub present: u32,
}

impl Tray {
    pub fn new(shift: u32, largest: u32) -> Self {
        Self {
            boxes: Boxes {
                low: [[0; TRAY]; 3],
                high: [[0; TRAY]; 3],
                shift,
                // The value is less than 2^16, because a radius has 8 bits after the shift.
                largest: (largest >> (2 * shift)) as u16,
            },
            leaves: [0; TRAY],
            present: 0,
        }
    }

    /// Replaces the tray's leaves by up to [`TRAY`] others.
    #[inline(always)]
    pub fn set(&mut self, seen: &[Seen], leaves: &[u32]) {
        for (place, leaf) in leaves.iter().enumerate() {
            let seen = &seen[*leaf as usize];
            self.leaves[place] = *leaf;
            for axis in 0..3 {
                self.boxes.low[axis][place] = seen.low[axis];
                self.boxes.high[axis][place] = seen.high[axis];
            }
        }
        self.present = u32::MAX
            .checked_shr((TRAY - leaves.len()) as u32)
            .unwrap_or(0);
    }
}

/// Permutes the values of the three axes into this order.
#[inline(always)]
pub(super) fn ordered(on: [i16; 3], axes: [usize; 3]) -> [i16; 3] {
    [on[axes[0]], on[axes[1]], on[axes[2]]]
}
