//! Random numbers that depend on their purpose and index, and not on the thread.

use glam::DVec3;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// The purpose of a stream. Streams of different purposes never share numbers.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Purpose {
    /// One emitted path, by its index in the whole run.
    Path = 1,
    /// The view rays of one pixel.
    View = 2,
    /// The choice of queries for a workload.
    Workload = 3,
    /// The shadow rays and gather rays of one pixel.
    Light = 4,
}

/// The stream of item `index` of a purpose.
///
/// Index and seed pass through the finaliser of SplitMix64 (Steele, Lea, Flood 2014), which is
/// a bijection: within one seed and purpose no two items share a stream.
pub(crate) fn stream(seed: u64, purpose: Purpose, index: u64) -> Pcg64Mcg {
    let base = mix(seed ^ mix(purpose as u64));
    Pcg64Mcg::seed_from_u64(mix(base.wrapping_add(index)))
}

/// The finaliser of SplitMix64.
pub(crate) fn mix(value: u64) -> u64 {
    let mut z = value.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// Well separated points of the unit square: Roberts' R2 sequence (2018), shifted by a random vector (Cranley
/// and Patterson, 1976). Each point alone is uniform, so the mean over them has no bias.
#[derive(Debug, Clone)]
pub(crate) struct Apart {
    point: [f64; 2],
}

impl Apart {
    /// 1 / g and 1 / g^2 of the plastic number g, the root of g^3 = g + 1.
    const STEP: [f64; 2] = [0.754_877_666_246_692_8, 0.569_840_290_998_053_3];

    pub fn new(rng: &mut Pcg64Mcg) -> Self {
        Self {
            point: [rng.random(), rng.random()],
        }
    }

    pub fn next(&mut self) -> [f64; 2] {
        for (coordinate, step) in self.point.iter_mut().zip(Self::STEP) {
            *coordinate = (*coordinate + step).fract();
        }
        self.point
    }
}

/// A direction about `normal` with density cos / pi: by Malley's method, a uniform point of
/// the unit disc lifted to the hemisphere.
pub(crate) fn cosine_direction(normal: DVec3, rng: &mut Pcg64Mcg) -> DVec3 {
    cosine_direction_at(normal, [rng.random(), rng.random()])
}

/// A direction about `normal` with density cos / pi, from a point of the unit square.
pub(crate) fn cosine_direction_at(normal: DVec3, [radius_sq, turn]: [f64; 2]) -> DVec3 {
    let angle = std::f64::consts::TAU * turn;
    let (x, y) = normal.any_orthonormal_pair();
    let disc = radius_sq.sqrt() * (angle.cos() * x + angle.sin() * y);
    disc + (1.0 - radius_sq).sqrt() * normal
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sixteen random points are in 16 (1 - (15/16)^16) = 10.3 of sixteen cells on average.
    #[test]
    fn points_keep_apart() {
        let mut filled = 0;
        for index in 0..100 {
            let mut points = Apart::new(&mut stream(1, Purpose::Light, index));
            let mut cells = std::collections::HashSet::new();
            for _ in 0..16 {
                let [x, y] = points.next();
                assert!((0.0..1.0).contains(&x) && (0.0..1.0).contains(&y));
                cells.insert(((4.0 * x) as u32, (4.0 * y) as u32));
            }
            filled += cells.len();
        }
        assert!(filled > 12 * 100, "{filled}");
    }

    #[test]
    fn streams_differ_by_seed_purpose_and_index() {
        let first = |seed, purpose, index| stream(seed, purpose, index).random::<u64>();
        let base = first(1, Purpose::Path, 1);
        assert_eq!(base, first(1, Purpose::Path, 1));
        assert_ne!(base, first(2, Purpose::Path, 1));
        assert_ne!(base, first(1, Purpose::View, 1));
        assert_ne!(base, first(1, Purpose::Path, 2));
    }

    #[test]
    fn cosine_directions_average_to_two_thirds() {
        let normal = DVec3::new(1.0, -2.0, 0.5).normalize();
        let mut rng = stream(7, Purpose::Path, 0);
        let count = 20_000;
        let mut cosines = 0.0;
        for _ in 0..count {
            let wi = cosine_direction(normal, &mut rng);
            assert!((wi.length() - 1.0).abs() < 1e-12);
            assert!(wi.dot(normal) >= 0.0);
            cosines += wi.dot(normal);
        }
        // The cosine's mean is 2/3, its deviation sqrt(1/18): 0.0017 for the mean; five of it.
        assert!((cosines / f64::from(count) - 2.0 / 3.0).abs() < 0.0085);
    }
}
