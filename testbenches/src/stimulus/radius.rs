//! Photons at the search radius of a query.

use rand::{Rng, RngExt};

use super::case::largest;
use super::cases::Cases;

impl<R: Rng> Cases<'_, R> {
    /// A photon within a step of the radius, in a random direction. Where the frame ends before the radius,
    /// the photon is nearer.
    pub(super) fn at_radius(&mut self, query: [u32; 3], radius_sq: u32) -> [u32; 3] {
        let x = self.rng.random_range(0..=radius_sq.isqrt());
        let y = self.rng.random_range(0..=(radius_sq - x * x).isqrt());
        let z = (radius_sq - x * x - y * y).isqrt() + self.rng.random_range(0..=1);
        let mut steps = [x, y, z];
        steps.rotate_left(self.rng.random_range(0..3));
        let limit = largest(self.widths.photon);
        let centre = self.aim.cell(query);
        [0, 1, 2].map(|axis| {
            if self.rng.random() {
                (centre[axis] + steps[axis]).min(limit)
            } else {
                centre[axis].saturating_sub(steps[axis])
            }
        })
    }

    /// A photon whose squared distance is the squared radius or next to it, or, where none is found, one within a step.
    pub(super) fn next_to_radius(&mut self, query: [u32; 3], radius_sq: u32) -> [u32; 3] {
        // One in some fifty lattice points within a step is so near.
        const TRIES: usize = 256;
        let mut photon = self.at_radius(query, radius_sq);
        for _ in 1..TRIES {
            let distance_sq = self.aim.distance_sq(query, photon);
            if distance_sq.abs_diff(radius_sq.into()) <= 1 {
                break;
            }
            photon = self.at_radius(query, radius_sq);
        }
        photon
    }
}
