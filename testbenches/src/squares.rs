//! The expected squares of a spatial machine, by the spec's formula.

use std::collections::VecDeque;

use photoncube_spec::Squarer;

/// Two squares of a spatial machine, with their pipeline registers, which start as 0.
pub(crate) struct SquarePair {
    radius_bits: u32,
    /// Fraction bits that only a query has.
    extra_bits: u32,
    squarer: Squarer,
    registers: VecDeque<[u64; 4]>,
}

impl SquarePair {
    /// Squares whose outputs appear `latency` clocks after their operands.
    pub fn new(latency: usize, radius_bits: u32, extra_bits: u32, squarer: Squarer) -> Self {
        Self {
            radius_bits,
            extra_bits,
            squarer,
            registers: VecDeque::from(vec![[0; 4]; latency]),
        }
    }

    /// The outputs in a clock with these operands: both squares, and whether each is far.
    pub fn clock(&mut self, query: u64, [photon_a, photon_b]: [u64; 2]) -> [u64; 4] {
        let square = |photon| match self.extra_bits {
            0 => square_of(query, photon, self.radius_bits, self.squarer),
            extra_bits => half_square_of(query, photon, self.radius_bits, extra_bits),
        };
        let ((square_a, far_a), (square_b, far_b)) = (square(photon_a), square(photon_b));
        self.registers.push_back([square_a, square_b, far_a, far_b]);
        self.registers.pop_front().expect("one was pushed")
    }
}

/// The expected `Square` and `SquareFar` of a spatial machine, by the spec.
fn square_of(query: u64, photon: u64, radius_bits: u32, squarer: Squarer) -> (u64, u64) {
    let distance = query.abs_diff(photon);
    let modulus = 1 << radius_bits;
    let squared = match squarer {
        Squarer::Digits => distance % modulus,
        Squarer::Product | Squarer::Table => distance,
    };
    let square = squared * squared % (modulus * modulus);
    (square, u64::from(distance >= modulus))
}

/// The expected `Square` and `SquareFar` on half steps, by the spec: with positions in half steps, all middles are odd or
/// even numbers, and the distance is m + 1/2 steps.
fn half_square_of(query: u64, photon: u64, radius_bits: u32, extra_bits: u32) -> (u64, u64) {
    let steps = (2 * query + 1).abs_diff((2 * photon + 1) << extra_bits) / 2;
    let modulus = 1 << radius_bits;
    let square = steps * (steps + 1) % (modulus * modulus);
    (square, u64::from(steps >= modulus))
}
