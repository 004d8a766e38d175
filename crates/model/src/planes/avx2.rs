//! The lanes in AVX2: a leaf is one register of bytes.
//!
//! Everything here is inlined into one function that the processor's features are switched on for; a
//! closure would be a function of its own without them, and ten times slower, so there are none.

use core::arch::x86_64::__m256i;

use pulp::cast;
use pulp::x86::V3;

use super::axis::{Axis, Side};
use super::lanes::{BATCH, Bytes, Lanes, Meeting, Words};
use super::leaf::LEAF;

/// Distances of words saturate here, so that three squares fit 31 bits.
const LARGEST_WORD: i16 = (1 << 14) - 1;

/// From 32 - n on: n ones, then none.
const ONES: [u8; 2 * LEAF] = {
    let mut ones = [0; 2 * LEAF];
    let mut lane = 0;
    while lane < LEAF {
        ones[lane] = 1;
        lane += 1;
    }
    ones
};

/// [`Axis`] in every lane.
#[derive(Copy, Clone, Debug)]
pub(super) struct AxisLanes {
    at: __m256i,
    above: __m256i,
    from_below: __m256i,
    from_above: __m256i,
}

impl AxisLanes {
    #[inline(always)]
    fn from(&self, side: Side) -> __m256i {
        match side {
            Side::Below => self.from_below,
            _ => self.from_above,
        }
    }
}

/// The two operands of the three squares, in words: m, and m or m + 1.
#[inline(always)]
fn operands<const HALF_STEPS: bool>(simd: V3, m: __m256i) -> [__m256i; 2] {
    let one = simd.avx._mm256_set1_epi16(1);
    [
        m,
        if HALF_STEPS {
            simd.avx2._mm256_add_epi16(m, one)
        } else {
            m
        },
    ]
}

/// m^2 or m (m + 1) in words of 16 bits.
#[inline(always)]
fn square<const HALF_STEPS: bool>(simd: V3, m: __m256i) -> __m256i {
    let [a, b] = operands::<HALF_STEPS>(simd, m);
    simd.avx2._mm256_mullo_epi16(a, b)
}

/// For each word all ones where a saturating sum of squares is at most `largest`.
#[inline(always)]
fn is_at_most(simd: V3, [x, y, z]: [__m256i; 3], largest: __m256i) -> __m256i {
    let sum = simd
        .avx2
        ._mm256_adds_epu16(simd.avx2._mm256_adds_epu16(x, y), z);
    let over = simd.avx2._mm256_subs_epu16(sum, largest);
    simd.avx2
        ._mm256_cmpeq_epi16(over, simd.avx._mm256_setzero_si256())
}

/// The m of 16 centres in the middle block.
#[inline(always)]
fn words_inside(simd: V3, axis: &AxisLanes, centres: __m256i) -> __m256i {
    let below = simd.avx2._mm256_subs_epu16(axis.at, centres);
    let above = simd.avx2._mm256_subs_epu16(centres, axis.above);
    simd.avx2._mm256_or_si256(below, above)
}

/// m, or what is as far out of range.
#[inline(always)]
fn clamped(simd: V3, m: __m256i) -> __m256i {
    simd.avx2
        ._mm256_min_epu16(m, simd.avx._mm256_set1_epi16(LARGEST_WORD))
}

/// For each of 8 pairs of words all ones where the sum of squares is over `largest`: `xy` has x and
/// y in turn, `z` has z and 0, and `xy1`, `z1` their other operands.
#[inline(always)]
fn sum_is_over(
    simd: V3,
    [xy, xy1]: [__m256i; 2],
    [z, z1]: [__m256i; 2],
    largest: __m256i,
) -> __m256i {
    let xy = simd.avx2._mm256_madd_epi16(xy, xy1);
    let sum = simd
        .avx2
        ._mm256_add_epi32(xy, simd.avx2._mm256_madd_epi16(z, z1));
    simd.avx2._mm256_cmpgt_epi32(sum, largest)
}

/// For each of 16 words all ones where the sum of squares is over `largest`.
#[inline(always)]
fn is_over<const HALF_STEPS: bool>(simd: V3, m: [__m256i; 3], largest: __m256i) -> __m256i {
    let avx2 = simd.avx2;
    let zero = simd.avx._mm256_setzero_si256();
    let [x, x1] = operands::<HALF_STEPS>(simd, m[0]);
    let [y, y1] = operands::<HALF_STEPS>(simd, m[1]);
    let [z, z1] = operands::<HALF_STEPS>(simd, m[2]);
    let low = sum_is_over(
        simd,
        [
            avx2._mm256_unpacklo_epi16(x, y),
            avx2._mm256_unpacklo_epi16(x1, y1),
        ],
        [
            avx2._mm256_unpacklo_epi16(z, zero),
            avx2._mm256_unpacklo_epi16(z1, zero),
        ],
        largest,
    );
    let high = sum_is_over(
        simd,
        [
            avx2._mm256_unpackhi_epi16(x, y),
            avx2._mm256_unpackhi_epi16(x1, y1),
        ],
        [
            avx2._mm256_unpackhi_epi16(z, zero),
            avx2._mm256_unpackhi_epi16(z1, zero),
        ],
        largest,
    );
    avx2._mm256_packs_epi32(low, high)
}

/// The squares, or half squares, of 32 m: of the low halves and of the high halves.
#[inline(always)]
fn byte_squares<const HALF_STEPS: bool>(simd: V3, m: __m256i) -> [__m256i; 2] {
    let zero = simd.avx._mm256_setzero_si256();
    [
        square::<HALF_STEPS>(simd, simd.avx2._mm256_unpacklo_epi8(m, zero)),
        square::<HALF_STEPS>(simd, simd.avx2._mm256_unpackhi_epi8(m, zero)),
    ]
}

/// The squared distances of 16 queries from a box on one axis.
#[inline(always)]
fn box_squares(simd: V3, meeting: &Meeting<'_>, axis: usize, queries: __m256i) -> __m256i {
    let low = simd.avx._mm256_set1_epi16(meeting.low[axis] as i16);
    let high = simd.avx._mm256_set1_epi16(meeting.high[axis] as i16);
    let below = simd.avx2._mm256_subs_epu16(low, queries);
    let above = simd.avx2._mm256_subs_epu16(queries, high);
    let outside = simd.avx2._mm256_or_si256(below, above);
    let shift = simd.sse2._mm_cvtsi32_si128(meeting.shift as i32);
    let m = simd.avx2._mm256_srl_epi16(outside, shift);
    let m = simd
        .avx2
        ._mm256_min_epu16(m, simd.avx._mm256_set1_epi16(255));
    simd.avx2._mm256_mullo_epi16(m, m)
}

impl Lanes for V3 {
    type Bytes = __m256i;
    /// The words of the first half of the photons, and of the second.
    type Words = [__m256i; 2];
    /// Less 128, hence with a sign.
    type Mantissas = __m256i;
    type ByteAxis = AxisLanes;
    type WordAxis = AxisLanes;
    /// 16 words with a sign, each of the mantissas of two photons, which are less 128 each.
    type Sum = __m256i;
    /// Four of 64 bits.
    type Count = __m256i;

    // Two mantissas are -256 at least.
    const ADDITIONS: usize = 127;

    #[inline(always)]
    fn byte_axis(self, axis: Axis<u8>) -> AxisLanes {
        AxisLanes {
            at: self.avx._mm256_set1_epi8(axis.at as i8),
            above: self.avx._mm256_set1_epi8(axis.above as i8),
            from_below: self.avx._mm256_set1_epi8(axis.from_below as i8),
            from_above: self.avx._mm256_set1_epi8(axis.from_above as i8),
        }
    }

    #[inline(always)]
    fn word_axis(self, axis: Axis<u16>) -> AxisLanes {
        AxisLanes {
            at: self.avx._mm256_set1_epi16(axis.at as i16),
            above: self.avx._mm256_set1_epi16(axis.above as i16),
            from_below: self.avx._mm256_set1_epi16(axis.from_below as i16),
            from_above: self.avx._mm256_set1_epi16(axis.from_above as i16),
        }
    }

    #[inline(always)]
    fn bytes(self, bytes: &Bytes) -> __m256i {
        cast(*bytes)
    }

    #[inline(always)]
    fn words(self, words: &Words) -> [__m256i; 2] {
        cast(*words)
    }

    #[inline(always)]
    fn mantissas(self, bytes: &Bytes) -> __m256i {
        let sign = self.avx._mm256_set1_epi8(i8::MIN);
        self.avx2._mm256_xor_si256(cast(*bytes), sign)
    }

    #[inline(always)]
    fn ones(self, photons: usize) -> __m256i {
        let ones: &Bytes = ONES[LEAF - photons..]
            .first_chunk()
            .expect("at most a leaf");
        cast(*ones)
    }

    #[inline(always)]
    fn bytes_from(self, largest: u8, bytes: __m256i) -> __m256i {
        let largest = self.avx._mm256_set1_epi8(largest as i8);
        self.avx2._mm256_sub_epi8(largest, bytes)
    }

    #[inline(always)]
    fn words_from(self, largest: u16, words: [__m256i; 2]) -> [__m256i; 2] {
        let largest = self.avx._mm256_set1_epi16(largest as i16);
        [
            self.avx2._mm256_sub_epi16(largest, words[0]),
            self.avx2._mm256_sub_epi16(largest, words[1]),
        ]
    }

    #[inline(always)]
    fn bytes_inside(self, axis: &AxisLanes, centres: __m256i) -> __m256i {
        let below = self.avx2._mm256_subs_epu8(axis.at, centres);
        let above = self.avx2._mm256_subs_epu8(centres, axis.above);
        self.avx2._mm256_or_si256(below, above)
    }

    #[inline(always)]
    fn bytes_outside(self, axis: &AxisLanes, side: Side, centres: __m256i) -> __m256i {
        self.avx2._mm256_adds_epu8(centres, axis.from(side))
    }

    #[inline(always)]
    fn words_inside(self, axis: &AxisLanes, centres: [__m256i; 2]) -> [__m256i; 2] {
        [
            words_inside(self, axis, centres[0]),
            words_inside(self, axis, centres[1]),
        ]
    }

    #[inline(always)]
    fn words_outside(self, axis: &AxisLanes, side: Side, centres: [__m256i; 2]) -> [__m256i; 2] {
        [
            self.avx2._mm256_adds_epu16(centres[0], axis.from(side)),
            self.avx2._mm256_adds_epu16(centres[1], axis.from(side)),
        ]
    }

    #[inline(always)]
    fn bytes_in_range<const HALF_STEPS: bool>(
        self,
        m: [__m256i; 3],
        largest: u16,
        ones: __m256i,
    ) -> __m256i {
        let [x, x_high] = byte_squares::<HALF_STEPS>(self, m[0]);
        let [y, y_high] = byte_squares::<HALF_STEPS>(self, m[1]);
        let [z, z_high] = byte_squares::<HALF_STEPS>(self, m[2]);
        let largest = self.avx._mm256_set1_epi16(largest as i16);
        // Packing puts the bytes back to where unpacking took them from.
        let in_range = self.avx2._mm256_packs_epi16(
            is_at_most(self, [x, y, z], largest),
            is_at_most(self, [x_high, y_high, z_high], largest),
        );
        self.avx2._mm256_and_si256(in_range, ones)
    }

    #[inline(always)]
    fn words_in_range<const HALF_STEPS: bool>(
        self,
        [x, y, z]: [[__m256i; 2]; 3],
        largest: u32,
        ones: __m256i,
    ) -> __m256i {
        let largest = self.avx._mm256_set1_epi32(largest as i32);
        let first = [
            clamped(self, x[0]),
            clamped(self, y[0]),
            clamped(self, z[0]),
        ];
        let second = [
            clamped(self, x[1]),
            clamped(self, y[1]),
            clamped(self, z[1]),
        ];
        let over = self.avx2._mm256_packs_epi16(
            is_over::<HALF_STEPS>(self, first, largest),
            is_over::<HALF_STEPS>(self, second, largest),
        );
        // Packing took the halves of both registers in turn.
        let over = self.avx2._mm256_permute4x64_epi64::<0b11_01_10_00>(over);
        self.avx2._mm256_andnot_si256(over, ones)
    }

    #[inline(always)]
    fn no_sum(self) -> __m256i {
        self.avx._mm256_setzero_si256()
    }

    #[inline(always)]
    fn no_count(self) -> __m256i {
        self.avx._mm256_setzero_si256()
    }

    #[inline(always)]
    fn add(self, sum: __m256i, in_range: __m256i, mantissas: __m256i) -> __m256i {
        let pairs = self.avx2._mm256_maddubs_epi16(in_range, mantissas);
        self.avx2._mm256_add_epi16(sum, pairs)
    }

    #[inline(always)]
    fn add_count(self, count: __m256i, in_range: __m256i) -> __m256i {
        let zero = self.avx._mm256_setzero_si256();
        self.avx2
            ._mm256_add_epi64(count, self.avx2._mm256_sad_epu8(in_range, zero))
    }

    #[inline(always)]
    fn count(self, count: __m256i) -> u64 {
        let low = self.avx._mm256_castsi256_si128(count);
        let high = self.avx2._mm256_extracti128_si256::<1>(count);
        let [a, b]: [u64; 2] = cast(self.sse2._mm_add_epi64(low, high));
        a + b
    }

    #[inline(always)]
    fn total(self, sum: __m256i, count: u64) -> u64 {
        let ones = self.avx._mm256_set1_epi16(1);
        let fours = self.avx2._mm256_madd_epi16(sum, ones);
        let low = self.avx._mm256_castsi256_si128(fours);
        let high = self.avx2._mm256_extracti128_si256::<1>(fours);
        let [a, b, c, d]: [i32; 4] = cast(self.sse2._mm_add_epi32(low, high));
        // What was taken from each mantissa in range.
        (i64::from(a + b + c + d) + 128 * count as i64) as u64
    }

    #[inline(always)]
    fn touched(self, meeting: &Meeting<'_>) -> u32 {
        let [x, y, z] = meeting.queries;
        let x: [__m256i; 2] = cast(*x);
        let y: [__m256i; 2] = cast(*y);
        let z: [__m256i; 2] = cast(*z);
        let first = [
            box_squares(self, meeting, 0, x[0]),
            box_squares(self, meeting, 1, y[0]),
            box_squares(self, meeting, 2, z[0]),
        ];
        let second = [
            box_squares(self, meeting, 0, x[1]),
            box_squares(self, meeting, 1, y[1]),
            box_squares(self, meeting, 2, z[1]),
        ];
        let largest = self.avx._mm256_set1_epi16(meeting.largest as i16);
        let touched = self.avx2._mm256_packs_epi16(
            is_at_most(self, first, largest),
            is_at_most(self, second, largest),
        );
        let touched = self.avx2._mm256_permute4x64_epi64::<0b11_01_10_00>(touched);
        self.avx2._mm256_movemask_epi8(touched) as u32
    }
}

// One for each bit of a mask.
const _: () = assert!(BATCH == 32);
