//! The loop over leaves, queries and photons, for any lanes.
//!
//! As in the tile machine the queries stay and the photons come by: a leaf's planes are loaded once for
//! a batch of queries of one block.

use std::mem;

use photoncube_spec::LocalQuery;

use super::gather::Gathered;
use super::lanes::{BATCH, Lanes, Meeting};
use super::leaf::LEAF;
use super::positions::Positions;
use super::store::{PhotonPlanes, plane};
use super::surroundings::{Seen, Surroundings};

/// What is to be gathered.
pub(super) struct Work<'a> {
    pub planes: &'a PhotonPlanes,
    pub around: &'a Surroundings,
    pub queries: &'a [LocalQuery],
    /// The largest sum of squares, or half squares, in range.
    pub largest: u32,
    /// One for each query.
    pub found: &'a mut [Gathered],
}

impl Work<'_> {
    /// Gathers every query, by lanes that are known to be there.
    #[inline(always)]
    pub fn run<L: Lanes, P: Positions<L>, const HALF_STEPS: bool, const PLANES: usize>(
        self,
        lanes: L,
    ) {
        let edge = self.planes.format().edge_steps();
        let shift = self.planes.format().radius_bits().saturating_sub(u8::BITS);
        let mut batch = Batch::<L, P, PLANES> {
            lanes,
            axes: [[P::axis(lanes, 0, edge, HALF_STEPS); 3]; BATCH],
            positions: [[0; BATCH]; 3],
            sums: [[lanes.no_sum(); PLANES]; BATCH],
            counts: [lanes.no_count(); BATCH],
            tests: [0; BATCH],
        };
        for (queries, found) in self.queries.chunks(BATCH).zip(self.found.chunks_mut(BATCH)) {
            found.fill(Gathered {
                photons: self.around.photons(),
                ..Gathered::default()
            });
            for (index, query) in queries.iter().enumerate().take(BATCH) {
                for (axis, position) in query.position.into_iter().enumerate() {
                    batch.axes[index][axis] = P::axis(lanes, position - edge, edge, HALF_STEPS);
                    // Less than two edges of 2^14.
                    batch.positions[axis][index] = position as u16;
                }
            }
            let present = u32::MAX >> (BATCH - queries.len());
            let (mut exponent, mut additions) = (0, 0);
            for seen in &self.around.seen {
                if seen.leaf.exponent != exponent || additions == L::ADDITIONS {
                    batch.flush(exponent, found);
                    (exponent, additions) = (seen.leaf.exponent, 0);
                }
                additions += 1;
                let touched = lanes.touched(&Meeting {
                    low: seen.low,
                    high: seen.high,
                    queries: &batch.positions,
                    shift,
                    // Less than 2^16: a radius has 8 bits after the shift.
                    largest: (self.largest >> (2 * shift)) as u16,
                });
                let touched = touched & present;
                if touched == 0 {
                    continue;
                }
                let (planes, largest) = (self.planes, self.largest);
                match seen.inside {
                    0 => batch.meet::<HALF_STEPS, 0>(planes, seen, touched, largest),
                    1 => batch.meet::<HALF_STEPS, 1>(planes, seen, touched, largest),
                    2 => batch.meet::<HALF_STEPS, 2>(planes, seen, touched, largest),
                    _ => batch.meet::<HALF_STEPS, 3>(planes, seen, touched, largest),
                }
            }
            batch.flush(exponent, found);
        }
    }
}

/// The queries that meet leaves together, by their place in the batch.
struct Batch<L: Lanes, P: Positions<L>, const PLANES: usize> {
    lanes: L,
    axes: [[P::Axis; 3]; BATCH],
    /// By axis.
    positions: [[u16; BATCH]; 3],
    /// Since the last flush.
    sums: [[L::Sum; PLANES]; BATCH],
    counts: [L::Count; BATCH],
    tests: [u64; BATCH],
}

impl<L: Lanes, P: Positions<L>, const PLANES: usize> Batch<L, P, PLANES> {
    /// Tests the photons of a leaf, whose block is in the middle on `INSIDE` axes, against the queries whose
    /// bits are set.
    #[inline(always)]
    fn meet<const HALF_STEPS: bool, const INSIDE: usize>(
        &mut self,
        planes: &PhotonPlanes,
        seen: &Seen,
        mut touched: u32,
        largest: u32,
    ) {
        let lanes = self.lanes;
        let photons = usize::from(seen.leaf.photons).min(LEAF);
        let window = planes.window(&seen.leaf);
        let edge = planes.format().edge_steps();
        let order = [
            usize::from(seen.axes[0]) % 3,
            usize::from(seen.axes[1]) % 3,
            usize::from(seen.axes[2]) % 3,
        ];
        let [a, b, c] = seen.sides;
        let centres = [
            P::centres(lanes, window, photons, order[0], a, edge),
            P::centres(lanes, window, photons, order[1], b, edge),
            P::centres(lanes, window, photons, order[2], c, edge),
        ];
        let ones = lanes.ones(photons);
        let mut mantissas = [lanes.mantissas(plane(window, 3 * P::BYTES, photons)); PLANES];
        for (index, mantissas) in mantissas.iter_mut().enumerate() {
            *mantissas = lanes.mantissas(plane(window, 3 * P::BYTES + index, photons));
        }
        while touched != 0 {
            let query = touched.trailing_zeros() as usize % BATCH;
            touched &= touched - 1;
            let axes = &self.axes[query];
            let mut m = centres;
            for place in 0..3 {
                let (axis, centres) = (&axes[order[place]], centres[place]);
                m[place] = if place < INSIDE {
                    P::inside(lanes, axis, centres)
                } else {
                    P::outside(lanes, axis, seen.sides[place], centres)
                };
            }
            let in_range = P::in_range::<HALF_STEPS>(lanes, m, largest, ones);
            self.counts[query] = lanes.add_count(self.counts[query], in_range);
            for (sum, mantissas) in self.sums[query].iter_mut().zip(mantissas) {
                *sum = lanes.add(*sum, in_range, mantissas);
            }
            self.tests[query] += photons as u64;
        }
    }

    /// Adds the sums of one exponent to what was found, and starts anew.
    #[inline(always)]
    fn flush(&mut self, exponent: u8, found: &mut [Gathered]) {
        let lanes = self.lanes;
        let bytes_each = if PLANES.is_multiple_of(2) { 2 } else { 1 };
        let since = self
            .sums
            .iter_mut()
            .zip(&mut self.counts)
            .zip(&mut self.tests);
        for (((sums, counts), tests), found) in since.zip(found) {
            let count = lanes.count(*counts);
            *counts = lanes.no_count();
            found.sums.count += count;
            found.tests += mem::take(tests);
            for (index, sum) in sums.iter_mut().enumerate() {
                let total = lanes.total(*sum, count);
                let (channel, byte) = (index / bytes_each, index % bytes_each);
                // An exponent is 24 at most, and sums are of so few leaves that this fits.
                let total = total << (usize::from(exponent) + 8 * byte);
                found.sums.power[channel] += u128::from(total);
                *sum = lanes.no_sum();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::store::Window;
    use super::*;

    /// What [`plane`] is given, at most, stays in a window.
    #[test]
    fn the_last_plane_is_in_the_window() {
        let window: &Window = &std::array::from_fn(|byte| byte as u8);
        let last: &[u8; LEAF] = plane(window, 11, LEAF);
        assert_eq!(usize::from(last[0]), 11 * LEAF % 256);
    }
}
