//! The traits of the kernel: operations on all photons of a leaf, or on all leaves of a tray, at a time.

use super::cube::Part;
use super::frame::Frame;
use super::store::{LeafPlanes, Words};
use super::tray::TRAY;

/// The coordinate of lanes without a photon in formats of bytes, in steps or half steps. It is out of range
/// of every query, and neither the difference nor its square overflows.
pub(super) const BYTES_NOWHERE: i16 = 1 << 14;

/// The coordinate of lanes without a photon in formats of words, whose distances saturate.
pub(super) const WORDS_NOWHERE: i16 = i16::MAX;

/// The bounding boxes of a tray's leaves: on each axis the lowest and the highest query coordinate, in fine
/// steps of the frame, at which the distance to a photon of the leaf may be 0.
#[derive(Copy, Clone, Debug)]
pub(super) struct Boxes {
    pub low: [[u16; TRAY]; 3],
    pub high: [[u16; TRAY]; 3],
    /// The number of low bits of a distance that are dropped, so that a square fits 16 bits.
    pub shift: u32,
    /// The largest sum of the shortened squares that may be in range.
    pub largest: u16,
}

/// The operations of one instruction set. Formats have `PLANES` planes of mantissas.
pub(super) trait Lanes: Copy {
    /// An in-range mask: for each photon whether it is in range.
    type Mask: Copy;
    /// The mantissa bytes of a leaf's photons.
    type Powers<const PLANES: usize>: Copy;
    /// The sums of the mantissa bytes of photons in range, and their count, over up to a tray of leaves.
    type Sums<const PLANES: usize>: Copy;

    fn powers<const PLANES: usize>(self, planes: &LeafPlanes) -> Self::Powers<PLANES>;

    fn no_sums<const PLANES: usize>(self) -> Self::Sums<PLANES>;

    /// Adds the photons in range to the sums.
    fn add<const PLANES: usize>(
        self,
        sums: Self::Sums<PLANES>,
        in_range: Self::Mask,
        powers: &Self::Powers<PLANES>,
    ) -> Self::Sums<PLANES>;

    /// The total of each plane, and the count.
    fn totals<const PLANES: usize>(self, sums: Self::Sums<PLANES>) -> ([u32; PLANES], u32);

    /// A mask with a bit for each leaf of the tray, set where its box and the one from `low` to `high` meet.
    fn meeting(self, boxes: &Boxes, low: [u16; 3], high: [u16; 3]) -> u32;

    /// A mask with a bit for each lane of a leaf whose packed block is one of the part.
    fn inside(self, part: Part, blocks: &Words) -> u32;

    /// A mask with a bit for each leaf of the tray. It is set for every leaf that the sphere of the query at
    /// `query` in the frame touches, and for few others.
    fn touched(self, boxes: &Boxes, query: [u16; 3]) -> u32;
}

/// The layout of positions in the planes, one byte or two each, and their test.
pub(super) trait Positions<L: Lanes> {
    /// The coordinates of a leaf's photons in the frame. In lanes without a photon they are never in range.
    type Photons: Copy;

    /// A query's coordinates, prepared for the test.
    type Query: Copy;

    /// Loads the photons of a leaf, on the axes in this order. `corner` is the lowest corner of the leaf's cube
    /// on each of them.
    fn photons(
        lanes: L,
        frame: &Frame,
        planes: &LeafPlanes,
        axes: [usize; 3],
        corner: [i16; 3],
    ) -> Self::Photons;

    /// Prepares the query at `place`, whose axes are in the order of the photons' axes. `shared` is the coordinate
    /// of all photons on the last axis, for positions that need it.
    fn query(lanes: L, frame: &Frame, place: [i16; 3], shared: i16) -> Self::Query;

    fn in_range(lanes: L, photons: &Self::Photons, query: &Self::Query) -> L::Mask;
}

/// Formats of up to 8 bits per radius.
pub(super) struct OfBytes;

/// Formats of up to 8 bits per radius, for leaves whose photons all share the last coordinate, such as those on a
/// wall along the other two axes. The distance on the last axis is computed once for all leaves.
pub(super) struct OfFlatBytes;

/// Formats of 9 to 14 bits per radius.
pub(super) struct OfWords;
