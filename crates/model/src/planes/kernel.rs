//! The loop over leaves and queries, generic over the instruction set.

use photoncube_spec::Query;

use super::frame::Frame;
use super::gather::Gathered;
use super::lanes::{Lanes, Positions};
use super::store::PhotonPlanes;
use super::surroundings::{Seen, Surroundings};
use super::tray::{TRAY, Tray, ordered};

/// The input and output of one gather.
pub(super) struct Work<'a> {
    pub planes: &'a PhotonPlanes,
    pub around: &'a Surroundings,
    pub queries: &'a [Query],
    pub frame: Frame,
    /// The results, one for each query.
    pub found: &'a mut [Gathered],
}

impl Work<'_> {
    /// Gathers every query with the instruction set `L`, which the processor must have. Leaves that are flat
    /// on one axis use `F`.
    #[inline(always)]
    pub fn run<L: Lanes, P: Positions<L>, F: Positions<L>, const PLANES: usize>(self, lanes: L) {
        let nothing = Gathered {
            photons: self.around.photons(),
            ..Gathered::default()
        };
        self.found.fill(nothing);
        let shift = self.planes.format().radius_bits().saturating_sub(u8::BITS);
        let mut tray = Tray::<L, P, PLANES>::new(shift, self.frame.largest);
        let mut flat_tray = Tray::<L, F, PLANES>::new(shift, self.frame.largest);
        let mut rest = self.around.seen.as_slice();
        while !rest.is_empty() {
            let (here, behind) = rest.split_at(alike(rest));
            let exponent = here[0].leaf.exponent;
            // A leaf of one or two photons is flat by chance, so leaves are not sorted by flatness.
            let flat = here.iter().fold(u8::MAX, |flat, seen| flat & seen.flat);
            let axes = flat_last(flat);
            if flat == 0 {
                tray.lay(lanes, self.planes, &self.frame, axes, here);
                tray.gather_all(lanes, &self.frame, self.queries, exponent, self.found);
            } else {
                flat_tray.lay(lanes, self.planes, &self.frame, axes, here);
                flat_tray.gather_all(lanes, &self.frame, self.queries, exponent, self.found);
            }
            rest = behind;
        }
    }
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
    let exponent = seen[0].leaf.exponent;
    let alike = seen.iter().take(TRAY);
    alike
        .take_while(|seen| seen.leaf.exponent == exponent)
        .count()
}

impl<L: Lanes, P: Positions<L>, const PLANES: usize> Tray<L, P, PLANES> {
    #[inline(always)]
    fn gather_all(
        &self,
        lanes: L,
        frame: &Frame,
        queries: &[Query],
        exponent: u8,
        found: &mut [Gathered],
    ) {
        let present = self.present();
        for (query, found) in queries.iter().zip(found) {
            // The coordinates are less than two edges of 2^14.
            let position = [
                query.position[0] as u16,
                query.position[1] as u16,
                query.position[2] as u16,
            ];
            let touched = lanes.touched(&self.boxes, position) & present;
            let place = ordered(frame.place(query.position), self.axes);
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
        let mut sums = [lanes.no_sum(); PLANES];
        let mut count = lanes.no_count();
        let mut tests = 0;
        while touched != 0 {
            let leaf = &self.leaves[touched.trailing_zeros() as usize];
            touched &= touched - 1;
            let in_range = P::in_range(lanes, &leaf.positions, query);
            count = lanes.add_count(count, in_range);
            for (sum, mantissas) in sums.iter_mut().zip(&leaf.mantissas) {
                *sum = lanes.add(*sum, in_range, mantissas);
            }
            tests += leaf.photons;
        }
        found.tests += tests;
        let (totals, count) = totals(lanes, sums, count);
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

/// The totals of all mantissa sums, and of the count.
#[inline(always)]
fn totals<L: Lanes, const PLANES: usize>(
    lanes: L,
    sums: [L::Sum; PLANES],
    count: L::Count,
) -> ([u32; PLANES], u32) {
    let mut totals = [0; PLANES];
    if let [a, b, c] = sums[..] {
        let (three, count) = lanes.totals([a, b, c], count);
        totals.copy_from_slice(&three);
        return (totals, count);
    }
    for (total, sum) in totals.iter_mut().zip(sums) {
        *total = lanes.total(sum);
    }
    (totals, lanes.count(count))
}
