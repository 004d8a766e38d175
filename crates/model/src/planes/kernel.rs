//! The loop over leaves and queries, generic over the instruction set.

use super::frame::Frame;
use super::gather::{Gathered, PlacedQuery};
use super::lanes::{Lanes, Positions};
use super::photon_planes::PhotonPlanes;
use super::tray::{TRAY, Tray, ordered};
use super::windows::{Seen, Windows};
use crate::gather::GatherError;

/// The input and output of one gather.
pub(super) struct Work<'a, F> {
    pub photons: &'a PhotonPlanes,
    pub queries: &'a [PlacedQuery],
    pub frame: Frame,
    pub windows: Windows<'a, F>,
    /// The results, one for each query.
    pub found: &'a mut [Gathered],
}

impl<F: Fn(u32, u32) -> bool> Work<'_, F> {
    /// Gathers every query with the instruction set `L`, which the processor must have. Leaves that are flat
    /// on one axis use `Q`.
    #[inline(always)]
    pub fn run<L: Lanes, P: Positions<L>, Q: Positions<L>, const PLANES: usize>(
        mut self,
        lanes: L,
    ) -> Result<(), GatherError> {
        let shift = self.photons.format().radius_bits().saturating_sub(u8::BITS);
        let mut tray = Tray::<L, P, PLANES>::new(shift, self.frame.largest);
        let mut flat_tray = Tray::<L, Q, PLANES>::new(shift, self.frame.largest);
        let mut first = 0;
        while first < self.queries.len() {
            let (end, seen) = self.windows.next(first);
            let queries = &self.queries[first..end];
            let found = &mut self.found[first..end];
            begin(self.photons, queries, seen, found)?;
            let mut rest = seen;
            while !rest.is_empty() {
                let (here, behind) = rest.split_at(alike(rest));
                let exponent = here[0].leaf.exponent();
                // A leaf of one or two photons is flat by chance, so leaves are not sorted by flatness.
                let flat = here
                    .iter()
                    .fold(u8::MAX, |flat, seen| flat & seen.leaf.flat());
                let axes = flat_last(flat);
                if flat == 0 {
                    tray.lay(lanes, &self.photons.planes, &self.frame, axes, here);
                    tray.gather_all(lanes, &self.frame, queries, exponent, found);
                } else {
                    flat_tray.lay(lanes, &self.photons.planes, &self.frame, axes, here);
                    flat_tray.gather_all(lanes, &self.frame, queries, exponent, found);
                }
                rest = behind;
            }
            first = end;
        }
        Ok(())
    }
}

/// Begins the results: sums of nothing, and the number of photons in the 27 blocks around each query.
fn begin(
    photons: &PhotonPlanes,
    queries: &[PlacedQuery],
    seen: &[Seen],
    found: &mut [Gathered],
) -> Result<(), GatherError> {
    let mut block = None;
    let mut around = Gathered::default();
    for (query, found) in queries.iter().zip(found) {
        if block != Some(query.block) {
            block = Some(query.block);
            around.photons = photons.photons_around(query, seen);
            photons.planes.limits.check_count(around.photons)?;
        }
        *found = around;
    }
    Ok(())
}

/// The order of the axes: an axis on which the leaves are flat comes last, if there is one.
fn flat_last(flat: u8) -> [usize; 3] {
    match flat.trailing_zeros() {
        0 => [1, 2, 0],
        1 => [0, 2, 1],
        _ => [0, 1, 2],
    }
}

/// The number of leaves from the first on that go on one tray: leaves of one exponent, because each exponent
/// is summed on its own.
fn alike(seen: &[Seen]) -> usize {
    let exponent = seen[0].leaf.exponent();
    let alike = seen.iter().take(TRAY);
    alike
        .take_while(|seen| seen.leaf.exponent() == exponent)
        .count()
}

impl<L: Lanes, P: Positions<L>, const PLANES: usize> Tray<L, P, PLANES> {
    #[inline(always)]
    fn gather_all(
        &self,
        lanes: L,
        frame: &Frame,
        queries: &[PlacedQuery],
        exponent: u8,
        found: &mut [Gathered],
    ) {
        let present = self.present();
        for (query, found) in queries.iter().zip(found) {
            let position = frame.position(query);
            let touched = lanes.touched(&self.boxes, position) & present;
            let place = ordered(frame.place(position), self.axes);
            let query = P::query(lanes, frame, place);
            self.gather(lanes, &query, touched, exponent, found);
        }
    }

    /// Adds the photons in range of the leaves whose bits are set to the sums of a query.
    #[inline(always)]
    fn gather(
        &self,
        lanes: L,
        query: &P::Query,
        mut touched: u32,
        exponent: u8,
        found: &mut Gathered,
    ) {
        let mut sums = lanes.no_sums();
        let mut tests = 0;
        while touched != 0 {
            let leaf = &self.leaves[touched.trailing_zeros() as usize];
            touched &= touched - 1;
            let in_range = P::in_range(lanes, &leaf.positions, query);
            lanes.add(&mut sums, in_range, &leaf.powers);
            tests += leaf.photons;
        }
        found.tests += tests;
        let (totals, count) = lanes.totals::<PLANES>(sums);
        found.sums.count += u64::from(count);
        let bytes_each = if PLANES.is_multiple_of(2) { 2 } else { 1 };
        for (index, total) in totals.into_iter().enumerate() {
            let (channel, byte) = (index / bytes_each, index % bytes_each);
            // A tray's sum has 18 bits, and an exponent is at most 24.
            let total = u64::from(total) << (usize::from(exponent) + 8 * byte);
            found.sums.power[channel] += u128::from(total);
        }
    }
}
