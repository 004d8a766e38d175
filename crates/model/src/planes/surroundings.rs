//! The leaves in the blocks around a block, shared by all queries in it.

use photoncube_spec::{Numbers, PhotonFormat};

use super::leaf::Leaf;
use super::store::{PhotonPlanes, centre};

/// A leaf in the frame of a block's queries.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) struct Seen {
    pub leaf: Leaf,
    /// The offset of the leaf's block in the frame.
    pub offset: [u8; 3],
    /// The lowest and the highest query coordinate on each axis, in fine steps of the frame, at which the
    /// distance to a photon of the leaf may be 0.
    pub low: [u16; 3],
    pub high: [u16; 3],
    /// A mask with a bit for each axis on which all photons of the leaf share a coordinate.
    pub flat: u8,
}

impl Seen {
    fn new(format: &PhotonFormat, offset: [u32; 3], leaf: Leaf) -> Self {
        let (mut low, mut high) = ([0; 3], [0; 3]);
        for (axis, blocks) in offset.into_iter().enumerate() {
            // The corner is at most three edges of 2^14.
            let corner = (blocks * format.edge_steps()) as u16;
            let [first, last] = leaf.cells(axis, format.position_bits);
            // On half steps, a photon above the query has m = centre - query - 1.
            low[axis] = corner + centre(format, first as u16) - u16::from(format.half_steps());
            high[axis] = corner + centre(format, last as u16);
        }
        Self {
            leaf,
            offset: offset.map(|blocks| blocks as u8),
            low,
            high,
            flat: leaf.flat(format.position_bits),
        }
    }
}

/// The leaves that the queries of one block and one facing gather from.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Surroundings {
    pub(super) seen: Vec<Seen>,
    photons: u64,
}

impl Surroundings {
    /// Sets the leaves to those of `runs` of `planes`. Each run has its block's offset in the frame, 0 to 2
    /// on each axis.
    ///
    /// # Panics
    /// Where an offset or a run does not exist.
    pub fn set(
        &mut self,
        planes: &PhotonPlanes,
        runs: impl IntoIterator<Item = ([u32; 3], usize)>,
    ) {
        self.seen.clear();
        let format = planes.format();
        // Chained iterators are faster by internal iteration.
        runs.into_iter().for_each(|(offset, run)| {
            assert!(offset.iter().all(|&blocks| blocks < Numbers::FRAME_BLOCKS));
            let leaves = planes.leaves_of(run).iter();
            self.seen
                .extend(leaves.map(|leaf| Seen::new(format, offset, *leaf)));
        });
        // Leaves are sorted by exponent, because the kernel sums each exponent on its own.
        if self
            .seen
            .iter()
            .any(|seen| seen.leaf.exponent != self.seen[0].leaf.exponent)
        {
            self.seen.sort_by_key(|seen| seen.leaf.exponent);
        }
        self.photons = self
            .seen
            .iter()
            .map(|seen| u64::from(seen.leaf.photons))
            .sum();
    }

    /// The number of photons of all leaves, which a machine would test.
    #[must_use]
    pub fn photons(&self) -> u64 {
        self.photons
    }
}
