//! The AVX-512 implementation of [`Lanes`], with masks of a bit for each photon.
//!
//! As in `avx2.rs`, all code is inlined into one function for which the processor's features are enabled.

use core::arch::x86_64::{__m128i, __m512i, __mmask32};

use pulp::cast;
use pulp::x86::V4;

use super::cube::Part;
use super::lanes::{Boxes, Lanes};
use super::leaf::LEAF;
use super::store::{Bytes, LeafPlanes, Words};
use super::tray::TRAY;

/// The first 16 photons of a leaf, and the others.
pub(super) type Halves<T> = [T; 2];

/// A byte of each photon as words of 32 bits.
#[inline(always)]
pub(super) fn widened(simd: V4, bytes: Bytes) -> Halves<__m512i> {
    let [first, second]: [__m128i; 2] = cast(bytes);
    [
        simd.avx512f._mm512_cvtepu8_epi32(first),
        simd.avx512f._mm512_cvtepu8_epi32(second),
    ]
}

/// Two values of 16 bits, the first in the low half.
#[inline(always)]
pub(super) fn pair(simd: V4, first: __m512i, second: __m512i) -> __m512i {
    let second = simd.avx512f._mm512_slli_epi32::<16>(second);
    simd.avx512f._mm512_or_si512(first, second)
}

/// The sums of four lanes, as words of 32 bits.
#[inline(always)]
fn folded(simd: V4, sums: __m512i) -> __m128i {
    let low = simd.avx512f._mm512_castsi512_si256(sums);
    let high = simd.avx512f._mm512_extracti64x4_epi64::<1>(sums);
    let eight = simd.avx2._mm256_add_epi16(low, high);
    let low = simd.avx._mm256_castsi256_si128(eight);
    let high = simd.avx2._mm256_extracti128_si256::<1>(eight);
    // Less than 2^15, so that the sum is the right one with a sign too.
    let four = simd.sse2._mm_add_epi16(low, high);
    simd.sse2._mm_madd_epi16(four, simd.sse2._mm_set1_epi16(1))
}

/// The squared distances on one axis of a query from 32 boxes.
#[inline(always)]
fn box_squares(simd: V4, low: __m512i, high: __m512i, query: u16, shift: u32) -> __m512i {
    let (f, bw) = (simd.avx512f, simd.avx512bw);
    let query = f._mm512_set1_epi16(query as i16);
    let below = bw._mm512_subs_epu16(low, query);
    let above = bw._mm512_subs_epu16(query, high);
    let mut outside = f._mm512_or_si512(below, above);
    if shift > 0 {
        let shift = simd.sse2._mm_cvtsi32_si128(shift as i32);
        outside = bw._mm512_srl_epi16(outside, shift);
    }
    let m = bw._mm512_min_epu16(outside, f._mm512_set1_epi16(255));
    bw._mm512_mullo_epi16(m, m)
}

/// The sums of a tray.
#[derive(Copy, Clone, Debug)]
pub(super) struct Sums<const PLANES: usize> {
    /// 32 words a plane, one for each photon of a leaf.
    planes: [__m512i; PLANES],
    count: u32,
}

impl Lanes for V4 {
    type Mask = __mmask32;
    /// A word of 16 bits for each photon.
    type Powers<const PLANES: usize> = [__m512i; PLANES];
    type Sums<const PLANES: usize> = Sums<PLANES>;

    #[inline(always)]
    fn powers<const PLANES: usize>(self, planes: &LeafPlanes) -> [__m512i; PLANES] {
        let mut powers = [self.avx512f._mm512_setzero_si512(); PLANES];
        for (index, power) in powers.iter_mut().enumerate() {
            *power = self
                .avx512bw
                ._mm512_cvtepu8_epi16(cast(*planes.mantissas(index)));
        }
        powers
    }

    #[inline(always)]
    fn no_sums<const PLANES: usize>(self) -> Sums<PLANES> {
        Sums {
            planes: [self.avx512f._mm512_setzero_si512(); PLANES],
            count: 0,
        }
    }

    #[inline(always)]
    fn add<const PLANES: usize>(
        self,
        mut sums: Sums<PLANES>,
        in_range: __mmask32,
        powers: &[__m512i; PLANES],
    ) -> Sums<PLANES> {
        sums.count += in_range.count_ones();
        for (sum, power) in sums.planes.iter_mut().zip(powers) {
            *sum = self
                .avx512bw
                ._mm512_mask_add_epi16(*sum, in_range, *sum, *power);
        }
        sums
    }

    #[inline(always)]
    fn totals<const PLANES: usize>(self, sums: Sums<PLANES>) -> ([u32; PLANES], u32) {
        let mut totals = [0; PLANES];
        if let [a, b, c] = sums.planes[..] {
            let ab = self.ssse3._mm_hadd_epi32(folded(self, a), folded(self, b));
            let c = folded(self, c);
            let cc = self.ssse3._mm_hadd_epi32(c, c);
            let [a, b, c, _]: [u32; 4] = cast(self.ssse3._mm_hadd_epi32(ab, cc));
            totals.copy_from_slice(&[a, b, c]);
            return (totals, sums.count);
        }
        for (total, sum) in totals.iter_mut().zip(sums.planes) {
            let [a, b, c, d]: [u32; 4] = cast(folded(self, sum));
            *total = (a + b) + (c + d);
        }
        (totals, sums.count)
    }

    #[inline(always)]
    fn meeting(self, boxes: &Boxes, low: [u16; 3], high: [u16; 3]) -> u32 {
        let (f, bw) = (self.avx512f, self.avx512bw);
        let mut meeting = u32::MAX;
        for axis in 0..3 {
            let low = f._mm512_set1_epi16(low[axis] as i16);
            let high = f._mm512_set1_epi16(high[axis] as i16);
            meeting &= bw._mm512_cmple_epu16_mask(low, cast(boxes.high[axis]));
            meeting &= bw._mm512_cmple_epu16_mask(cast(boxes.low[axis]), high);
        }
        meeting
    }

    #[inline(always)]
    fn inside(self, part: Part, blocks: &Words) -> u32 {
        let (f, bw) = (self.avx512f, self.avx512bw);
        let blocks = cast(*blocks);
        let guards = f._mm512_set1_epi16(Part::GUARDS as i16);
        let first = f._mm512_set1_epi16(part.first as i16);
        let last = f._mm512_set1_epi16(part.last_and_guards as i16);
        let from_first = bw._mm512_sub_epi16(f._mm512_or_si512(blocks, guards), first);
        let to_last = bw._mm512_sub_epi16(last, blocks);
        let both = f._mm512_and_si512(f._mm512_and_si512(from_first, to_last), guards);
        bw._mm512_cmpeq_epi16_mask(both, guards)
    }

    #[inline(always)]
    fn touched(self, boxes: &Boxes, query: [u16; 3]) -> u32 {
        let (f, bw) = (self.avx512f, self.avx512bw);
        let mut sum = f._mm512_setzero_si512();
        let bounds = boxes.low.iter().zip(&boxes.high);
        for ((low, high), query) in bounds.zip(query) {
            let squares = box_squares(self, cast(*low), cast(*high), query, boxes.shift);
            sum = bw._mm512_adds_epu16(sum, squares);
        }
        bw._mm512_cmple_epu16_mask(sum, f._mm512_set1_epi16(boxes.largest as i16))
    }
}

// A mask of a tray has one bit for each leaf. Four words of a sum are added as signed ones.
const _: () = assert!(TRAY == 32 && 4 * 255 * TRAY <= i16::MAX as usize && LEAF == 32);
