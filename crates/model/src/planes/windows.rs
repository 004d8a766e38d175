//! Windows: consecutive queries near each other, and the leaves around them.

use super::cube::{FRAME_CUBES, block_on, centre};
use super::gather::PlacedQuery;
use super::leaf::{LEAF, Leaf};
use super::photon_planes::PhotonPlanes;
use super::tray::TRAY;

/// A leaf in the frame of a cube's queries.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) struct Seen {
    pub leaf: Leaf,
    /// The offset of the leaf's cube in the frame.
    pub offset: [u8; 3],
    /// The lowest and the highest query coordinate on each axis, in fine steps of the frame, at which the
    /// distance to a photon of the leaf may be 0.
    pub low: [u16; 3],
    pub high: [u16; 3],
}

impl Seen {
    fn new(photons: &PhotonPlanes, offset: [u32; 3], leaf: &Leaf) -> Self {
        let format = photons.format();
        let cube_steps = photons.cube_edge() * format.edge_steps();
        let half = u32::from(format.half_steps());
        let (mut low, mut high) = ([0; 3], [0; 3]);
        for axis in 0..3 {
            // At most three edges of 2^14.
            let corner = offset[axis] * cube_steps;
            let [first, last] = photons.planes.cells(leaf, axis);
            // On half steps, a photon above the query has m = centre - query - 1.
            low[axis] = (corner + centre(format, first) - half) as u16;
            high[axis] = (corner + centre(format, last)) as u16;
        }
        Self {
            leaf: *leaf,
            offset: offset.map(|cubes| cubes as u8),
            low,
            high,
        }
    }
}

/// Blocks of the frame, from the first to the last on each axis.
#[derive(Copy, Clone, Debug)]
struct Region {
    first: [u32; 3],
    last: [u32; 3],
}

impl Region {
    /// The region from one block before the blocks of `queries` to one behind.
    fn around(queries: &[PlacedQuery], edge: u32) -> Self {
        let (mut first, mut last) = ([u32::MAX; 3], [0; 3]);
        for query in queries {
            let block = in_frame(query.block, edge);
            for axis in 0..3 {
                first[axis] = block[axis].min(first[axis]);
                last[axis] = block[axis].max(last[axis]);
            }
        }
        Self {
            first: first.map(|block| block - 1),
            last: last.map(|block| block + 1),
        }
    }

    /// Whether a photon of the leaf may be in the region.
    fn meets(&self, seen: &Seen, radius_bits: u32) -> bool {
        (0..3).all(|axis| {
            u32::from(seen.high[axis]) >> radius_bits >= self.first[axis]
                && u32::from(seen.low[axis]) >> radius_bits <= self.last[axis]
        })
    }

    /// Whether all photons of the leaf are in the region.
    fn contains(&self, seen: &Seen, radius_bits: u32) -> bool {
        (0..3).all(|axis| {
            u32::from(seen.low[axis]) >> radius_bits >= self.first[axis]
                && u32::from(seen.high[axis]) >> radius_bits <= self.last[axis]
        })
    }
}

/// The block in the frame whose middle cube contains it.
pub(super) fn in_frame(block: [i32; 3], edge: u32) -> [u32; 3] {
    block.map(|at| edge + (at as u32 & (edge - 1)))
}

/// Whether both queries are in one cube of 2^`bits` blocks and gather the same groups.
fn is_beside(a: &PlacedQuery, b: &PlacedQuery, bits: u32) -> bool {
    a.facing == b.facing && (0..3).all(|axis| a.block[axis] >> bits == b.block[axis] >> bits)
}

/// The end of the queries from `first` on that are in one cube of 2^`bits` blocks.
fn end_of(queries: &[PlacedQuery], first: usize, bits: u32) -> usize {
    let beside = |query: &&PlacedQuery| is_beside(query, &queries[first], bits);
    first + queries[first..].iter().take_while(beside).count()
}

/// The windows of a gather. The leaves around a cube are looked up once. Where they are more than a tray
/// holds, windows are half as wide, or a block.
pub(super) struct Windows<'a, F> {
    photons: &'a PhotonPlanes,
    queries: &'a [PlacedQuery],
    /// Whether queries of a facing gather a group.
    faces: F,
    /// The ends of the queries in the cube and in the half cube that were looked up last.
    ends: [usize; 2],
    /// The leaves around the cube, the half cube and the block.
    seen: [Vec<Seen>; 3],
}

impl<'a, F: Fn(u32, u32) -> bool> Windows<'a, F> {
    pub fn new(photons: &'a PhotonPlanes, queries: &'a [PlacedQuery], faces: F) -> Self {
        Self {
            photons,
            queries,
            faces,
            ends: [0; 2],
            seen: Default::default(),
        }
    }

    /// The window of the queries from `first` on, which is the end of the window before: the window's end, and
    /// the leaves that the queries gather from, by exponent.
    pub fn next(&mut self, first: usize) -> (usize, &[Seen]) {
        let edge_bits = self.photons.planes.layout.edge_bits();
        if first >= self.ends[0] {
            self.ends = [end_of(self.queries, first, edge_bits), first];
            self.look_up(first);
        }
        if self.seen[0].len() <= TRAY || edge_bits == 0 {
            return (self.ends[0], &self.seen[0]);
        }
        if first >= self.ends[1] {
            self.ends[1] = end_of(&self.queries[..self.ends[0]], first, edge_bits - 1);
            self.narrow(0, first..self.ends[1]);
        }
        if self.seen[1].len() <= TRAY {
            return (self.ends[1], &self.seen[1]);
        }
        let end = end_of(&self.queries[..self.ends[1]], first, 0);
        self.narrow(1, first..end);
        (end, &self.seen[2])
    }

    /// Finds the leaves around the queries of a cube.
    fn look_up(&mut self, first: usize) {
        let (photons, edge_bits) = (self.photons, self.photons.planes.layout.edge_bits());
        let queries = &self.queries[first..self.ends[0]];
        let region = Region::around(queries, photons.cube_edge());
        // Cubes are numbered from the one before the queries' own.
        let corner = queries[0].block.map(|at| i64::from(at >> edge_bits) - 1);
        let cube = |block: [u32; 3]| {
            std::array::from_fn(|axis| corner[axis] + i64::from(block[axis] >> edge_bits))
        };
        let low = cube(region.first);
        let radius_bits = photons.format().radius_bits();
        let seen = &mut self.seen[0];
        seen.clear();
        photons.rows.within(low, cube(region.last), |offset, run| {
            if !(self.faces)(queries[0].facing, photons.groups[run]) {
                return;
            }
            let offset =
                std::array::from_fn(|axis| offset[axis] + (low[axis] - corner[axis]) as u32);
            debug_assert!(offset.iter().all(|cubes| *cubes < FRAME_CUBES));
            let leaves = photons.planes.leaves_of(run).iter();
            let leaves = leaves.map(|leaf| Seen::new(photons, offset, leaf));
            seen.extend(leaves.filter(|seen| region.meets(seen, radius_bits)));
        });
        // Leaves are sorted by exponent, because the kernel sums each exponent on its own.
        let exponent = |seen: &Seen| seen.leaf.exponent();
        if seen
            .iter()
            .any(|other| exponent(other) != exponent(&seen[0]))
        {
            seen.sort_by_key(exponent);
        }
    }

    /// Copies the leaves of a level that are around these queries to the next level.
    fn narrow(&mut self, level: usize, queries: std::ops::Range<usize>) {
        let region = Region::around(&self.queries[queries], self.photons.cube_edge());
        let radius_bits = self.photons.format().radius_bits();
        let mut seen = std::mem::take(&mut self.seen[level + 1]);
        seen.clear();
        let near = self.seen[level].iter();
        seen.extend(near.filter(|seen| region.meets(seen, radius_bits)));
        self.seen[level + 1] = seen;
    }
}

impl PhotonPlanes {
    /// The number of photons in the 27 blocks around the query.
    pub(super) fn photons_around(&self, query: &PlacedQuery, seen: &[Seen]) -> u64 {
        let edge = self.cube_edge();
        let region = Region::around(std::slice::from_ref(query), edge);
        let radius_bits = self.format().radius_bits();
        let count = |seen: &Seen| {
            if region.contains(seen, radius_bits) {
                u64::from(seen.leaf.photons)
            } else if region.meets(seen, radius_bits) {
                self.photons_in(&region, seen)
            } else {
                0
            }
        };
        seen.iter().map(count).sum()
    }

    /// The number of the leaf's photons in the region.
    fn photons_in(&self, region: &Region, seen: &Seen) -> u64 {
        let edge = self.cube_edge();
        let planes = self.planes.planes(&seen.leaf);
        let mut inside = [1_u8; LEAF];
        inside[planes.photons()..].fill(0);
        for axis in 0..3 {
            let corner = u32::from(seen.offset[axis]) * edge;
            // Differences wrap: those of blocks before the first one are large.
            let first = region.first[axis].wrapping_sub(corner) as u8;
            let blocks = (region.last[axis] - region.first[axis]) as u8;
            for (inside, block) in inside.iter_mut().zip(planes.blocks()) {
                *inside &= u8::from(block_on(*block, axis).wrapping_sub(first) <= blocks);
            }
        }
        inside.iter().map(|inside| u64::from(*inside)).sum()
    }
}
