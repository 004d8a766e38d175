//! The AVX2 implementation of [`Positions`]: distances in four registers of eight photons each, as pairs of
//! words that one instruction squares and adds.

use core::arch::x86_64::__m256i;

use pulp::cast;
use pulp::x86::V3;

use super::cube::{ON_AXIS, below};
use super::frame::Frame;
use super::lanes::{BYTES_NOWHERE, OfBytes, OfFlatBytes, OfWords, Positions, WORDS_NOWHERE};
use super::leaf::LEAF;
use super::store::{Bytes, LeafPlanes, Words};

/// A window of this table that starts at 32 - n has n bytes of all ones, then zeros.
const PRESENT: [u8; 2 * LEAF] = {
    let mut present = [0; 2 * LEAF];
    let mut lane = 0;
    while lane < LEAF {
        present[lane] = u8::MAX;
        lane += 1;
    }
    present
};

/// Widens the bytes of a register to words: the first and the second half of each 128-bit half.
#[inline(always)]
fn words(simd: V3, bytes: __m256i) -> [__m256i; 2] {
    let zero = simd.avx._mm256_setzero_si256();
    [
        simd.avx2._mm256_unpacklo_epi8(bytes, zero),
        simd.avx2._mm256_unpackhi_epi8(bytes, zero),
    ]
}

/// Words in the order in which [`words`] places them.
#[inline(always)]
fn unpacked(simd: V3, words: Words) -> [__m256i; 2] {
    let [first, second]: [__m256i; 2] = cast(words);
    let avx2 = simd.avx2;
    [
        avx2._mm256_permute2x128_si256::<0b10_0000>(first, second),
        avx2._mm256_permute2x128_si256::<0b11_0001>(first, second),
    ]
}

/// Replaces the words of lanes without a photon by `nowhere`.
#[inline(always)]
fn present(simd: V3, words: [__m256i; 2], photons: usize, nowhere: i16) -> [__m256i; 2] {
    let present: &Bytes = PRESENT[LEAF - photons.min(LEAF)..]
        .first_chunk()
        .expect("at most a leaf");
    let present = cast(*present);
    let nowhere = simd.avx._mm256_set1_epi16(nowhere);
    [
        simd.avx2._mm256_blendv_epi8(
            nowhere,
            words[0],
            simd.avx2._mm256_unpacklo_epi8(present, present),
        ),
        simd.avx2._mm256_blendv_epi8(
            nowhere,
            words[1],
            simd.avx2._mm256_unpackhi_epi8(present, present),
        ),
    ]
}

/// Two words of each photon, eight photons to a register, in the order in which packing restores the order of
/// the masks.
type Pairs = [__m256i; 4];

#[inline(always)]
fn pairs(simd: V3, a: [__m256i; 2], b: [__m256i; 2]) -> Pairs {
    [
        simd.avx2._mm256_unpacklo_epi16(a[0], b[0]),
        simd.avx2._mm256_unpackhi_epi16(a[0], b[0]),
        simd.avx2._mm256_unpacklo_epi16(a[1], b[1]),
        simd.avx2._mm256_unpackhi_epi16(a[1], b[1]),
    ]
}

/// The coordinates of a leaf's photons as pairs: x and y, and z and 0.
#[derive(Copy, Clone, Debug)]
pub(super) struct Places {
    xy: Pairs,
    z: Pairs,
}

impl Places {
    #[inline(always)]
    fn new(simd: V3, [x, y, z]: [[__m256i; 2]; 3]) -> Self {
        let zero = simd.avx._mm256_setzero_si256();
        Self {
            xy: pairs(simd, x, y),
            z: pairs(simd, z, [zero; 2]),
        }
    }
}

/// A register in which every pair has these two words.
#[inline(always)]
fn pair(simd: V3, first: i16, second: i16) -> __m256i {
    let both = u32::from(first as u16) | u32::from(second as u16) << 16;
    simd.avx._mm256_set1_epi32(both as i32)
}

/// Packs four masks of 32-bit words into a mask of bytes.
#[inline(always)]
fn packed(simd: V3, masks: [__m256i; 4]) -> __m256i {
    simd.avx2._mm256_packs_epi16(
        simd.avx2._mm256_packs_epi32(masks[0], masks[1]),
        simd.avx2._mm256_packs_epi32(masks[2], masks[3]),
    )
}

/// A query in half fine steps.
#[derive(Copy, Clone, Debug)]
pub(super) struct ByteQuery {
    xy: __m256i,
    z: __m256i,
    /// The smallest sum of squares that is out of range.
    over: __m256i,
}

/// The coordinates on an axis from bytes, in half fine steps from the middle of the frame.
#[inline(always)]
fn byte_places(
    simd: V3,
    frame: &Frame,
    planes: &LeafPlanes,
    axis: usize,
    corner: i16,
) -> [__m256i; 2] {
    let mut places = words(simd, cast(planes.bytes(axis)));
    let blocks = unpacked(simd, *planes.blocks());
    let below = simd.sse2._mm_cvtsi32_si128(below(axis) as i32);
    let edge_bits = simd.sse2._mm_cvtsi32_si128(frame.edge_bits() as i32);
    let corner = simd.avx._mm256_set1_epi16(2 * corner);
    for (place, block) in places.iter_mut().zip(blocks) {
        let block = simd.avx2._mm256_srl_epi16(block, below);
        let block = simd
            .avx2
            ._mm256_and_si256(block, simd.avx._mm256_set1_epi16(ON_AXIS as i16));
        let block = simd.avx2._mm256_sll_epi16(block, edge_bits);
        let in_cube = simd.avx2._mm256_add_epi16(*place, block);
        let halves = simd.avx2._mm256_add_epi16(in_cube, in_cube);
        *place = simd.avx2._mm256_add_epi16(halves, corner);
    }
    places
}

/// A query's coordinate on an axis, in half fine steps.
#[inline(always)]
fn byte_place(frame: &Frame, place: i16) -> i16 {
    2 * place + frame.half()
}

/// The smallest sum of squares that is out of range. In half fine steps the sum is four times that in fine
/// steps, or on half steps four times the sum of half squares, plus 3.
#[inline(always)]
fn byte_over(frame: &Frame) -> i32 {
    4 * frame.largest as i32 + 4
}

/// Photons and queries are counted in half fine steps, so that the distance is always the difference of two
/// integers.
impl Positions<V3> for OfBytes {
    type Photons = Places;
    type Query = ByteQuery;

    #[inline(always)]
    fn photons(
        simd: V3,
        frame: &Frame,
        planes: &LeafPlanes,
        axes: [usize; 3],
        corner: [i16; 3],
    ) -> Places {
        let x = byte_places(simd, frame, planes, axes[0], corner[0]);
        let y = byte_places(simd, frame, planes, axes[1], corner[1]);
        let z = byte_places(simd, frame, planes, axes[2], corner[2]);
        Places::new(
            simd,
            [present(simd, x, planes.photons(), BYTES_NOWHERE), y, z],
        )
    }

    #[inline(always)]
    fn query(simd: V3, frame: &Frame, place: [i16; 3], _: i16) -> ByteQuery {
        ByteQuery {
            xy: pair(
                simd,
                byte_place(frame, place[0]),
                byte_place(frame, place[1]),
            ),
            z: pair(simd, byte_place(frame, place[2]), 0),
            over: simd.avx._mm256_set1_epi32(byte_over(frame)),
        }
    }

    #[inline(always)]
    fn in_range(simd: V3, photons: &Places, query: &ByteQuery) -> __m256i {
        let mut in_range = [query.over; 4];
        let eights = photons.xy.iter().zip(&photons.z);
        for ((xy, z), in_range) in eights.zip(&mut in_range) {
            let xy = simd.avx2._mm256_sub_epi16(query.xy, *xy);
            let z = simd.avx2._mm256_sub_epi16(query.z, *z);
            let sum = simd.avx2._mm256_add_epi32(
                simd.avx2._mm256_madd_epi16(xy, xy),
                simd.avx2._mm256_madd_epi16(z, z),
            );
            *in_range = simd.avx2._mm256_cmpgt_epi32(query.over, sum);
        }
        packed(simd, in_range)
    }
}

/// A query in half fine steps.
#[derive(Copy, Clone, Debug)]
pub(super) struct FlatQuery {
    xy: __m256i,
    /// The smallest sum of squares on the first two axes that is out of range.
    over: __m256i,
}

impl Positions<V3> for OfFlatBytes {
    /// The first two coordinates.
    type Photons = Pairs;
    type Query = FlatQuery;

    #[inline(always)]
    fn photons(
        simd: V3,
        frame: &Frame,
        planes: &LeafPlanes,
        axes: [usize; 3],
        corner: [i16; 3],
    ) -> Pairs {
        let x = byte_places(simd, frame, planes, axes[0], corner[0]);
        let y = byte_places(simd, frame, planes, axes[1], corner[1]);
        pairs(simd, present(simd, x, planes.photons(), BYTES_NOWHERE), y)
    }

    #[inline(always)]
    fn query(simd: V3, frame: &Frame, place: [i16; 3], shared: i16) -> FlatQuery {
        let [x, y, z] = place;
        let z = i32::from(byte_place(frame, z)) - 2 * i32::from(shared);
        FlatQuery {
            xy: pair(simd, byte_place(frame, x), byte_place(frame, y)),
            over: simd.avx._mm256_set1_epi32(byte_over(frame) - z * z),
        }
    }

    #[inline(always)]
    fn in_range(simd: V3, photons: &Pairs, query: &FlatQuery) -> __m256i {
        let mut in_range = [query.over; 4];
        for (xy, in_range) in photons.iter().zip(&mut in_range) {
            let xy = simd.avx2._mm256_sub_epi16(query.xy, *xy);
            let square = simd.avx2._mm256_madd_epi16(xy, xy);
            *in_range = simd.avx2._mm256_cmpgt_epi32(query.over, square);
        }
        packed(simd, in_range)
    }
}

/// A query in fine steps.
#[derive(Copy, Clone, Debug)]
pub(super) struct WordQuery {
    xy: __m256i,
    z: __m256i,
    /// The smallest sum of squares, or of half squares, that is out of range.
    over: __m256i,
    /// 1 on half steps, otherwise 0, in every word.
    half: __m256i,
    /// A mask of all ones, or 0 on half steps.
    whole: __m256i,
}

/// m for pairs of coordinates, saturated at [`Frame::FURTHEST`].
#[inline(always)]
fn distance(simd: V3, query: &WordQuery, at: __m256i, photons: __m256i) -> __m256i {
    let d = simd.avx2._mm256_subs_epi16(at, photons);
    let sign = simd.avx2._mm256_srai_epi16::<15>(d);
    let m = simd.avx2._mm256_sub_epi16(
        simd.avx2._mm256_xor_si256(d, sign),
        simd.avx2._mm256_and_si256(sign, query.whole),
    );
    let furthest = simd.avx._mm256_set1_epi16(Frame::FURTHEST as i16);
    simd.avx2._mm256_min_epu16(m, furthest)
}

/// The sums of the squares, or half squares, of each pair.
#[inline(always)]
fn squares(simd: V3, query: &WordQuery, m: __m256i) -> __m256i {
    simd.avx2
        ._mm256_madd_epi16(m, simd.avx2._mm256_add_epi16(m, query.half))
}

/// Photons and queries are counted in fine steps, and their differences saturate.
impl Positions<V3> for OfWords {
    type Photons = Places;
    type Query = WordQuery;

    #[inline(always)]
    fn photons(
        simd: V3,
        _: &Frame,
        planes: &LeafPlanes,
        axes: [usize; 3],
        corner: [i16; 3],
    ) -> Places {
        let zero = simd.avx._mm256_setzero_si256();
        let mut places = [[zero; 2]; 3];
        for axis in 0..3 {
            let [low, high] = unpacked(simd, planes.words(axes[axis]));
            let corner = simd.avx._mm256_set1_epi16(corner[axis]);
            places[axis] = [
                simd.avx2._mm256_add_epi16(low, corner),
                simd.avx2._mm256_add_epi16(high, corner),
            ];
        }
        places[0] = present(simd, places[0], planes.photons(), WORDS_NOWHERE);
        Places::new(simd, places)
    }

    #[inline(always)]
    fn query(simd: V3, frame: &Frame, place: [i16; 3], _: i16) -> WordQuery {
        WordQuery {
            xy: pair(simd, place[0], place[1]),
            z: pair(simd, place[2], 0),
            over: simd.avx._mm256_set1_epi32(frame.largest as i32 + 1),
            half: simd.avx._mm256_set1_epi16(frame.half()),
            whole: simd.avx._mm256_set1_epi16(frame.half() - 1),
        }
    }

    #[inline(always)]
    fn in_range(simd: V3, photons: &Places, query: &WordQuery) -> __m256i {
        let mut in_range = [query.over; 4];
        let eights = photons.xy.iter().zip(&photons.z);
        for ((xy, z), in_range) in eights.zip(&mut in_range) {
            let xy = distance(simd, query, query.xy, *xy);
            let z = distance(simd, query, query.z, *z);
            let sum = simd
                .avx2
                ._mm256_add_epi32(squares(simd, query, xy), squares(simd, query, z));
            *in_range = simd.avx2._mm256_cmpgt_epi32(query.over, sum);
        }
        packed(simd, in_range)
    }
}
