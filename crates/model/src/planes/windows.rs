//! Windows: consecutive queries near each other, and the leaves around them.

use std::ops::Range;

use super::cube::{FRAME_CUBES, Part, centre, on_axis};
use super::gather::PlacedQuery;
use super::leaf::Leaf;
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
    #[inline]
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
pub(super) struct Region {
    first: [u32; 3],
    last: [u32; 3],
}

impl Region {
    /// The region from one block before the blocks of `spans` to one behind.
    #[inline]
    fn around(spans: &[Span], edge: u32) -> Self {
        let (mut first, mut last) = ([u32::MAX; 3], [0; 3]);
        for span in spans {
            let block = in_frame(span.block, edge);
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

    /// The parts that lie in the cubes of the frame.
    #[inline]
    pub fn parts(&self, edge: u32) -> Parts {
        let (mut first, mut last) = ([[0; CUBES]; 3], [[0; CUBES]; 3]);
        for axis in 0..3 {
            for cube in 0..CUBES {
                let corner = cube as u32 * edge;
                let at = self.first[axis].saturating_sub(corner);
                first[axis][cube] = on_axis(at as u16, axis);
                // The result is of no use where the region ends before the cube.
                let at = self.last[axis].saturating_sub(corner).min(edge - 1);
                last[axis][cube] = on_axis(at as u16, axis);
            }
        }
        Parts { first, last }
    }

    /// The lowest and the highest coordinates in fine steps of the frame.
    #[inline]
    pub fn steps(&self, edge_bits: u32) -> [[u16; 3]; 2] {
        let low = self.first.map(|block| (block << edge_bits) as u16);
        let high = self
            .last
            .map(|block| (((block + 1) << edge_bits) - 1) as u16);
        [low, high]
    }
}

/// The cubes on an edge of the frame.
const CUBES: usize = FRAME_CUBES as usize;

/// The parts of a region in the cubes of the frame, axis by axis.
#[derive(Copy, Clone, Debug)]
pub(super) struct Parts {
    first: [[u16; CUBES]; 3],
    last: [[u16; CUBES]; 3],
}

impl Parts {
    /// The part in a cube, which must not be empty.
    #[inline]
    pub fn of(&self, cube: [u8; 3]) -> Part {
        let [x, y, z] = cube.map(|at| usize::from(at) % CUBES);
        let packed = |on: &[[u16; CUBES]; 3]| on[0][x] | on[1][y] | on[2][z];
        Part::new(packed(&self.first), packed(&self.last))
    }
}

/// Whether a photon of the leaf may be between `low` and `high`.
#[inline]
fn meets(seen: &Seen, [low, high]: &[[u16; 3]; 2]) -> bool {
    // Without branches, because neither answer is rare.
    let mut meets = true;
    for axis in 0..3 {
        meets &= seen.high[axis] >= low[axis];
        meets &= seen.low[axis] <= high[axis];
    }
    meets
}

/// The block in the frame whose middle cube contains it.
#[inline]
pub(super) fn in_frame(block: [i32; 3], edge: u32) -> [u32; 3] {
    block.map(|at| edge + (at as u32 & (edge - 1)))
}

/// Consecutive queries of one block and one facing.
#[derive(Copy, Clone, Debug)]
pub(super) struct Span {
    block: [i32; 3],
    facing: u32,
    /// The end of the queries; they begin where those of the span before end.
    end: usize,
}

impl Span {
    /// All spans of `queries`, in their order.
    fn all(queries: &[PlacedQuery]) -> Vec<Self> {
        let mut spans: Vec<Self> = Vec::with_capacity(queries.len());
        for (index, query) in queries.iter().enumerate() {
            let (block, facing, end) = (query.block, query.facing, index + 1);
            match spans.last_mut() {
                Some(span) if span.block == block && span.facing == facing => span.end = end,
                _ => spans.push(Self { block, facing, end }),
            }
        }
        spans
    }

    /// The end of the span's queries.
    #[inline]
    pub fn end(&self) -> usize {
        self.end
    }

    /// The region of the 27 blocks around the span's.
    #[inline]
    pub fn region(&self, edge: u32) -> Region {
        Region::around(std::slice::from_ref(self), edge)
    }

    /// Whether both are in one cube of 2^`bits` blocks and gather the same groups.
    #[inline]
    fn is_beside(&self, other: &Self, bits: u32) -> bool {
        let apart = (0..3).fold(0, |apart, axis| {
            apart | (self.block[axis] ^ other.block[axis]) >> bits
        });
        apart == 0 && self.facing == other.facing
    }
}

/// The spans from the first one on that are in one cube of 2^`bits` blocks.
#[inline]
fn count_beside(spans: &[Span], bits: u32) -> usize {
    let beside = |span: &&Span| span.is_beside(&spans[0], bits);
    spans.iter().take_while(beside).count()
}

/// Queries that share a list of leaves.
pub(super) struct Window<'a> {
    pub spans: &'a [Span],
    /// The leaves around the cube of the queries, by exponent.
    pub seen: &'a [Seen],
    /// Whether these are others than those of the window before.
    pub is_first: bool,
    /// The indices of the leaves that the queries gather from.
    pub near: &'a [u32],
}

/// The widths of windows: a cube of 8 blocks, 4, 2, and a block.
const LEVELS: usize = 4;

/// The windows of a gather. The leaves around a cube are looked up once. Where they are more than a tray
/// holds, windows are half as wide, and so on down to a block.
pub(super) struct Windows<'a> {
    photons: &'a PhotonPlanes,
    /// Whether queries of a facing gather a group.
    faces: &'a dyn Fn(u32, u32) -> bool,
    spans: Vec<Span>,
    /// The end of the last window's spans.
    next: usize,
    /// The ends of the spans in the cube that was looked up last, in its half, and so on to the block.
    ends: [usize; LEVELS],
    /// The leaves around the cube.
    seen: Vec<Seen>,
    /// The indices of the leaves around the cube, its half, and so on to the block.
    near: [Vec<u32>; LEVELS],
}

impl<'a> Windows<'a> {
    pub fn new(
        photons: &'a PhotonPlanes,
        queries: &[PlacedQuery],
        faces: &'a dyn Fn(u32, u32) -> bool,
    ) -> Self {
        Self {
            photons,
            faces,
            spans: Span::all(queries),
            next: 0,
            ends: [0; LEVELS],
            seen: Vec::new(),
            near: Default::default(),
        }
    }

    /// The next window.
    pub fn next(&mut self) -> Option<Window<'_>> {
        let edge_bits = self.photons.planes.layout.edge_bits();
        let first = self.next;
        if first == self.spans.len() {
            return None;
        }
        let is_first = first == self.ends[0];
        if is_first {
            let end = first + count_beside(&self.spans[first..], edge_bits);
            self.ends = [first; LEVELS];
            self.ends[0] = end;
            self.look_up(first..end);
        }
        let level = self.level(first, edge_bits);
        Some(Window {
            spans: &self.spans[first..self.next],
            seen: &self.seen,
            is_first,
            near: &self.near[level],
        })
    }

    /// Finds the window from the first span on: its level and, in `next`, its end.
    fn level(&mut self, first: usize, edge_bits: u32) -> usize {
        let mut level = 0;
        while self.near[level].len() > TRAY && level < edge_bits as usize {
            level += 1;
            if self.ends[level] == first {
                let around = &self.spans[first..self.ends[level - 1]];
                let end = first + count_beside(around, edge_bits - level as u32);
                self.ends[level..].fill(first);
                self.ends[level] = end;
                self.narrow(level - 1, first..end);
            }
        }
        self.next = self.ends[level];
        level
    }

    /// Finds the leaves around the queries of a cube.
    fn look_up(&mut self, spans: Range<usize>) {
        let (photons, edge_bits) = (self.photons, self.photons.planes.layout.edge_bits());
        let spans = &self.spans[spans];
        let region = Region::around(spans, photons.cube_edge());
        // Cubes are numbered from the one before the queries' own.
        let corner = spans[0].block.map(|at| i64::from(at >> edge_bits) - 1);
        let cube = |block: [u32; 3]| {
            std::array::from_fn(|axis| corner[axis] + i64::from(block[axis] >> edge_bits))
        };
        let low: [i64; 3] = cube(region.first);
        let steps = region.steps(photons.format().radius_bits());
        let facing = spans[0].facing;
        // Most neighbouring runs are of one group.
        let mut answered = None;
        let seen = &mut self.seen;
        seen.clear();
        photons.rows.within(low, cube(region.last), |offset, run| {
            let group = photons.groups[run];
            let faces = match answered {
                Some((other, faces)) if other == group => faces,
                _ => (self.faces)(facing, group),
            };
            answered = Some((group, faces));
            if !faces {
                return;
            }
            let offset =
                std::array::from_fn(|axis| offset[axis] + (low[axis] - corner[axis]) as u32);
            for leaf in photons.planes.leaves_of(run) {
                let leaf = Seen::new(photons, offset, leaf);
                if meets(&leaf, &steps) {
                    seen.push(leaf);
                }
            }
        });
        // Leaves are sorted by exponent, because the kernel sums each exponent on its own.
        let exponent = |seen: &Seen| seen.leaf.exponent();
        if seen
            .iter()
            .any(|other| exponent(other) != exponent(&seen[0]))
        {
            seen.sort_by_key(exponent);
        }
        self.near[0].clear();
        self.near[0].extend(0..self.seen.len() as u32);
    }

    /// Copies the leaves of a level that are around these spans to the next level.
    fn narrow(&mut self, level: usize, spans: Range<usize>) {
        let region = Region::around(&self.spans[spans], self.photons.cube_edge());
        let steps = region.steps(self.photons.format().radius_bits());
        let [wide, narrow] = &mut self.near[level..level + 2] else {
            unreachable!("a level below");
        };
        narrow.clear();
        for index in &*wide {
            if meets(&self.seen[*index as usize], &steps) {
                narrow.push(*index);
            }
        }
    }
}
