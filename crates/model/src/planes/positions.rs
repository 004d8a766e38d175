//! Positions of one byte or of two: which lanes the kernel asks for.

use super::axis::{Axis, Side};
use super::lanes::Lanes;
use super::store::{Window, plane};

/// How positions stand in the planes.
pub(super) trait Positions<L: Lanes> {
    /// Bytes of a centre on one axis.
    const BYTES: usize;

    /// One axis of a query.
    type Axis: Copy;

    /// A word for each photon: a centre, or m.
    type Words: Copy;

    /// The axis of a query `at` fine steps into the middle block.
    fn axis(lanes: L, at: u32, edge: u32, half_steps: bool) -> Self::Axis;

    /// The centres of a leaf's photons on one axis, as [`Axis`] asks for them.
    fn centres(
        lanes: L,
        window: &Window,
        photons: usize,
        axis: usize,
        side: Side,
        edge: u32,
    ) -> Self::Words;

    /// m in the middle block.
    fn inside(lanes: L, axis: &Self::Axis, centres: Self::Words) -> Self::Words;

    /// m in another.
    fn outside(lanes: L, axis: &Self::Axis, side: Side, centres: Self::Words) -> Self::Words;

    /// Those of `ones` that are in range.
    fn in_range<const HALF_STEPS: bool>(
        lanes: L,
        m: [Self::Words; 3],
        largest: u32,
        ones: L::Bytes,
    ) -> L::Bytes;
}

/// Formats of up to 8 bits per radius.
pub(super) struct OfBytes;

impl<L: Lanes> Positions<L> for OfBytes {
    const BYTES: usize = 1;

    type Axis = L::ByteAxis;
    type Words = L::Bytes;

    #[inline(always)]
    fn axis(lanes: L, at: u32, edge: u32, half_steps: bool) -> L::ByteAxis {
        lanes.byte_axis(Axis::<u8>::new(at, edge, half_steps))
    }

    #[inline(always)]
    fn centres(
        lanes: L,
        window: &Window,
        photons: usize,
        axis: usize,
        side: Side,
        edge: u32,
    ) -> L::Bytes {
        let centres = lanes.bytes(plane(window, axis, photons));
        match side {
            Side::Below => lanes.bytes_from((edge - 1) as u8, centres),
            _ => centres,
        }
    }

    #[inline(always)]
    fn inside(lanes: L, axis: &L::ByteAxis, centres: L::Bytes) -> L::Bytes {
        lanes.bytes_inside(axis, centres)
    }

    #[inline(always)]
    fn outside(lanes: L, axis: &L::ByteAxis, side: Side, centres: L::Bytes) -> L::Bytes {
        lanes.bytes_outside(axis, side, centres)
    }

    #[inline(always)]
    fn in_range<const HALF_STEPS: bool>(
        lanes: L,
        m: [L::Bytes; 3],
        largest: u32,
        ones: L::Bytes,
    ) -> L::Bytes {
        // At most 254^2.
        lanes.bytes_in_range::<HALF_STEPS>(m, largest as u16, ones)
    }
}

/// Formats of 9 to 14 bits per radius.
pub(super) struct OfWords;

impl<L: Lanes> Positions<L> for OfWords {
    const BYTES: usize = 2;

    type Axis = L::WordAxis;
    type Words = L::Words;

    #[inline(always)]
    fn axis(lanes: L, at: u32, edge: u32, half_steps: bool) -> L::WordAxis {
        lanes.word_axis(Axis::<u16>::new(at, edge, half_steps))
    }

    #[inline(always)]
    fn centres(
        lanes: L,
        window: &Window,
        photons: usize,
        axis: usize,
        side: Side,
        edge: u32,
    ) -> L::Words {
        let centres = lanes.words(plane(window, 2 * axis, photons));
        match side {
            Side::Below => lanes.words_from((edge - 1) as u16, centres),
            _ => centres,
        }
    }

    #[inline(always)]
    fn inside(lanes: L, axis: &L::WordAxis, centres: L::Words) -> L::Words {
        lanes.words_inside(axis, centres)
    }

    #[inline(always)]
    fn outside(lanes: L, axis: &L::WordAxis, side: Side, centres: L::Words) -> L::Words {
        lanes.words_outside(axis, side, centres)
    }

    #[inline(always)]
    fn in_range<const HALF_STEPS: bool>(
        lanes: L,
        m: [L::Words; 3],
        largest: u32,
        ones: L::Bytes,
    ) -> L::Bytes {
        lanes.words_in_range::<HALF_STEPS>(m, largest, ones)
    }
}
