//! The limit of the processor's instruction ports: the photons a second that the operations on a leaf allow, if
//! nothing else were to be done.
//!
//! The operations are those of `crates/model/src/planes/` on a leaf of 32 photons on a wall along two axes, with
//! three planes of mantissas. All operands are in registers. One addition for each leaf changes the query, so
//! that no operation can be left out.

use core::arch::x86_64::{__m256i, __m512i};
use std::hint::black_box;
use std::time::Instant;

use pulp::cast;
use pulp::x86::{V3, V4};

/// The photons of a leaf.
const LEAF: u32 = 32;

/// The leaves of a measurement: some hundredths of a second.
const LEAVES: u32 = 1 << 23;

/// The instruction set of a limit.
pub enum Limit {
    Avx2(V3),
    Avx512(V4),
}

impl Limit {
    /// The limit of a contestant; `None` where its instructions have none here.
    pub fn of(contestant: &str) -> Option<Self> {
        let avx2 = || V3::try_new().map(Self::Avx2);
        match contestant {
            "fixed point" => V4::try_new().map(Self::Avx512).or_else(avx2),
            "fixed point, AVX2" => avx2(),
            _ => None,
        }
    }

    /// Measures the photons a second.
    pub fn photons_per_second(&self) -> f64 {
        let started = Instant::now();
        match *self {
            Self::Avx2(simd) => black_box(simd.vectorize(
                #[inline(always)]
                || avx2(simd),
            )),
            Self::Avx512(simd) => black_box(simd.vectorize(
                #[inline(always)]
                || avx512(simd),
            )),
        };
        f64::from(LEAF) * f64::from(LEAVES) / started.elapsed().as_secs_f64()
    }
}

/// The sums of three planes, and the count.
type Sums = ([__m256i; 3], __m256i);

#[inline(always)]
fn avx512(simd: V4) -> Sums {
    let (f, bw, avx2) = (simd.avx512f, simd.avx512bw, simd.avx2);
    let photons: [__m512i; 2] = cast(black_box([[1_u64; 8], [2; 8]]));
    let powers: [__m256i; 3] = cast(black_box([[1_u8; 32], [2; 32], [3; 32]]));
    let largest = f._mm512_set1_epi32(black_box(1000));
    let step = f._mm512_set1_epi16(black_box(1));
    let (mut query, mut count) = (step, 0_u32);
    let mut sums = [simd.avx._mm256_setzero_si256(); 3];
    for _ in 0..LEAVES {
        let first = bw._mm512_sub_epi16(query, photons[0]);
        let second = bw._mm512_sub_epi16(query, photons[1]);
        let first = f._mm512_cmple_epi32_mask(bw._mm512_madd_epi16(first, first), largest);
        let second = f._mm512_cmple_epi32_mask(bw._mm512_madd_epi16(second, second), largest);
        let in_range = u32::from(first) | u32::from(second) << 16;
        count = count.wrapping_add(in_range.count_ones());
        let minus = bw._mm256_movm_epi8(in_range);
        for (sum, power) in sums.iter_mut().zip(powers) {
            *sum = avx2._mm256_add_epi16(*sum, avx2._mm256_maddubs_epi16(power, minus));
        }
        query = bw._mm512_add_epi16(query, step);
    }
    (sums, simd.avx._mm256_set1_epi32(count as i32))
}

#[inline(always)]
fn avx2(simd: V3) -> Sums {
    let avx2 = simd.avx2;
    let photons: [__m256i; 4] = cast(black_box([[1_u64; 4], [2; 4], [3; 4], [4; 4]]));
    let powers: [__m256i; 3] = cast(black_box([[1_u8; 32], [2; 32], [3; 32]]));
    let over = simd.avx._mm256_set1_epi32(black_box(1000));
    let step = simd.avx._mm256_set1_epi16(black_box(1));
    let (mut query, mut count) = (step, simd.avx._mm256_setzero_si256());
    let mut sums = [count; 3];
    for _ in 0..LEAVES {
        let mut masks = photons;
        for mask in &mut masks {
            let d = avx2._mm256_sub_epi16(query, *mask);
            *mask = avx2._mm256_cmpgt_epi32(over, avx2._mm256_madd_epi16(d, d));
        }
        let in_range = avx2._mm256_packs_epi16(
            avx2._mm256_packs_epi32(masks[0], masks[1]),
            avx2._mm256_packs_epi32(masks[2], masks[3]),
        );
        count = avx2._mm256_sub_epi8(count, in_range);
        for (sum, power) in sums.iter_mut().zip(powers) {
            *sum = avx2._mm256_sub_epi16(*sum, avx2._mm256_maddubs_epi16(power, in_range));
        }
        query = avx2._mm256_add_epi16(query, step);
    }
    (sums, count)
}
