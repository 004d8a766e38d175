//! The NEON implementation of [`Lanes`], for processors of 64-bit Arm.

use core::arch::aarch64::{uint8x16_t, uint16x8_t};

use pulp::aarch64::Neon;
use pulp::cast;

use super::cube::Part;
use super::lanes::{Boxes, Lanes};
use super::leaf::LEAF;
use super::store::{LeafPlanes, Words};
use super::tray::TRAY;

/// The photons of a leaf in registers of 8 words.
pub(super) type Eights<T> = [T; LEAF / 8];

/// The photons of a leaf in registers of 16 bytes.
pub(super) type Sixteens<T> = [T; LEAF / 16];

/// The low bytes of words, which are all ones or 0.
#[inline(always)]
pub(super) fn bytes(simd: Neon, words: Eights<uint16x8_t>) -> Sixteens<uint8x16_t> {
    let words: [uint8x16_t; 4] = cast(words);
    [
        simd.neon.vuzp1q_u8(words[0], words[1]),
        simd.neon.vuzp1q_u8(words[2], words[3]),
    ]
}

/// A mask with a bit for each word, which is all ones or 0.
#[inline(always)]
fn bits(simd: Neon, words: Eights<uint16x8_t>) -> u32 {
    const BIT: [u8; 16] = [1, 2, 4, 8, 16, 32, 64, 128, 1, 2, 4, 8, 16, 32, 64, 128];
    let [first, second] = bytes(simd, words);
    let first = simd.neon.vandq_u8(first, cast(BIT));
    let second = simd.neon.vandq_u8(second, cast(BIT));
    // Three sums of neighbours bring the bits of eight photons into a byte.
    let pairs = simd.neon.vpaddq_u8(first, second);
    let fours = simd.neon.vpaddq_u8(pairs, pairs);
    let eights: [u8; 16] = cast(simd.neon.vpaddq_u8(fours, fours));
    u32::from_le_bytes([eights[0], eights[1], eights[2], eights[3]])
}

/// The squared distances on one axis of a query from 8 boxes. `left` is the shift, a number below 0.
#[inline(always)]
fn box_squares(
    simd: Neon,
    [low, high]: [uint16x8_t; 2],
    query: uint16x8_t,
    left: i16,
) -> uint16x8_t {
    let neon = simd.neon;
    let below = neon.vqsubq_u16(low, query);
    let above = neon.vqsubq_u16(query, high);
    let outside = neon.vorrq_u16(below, above);
    let m = neon.vshlq_u16(outside, neon.vdupq_n_s16(left));
    let m = neon.vminq_u16(m, neon.vdupq_n_u16(255));
    neon.vmulq_u16(m, m)
}

/// For each packed block, all ones where it is one of the part, else 0.
#[inline(always)]
fn contained(simd: Neon, part: Part, blocks: uint16x8_t) -> uint16x8_t {
    let neon = simd.neon;
    let guards = neon.vdupq_n_u16(Part::GUARDS);
    let first = neon.vdupq_n_u16(part.first);
    let last = neon.vdupq_n_u16(part.last_and_guards);
    let from_first = neon.vsubq_u16(neon.vorrq_u16(blocks, guards), first);
    let to_last = neon.vsubq_u16(last, blocks);
    let both = neon.vandq_u16(neon.vandq_u16(from_first, to_last), guards);
    neon.vceqq_u16(both, guards)
}

/// The sums of a tray.
#[derive(Copy, Clone, Debug)]
pub(super) struct Sums<const PLANES: usize> {
    /// 8 words a plane, each the sum of the mantissas of four photons.
    planes: [uint16x8_t; PLANES],
    /// 16 bytes, each the count of two photons.
    count: uint8x16_t,
}

impl Lanes for Neon {
    /// All ones where a photon is in range.
    type Mask = Sixteens<uint8x16_t>;
    type Powers<const PLANES: usize> = [Sixteens<uint8x16_t>; PLANES];
    type Sums<const PLANES: usize> = Sums<PLANES>;

    #[inline(always)]
    fn powers<const PLANES: usize>(self, planes: &LeafPlanes) -> [Sixteens<uint8x16_t>; PLANES] {
        let mut powers = [[self.neon.vdupq_n_u8(0); 2]; PLANES];
        for (index, power) in powers.iter_mut().enumerate() {
            *power = cast(*planes.mantissas(index));
        }
        powers
    }

    #[inline(always)]
    fn no_sums<const PLANES: usize>(self) -> Sums<PLANES> {
        Sums {
            planes: [self.neon.vdupq_n_u16(0); PLANES],
            count: self.neon.vdupq_n_u8(0),
        }
    }

    #[inline(always)]
    fn add<const PLANES: usize>(
        self,
        mut sums: Sums<PLANES>,
        in_range: Sixteens<uint8x16_t>,
        powers: &[Sixteens<uint8x16_t>; PLANES],
    ) -> Sums<PLANES> {
        for half in 0..2 {
            // All ones are -1.
            sums.count = self.neon.vsubq_u8(sums.count, in_range[half]);
            for (sum, mantissas) in sums.planes.iter_mut().zip(powers) {
                let mantissas = self.neon.vandq_u8(mantissas[half], in_range[half]);
                *sum = self.neon.vpadalq_u8(*sum, mantissas);
            }
        }
        sums
    }

    #[inline(always)]
    fn totals<const PLANES: usize>(self, sums: Sums<PLANES>) -> ([u32; PLANES], u32) {
        let mut totals = [0; PLANES];
        for (each, sum) in totals.iter_mut().zip(sums.planes) {
            *each = self.neon.vaddlvq_u16(sum);
        }
        (totals, self.neon.vaddlvq_u8(sums.count).into())
    }

    #[inline(always)]
    fn meeting(self, boxes: &Boxes, low: [u16; 3], high: [u16; 3]) -> u32 {
        let neon = self.neon;
        let mut meeting = [neon.vdupq_n_u16(u16::MAX); TRAY / 8];
        for axis in 0..3 {
            let (from, to) = (neon.vdupq_n_u16(low[axis]), neon.vdupq_n_u16(high[axis]));
            let lows: Eights<uint16x8_t> = cast(boxes.low[axis]);
            let highs: Eights<uint16x8_t> = cast(boxes.high[axis]);
            for ((low, high), meeting) in lows.into_iter().zip(highs).zip(&mut meeting) {
                let both = neon.vandq_u16(neon.vcleq_u16(from, high), neon.vcleq_u16(low, to));
                *meeting = neon.vandq_u16(*meeting, both);
            }
        }
        bits(self, meeting)
    }

    #[inline(always)]
    fn inside(self, part: Part, blocks: &Words) -> u32 {
        let mut inside: Eights<uint16x8_t> = cast(*blocks);
        for blocks in &mut inside {
            *blocks = contained(self, part, *blocks);
        }
        bits(self, inside)
    }

    #[inline(always)]
    fn touched(self, boxes: &Boxes, query: [u16; 3]) -> u32 {
        let neon = self.neon;
        let mut sums = [neon.vdupq_n_u16(0); TRAY / 8];
        for axis in 0..3 {
            let query = neon.vdupq_n_u16(query[axis]);
            let lows: Eights<uint16x8_t> = cast(boxes.low[axis]);
            let highs: Eights<uint16x8_t> = cast(boxes.high[axis]);
            for ((low, high), sum) in lows.into_iter().zip(highs).zip(&mut sums) {
                let squares = box_squares(self, [low, high], query, -(boxes.shift as i16));
                *sum = neon.vqaddq_u16(*sum, squares);
            }
        }
        for sum in &mut sums {
            *sum = neon.vcleq_u16(*sum, neon.vdupq_n_u16(boxes.largest));
        }
        bits(self, sums)
    }
}

// A mask has one bit for each leaf. A word of a sum holds four mantissas of a leaf, and a byte of the count two photons.
const _: () = assert!(TRAY == 32 && 255 * 4 * TRAY <= u16::MAX as usize && 2 * TRAY <= 255);
