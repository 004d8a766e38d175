//! Arithmetic that is known to fail, for the contrasts.

use glam::DVec3;

/// The decision d^2 <= r^2 in f64.
pub(super) fn in_range_f64(a: DVec3, b: DVec3, radius: f64) -> bool {
    a.distance_squared(b) <= radius * radius
}

/// The decision d^2 <= r^2 in f32, with f32 positions.
pub(super) fn in_range_f32(a: DVec3, b: DVec3, radius: f64) -> bool {
    a.as_vec3().distance_squared(b.as_vec3()) <= radius as f32 * radius as f32
}

/// A position of the unit room in steps of 2^-bits of the whole scene; the last step includes 1.
pub(super) fn absolute(position: DVec3, bits: u32) -> [u32; 3] {
    let steps = 1_u32 << bits;
    let index = position * f64::from(steps);
    index.to_array().map(|c| (c as u32).min(steps - 1))
}

/// The decision d^2 <= r^2 in steps of the whole scene, exact in their integers.
pub(super) fn in_range_absolute(a: DVec3, b: DVec3, radius: f64, bits: u32) -> bool {
    let (a, b) = (absolute(a, bits), absolute(b, bits));
    let distance_sq: u64 = (0..3).map(|i| u64::from(a[i].abs_diff(b[i])).pow(2)).sum();
    let steps = radius * (1_u64 << bits) as f64;
    distance_sq as f64 <= steps * steps
}

/// The decision d^2 <= r^2 in 16-bit steps of the whole scene, with sums of 32 bits that wrap.
pub(super) fn in_range_wrapping_32(a: DVec3, b: DVec3, radius: f64) -> bool {
    let (a, b) = (absolute(a, 16), absolute(b, 16));
    let square = |axis: usize| a[axis].abs_diff(b[axis]).wrapping_pow(2);
    let distance_sq = square(0).wrapping_add(square(1)).wrapping_add(square(2));
    let steps = (radius * 65_536.0) as u32;
    distance_sq <= steps.wrapping_pow(2)
}

/// The decision d^2 <= r^2 in 16-bit steps of the whole scene, with differences of 16 bits, which wrap where
/// they need a sign bit.
pub(super) fn in_range_wrapping_16(a: DVec3, b: DVec3, radius: f64) -> bool {
    let (a, b) = (absolute(a, 16), absolute(b, 16));
    let square = |axis: usize| {
        let difference = (a[axis] as u16).wrapping_sub(b[axis] as u16) as i16;
        u64::from(difference.unsigned_abs()).pow(2)
    };
    let steps = radius * 65_536.0;
    (square(0) + square(1) + square(2)) as f64 <= steps * steps
}

/// The sequential sum in f32.
pub(super) fn sum_f32(values: impl Iterator<Item = f64>) -> f32 {
    values.fold(0.0, |sum, value| sum + value as f32)
}
