//! What the kernel does with all photons of a leaf, or with all leaves of a tray, at a time.

use super::frame::Frame;
use super::leaf::LEAF;
use super::store::Window;
use super::tray::TRAY;

/// A byte for each photon of a leaf.
pub(super) type Bytes = [u8; LEAF];

/// Two bytes for each photon of a leaf, little end first.
pub(super) type Words = [u8; 2 * LEAF];

/// Where the lanes past the last photon of a format of bytes are, in steps or half steps: out of range of every
/// query, and neither the difference nor its square overflows.
pub(super) const BYTES_NOWHERE: i16 = 1 << 14;

/// The same of a format of words, whose distances saturate.
pub(super) const WORDS_NOWHERE: i16 = i16::MAX;

/// The boxes of a tray's leaves: on each axis the lowest and the highest query, in fine steps of the
/// frame, for which the distance to a photon of the leaf may be 0.
#[derive(Copy, Clone, Debug)]
pub(super) struct Boxes {
    pub low: [[u16; TRAY]; 3],
    pub high: [[u16; TRAY]; 3],
    /// Low bits of a distance that are left out, so that a square fits 16 bits.
    pub shift: u32,
    /// The largest sum of such squares that may be in range.
    pub largest: u16,
}

/// One set of instructions.
pub(super) trait Lanes: Copy {
    /// For each photon whether it is in range.
    type Mask: Copy;
    /// A mantissa byte for each photon.
    type Mantissas: Copy;
    /// The mantissa bytes of those in range, of up to a tray of leaves.
    type Sum: Copy;
    /// How many are in range, of up to a tray of leaves.
    type Count: Copy;

    fn mantissas(self, bytes: &Bytes) -> Self::Mantissas;

    fn no_sum(self) -> Self::Sum;

    fn no_count(self) -> Self::Count;

    /// The sum and the mantissas of those in range.
    fn add(self, sum: Self::Sum, in_range: Self::Mask, mantissas: &Self::Mantissas) -> Self::Sum;

    fn add_count(self, count: Self::Count, in_range: Self::Mask) -> Self::Count;

    fn count(self, count: Self::Count) -> u32;

    fn total(self, sum: Self::Sum) -> u32;

    /// Three totals and the count, for which there may be a shorter way.
    fn totals(self, sums: [Self::Sum; 3], count: Self::Count) -> ([u32; 3], u32);

    /// A bit for each leaf of the tray that the sphere of the query at `query` in the frame may touch: for
    /// all that it does, and for few others.
    fn touched(self, boxes: &Boxes, query: [u16; 3]) -> u32;
}

/// How positions stand in the planes, one byte each or two, and how they are tested.
pub(super) trait Positions<L: Lanes> {
    /// Bytes of a centre on one axis.
    const BYTES: usize;

    /// The positions of a leaf's photons, in the frame; in lanes past the last photon what is never in
    /// range.
    type Photons: Copy;

    /// A query.
    type Query: Copy;

    /// The first `photons` of the leaf in `window`, on the axes in this order. On each, a block's lowest
    /// corner is at `corner`.
    fn photons(
        lanes: L,
        window: &Window,
        photons: usize,
        axes: [usize; 3],
        corner: [i16; 3],
    ) -> Self::Photons;

    /// The query at `place`, by axis in the same order.
    fn query(lanes: L, frame: &Frame, place: [i16; 3]) -> Self::Query;

    fn in_range(lanes: L, photons: &Self::Photons, query: &Self::Query) -> L::Mask;
}

/// Formats of up to 8 bits per radius.
pub(super) struct OfBytes;

/// The same where all photons of a leaf are alike on the last axis, as those on a wall along the other two: the
/// distance on it is computed once for all of them.
pub(super) struct OfFlatBytes;

/// Formats of 9 to 14 bits per radius.
pub(super) struct OfWords;
