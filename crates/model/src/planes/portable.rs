//! The lanes in plain loops over arrays, which compilers turn into what vector instructions there are.

use super::axis::{Axis, Side};
use super::lanes::{BATCH, Bytes, Lanes, Meeting, Words};
use super::leaf::LEAF;

/// Distances of words saturate here, so that three squares fit 31 bits.
const LARGEST_WORD: u16 = (1 << 14) - 1;

#[derive(Copy, Clone, Debug)]
pub(super) struct Portable;

impl Lanes for Portable {
    type Bytes = Bytes;
    type Words = [u16; LEAF];
    type Mantissas = Bytes;
    type ByteAxis = Axis<u8>;
    type WordAxis = Axis<u16>;
    type Sum = u64;
    type Count = u64;

    // 2^21 photons of 8 bits, which the kernel shifts up by 32 at most.
    const ADDITIONS: usize = 1 << 16;

    #[inline(always)]
    fn byte_axis(self, axis: Axis<u8>) -> Axis<u8> {
        axis
    }

    #[inline(always)]
    fn word_axis(self, axis: Axis<u16>) -> Axis<u16> {
        axis
    }

    #[inline(always)]
    fn bytes(self, bytes: &Bytes) -> Bytes {
        *bytes
    }

    #[inline(always)]
    fn words(self, words: &Words) -> [u16; LEAF] {
        std::array::from_fn(|lane| u16::from_le_bytes([words[2 * lane], words[2 * lane + 1]]))
    }

    #[inline(always)]
    fn mantissas(self, bytes: &Bytes) -> Bytes {
        *bytes
    }

    #[inline(always)]
    fn ones(self, photons: usize) -> Bytes {
        std::array::from_fn(|lane| u8::from(lane < photons))
    }

    #[inline(always)]
    fn bytes_from(self, largest: u8, bytes: Bytes) -> Bytes {
        bytes.map(|byte| largest.wrapping_sub(byte))
    }

    #[inline(always)]
    fn words_from(self, largest: u16, words: [u16; LEAF]) -> [u16; LEAF] {
        words.map(|word| largest.wrapping_sub(word))
    }

    #[inline(always)]
    fn bytes_inside(self, axis: &Axis<u8>, centres: Bytes) -> Bytes {
        centres.map(|centre| axis.inside(centre))
    }

    #[inline(always)]
    fn bytes_outside(self, axis: &Axis<u8>, side: Side, centres: Bytes) -> Bytes {
        centres.map(|centre| axis.outside(side, centre))
    }

    #[inline(always)]
    fn words_inside(self, axis: &Axis<u16>, centres: [u16; LEAF]) -> [u16; LEAF] {
        centres.map(|centre| axis.inside(centre))
    }

    #[inline(always)]
    fn words_outside(self, axis: &Axis<u16>, side: Side, centres: [u16; LEAF]) -> [u16; LEAF] {
        centres.map(|centre| axis.outside(side, centre))
    }

    #[inline(always)]
    fn bytes_in_range<const HALF_STEPS: bool>(
        self,
        m: [Bytes; 3],
        largest: u16,
        ones: Bytes,
    ) -> Bytes {
        let mut sums = [0_u16; LEAF];
        for m in m {
            for (sum, m) in sums.iter_mut().zip(m) {
                // 255 * 256 at most.
                let square = u16::from(m) * (u16::from(m) + u16::from(HALF_STEPS));
                *sum = sum.saturating_add(square);
            }
        }
        std::array::from_fn(|lane| ones[lane] & u8::from(sums[lane] <= largest))
    }

    #[inline(always)]
    fn words_in_range<const HALF_STEPS: bool>(
        self,
        m: [[u16; LEAF]; 3],
        largest: u32,
        ones: Bytes,
    ) -> Bytes {
        let mut sums = [0_u32; LEAF];
        for m in m {
            for (sum, m) in sums.iter_mut().zip(m) {
                let m = u32::from(m.min(LARGEST_WORD));
                *sum += m * (m + u32::from(HALF_STEPS));
            }
        }
        std::array::from_fn(|lane| ones[lane] & u8::from(sums[lane] <= largest))
    }

    #[inline(always)]
    fn no_sum(self) -> u64 {
        0
    }

    #[inline(always)]
    fn no_count(self) -> u64 {
        0
    }

    #[inline(always)]
    fn add(self, sum: u64, in_range: Bytes, mantissas: Bytes) -> u64 {
        let added = in_range.iter().zip(mantissas);
        // 32 bytes fit 16 bits.
        let added: u16 = added.map(|(is, m)| u16::from(*is) * u16::from(m)).sum();
        sum + u64::from(added)
    }

    #[inline(always)]
    fn add_count(self, count: u64, in_range: Bytes) -> u64 {
        count + u64::from(in_range.iter().sum::<u8>())
    }

    #[inline(always)]
    fn count(self, count: u64) -> u64 {
        count
    }

    #[inline(always)]
    fn total(self, sum: u64, _count: u64) -> u64 {
        sum
    }

    #[inline(always)]
    fn touched(self, meeting: &Meeting<'_>) -> u32 {
        let mut sums = [0_u16; BATCH];
        let bounds = meeting.low.into_iter().zip(meeting.high);
        for ((low, high), queries) in bounds.zip(meeting.queries) {
            for (sum, query) in sums.iter_mut().zip(queries) {
                let outside = low.saturating_sub(*query) | query.saturating_sub(high);
                let m = (outside >> meeting.shift).min(255);
                *sum = sum.saturating_add(m * m);
            }
        }
        let bits = sums.iter().zip(0..);
        let bits = bits.map(|(sum, bit)| u32::from(*sum <= meeting.largest) << bit);
        bits.fold(0, |all, bit| all | bit)
    }
}
