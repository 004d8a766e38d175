//! The AVX-512 implementation of [`Positions`]: distances in two registers of 16 photons each, as pairs of
//! words that one instruction squares and adds.

use core::arch::x86_64::{__m256i, __m512i, __mmask16, __mmask32};

use pulp::cast;
use pulp::x86::V4;

use super::avx512::{Halves, pair, widened};
use super::cube::{ON_AXIS, below};
use super::frame::Frame;
use super::lanes::{BYTES_NOWHERE, OfBytes, OfFlatBytes, OfWords, Positions, WORDS_NOWHERE};
use super::store::{LeafPlanes, Words};

/// Replaces the words of lanes without a photon by `nowhere`, in both halves of the leaf.
#[inline(always)]
fn present(simd: V4, words: Halves<__m512i>, photons: usize, nowhere: i16) -> Halves<__m512i> {
    let present = u32::MAX.checked_shr(32 - photons as u32).unwrap_or(0);
    let nowhere = simd.avx512f._mm512_set1_epi16(nowhere);
    let f = simd.avx512f;
    let lanes = [present as __mmask16, (present >> 16) as __mmask16];
    [
        f._mm512_mask_blend_epi32(lanes[0], nowhere, words[0]),
        f._mm512_mask_blend_epi32(lanes[1], nowhere, words[1]),
    ]
}

/// The coordinates of a leaf's photons as pairs: x and y, and z and 0.
#[derive(Copy, Clone, Debug)]
pub(super) struct Places {
    xy: Halves<__m512i>,
    z: Halves<__m512i>,
}

/// A register in which every pair has these two words.
#[inline(always)]
fn both(simd: V4, first: i16, second: i16) -> __m512i {
    let both = u32::from(first as u16) | u32::from(second as u16) << 16;
    simd.avx512f._mm512_set1_epi32(both as i32)
}

/// The mask of both halves.
#[inline(always)]
fn joined(halves: Halves<__mmask16>) -> __mmask32 {
    __mmask32::from(halves[0]) | __mmask32::from(halves[1]) << 16
}

/// A query in half fine steps.
#[derive(Copy, Clone, Debug)]
pub(super) struct ByteQuery {
    xy: __m512i,
    z: __m512i,
    /// The largest sum of squares that is in range.
    largest: __m512i,
}

/// Words of 16 bits as words of 32 bits.
#[inline(always)]
fn widened_words(simd: V4, words: Words) -> Halves<__m512i> {
    let [first, second]: [__m256i; 2] = cast(words);
    let f = simd.avx512f;
    [
        f._mm512_cvtepu16_epi32(first),
        f._mm512_cvtepu16_epi32(second),
    ]
}

/// The coordinates on an axis from bytes, in fine steps from the corner of the cube.
#[inline(always)]
fn byte_places(simd: V4, frame: &Frame, planes: &LeafPlanes, axis: usize) -> Halves<__m512i> {
    let f = simd.avx512f;
    let mut places = widened(simd, planes.bytes(axis));
    let blocks = widened_words(simd, *planes.blocks());
    let below = simd.sse2._mm_cvtsi32_si128(below(axis) as i32);
    let edge_bits = simd.sse2._mm_cvtsi32_si128(frame.edge_bits() as i32);
    for (place, block) in places.iter_mut().zip(blocks) {
        let block = f._mm512_srl_epi32(block, below);
        let block = f._mm512_and_si512(block, f._mm512_set1_epi32(ON_AXIS.into()));
        let block = f._mm512_sll_epi32(block, edge_bits);
        *place = f._mm512_add_epi32(*place, block);
    }
    places
}

/// Pairs of coordinates in half fine steps from the middle of the frame.
#[inline(always)]
fn byte_pairs(
    simd: V4,
    frame: &Frame,
    planes: &LeafPlanes,
    axes: [usize; 2],
    corner: [i16; 2],
) -> Halves<__m512i> {
    let corner = both(simd, 2 * corner[0], 2 * corner[1]);
    let first = byte_places(simd, frame, planes, axes[0]);
    let second = byte_places(simd, frame, planes, axes[1]);
    let mut pairs = first;
    for half in 0..2 {
        let steps = pair(simd, first[half], second[half]);
        let halves = simd.avx512bw._mm512_add_epi16(steps, steps);
        pairs[half] = simd.avx512bw._mm512_add_epi16(halves, corner);
    }
    pairs
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

/// Photons and queries are counted in half fine steps, so that the distance is always the difference of two
/// integers.
impl Positions<V4> for OfBytes {
    type Photons = Places;
    type Query = ByteQuery;

    #[inline(always)]
    fn photons(
        simd: V4,
        frame: &Frame,
        planes: &LeafPlanes,
        axes: [usize; 3],
        corner: [i16; 3],
    ) -> Places {
        let [x, y, z] = axes;
        let xy = byte_pairs(simd, frame, planes, [x, y], [corner[0], corner[1]]);
        let corner = both(simd, 2 * corner[2], 0);
        let mut z = byte_places(simd, frame, planes, z);
        for z in &mut z {
            let halves = simd.avx512f._mm512_add_epi32(*z, *z);
            *z = simd.avx512bw._mm512_add_epi16(halves, corner);
        }
        Places {
            xy: present(simd, xy, planes.photons(), BYTES_NOWHERE),
            z,
        }
    }

    #[inline(always)]
    fn query(simd: V4, frame: &Frame, place: [i16; 3], _: i16) -> ByteQuery {
        let [x, y, z] = place;
        ByteQuery {
            xy: both(simd, byte_place(frame, x), byte_place(frame, y)),
            z: both(simd, byte_place(frame, z), 0),
            largest: simd.avx512f._mm512_set1_epi32(byte_largest(frame)),
        }
    }

    #[inline(always)]
    fn in_range(simd: V4, photons: &Places, query: &ByteQuery) -> __mmask32 {
        let (f, bw) = (simd.avx512f, simd.avx512bw);
        let mut in_range = [0; 2];
        let halves = photons.xy.iter().zip(&photons.z);
        for ((xy, z), in_range) in halves.zip(&mut in_range) {
            let xy = bw._mm512_sub_epi16(query.xy, *xy);
            let z = bw._mm512_sub_epi16(query.z, *z);
            let sum = f._mm512_add_epi32(bw._mm512_madd_epi16(xy, xy), bw._mm512_madd_epi16(z, z));
            *in_range = f._mm512_cmple_epi32_mask(sum, query.largest);
        }
        joined(in_range)
    }
}

/// A query in half fine steps.
#[derive(Copy, Clone, Debug)]
pub(super) struct FlatQuery {
    xy: __m512i,
    /// The largest sum of squares on the first two axes that is in range.
    largest: __m512i,
}

impl Positions<V4> for OfFlatBytes {
    /// The first two coordinates.
    type Photons = Halves<__m512i>;
    type Query = FlatQuery;

    #[inline(always)]
    fn photons(
        simd: V4,
        frame: &Frame,
        planes: &LeafPlanes,
        axes: [usize; 3],
        corner: [i16; 3],
    ) -> Halves<__m512i> {
        let [x, y, _] = axes;
        let xy = byte_pairs(simd, frame, planes, [x, y], [corner[0], corner[1]]);
        present(simd, xy, planes.photons(), BYTES_NOWHERE)
    }

    #[inline(always)]
    fn query(simd: V4, frame: &Frame, place: [i16; 3], shared: i16) -> FlatQuery {
        let [x, y, z] = place;
        let z = i32::from(byte_place(frame, z)) - 2 * i32::from(shared);
        FlatQuery {
            xy: both(simd, byte_place(frame, x), byte_place(frame, y)),
            largest: simd.avx512f._mm512_set1_epi32(byte_largest(frame) - z * z),
        }
    }

    #[inline(always)]
    fn in_range(simd: V4, photons: &Halves<__m512i>, query: &FlatQuery) -> __mmask32 {
        let (f, bw) = (simd.avx512f, simd.avx512bw);
        let mut in_range = [0; 2];
        for (xy, in_range) in photons.iter().zip(&mut in_range) {
            let xy = bw._mm512_sub_epi16(query.xy, *xy);
            let square = bw._mm512_madd_epi16(xy, xy);
            *in_range = f._mm512_cmple_epi32_mask(square, query.largest);
        }
        joined(in_range)
    }
}

/// A query in fine steps.
#[derive(Copy, Clone, Debug)]
pub(super) struct WordQuery {
    xy: __m512i,
    z: __m512i,
    /// The largest sum of squares, or of half squares, in range.
    largest: __m512i,
    /// 1 on half steps, otherwise 0, in every word.
    half: __m512i,
    /// A mask of all ones, or 0 on half steps.
    whole: __m512i,
}

/// m for pairs of coordinates, saturated at [`Frame::FURTHEST`].
#[inline(always)]
fn distance(simd: V4, query: &WordQuery, at: __m512i, photons: __m512i) -> __m512i {
    let (f, bw) = (simd.avx512f, simd.avx512bw);
    let d = bw._mm512_subs_epi16(at, photons);
    let sign = bw._mm512_srai_epi16::<15>(d);
    let m = bw._mm512_sub_epi16(
        f._mm512_xor_si512(d, sign),
        f._mm512_and_si512(sign, query.whole),
    );
    bw._mm512_min_epu16(m, f._mm512_set1_epi16(Frame::FURTHEST as i16))
}

/// The sums of the squares, or half squares, of each pair.
#[inline(always)]
fn squares(simd: V4, query: &WordQuery, m: __m512i) -> __m512i {
    let bw = simd.avx512bw;
    bw._mm512_madd_epi16(m, bw._mm512_add_epi16(m, query.half))
}

/// The coordinates on an axis from words, in fine steps from the middle of the frame, as words of 32 bits whose
/// high halves are 0.
#[inline(always)]
fn word_places(simd: V4, planes: &LeafPlanes, axis: usize, corner: i16) -> Halves<__m512i> {
    let [first, second] = widened_words(simd, planes.words(axis));
    let corner = both(simd, corner, 0);
    let bw = simd.avx512bw;
    [
        bw._mm512_add_epi16(first, corner),
        bw._mm512_add_epi16(second, corner),
    ]
}

/// Photons and queries are counted in fine steps, and their differences saturate.
impl Positions<V4> for OfWords {
    type Photons = Places;
    type Query = WordQuery;

    #[inline(always)]
    fn photons(
        simd: V4,
        _: &Frame,
        planes: &LeafPlanes,
        axes: [usize; 3],
        corner: [i16; 3],
    ) -> Places {
        let x = word_places(simd, planes, axes[0], corner[0]);
        let y = word_places(simd, planes, axes[1], corner[1]);
        let z = word_places(simd, planes, axes[2], corner[2]);
        let xy = [pair(simd, x[0], y[0]), pair(simd, x[1], y[1])];
        Places {
            xy: present(simd, xy, planes.photons(), WORDS_NOWHERE),
            z,
        }
    }

    #[inline(always)]
    fn query(simd: V4, frame: &Frame, place: [i16; 3], _: i16) -> WordQuery {
        let f = simd.avx512f;
        WordQuery {
            xy: both(simd, place[0], place[1]),
            z: both(simd, place[2], 0),
            largest: f._mm512_set1_epi32(frame.largest as i32),
            half: f._mm512_set1_epi16(frame.half()),
            whole: f._mm512_set1_epi16(frame.half() - 1),
        }
    }

    #[inline(always)]
    fn in_range(simd: V4, photons: &Places, query: &WordQuery) -> __mmask32 {
        let f = simd.avx512f;
        let mut in_range = [0; 2];
        let halves = photons.xy.iter().zip(&photons.z);
        for ((xy, z), in_range) in halves.zip(&mut in_range) {
            let xy = distance(simd, query, query.xy, *xy);
            let z = distance(simd, query, query.z, *z);
            let sum = f._mm512_add_epi32(squares(simd, query, xy), squares(simd, query, z));
            *in_range = f._mm512_cmple_epi32_mask(sum, query.largest);
        }
        joined(in_range)
    }
}
