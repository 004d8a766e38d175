//! The AVX-512 implementation of [`Lanes`], with masks of a bit for each photon.
//!
//! As in `avx2.rs`, all code is inlined into one function for which the processor's features are enabled.

use core::arch::x86_64::{__m128i, __m256i, __m512i, __mmask32};

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
    /// 16 words a plane, each the sum of the mantissas of two photons, negated.
    planes: [__m256i; PLANES],
    count: u32,
}

impl Lanes for V4 {
    type Mask = __mmask32;
    /// A byte for each photon, because loads of two take longer than what they save.
    type Powers<const PLANES: usize> = [__m256i; PLANES];
    type Sums<const PLANES: usize> = Sums<PLANES>;

    #[inline(always)]
    fn powers<const PLANES: usize>(self, planes: &LeafPlanes) -> [__m256i; PLANES] {
        let mut powers = [self.avx._mm256_setzero_si256(); PLANES];
        for (index, power) in powers.iter_mut().enumerate() {
            *power = cast(*planes.mantissas(index));
        }
        powers
    }

    #[inline(always)]
    fn no_sums<const PLANES: usize>(self) -> Sums<PLANES> {
        Sums {
            planes: [self.avx._mm256_setzero_si256(); PLANES],
            count: 0,
        }
    }

    #[inline(always)]
    fn add<const PLANES: usize>(
        self,
        mut sums: Sums<PLANES>,
        in_range: __mmask32,
        powers: &[__m256i; PLANES],
    ) -> Sums<PLANES> {
        sums.count += in_range.count_ones();
        // All ones are -1.
        let minus = self.avx512bw._mm256_movm_epi8(in_range);
        for (sum, mantissas) in sums.planes.iter_mut().zip(powers) {
            let pairs = self.avx2._mm256_maddubs_epi16(*mantissas, minus);
            *sum = self.avx2._mm256_add_epi16(*sum, pairs);
        }
        sums
    }

    #[inline(always)]
    fn totals<const PLANES: usize>(self, sums: Sums<PLANES>) -> ([u32; PLANES], u32) {
        let mut totals = [0; PLANES];
        let (sse2, avx2) = (self.sse2, self.avx2);
        let minus = self.avx._mm256_set1_epi16(-1);
        if let [a, b, c] = sums.planes[..] {
            // Neighbouring words are added; then each half of the register gets one word of each sum.
            let [a, b, c] = [
                avx2._mm256_madd_epi16(a, minus),
                avx2._mm256_madd_epi16(b, minus),
                avx2._mm256_madd_epi16(c, minus),
            ];
            let zero = self.avx._mm256_setzero_si256();
            let ab = avx2._mm256_add_epi32(
                avx2._mm256_unpacklo_epi32(a, b),
                avx2._mm256_unpackhi_epi32(a, b),
            );
            let c = avx2._mm256_add_epi32(
                avx2._mm256_unpacklo_epi32(c, zero),
                avx2._mm256_unpackhi_epi32(c, zero),
            );
            let all = avx2._mm256_add_epi32(
                avx2._mm256_unpacklo_epi64(ab, c),
                avx2._mm256_unpackhi_epi64(ab, c),
            );
            let low = self.avx._mm256_castsi256_si128(all);
            let high = avx2._mm256_extracti128_si256::<1>(all);
            let [a, b, c, _]: [u32; 4] = cast(sse2._mm_add_epi32(low, high));
            totals.copy_from_slice(&[a, b, c]);
            return (totals, sums.count);
        }
        for (total, sum) in totals.iter_mut().zip(sums.planes) {
            let eight = avx2._mm256_madd_epi16(sum, minus);
            let low = self.avx._mm256_castsi256_si128(eight);
            let high = avx2._mm256_extracti128_si256::<1>(eight);
            let [a, b, c, d]: [u32; 4] = cast(sse2._mm_add_epi32(low, high));
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

// A mask of a tray has one bit for each leaf. A word of a sum is signed and holds 2 * TRAY mantissas.
const _: () = assert!(TRAY == 32 && 255 * 2 * TRAY <= i16::MAX as usize && LEAF == 32);
