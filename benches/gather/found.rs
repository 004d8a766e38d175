//! The results of the contestants, by which their work is compared.

use std::ops::AddAssign;

use glam::DVec3;

/// The sums over all queries.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Found {
    pub queries: u64,
    pub power: DVec3,
    pub count: u64,
    /// The number of photons that were decided: those of all blocks or cells around; for a tree, which does
    /// not report these, those in range.
    pub candidates: u64,
    /// The number of these whose distance was computed; the others are known to be out of range.
    pub tests: u64,
}

impl Found {
    /// Whether the two sums are near. Formats round, and f32 decides differently at the sphere's border,
    /// which may change a few photons in a thousand.
    pub fn is_near(&self, other: &Self) -> bool {
        let near = |a: f64, b: f64| (a - b).abs() <= 0.005 * b;
        let powers = self
            .power
            .to_array()
            .into_iter()
            .zip(other.power.to_array());
        self.queries == other.queries
            && near(self.count as f64, other.count as f64)
            && powers.into_iter().all(|(a, b)| near(a, b))
    }
}

impl AddAssign for Found {
    fn add_assign(&mut self, other: Self) {
        self.queries += other.queries;
        self.power += other.power;
        self.count += other.count;
        self.candidates += other.candidates;
        self.tests += other.tests;
    }
}
