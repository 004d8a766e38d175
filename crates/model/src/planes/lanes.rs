//! What the kernel does with all photons of a leaf, or with all queries of a batch, at a time.

use super::axis::{Axis, Side};
use super::leaf::LEAF;

/// A byte for each photon of a leaf.
pub(super) type Bytes = [u8; LEAF];

/// Two bytes for each photon of a leaf, little end first.
pub(super) type Words = [u8; 2 * LEAF];

/// Queries that meet a leaf together.
pub(super) const BATCH: usize = 32;

/// A leaf's box against the queries of a batch, in fine steps of the frame.
#[derive(Copy, Clone, Debug)]
pub(super) struct Meeting<'a> {
    /// On each axis the lowest and the highest query for which the distance to a photon may be 0.
    pub low: [u16; 3],
    pub high: [u16; 3],
    pub queries: &'a [[u16; BATCH]; 3],
    /// Low bits of a distance that are left out, so that a square fits 16 bits.
    pub shift: u32,
    /// The largest sum of such squares that may be in range.
    pub largest: u16,
}

/// One set of instructions. In lanes past a leaf's photons there is anything, which [`Self::ones`] takes
/// out.
pub(super) trait Lanes: Copy {
    /// A byte for each photon.
    type Bytes: Copy;
    /// Two bytes for each photon.
    type Words: Copy;
    /// A mantissa byte for each photon.
    type Mantissas: Copy;
    /// An axis for centres of a byte.
    type ByteAxis: Copy;
    /// An axis for centres of two.
    type WordAxis: Copy;
    /// The mantissa bytes of those in range, of up to [`Self::ADDITIONS`] leaves.
    type Sum: Copy;
    /// How many are in range.
    type Count: Copy;

    /// Leaves that a sum holds, so that it is below 2^32.
    const ADDITIONS: usize;

    fn byte_axis(self, axis: Axis<u8>) -> Self::ByteAxis;

    fn word_axis(self, axis: Axis<u16>) -> Self::WordAxis;

    fn bytes(self, bytes: &Bytes) -> Self::Bytes;

    fn words(self, words: &Words) -> Self::Words;

    fn mantissas(self, bytes: &Bytes) -> Self::Mantissas;

    /// 1 for each of the first `photons`.
    fn ones(self, photons: usize) -> Self::Bytes;

    /// `largest` less each byte.
    fn bytes_from(self, largest: u8, bytes: Self::Bytes) -> Self::Bytes;

    /// `largest` less each word.
    fn words_from(self, largest: u16, words: Self::Words) -> Self::Words;

    /// The m of centres in the middle block.
    fn bytes_inside(self, axis: &Self::ByteAxis, centres: Self::Bytes) -> Self::Bytes;

    /// The m of centres in another.
    fn bytes_outside(self, axis: &Self::ByteAxis, side: Side, centres: Self::Bytes) -> Self::Bytes;

    /// The m of centres in the middle block.
    fn words_inside(self, axis: &Self::WordAxis, centres: Self::Words) -> Self::Words;

    /// The m of centres in another.
    fn words_outside(self, axis: &Self::WordAxis, side: Side, centres: Self::Words) -> Self::Words;

    /// Those of `ones` whose sum of squares, or of half squares, is at most `largest`, which is
    /// below 2^16 - 1; sums saturate there.
    fn bytes_in_range<const HALF_STEPS: bool>(
        self,
        m: [Self::Bytes; 3],
        largest: u16,
        ones: Self::Bytes,
    ) -> Self::Bytes;

    /// The same in words: m saturates at 2^14 - 1, and sums are below 2^31.
    fn words_in_range<const HALF_STEPS: bool>(
        self,
        m: [Self::Words; 3],
        largest: u32,
        ones: Self::Bytes,
    ) -> Self::Bytes;

    fn no_sum(self) -> Self::Sum;

    fn no_count(self) -> Self::Count;

    /// The sum and the mantissas where `in_range` is 1.
    fn add(self, sum: Self::Sum, in_range: Self::Bytes, mantissas: Self::Mantissas) -> Self::Sum;

    fn add_count(self, count: Self::Count, in_range: Self::Bytes) -> Self::Count;

    fn count(self, count: Self::Count) -> u64;

    /// A sum, of `count` photons in range.
    fn total(self, sum: Self::Sum, count: u64) -> u64;

    /// A bit for each query whose sphere may touch the box: for all that do, and for few others.
    fn touched(self, meeting: &Meeting<'_>) -> u32;
}
