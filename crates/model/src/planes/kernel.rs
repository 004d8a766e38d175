//! The loop over leaves and queries, generic over the instruction set.

use super::frame::Frame;
use super::gather::Gathered;
use super::lanes::{Lanes, Positions};
use super::leaf::LEAF;
use super::photon_planes::PhotonPlanes;
use super::store::Planes;
use super::tray::{Laid, TRAY, Tray, ordered};
use super::windows::{Seen, Span, Windows};
use crate::gather::GatherError;

/// The input and output of one gather.
pub(super) struct Work<'a, F> {
    pub photons: &'a PhotonPlanes,
    /// The queries' positions in the frames of their cubes.
    pub positions: &'a [[u16; 3]],
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
        let planes = &self.photons.planes;
        let mut laid = Laid::<L, P, PLANES>::new();
        let mut flat_laid = Laid::<L, Q, PLANES>::new();
        let mut tray = Tray::new(shift, self.frame.largest);
        let mut flat = None;
        let mut first = 0;
        while let Some(window) = self.windows.next() {
            if window.is_first {
                flat = wall(planes, &self.frame, window.seen);
                match flat {
                    None => laid.lay(lanes, planes, &self.frame, ([0, 1, 2], 0), window.seen),
                    Some(wall) => flat_laid.lay(lanes, planes, &self.frame, wall, window.seen),
                }
            }
            let end = window.spans.last().map_or(first, Span::end);
            self.found[first..end].fill(Gathered::default());
            let mut rest = window.near;
            while !rest.is_empty() {
                let (here, behind) = rest.split_at(alike(window.seen, rest));
                let exponent = window.seen[here[0] as usize].leaf.exponent();
                tray.set(window.seen, here);
                let mut start = first;
                for span in window.spans {
                    let photons = photons_around(lanes, self.photons, &tray, window.seen, span);
                    let queries = Queries {
                        frame: &self.frame,
                        positions: &self.positions[start..span.end()],
                        photons,
                        exponent,
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

/// The number of the tray's photons in the 27 blocks around the span's.
#[inline(always)]
fn photons_around<L: Lanes>(
    lanes: L,
    photons: &PhotonPlanes,
    tray: &Tray,
    seen: &[Seen],
    span: &Span,
) -> u64 {
    let edge = photons.cube_edge();
    let region = span.region(edge);
    let [low, high] = region.steps(photons.format().radius_bits());
    let mut meeting = lanes.meeting(&tray.boxes, low, high) & tray.present;
    let mut around = 0;
    while meeting != 0 {
        let seen = &seen[tray.leaves[meeting.trailing_zeros() as usize % TRAY] as usize];
        meeting &= meeting - 1;
        around += if edge == 1 {
            u64::from(seen.leaf.photons)
        } else {
            let part = region.in_cube(seen.offset, edge);
            let planes = photons.planes.planes(&seen.leaf);
            // Lanes without a photon have any block.
            let present = u32::MAX >> (LEAF - planes.photons());
            let inside = lanes.inside(part, planes.blocks()) & present;
            inside.count_ones().into()
        };
    }
    around
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
}

impl<L: Lanes, P: Positions<L>, const PLANES: usize> Laid<L, P, PLANES> {
    #[inline(always)]
    fn gather_all(&self, lanes: L, tray: &Tray, queries: &Queries, found: &mut [Gathered]) {
        for (position, found) in queries.positions.iter().zip(found) {
            let touched = lanes.touched(&tray.boxes, *position) & tray.present;
            let place = ordered(queries.frame.place(*position), self.axes);
            let query = P::query(lanes, queries.frame, place, self.shared);
            found.photons += queries.photons;
            self.gather(lanes, tray, &query, touched, queries.exponent, found);
        }
    }

    /// Adds the photons in range of the leaves whose bits are set to the sums of a query.
    #[inline(always)]
    fn gather(
        &self,
        lanes: L,
        tray: &Tray,
        query: &P::Query,
        mut touched: u32,
        exponent: u8,
        found: &mut Gathered,
    ) {
        let mut sums = lanes.no_sums();
        let mut tests = 0;
        while touched != 0 {
            let leaf = &self.leaves[tray.leaves[touched.trailing_zeros() as usize % TRAY] as usize];
            touched &= touched - 1;
            let in_range = P::in_range(lanes, &leaf.positions, query);
            sums = lanes.add(sums, in_range, &leaf.powers);
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
