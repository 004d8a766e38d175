//! Photons in planes of bytes.

use photoncube_spec::{PhotonFormat, PhotonRecord};

use super::leaf::{LEAF, Leaf, into_leaves};
use crate::local::{LocalGather, ValueError};

/// The planes of a leaf, and what the kernel may read behind them and never uses: it always reads bytes
/// for a full leaf. At most 12 planes and one more, as positions of two bytes take two planes each.
pub(super) type Window = [u8; 13 * LEAF];

/// Bytes behind the last photon, so that there is a window for it.
const SLACK: usize = size_of::<Window>();

/// What stands in the planes of a leaf of n photons, each plane n words of a photon's: x, y, z, then the
/// channels' mantissas, the low byte of each and behind it the high one if there is one.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) struct Layout {
    /// Centres take two bytes, little end first; otherwise one.
    pub wide: bool,
    /// Planes of mantissa bytes: 1, 2, 3 or 6.
    pub mantissa_planes: usize,
    /// Bytes of a photon in all planes.
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
/// A format of up to 8 bits per radius takes 3 bytes for a photon's position, others 6, and each channel
/// a byte or, over 8 bits, two; leaves add 12 bytes each.
#[derive(Debug, Clone)]
pub struct PhotonPlanes {
    pub(super) gather: LocalGather,
    pub(super) layout: Layout,
    /// Photons, and [`SLACK`] behind them.
    pub(super) bytes: Vec<u8>,
    pub(super) leaves: Vec<Leaf>,
    /// The first leaf of each run, and the end of the last.
    runs: Vec<u32>,
    photons: u32,
}

impl PhotonPlanes {
    /// No photons yet.
    #[must_use]
    pub fn new(gather: LocalGather) -> Self {
        Self {
            gather,
            layout: Layout::of(gather.format()),
            bytes: vec![0; SLACK],
            leaves: Vec::new(),
            runs: vec![0],
            photons: 0,
        }
    }

    /// Stores one more run: the photons of one block, or of one surface in it, with the block's
    /// exponent.
    ///
    /// # Errors
    /// A value that the format cannot hold; nothing is stored then.
    pub fn push_run(
        &mut self,
        block_exponent: u8,
        records: &[PhotonRecord],
    ) -> Result<(), ValueError> {
        self.gather.limits().check_block_exponent(block_exponent)?;
        self.gather.limits().check_records(records)?;
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
        let format = *self.format();
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

    /// The runs of both, those of `other` behind those here: so that parts can be made side by side.
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

    /// The format.
    #[must_use]
    pub fn format(&self) -> &PhotonFormat {
        self.gather.format()
    }

    /// Photons stored.
    #[must_use]
    pub fn photons(&self) -> usize {
        self.photons as usize
    }

    /// Runs stored.
    #[must_use]
    pub fn runs(&self) -> usize {
        self.runs.len() - 1
    }

    /// Bytes that planes, leaves and runs take.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.bytes.len() + size_of_val(self.leaves.as_slice()) + size_of_val(self.runs.as_slice())
    }

    /// The planes of a leaf.
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

/// What plane `index` of a leaf of up to [`LEAF`] photons starts with.
#[inline(always)]
pub(super) fn plane<const N: usize>(window: &Window, index: usize, photons: usize) -> &[u8; N] {
    window[index * photons..]
        .first_chunk()
        .expect("a window has room for it")
}

/// The fine step from a block's corner that a photon in this cell stands for: its cell, or the grid line
/// through the cell's middle.
pub(super) fn centre(format: &PhotonFormat, cell: u16) -> u16 {
    let extra = format.query_extra_bits;
    (cell << extra) + ((1 << extra) >> 1)
}
