//! The photons of a map, with the index that finds those around a query.

use photoncube_spec::{FormatError, PhotonBlock, PhotonFormat};

use super::rows::Rows;
use super::store::Planes;
use crate::gather::RangeError;

/// The photons of a map in one format, for [`Self::gather`].
///
/// They are stored by *cubes* of blocks, because a block may hold a photon or none. Photons of one cube and
/// one group are a *run*; a group is whatever a query gathers or leaves out as a whole, such as a surface.
#[derive(Debug, Clone)]
pub struct PhotonPlanes {
    pub(super) planes: Planes,
    /// The cubes of the runs.
    pub(super) rows: Rows,
    /// The group of each run.
    pub(super) groups: Vec<u32>,
}

impl PhotonPlanes {
    /// Makes planes without photons.
    ///
    /// # Errors
    /// The format is not legal.
    pub fn new(format: &PhotonFormat) -> Result<Self, FormatError> {
        Ok(Self {
            planes: Planes::new(format)?,
            rows: Rows::default(),
            groups: Vec::new(),
        })
    }

    /// Makes room for `photons` more. Without it the planes grow by doubling, and take up to twice their memory.
    pub fn reserve(&mut self, photons: usize) {
        self.planes.reserve(photons);
    }

    /// Gives back the memory that the photons do not use.
    pub fn shrink_to_fit(&mut self) {
        self.planes.shrink_to_fit();
        self.rows.shrink_to_fit();
        self.groups.shrink_to_fit();
    }

    /// The number of blocks on an edge of a cube, a power of two.
    #[must_use]
    pub fn cube_edge(&self) -> u32 {
        1 << self.planes.layout.edge_bits()
    }

    /// Appends the photons of one group in one cube of the grid. The offset of each block is its place in the
    /// cube. Cubes are in ascending order by z, y, x.
    ///
    /// # Errors
    /// A value does not fit the format. Nothing is stored in this case.
    ///
    /// # Panics
    /// Where the cube is before the last one, or a block is not in the cube.
    pub fn push_run(
        &mut self,
        cube: [u64; 3],
        group: u32,
        blocks: &[PhotonBlock<'_>],
    ) -> Result<(), RangeError> {
        let edge = self.cube_edge();
        let offsets = blocks.iter().flat_map(|block| block.offset);
        assert!(offsets.max() < Some(edge), "a block in its cube");
        self.planes.push_run(blocks)?;
        self.rows.push(cube);
        self.groups.push(group);
        Ok(())
    }

    /// Appends the runs of `other`, whose cubes are not before those here, so that parts can be built in
    /// parallel.
    ///
    /// # Panics
    /// Where a cube of `other` is before the last one.
    #[must_use]
    pub fn joined(mut self, other: &Self) -> Self {
        self.planes.append(&other.planes);
        self.rows.append(&other.rows);
        self.groups.extend(&other.groups);
        self
    }

    /// The format of the photons.
    #[must_use]
    pub fn format(&self) -> &PhotonFormat {
        &self.planes.format
    }

    /// The number of photons stored.
    #[must_use]
    pub fn photons(&self) -> usize {
        self.planes.photons()
    }

    /// The number of runs stored.
    #[must_use]
    pub fn runs(&self) -> usize {
        self.groups.len()
    }

    /// The number of bytes that photons and index occupy.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.planes.bytes() + self.rows.bytes() + size_of_val(self.groups.as_slice())
    }
}
