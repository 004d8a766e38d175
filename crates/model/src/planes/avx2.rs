//! The AVX2 implementation of [`Lanes`].
//!
//! All code here and in `avx2_positions.rs` is inlined into one function for which the processor's features
//! are enabled. A closure would be compiled as a function without these features, and would be ten times
//! slower, so there are none.

use core::arch::x86_64::__m256i;

use pulp::cast;
use pulp::x86::V3;

use super::cube::Part;
use super::lanes::{Boxes, Lanes};
use super::leaf::LEAF;
use super::store::{LeafPlanes, Words};
use super::tray::TRAY;

/// The squared distances on one axis of a query from 16 boxes.
#[inline(always)]
fn box_squares(simd: V3, [low, high]: [__m256i; 2], query: u16, shift: u32) -> __m256i {
    let query = simd.avx._mm256_set1_epi16(query as i16);
    let below = simd.avx2._mm256_subs_epu16(low, query);
    let above = simd.avx2._mm256_subs_epu16(query, high);
    let outside = simd.avx2._mm256_or_si256(below, above);
    let shift = simd.sse2._mm_cvtsi32_si128(shift as i32);
    let m = simd.avx2._mm256_srl_epi16(outside, shift);
    let m = simd
        .avx2
        ._mm256_min_epu16(m, simd.avx._mm256_set1_epi16(255));
    simd.avx2._mm256_mullo_epi16(m, m)
}

/// For each packed block, all ones where it is one of the part, else 0.
#[inline(always)]
fn contained(simd: V3, part: Part, blocks: __m256i) -> __m256i {
    let (avx, avx2) = (simd.avx, simd.avx2);
    let guards = avx._mm256_set1_epi16(Part::GUARDS as i16);
    let first = avx._mm256_set1_epi16(part.first as i16);
    let last = avx._mm256_set1_epi16(part.last_and_guards as i16);
    let from_first = avx2._mm256_sub_epi16(avx2._mm256_or_si256(blocks, guards), first);
    let to_last = avx2._mm256_sub_epi16(last, blocks);
    let both = avx2._mm256_and_si256(avx2._mm256_and_si256(from_first, to_last), guards);
    avx2._mm256_cmpeq_epi16(both, guards)
}

/// The words by which two boxes are apart on an axis, 0 where they are not.
#[inline(always)]
fn apart(simd: V3, [low, high]: [__m256i; 2], from: u16, to: u16) -> __m256i {
    let from = simd.avx._mm256_set1_epi16(from as i16);
    let to = simd.avx._mm256_set1_epi16(to as i16);
    simd.avx2._mm256_or_si256(
        simd.avx2._mm256_subs_epu16(from, high),
        simd.avx2._mm256_subs_epu16(low, to),
    )
}

/// A mask with a bit for each word of both registers, which are all ones or 0.
#[inline(always)]
fn bits(simd: V3, first: __m256i, second: __m256i) -> u32 {
    let bytes = simd.avx2._mm256_packs_epi16(first, second);
    let bytes = simd.avx2._mm256_permute4x64_epi64::<0b11_01_10_00>(bytes);
    simd.avx2._mm256_movemask_epi8(bytes) as u32
}

/// For each word, all ones where a saturating sum of squares is at most `largest`, else 0.
#[inline(always)]
fn is_at_most(simd: V3, [x, y, z]: [__m256i; 3], largest: __m256i) -> __m256i {
    let sum = simd
        .avx2
        ._mm256_adds_epu16(simd.avx2._mm256_adds_epu16(x, y), z);
    let over = simd.avx2._mm256_subs_epu16(sum, largest);
    simd.avx2
        ._mm256_cmpeq_epi16(over, simd.avx._mm256_setzero_si256())
}

/// The sum of the register's eight 32-bit words.
#[inline(always)]
fn total(simd: V3, eight: __m256i) -> u32 {
    let low = simd.avx._mm256_castsi256_si128(eight);
    let high = simd.avx2._mm256_extracti128_si256::<1>(eight);
    let [a, b, c, d]: [u32; 4] = cast(simd.sse2._mm_add_epi32(low, high));
    (a + b) + (c + d)
}

/// The sums of a tray.
#[derive(Copy, Clone, Debug)]
pub(super) struct Sums<const PLANES: usize> {
    /// 16 words a plane, each the sum of the mantissas of two photons.
    planes: [__m256i; PLANES],
    /// 32 bytes, one for each photon of a leaf.
    count: __m256i,
}

impl Lanes for V3 {
    /// All ones where a photon is in range.
    type Mask = __m256i;
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
        let zero = self.avx._mm256_setzero_si256();
        Sums {
            planes: [zero; PLANES],
            count: zero,
        }
    }

    #[inline(always)]
    fn add<const PLANES: usize>(
        self,
        mut sums: Sums<PLANES>,
        in_range: __m256i,
        powers: &[__m256i; PLANES],
    ) -> Sums<PLANES> {
        sums.count = self.avx2._mm256_sub_epi8(sums.count, in_range);
        for (sum, mantissas) in sums.planes.iter_mut().zip(powers) {
            // All ones are -1, so multiplying by the mask negates the mantissas.
            let pairs = self.avx2._mm256_maddubs_epi16(*mantissas, in_range);
            *sum = self.avx2._mm256_sub_epi16(*sum, pairs);
        }
        sums
    }

    #[inline(always)]
    fn totals<const PLANES: usize>(self, sums: Sums<PLANES>) -> ([u32; PLANES], u32) {
        let mut totals = [0; PLANES];
        let (avx2, zero) = (self.avx2, self.avx._mm256_setzero_si256());
        let ones = self.avx._mm256_set1_epi16(1);
        let count = avx2._mm256_sad_epu8(sums.count, zero);
        if let [a, b, c] = sums.planes[..] {
            // Neighbouring words are added twice; then each half of the register has one word of each sum.
            let ab = avx2._mm256_hadd_epi32(
                avx2._mm256_madd_epi16(a, ones),
                avx2._mm256_madd_epi16(b, ones),
            );
            let cd = avx2._mm256_hadd_epi32(avx2._mm256_madd_epi16(c, ones), count);
            let all = avx2._mm256_hadd_epi32(ab, cd);
            let low = self.avx._mm256_castsi256_si128(all);
            let high = avx2._mm256_extracti128_si256::<1>(all);
            let [a, b, c, count]: [u32; 4] = cast(self.sse2._mm_add_epi32(low, high));
            totals.copy_from_slice(&[a, b, c]);
            return (totals, count);
        }
        for (each, sum) in totals.iter_mut().zip(sums.planes) {
            *each = total(self, avx2._mm256_madd_epi16(sum, ones));
        }
        (totals, total(self, count))
    }

    #[inline(always)]
    fn meeting(self, boxes: &Boxes, low: [u16; 3], high: [u16; 3]) -> u32 {
        let zero = self.avx._mm256_setzero_si256();
        let (mut first, mut second) = (zero, zero);
        for axis in 0..3 {
            let lows: [__m256i; 2] = cast(boxes.low[axis]);
            let highs: [__m256i; 2] = cast(boxes.high[axis]);
            let (from, to) = (low[axis], high[axis]);
            let apart = [
                apart(self, [lows[0], highs[0]], from, to),
                apart(self, [lows[1], highs[1]], from, to),
            ];
            first = self.avx2._mm256_or_si256(first, apart[0]);
            second = self.avx2._mm256_or_si256(second, apart[1]);
        }
        let first = self.avx2._mm256_cmpeq_epi16(first, zero);
        let second = self.avx2._mm256_cmpeq_epi16(second, zero);
        bits(self, first, second)
    }

    #[inline(always)]
    fn inside(self, part: Part, blocks: &Words) -> u32 {
        let [first, second]: [__m256i; 2] = cast(*blocks);
        let first = contained(self, part, first);
        let second = contained(self, part, second);
        bits(self, first, second)
    }

    #[inline(always)]
    fn touched(self, boxes: &Boxes, query: [u16; 3]) -> u32 {
        let zero = self.avx._mm256_setzero_si256();
        let (mut first, mut second) = ([zero; 3], [zero; 3]);
        for axis in 0..3 {
            let low: [__m256i; 2] = cast(boxes.low[axis]);
            let high: [__m256i; 2] = cast(boxes.high[axis]);
            let shift = boxes.shift;
            first[axis] = box_squares(self, [low[0], high[0]], query[axis], shift);
            second[axis] = box_squares(self, [low[1], high[1]], query[axis], shift);
        }
        let largest = self.avx._mm256_set1_epi16(boxes.largest as i16);
        let first = is_at_most(self, first, largest);
        let second = is_at_most(self, second, largest);
        bits(self, first, second)
    }
}

// A mask has one bit for each leaf. A word of a sum is signed and holds 2 * TRAY mantissas.
const _: () = assert!(TRAY == 32 && 255 * 2 * TRAY <= i16::MAX as usize && LEAF == 32);
