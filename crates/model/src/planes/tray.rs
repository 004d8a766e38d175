//! Leaves laid out for testing.

use super::frame::Frame;
use super::lanes::{Boxes, Lanes, Positions};
use super::store::{PhotonPlanes, plane};
use super::surroundings::Seen;

/// The most leaves of a tray: a bit of a word for each, and they fit the nearest cache.
pub(super) const TRAY: usize = 32;

/// A leaf in the frame of the queries.
#[derive(Copy, Clone)]
pub(super) struct Opened<L: Lanes, P: Positions<L>, const PLANES: usize> {
    pub positions: P::Photons,
    pub mantissas: [L::Mantissas; PLANES],
    pub photons: u64,
}

/// Leaves of one exponent that all queries of a block meet before the next ones are laid out.
pub(super) struct Tray<L: Lanes, P: Positions<L>, const PLANES: usize> {
    pub leaves: Vec<Opened<L, P, PLANES>>,
    pub boxes: Boxes,
    /// The order of the axes.
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
                // Less than 2^16: a radius has 8 bits after the shift.
                largest: (largest >> (2 * shift)) as u16,
            },
            axes: [0, 1, 2],
        }
    }

    /// Lays out up to [`TRAY`] leaves in place of those that were there, with the axes in this order.
    #[inline(always)]
    pub fn lay(
        &mut self,
        lanes: L,
        planes: &PhotonPlanes,
        frame: &Frame,
        axes: [usize; 3],
        seen: &[Seen],
    ) {
        self.axes = axes;
        self.leaves.clear();
        self.leaves.reserve(seen.len());
        for (index, seen) in seen.iter().enumerate().take(TRAY) {
            let photons = usize::from(seen.leaf.photons);
            let window = planes.window(&seen.leaf);
            let mut mantissas = [lanes.mantissas(plane(window, 3 * P::BYTES, photons)); PLANES];
            for (index, mantissas) in mantissas.iter_mut().enumerate() {
                *mantissas = lanes.mantissas(plane(window, 3 * P::BYTES + index, photons));
            }
            self.leaves.push(Opened {
                positions: P::photons(
                    lanes,
                    window,
                    photons,
                    axes,
                    ordered(frame.corner(seen.offset), axes),
                ),
                mantissas,
                photons: photons as u64,
            });
            for axis in 0..3 {
                self.boxes.low[axis][index] = seen.low[axis];
                self.boxes.high[axis][index] = seen.high[axis];
            }
        }
    }

    /// A bit for each leaf that there is.
    #[inline(always)]
    pub fn present(&self) -> u32 {
        u32::MAX
            .checked_shr((TRAY - self.leaves.len()) as u32)
            .unwrap_or(0)
    }
}

/// What is on each axis, in this order.
#[inline(always)]
pub(super) fn ordered(on: [i16; 3], axes: [usize; 3]) -> [i16; 3] {
    [on[axes[0]], on[axes[1]], on[axes[2]]]
}
