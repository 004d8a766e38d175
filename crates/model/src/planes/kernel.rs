//! The loop over leaves and queries, generic over the instruction set.

use super::around::Around;
use super::frame::Frame;
use super::gather::Gathered;
use super::lanes::{Lanes, Positions};
use super::photon_planes::PhotonPlanes;
use super::store::Planes;
use super::tray::{Laid, TRAY, Tray, ordered};
use super::windows::{Seen, Span, Windows};
use crate::gather::GatherError;

/// The input and output of one gather.
pub(super) struct Work<'a> {
    pub photons: &'a PhotonPlanes,
    /// The queries' positions in the frames of their cubes.
    pub positions: &'a [[u16; 3]],
    pub frame: Frame,
    pub windows: Windows<'a>,
    /// The results, one for each query.
    pub found: &'a mut [Gathered],
}

impl Work<'_> {
    /// Gathers every query with the instruction set `L`, which the processor must have. Leaves that are flat
    /// on one axis use `Q`.
    #[inline(always)]
    pub fn run<L: Lanes, P: Positions<L>, Q: Positions<L>, const PLANES: usize>(
        mut self,
        lanes: L,
    ) -> Result<(), GatherError> {
        let (edge, edge_bits) = (self.photons.cube_edge(), self.frame.edge_bits());
        let shift = edge_bits.saturating_sub(u8::BITS);
        let planes = &self.photons.planes;
        let mut laid = Laid::<L, P, PLANES>::new();
        let mut flat_laid = Laid::<L, Q, PLANES>::new();
        let mut around = Around::default();
        let mut tray = Tray::new(shift, self.frame.largest);
        let mut flat = None;
        let mut first = 0;
        while let Some(window) = self.windows.next() {
            if window.is_first {
                around.lay(planes, window.seen);
                flat = wall(planes, &self.frame, window.seen);
                match flat {
                    None => laid.lay(lanes, planes, &self.frame, ([0, 1, 2], 0), window.seen),
                    Some(wall) => flat_laid.lay(lanes, planes, &self.frame, wall, window.seen),
                }
            }
            let end = window.spans.last().map_or(first, Span::end);
            if window.near.is_empty() {
                self.found[first..end].fill(Gathered::default());
            }
            let mut rest = window.near;
            while !rest.is_empty() {
                let is_first = rest.len() == window.near.len();
                let (here, behind) = rest.split_at(alike(window.seen, rest));
                let exponent = window.seen[here[0] as usize].leaf.exponent();
                tray.set(window.seen, here);
                let mut start = first;
                for span in window.spans {
                    let region = span.region(edge);
                    let steps = region.steps(edge_bits);
                    let photons = around.count(lanes, &tray, window.seen, &region, edge, steps);
                    let queries = Queries {
                        frame: &self.frame,
                        positions: &self.positions[start..span.end()],
                        photons,
                        exponent,
                        is_first,
                    };
                    let found = &mut self.found[start..span.end()];
                    if flat.is_none() {
                        laid.gather_all(lanes, &tray, &queries, found);
                    } else {
                        flat_laid.gather_all(lanes, &tray, &queries, found);
                    }
                    start = span.end();
                }
                rest = behind;
            }
            let mut start = first;
            for span in window.spans {
                planes.limits.check_count(self.found[start].photons)?;
                start = span.end();
            }
            first = end;
        }
        Ok(())
    }
}

/// Where all photons are on a wall along two axes, in a format of bytes: the order of the axes, the third last, and
/// the coordinate that the photons share on it. A leaf of one or two photons is flat by chance, so leaves are not
/// sorted by flatness.
fn wall(planes: &Planes, frame: &Frame, seen: &[Seen]) -> Option<([usize; 3], i16)> {
    let flat = seen.iter().map(|seen| seen.leaf.flat());
    let flat = flat.reduce(|a, b| a & b).filter(|_| !planes.layout.wide)?;
    let axes = match flat.trailing_zeros() {
        0 => [1, 2, 0],
        1 => [0, 2, 1],
        2 => [0, 1, 2],
        _ => return None,
    };
    let coordinate = |seen: &Seen| {
        let in_cube = planes.planes(&seen.leaf).shared(axes[2], frame.edge_bits());
        frame.corner(seen.offset)[axes[2]] + in_cube as i16
    };
    let shared = coordinate(&seen[0]);
    let alike = seen.iter().all(|seen| coordinate(seen) == shared);
    alike.then_some((axes, shared))
}

/// The number of leaves from the first on that go on one tray: leaves of one exponent, because each exponent
/// is summed on its own.
fn alike(seen: &[Seen], leaves: &[u32]) -> usize {
    let exponent = |leaf: &u32| seen[*leaf as usize].leaf.exponent();
    let alike = leaves.iter().take(TRAY);
    alike
        .take_while(|leaf| exponent(leaf) == exponent(&leaves[0]))
        .count()
}

/// The queries of a span before a tray.
struct Queries<'a> {
    frame: &'a Frame,
    positions: &'a [[u16; 3]],
    /// The number of the tray's photons in the blocks around them.
    photons: u64,
    /// The exponent of the tray's photons.
    exponent: u8,
    /// Whether the tray is the first before these queries.
    is_first: bool,
}

/// The number of queries whose touched leaves are found before the first of them is gathered. A processor guesses
/// how many leaves a query has. It learns soon that a guess is wrong where it need not wait for the boxes.
const AHEAD: usize = 16;

impl<L: Lanes, P: Positions<L>, const PLANES: usize> Laid<L, P, PLANES> {
    #[inline(always)]
    fn gather_all(&self, lanes: L, tray: &Tray, queries: &Queries, found: &mut [Gathered]) {
        let positions = queries.positions.chunks(AHEAD);
        for (positions, found) in positions.zip(found.chunks_mut(AHEAD)) {
            let mut touched = [0; AHEAD];
            for (touched, position) in touched.iter_mut().zip(positions) {
                *touched = lanes.touched(&tray.boxes, *position) & tray.present;
            }
            for ((position, touched), found) in positions.iter().zip(touched).zip(found) {
                let place = ordered(queries.frame.place(*position), self.axes);
                let query = P::query(lanes, queries.frame, place, self.shared);
                let here = self.gather(lanes, tray, &query, touched);
                // A sum is written without being read first where there is none yet.
                let before = if queries.is_first {
                    Gathered::default()
                } else {
                    *found
                };
                *found = here.added_to(&before, queries);
            }
        }
    }

    /// The photons in range of the leaves whose bits are set.
    #[inline(always)]
    fn gather(&self, lanes: L, tray: &Tray, query: &P::Query, mut touched: u32) -> Here<PLANES> {
        let mut sums = lanes.no_sums();
        let mut tests = 0;
        while touched != 0 {
            let leaf = &self.leaves[tray.leaves[touched.trailing_zeros() as usize % TRAY] as usize];
            touched &= touched - 1;
            let in_range = P::in_range(lanes, &leaf.positions, query);
            sums = lanes.add(sums, in_range, &leaf.powers);
            tests += leaf.photons;
        }
        let (totals, count) = lanes.totals::<PLANES>(sums);
        Here {
            totals,
            count,
            tests,
        }
    }
}

/// The result of a query on one tray.
struct Here<const PLANES: usize> {
    /// The sums of the mantissas' bytes of photons in range, for each plane.
    totals: [u32; PLANES],
    count: u32,
    tests: u64,
}

impl<const PLANES: usize> Here<PLANES> {
    /// The result with that on the trays before.
    #[inline(always)]
    fn added_to(&self, before: &Gathered, queries: &Queries) -> Gathered {
        let mut found = *before;
        found.photons += queries.photons;
        found.tests += self.tests;
        found.sums.count += u64::from(self.count);
        let bytes_each = if PLANES.is_multiple_of(2) { 2 } else { 1 };
        for (index, total) in self.totals.into_iter().enumerate() {
            let (channel, byte) = (index / bytes_each, index % bytes_each);
            // A tray's sum has 18 bits, and an exponent is at most 24.
            let total = u64::from(total) << (usize::from(queries.exponent) + 8 * byte);
            found.sums.power[channel] += u128::from(total);
        }
        found
    }
}
