//! Stores photons in planes of bytes.

use photoncube_spec::{FormatError, PhotonFormat, PhotonRecord};

use super::leaf::{LEAF, Leaf, into_leaves};
use crate::gather::{Limits, RangeError};

/// The planes of a leaf, with bytes behind them that the kernel may read and never uses, because it always
/// reads a full leaf. There are at most 12 planes and one more, since positions of two bytes take two planes
/// each.
pub(super) type Window = [u8; 13 * LEAF];

/// The number of bytes behind the last photon, so that its leaf has a full window.
const SLACK: usize = size_of::<Window>();

/// The layout of a leaf of n photons. Each plane has n bytes: x, y, z, then the channels' mantissas, the low
/// byte of each followed by the high byte if there is one.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) struct Layout {
    /// Whether centres take two bytes (little-endian) instead of one.
    pub wide: bool,
    /// The number of planes of mantissa bytes: 1, 2, 3 or 6.
    pub mantissa_planes: usize,
    /// The number of bytes of a photon in all planes.
    pub bytes_per_photon: usize,
}

impl Layout {
    fn of(format: &PhotonFormat) -> Self {
        let wide = format.radius_bits() > u8::BITS;
        let channels = format.power.channels.count() as usize;
        let mantissa_planes = channels * format.power.mantissa_bits.div_ceil(u8::BITS) as usize;
        Self {
            wide,
            mantissa_planes,
            bytes_per_photon: 3 * (1 + usize::from(wide)) + mantissa_planes,
        }
    }
}

/// The photons of a map in one format, for [`Self::gather`].
///
/// In a format of up to 8 bits per radius a photon's position takes 3 bytes, otherwise 6. Each channel takes
/// a byte or, over 8 bits, two. Each leaf takes 12 further bytes.
#[derive(Debug, Clone)]
pub struct PhotonPlanes {
    format: PhotonFormat,
    pub(super) limits: Limits,
    pub(super) layout: Layout,
    /// The planes of all photons, followed by [`SLACK`] bytes.
    pub(super) bytes: Vec<u8>,
    pub(super) leaves: Vec<Leaf>,
    /// The index of each run's first leaf, and the number of leaves.
    runs: Vec<u32>,
    photons: u32,
}

impl PhotonPlanes {
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

    /// Appends a run: the photons of one block, or of one surface in it, with the block's exponent.
    ///
    /// # Errors
    /// A value does not fit the format. Nothing is stored in this case.
    pub fn push_run(
        &mut self,
        block_exponent: u8,
        records: &[PhotonRecord],
    ) -> Result<(), RangeError> {
        self.limits.check_records(block_exponent, records)?;
        let mut records = records.to_vec();
        self.bytes.truncate(self.bytes.len() - SLACK);
        for place in into_leaves(&mut records) {
            let leaf = &records[place];
            self.push_planes(leaf);
            let exponent = block_exponent + leaf[0].exponent;
            let bits = self.format().position_bits;
            self.leaves
                .push(Leaf::new(leaf, self.photons, exponent, bits));
            self.photons += leaf.len() as u32;
        }
        self.bytes.resize(self.bytes.len() + SLACK, 0);
        self.runs.push(self.leaves.len() as u32);
        Ok(())
    }

    fn push_planes(&mut self, records: &[PhotonRecord]) {
        let format = self.format;
        for axis in 0..3 {
            for record in records {
                let centre = centre(&format, record.position[axis]).to_le_bytes();
                self.bytes
                    .extend(&centre[..1 + usize::from(self.layout.wide)]);
            }
        }
        let channels = format.power.channels.count() as usize;
        let bytes_each = self.layout.mantissa_planes / channels;
        for (channel, byte) in (0..channels).flat_map(|c| (0..bytes_each).map(move |b| (c, b))) {
            let mantissas = records.iter().map(|record| record.mantissa[channel]);
            self.bytes
                .extend(mantissas.map(|mantissa| mantissa.to_le_bytes()[byte]));
        }
    }

    /// Appends the runs of `other`, so that parts can be built in parallel.
    #[must_use]
    pub fn joined(mut self, other: &Self) -> Self {
        self.bytes.truncate(self.bytes.len() - SLACK);
        self.bytes.extend_from_slice(&other.bytes);
        let (leaves, photons) = (self.leaves.len() as u32, self.photons);
        let moved = other.leaves.iter().map(|leaf| leaf.moved(photons));
        self.leaves.extend(moved);
        self.runs
            .extend(other.runs[1..].iter().map(|first| first + leaves));
        self.photons += other.photons;
        self
    }

    /// The format of the photons.
    #[must_use]
    pub fn format(&self) -> &PhotonFormat {
        &self.format
    }

    /// The number of photons stored.
    #[must_use]
    pub fn photons(&self) -> usize {
        self.photons as usize
    }

    /// The number of runs stored.
    #[must_use]
    pub fn runs(&self) -> usize {
        self.runs.len() - 1
    }

    /// The number of bytes that planes, leaves and runs occupy.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.bytes.len() + size_of_val(self.leaves.as_slice()) + size_of_val(self.runs.as_slice())
    }

    /// The planes of a leaf, with the bytes behind them.
    #[inline(always)]
    pub(super) fn window(&self, leaf: &Leaf) -> &Window {
        let start = leaf.start as usize * self.layout.bytes_per_photon;
        self.bytes[start..]
            .first_chunk()
            .expect("a window behind the last photon")
    }

    /// The leaves of a run.
    pub(super) fn leaves_of(&self, run: usize) -> &[Leaf] {
        &self.leaves[self.runs[run] as usize..self.runs[run + 1] as usize]
    }
}

/// The first `N` bytes of plane `index` of a leaf with `photons` photons.
#[inline(always)]
pub(super) fn plane<const N: usize>(window: &Window, index: usize, photons: usize) -> &[u8; N] {
    window[index * photons..]
        .first_chunk()
        .expect("a window has room for it")
}

/// The centre of a photon's cell, in fine steps from the block's corner: the cell's index, or the grid line
/// through its middle.
pub(super) fn centre(format: &PhotonFormat, cell: u16) -> u16 {
    let extra = format.query_extra_bits;
    (cell << extra) + ((1 << extra) >> 1)
}
