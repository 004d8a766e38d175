//! Stores photons in planes of bytes.

use photoncube_spec::{FormatError, PhotonBlock, PhotonFormat, PhotonRecord};

use super::cube::{block_on, centre, edge_bits, packed};
use super::leaf::{LEAF, Leaf, into_leaves};
use crate::gather::{Limits, RangeError};

/// A byte for each photon of a leaf.
pub(super) type Bytes = [u8; LEAF];

/// Two bytes for each photon of a leaf, little-endian.
pub(super) type Words = [u8; 2 * LEAF];

/// The planes of a leaf, with bytes behind them that the kernel may read and never uses, because it always
/// reads a full leaf. There are at most 12 planes and one more, since positions of two bytes take two planes
/// each.
type Window = [u8; 13 * LEAF];

/// The number of bytes behind the last photon, so that its leaf has a full window.
const SLACK: usize = size_of::<Window>();

/// The layout of a leaf of n photons. Each plane has n values: x, y, z, the blocks in the cube, then the
/// channels' mantissas, the low byte of each followed by the high byte if there is one. Positions are from
/// the corner of the block. A position on an axis on which the leaf is flat is stored once. Where a cube is
/// a block, there is no plane of blocks.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) struct Layout {
    /// Whether centres take two bytes (little-endian) instead of one.
    pub wide: bool,
    /// The number of planes of mantissa bytes: 1, 2, 3 or 6.
    pub mantissa_planes: usize,
}

impl Layout {
    fn of(format: &PhotonFormat) -> Self {
        let channels = format.power.channels.count() as usize;
        Self {
            wide: format.radius_bits() > u8::BITS,
            mantissa_planes: channels * format.power.mantissa_bits.div_ceil(u8::BITS) as usize,
        }
    }

    /// The bits of the number of blocks on a cube's edge.
    pub fn edge_bits(self) -> u32 {
        edge_bits(self.wide)
    }

    /// Where the planes of a leaf begin: x, y, z, the blocks, the mantissas.
    #[inline(always)]
    fn starts(self, leaf: &Leaf) -> [usize; 5] {
        let photons = usize::from(leaf.photons);
        let bytes_each = 1 + usize::from(self.wide);
        let mut starts = [0; 5];
        for axis in 0..3 {
            let values = if leaf.flat() >> axis & 1 == 1 {
                1
            } else {
                photons
            };
            starts[axis + 1] = starts[axis] + values * bytes_each;
        }
        starts[4] = starts[3] + if self.wide { 0 } else { 2 * photons };
        starts
    }
}

/// The photons of a map in one format, in planes.
///
/// In a format of up to 8 bits per radius a photon's position takes 5 bytes, one less in a leaf that is flat on an
/// axis; otherwise 6, or 4. Each channel takes a byte or, over 8 bits, two. Each leaf takes 12
/// further bytes.
#[derive(Debug, Clone)]
pub(super) struct Planes {
    pub format: PhotonFormat,
    pub limits: Limits,
    pub layout: Layout,
    /// The planes of all leaves, followed by [`SLACK`] bytes.
    bytes: Vec<u8>,
    leaves: Vec<Leaf>,
    /// The index of each run's first leaf, and the number of leaves.
    runs: Vec<u32>,
    photons: usize,
}

impl Planes {
    /// Makes planes without photons.
    ///
    /// # Errors
    /// The format is not legal.
    pub fn new(format: &PhotonFormat) -> Result<Self, FormatError> {
        Ok(Self {
            format: *format,
            limits: Limits::of(&format.into())?,
            layout: Layout::of(format),
            bytes: vec![0; SLACK],
            leaves: Vec::new(),
            runs: vec![0],
            photons: 0,
        })
    }

    /// Bits of a cell's index in its cube.
    fn cell_bits(&self) -> u32 {
        self.format.position_bits + self.layout.edge_bits()
    }

    /// Appends a run: photons of one cube. The offset of each block is its place in the cube.
    ///
    /// # Errors
    /// A value does not fit the format. Nothing is stored in this case.
    pub fn push_run(&mut self, blocks: &[PhotonBlock<'_>]) -> Result<(), RangeError> {
        let mut records = Vec::new();
        for block in blocks {
            self.limits.check_records(block.exponent, block.photons)?;
            let corner = block
                .offset
                .map(|at| (at << self.format.position_bits) as u16);
            records.extend(block.photons.iter().map(|photon| PhotonRecord {
                position: std::array::from_fn(|axis| corner[axis] + photon.position[axis]),
                exponent: block.exponent + photon.exponent,
                ..*photon
            }));
        }
        self.bytes.truncate(self.bytes.len() - SLACK);
        for place in into_leaves(&mut records) {
            let start = u32::try_from(self.bytes.len()).expect("photons of less than 4 GiB");
            let leaf = Leaf::new(&records[place.clone()], start, self.cell_bits());
            self.push_planes(&records[place], leaf.flat());
            self.leaves.push(leaf);
        }
        self.photons += records.len();
        self.bytes.resize(self.bytes.len() + SLACK, 0);
        self.runs.push(self.leaves.len() as u32);
        Ok(())
    }

    fn push_planes(&mut self, records: &[PhotonRecord], flat: u8) {
        let (format, wide) = (self.format, self.layout.wide);
        let in_block = (1 << format.position_bits) - 1;
        for axis in 0..3 {
            let values = if flat >> axis & 1 == 1 {
                1
            } else {
                records.len()
            };
            for record in &records[..values] {
                let cell = record.position[axis] & in_block;
                let centre = centre(&format, cell.into()).to_le_bytes();
                self.bytes.extend(&centre[..1 + usize::from(wide)]);
            }
        }
        if !wide {
            let block =
                |record: &PhotonRecord| record.position.map(|at| at >> format.position_bits);
            let blocks = records.iter().map(|record| packed(block(record)));
            self.bytes.extend(blocks.flat_map(u16::to_le_bytes));
        }
        let channels = format.power.channels.count() as usize;
        let bytes_each = self.layout.mantissa_planes / channels;
        for (channel, byte) in (0..channels).flat_map(|c| (0..bytes_each).map(move |b| (c, b))) {
            let mantissas = records.iter().map(|record| record.mantissa[channel]);
            self.bytes
                .extend(mantissas.map(|mantissa| mantissa.to_le_bytes()[byte]));
        }
    }

    /// Makes room for `photons` more, in leaves that are flat on no axis, so that the planes do not grow by doubling.
    pub fn reserve(&mut self, photons: usize) {
        let Layout {
            wide,
            mantissa_planes,
        } = self.layout;
        let positions = if wide { 3 * 2 } else { 3 + 2 };
        self.bytes
            .reserve_exact(photons * (positions + mantissa_planes));
    }

    /// Gives back the memory that the planes do not use.
    pub fn shrink_to_fit(&mut self) {
        self.bytes.shrink_to_fit();
        self.leaves.shrink_to_fit();
        self.runs.shrink_to_fit();
    }

    /// Appends the runs of `other`.
    pub fn append(&mut self, other: &Self) {
        self.bytes.truncate(self.bytes.len() - SLACK);
        let (leaves, bytes) = (self.leaves.len() as u32, self.bytes.len() as u32);
        self.bytes.extend_from_slice(&other.bytes);
        assert!(
            u32::try_from(self.bytes.len()).is_ok(),
            "photons of less than 4 GiB"
        );
        let moved = other.leaves.iter().map(|leaf| leaf.moved(bytes));
        self.leaves.extend(moved);
        self.runs
            .extend(other.runs[1..].iter().map(|first| first + leaves));
        self.photons += other.photons;
    }

    /// The number of photons stored.
    pub fn photons(&self) -> usize {
        self.photons
    }

    /// The number of bytes that planes, leaves and runs occupy.
    pub fn bytes(&self) -> usize {
        self.bytes.len() + size_of_val(self.leaves.as_slice()) + size_of_val(self.runs.as_slice())
    }

    /// The planes of a leaf.
    #[inline(always)]
    pub fn planes(&self, leaf: &Leaf) -> LeafPlanes<'_> {
        LeafPlanes {
            window: self.bytes[leaf.start as usize..]
                .first_chunk()
                .expect("a window behind the last photon"),
            leaf: *leaf,
            starts: self.layout.starts(leaf),
        }
    }

    /// The range of cells that a leaf of this format spans on an axis of its cube.
    pub fn cells(&self, leaf: &Leaf, axis: usize) -> [u32; 2] {
        leaf.cells(axis, self.cell_bits())
    }

    /// The leaves of a run.
    pub fn leaves_of(&self, run: usize) -> &[Leaf] {
        &self.leaves[self.runs[run] as usize..self.runs[run + 1] as usize]
    }
}

/// The planes of one leaf. Bytes behind those of its photons have any value.
#[derive(Copy, Clone, Debug)]
pub(super) struct LeafPlanes<'a> {
    window: &'a Window,
    leaf: Leaf,
    starts: [usize; 5],
}

impl<'a> LeafPlanes<'a> {
    /// The number of photons.
    #[inline(always)]
    pub fn photons(&self) -> usize {
        self.leaf.photons.into()
    }

    #[inline(always)]
    fn plane<const N: usize>(&self, start: usize) -> &'a [u8; N] {
        self.window[start..]
            .first_chunk()
            .expect("a window has room for it")
    }

    #[inline(always)]
    fn is_flat(&self, axis: usize) -> bool {
        self.leaf.flat() >> axis & 1 == 1
    }

    /// Positions on an axis in their blocks, in a format of bytes.
    #[inline(always)]
    pub fn bytes(&self, axis: usize) -> Bytes {
        let plane: &Bytes = self.plane(self.starts[axis]);
        if self.is_flat(axis) {
            [plane[0]; LEAF]
        } else {
            *plane
        }
    }

    /// Positions on an axis in their blocks, in a format of words.
    #[inline(always)]
    pub fn words(&self, axis: usize) -> Words {
        let plane: &Words = self.plane(self.starts[axis]);
        if !self.is_flat(axis) {
            return *plane;
        }
        let mut words = *plane;
        for word in words.chunks_exact_mut(2) {
            word.copy_from_slice(&plane[..2]);
        }
        words
    }

    /// The blocks of the photons in their cube, in a format of bytes.
    #[inline(always)]
    pub fn blocks(&self) -> &'a Words {
        self.plane(self.starts[3])
    }

    /// The block of one photon, packed, in a format of bytes.
    #[inline(always)]
    pub fn block(&self, photon: usize) -> u16 {
        let blocks = self.blocks();
        u16::from_le_bytes([blocks[2 * photon], blocks[2 * photon + 1]])
    }

    /// The position that all photons share on a flat axis, in fine steps from the corner of the cube, in a
    /// format of bytes.
    #[inline(always)]
    pub fn shared(&self, axis: usize, radius_bits: u32) -> i32 {
        let block = block_on(self.block(0), axis);
        (i32::from(block) << radius_bits) + i32::from(self.window[self.starts[axis]])
    }

    /// The bytes of a plane of mantissas.
    #[inline(always)]
    pub fn mantissas(&self, index: usize) -> &'a Bytes {
        self.plane(self.starts[4] + index * self.photons())
    }
}
