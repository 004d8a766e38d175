//! The NEON implementation of [`Positions`]: distances in four registers of eight words for each axis, squared
//! and added up in words of 32 bits.

use core::arch::aarch64::{int16x8_t, uint8x16_t, uint16x8_t, uint32x4_t};

use pulp::aarch64::Neon;
use pulp::cast;

use super::cube::{ON_AXIS, below};
use super::frame::Frame;
use super::lanes::{BYTES_NOWHERE, OfBytes, OfFlatBytes, OfWords, Positions, WORDS_NOWHERE};
use super::leaf::LEAF;
use super::neon::{Eights, Sixteens, bytes};
use super::store::{Bytes, LeafPlanes};

/// The number of each photon of a leaf.
const NUMBERS: [u16; LEAF] = {
    let mut numbers = [0; LEAF];
    let mut lane = 0;
    while lane < LEAF {
        numbers[lane] = lane as u16;
        lane += 1;
    }
    numbers
};

/// Replaces the words of lanes without a photon by `nowhere`.
#[inline(always)]
fn present(
    simd: Neon,
    mut words: Eights<int16x8_t>,
    photons: usize,
    nowhere: i16,
) -> Eights<int16x8_t> {
    let neon = simd.neon;
    let photons = neon.vdupq_n_u16(photons as u16);
    let nowhere = neon.vdupq_n_s16(nowhere);
    let numbers: Eights<uint16x8_t> = cast(NUMBERS);
    for (word, number) in words.iter_mut().zip(numbers) {
        *word = neon.vbslq_s16(neon.vcltq_u16(number, photons), *word, nowhere);
    }
    words
}

/// The mask of eight photons from the masks of four each.
#[inline(always)]
fn joined(simd: Neon, first: uint32x4_t, second: uint32x4_t) -> uint16x8_t {
    simd.neon.vuzp1q_u16(cast(first), cast(second))
}

/// The coordinates of a leaf's photons, by axis.
type Places<const AXES: usize> = [Eights<int16x8_t>; AXES];

/// A query in half fine steps.
#[derive(Copy, Clone, Debug)]
pub(super) struct ByteQuery<const AXES: usize> {
    at: [int16x8_t; AXES],
    /// The largest sum of squares on these axes that is in range.
    largest: i32,
}

/// The coordinates on an axis from bytes, in half fine steps from the middle of the frame.
#[inline(always)]
fn byte_places(
    simd: Neon,
    frame: &Frame,
    planes: &LeafPlanes,
    axis: usize,
    corner: i16,
) -> Eights<int16x8_t> {
    let neon = simd.neon;
    let words = words(simd, planes.bytes(axis));
    let blocks: Eights<uint16x8_t> = cast(*planes.blocks());
    let below = neon.vdupq_n_s16(-(below(axis) as i16));
    let edge_bits = neon.vdupq_n_s16(frame.edge_bits() as i16);
    let corner = neon.vdupq_n_s16(2 * corner);
    let mut places = [corner; LEAF / 8];
    for ((place, word), block) in places.iter_mut().zip(words).zip(blocks) {
        let block = neon.vshlq_u16(block, below);
        let block = neon.vandq_u16(block, neon.vdupq_n_u16(ON_AXIS));
        let block = neon.vshlq_u16(block, edge_bits);
        let in_cube: int16x8_t = cast(neon.vaddq_u16(word, block));
        let halves = neon.vaddq_s16(in_cube, in_cube);
        *place = neon.vaddq_s16(halves, corner);
    }
    places
}

/// Widens the bytes of a leaf to words.
#[inline(always)]
fn words(simd: Neon, bytes: Bytes) -> Eights<uint16x8_t> {
    let neon = simd.neon;
    let [first, second]: Sixteens<uint8x16_t> = cast(bytes);
    [
        neon.vmovl_u8(neon.vget_low_u8(first)),
        neon.vmovl_high_u8(first),
        neon.vmovl_u8(neon.vget_low_u8(second)),
        neon.vmovl_high_u8(second),
    ]
}

/// A query's coordinate on an axis, in half fine steps.
#[inline(always)]
fn byte_place(frame: &Frame, place: i16) -> i16 {
    2 * place + frame.half()
}

/// The largest sum of squares in range. In half fine steps the sum is four times that in fine steps, or on half
/// steps four times the sum of half squares, plus 3.
#[inline(always)]
fn byte_largest(frame: &Frame) -> i32 {
    4 * frame.largest as i32 + 3
}

/// A mask of the photons in range, in a format of bytes.
#[inline(always)]
fn bytes_in_range<const AXES: usize>(
    simd: Neon,
    photons: &Places<AXES>,
    query: &ByteQuery<AXES>,
) -> Sixteens<uint8x16_t> {
    let neon = simd.neon;
    let largest = neon.vdupq_n_s32(query.largest);
    let mut in_range = [neon.vdupq_n_u16(0); LEAF / 8];
    for (eight, in_range) in in_range.iter_mut().enumerate() {
        let mut sums = [neon.vdupq_n_s32(0); 2];
        for (photons, at) in photons.iter().zip(query.at) {
            let d = neon.vsubq_s16(at, photons[eight]);
            let low = neon.vget_low_s16(d);
            sums[0] = neon.vmlal_s16(sums[0], low, low);
            sums[1] = neon.vmlal_high_s16(sums[1], d, d);
        }
        *in_range = joined(
            simd,
            neon.vcleq_s32(sums[0], largest),
            neon.vcleq_s32(sums[1], largest),
        );
    }
    bytes(simd, in_range)
}

/// Photons and queries are counted in half fine steps, so that the distance is always the difference of two
/// integers.
impl Positions<Neon> for OfBytes {
    type Photons = Places<3>;
    type Query = ByteQuery<3>;

    #[inline(always)]
    fn photons(
        simd: Neon,
        frame: &Frame,
        planes: &LeafPlanes,
        axes: [usize; 3],
        corner: [i16; 3],
    ) -> Places<3> {
        let x = byte_places(simd, frame, planes, axes[0], corner[0]);
        let y = byte_places(simd, frame, planes, axes[1], corner[1]);
        let z = byte_places(simd, frame, planes, axes[2], corner[2]);
        [present(simd, x, planes.photons(), BYTES_NOWHERE), y, z]
    }

    #[inline(always)]
    fn query(simd: Neon, frame: &Frame, place: [i16; 3], _: i16) -> ByteQuery<3> {
        let [x, y, z] = place;
        ByteQuery {
            at: [
                simd.neon.vdupq_n_s16(byte_place(frame, x)),
                simd.neon.vdupq_n_s16(byte_place(frame, y)),
                simd.neon.vdupq_n_s16(byte_place(frame, z)),
            ],
            largest: byte_largest(frame),
        }
    }

    #[inline(always)]
    fn in_range(simd: Neon, photons: &Places<3>, query: &ByteQuery<3>) -> Sixteens<uint8x16_t> {
        bytes_in_range(simd, photons, query)
    }
}

impl Positions<Neon> for OfFlatBytes {
    /// The first two coordinates.
    type Photons = Places<2>;
    type Query = ByteQuery<2>;

    #[inline(always)]
    fn photons(
        simd: Neon,
        frame: &Frame,
        planes: &LeafPlanes,
        axes: [usize; 3],
        corner: [i16; 3],
    ) -> Places<2> {
        let x = byte_places(simd, frame, planes, axes[0], corner[0]);
        let y = byte_places(simd, frame, planes, axes[1], corner[1]);
        [present(simd, x, planes.photons(), BYTES_NOWHERE), y]
    }

    #[inline(always)]
    fn query(simd: Neon, frame: &Frame, place: [i16; 3], shared: i16) -> ByteQuery<2> {
        let [x, y, z] = place;
        let z = i32::from(byte_place(frame, z)) - 2 * i32::from(shared);
        ByteQuery {
            at: [
                simd.neon.vdupq_n_s16(byte_place(frame, x)),
                simd.neon.vdupq_n_s16(byte_place(frame, y)),
            ],
            largest: byte_largest(frame) - z * z,
        }
    }

    #[inline(always)]
    fn in_range(simd: Neon, photons: &Places<2>, query: &ByteQuery<2>) -> Sixteens<uint8x16_t> {
        bytes_in_range(simd, photons, query)
    }
}

/// A query in fine steps.
#[derive(Copy, Clone, Debug)]
pub(super) struct WordQuery {
    at: [int16x8_t; 3],
    /// The largest sum of squares, or of half squares, in range.
    largest: uint32x4_t,
    /// 1 on half steps, otherwise 0, in every word.
    half: uint16x8_t,
    /// A mask of all ones, or 0 on half steps.
    whole: int16x8_t,
}

/// m on an axis, saturated at [`Frame::FURTHEST`].
#[inline(always)]
fn distance(simd: Neon, query: &WordQuery, at: int16x8_t, photons: int16x8_t) -> uint16x8_t {
    let neon = simd.neon;
    let d = neon.vqsubq_s16(at, photons);
    let sign: int16x8_t = cast(neon.vcltq_s16(d, neon.vdupq_n_s16(0)));
    let m = neon.vsubq_s16(neon.veorq_s16(d, sign), neon.vandq_s16(sign, query.whole));
    neon.vminq_u16(cast(m), neon.vdupq_n_u16(Frame::FURTHEST))
}

/// Photons and queries are counted in fine steps, and their differences saturate.
impl Positions<Neon> for OfWords {
    type Photons = Places<3>;
    type Query = WordQuery;

    #[inline(always)]
    fn photons(
        simd: Neon,
        _: &Frame,
        planes: &LeafPlanes,
        axes: [usize; 3],
        corner: [i16; 3],
    ) -> Places<3> {
        let mut places = [[simd.neon.vdupq_n_s16(0); LEAF / 8]; 3];
        for axis in 0..3 {
            places[axis] = cast(planes.words(axes[axis]));
            let corner = simd.neon.vdupq_n_s16(corner[axis]);
            for place in &mut places[axis] {
                *place = simd.neon.vaddq_s16(*place, corner);
            }
        }
        places[0] = present(simd, places[0], planes.photons(), WORDS_NOWHERE);
        places
    }

    #[inline(always)]
    fn query(simd: Neon, frame: &Frame, place: [i16; 3], _: i16) -> WordQuery {
        let neon = simd.neon;
        WordQuery {
            at: [
                neon.vdupq_n_s16(place[0]),
                neon.vdupq_n_s16(place[1]),
                neon.vdupq_n_s16(place[2]),
            ],
            largest: neon.vdupq_n_u32(frame.largest),
            half: neon.vdupq_n_u16(frame.half() as u16),
            whole: neon.vdupq_n_s16(frame.half() - 1),
        }
    }

    #[inline(always)]
    fn in_range(simd: Neon, photons: &Places<3>, query: &WordQuery) -> Sixteens<uint8x16_t> {
        let neon = simd.neon;
        let mut in_range = [neon.vdupq_n_u16(0); LEAF / 8];
        for (eight, in_range) in in_range.iter_mut().enumerate() {
            let mut sums = [neon.vdupq_n_u32(0); 2];
            for (photons, at) in photons.iter().zip(query.at) {
                let m = distance(simd, query, at, photons[eight]);
                let other = neon.vaddq_u16(m, query.half);
                let (low, low_other) = (neon.vget_low_u16(m), neon.vget_low_u16(other));
                sums[0] = neon.vmlal_u16(sums[0], low, low_other);
                sums[1] = neon.vmlal_high_u16(sums[1], m, other);
            }
            *in_range = joined(
                simd,
                neon.vcleq_u32(sums[0], query.largest),
                neon.vcleq_u32(sums[1], query.largest),
            );
        }
        bytes(simd, in_range)
    }
}
