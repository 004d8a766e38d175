//! The grid of a format or a machine, on which the cases place photons.

use glam::DVec3;
use photoncube_spec::{Machine, Numbers, PhotonFormat};

use super::room::RADIUS;

/// The cells and the search radius of a grid. Indices count from the grid's first block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Grid {
    /// Fraction bits of a photon's position.
    pub position_bits: u32,
    /// The fraction bits of a query beyond those of a photon.
    pub extra: u32,
    /// The search radius in fine steps.
    pub radius_steps: u32,
    /// The most photons of a query.
    pub max_photons: u64,
}

impl Grid {
    /// The grid of a format.
    #[must_use]
    pub fn of_format(format: &PhotonFormat) -> Self {
        Self {
            position_bits: format.position_bits,
            extra: format.query_extra_bits,
            radius_steps: format.radius_steps(),
            max_photons: format.max_photons,
        }
    }

    /// The grid of a machine. In plain numbers the radius is free; it is chosen one step less than a block's
    /// edge, because a power of two has only six points at exactly its distance.
    #[must_use]
    pub fn of_machine(machine: &Machine) -> Self {
        match &machine.numbers {
            Numbers::Local(format) => Self::of_format(format),
            Numbers::Plain(format) => Self {
                position_bits: format.position_bits(),
                extra: 0,
                radius_steps: (1 << format.position_bits()) - 1,
                max_photons: format.max_photons,
            },
        }
    }

    /// A block's edge in fine steps.
    #[must_use]
    pub fn edge_steps(&self) -> u32 {
        1 << (self.position_bits + self.extra)
    }

    /// A block's edge for a search radius, in the radius's unit.
    #[must_use]
    pub fn edge(&self, radius: f64) -> f64 {
        radius * f64::from(self.edge_steps()) / f64::from(self.radius_steps)
    }

    /// The size of a photon's cell for a search radius, in the radius's unit.
    #[must_use]
    pub fn cell(&self, radius: f64) -> f64 {
        self.edge(radius) / f64::from(1_u32 << self.position_bits)
    }

    /// Whether queries lie halfway between the photons' grid lines.
    #[must_use]
    pub fn half_steps(&self) -> bool {
        self.extra > 0
    }

    /// The smaller of `photons` and the most photons of a query.
    pub(super) fn at_most(&self, photons: usize) -> usize {
        photons.min(usize::try_from(self.max_photons).unwrap_or(usize::MAX))
    }

    /// The middle of a photon's cell, in a room at the origin with radius [`RADIUS`].
    pub(super) fn photon_at(&self, cell: [i64; 3]) -> DVec3 {
        self.middle(cell, self.position_bits)
    }

    /// The middle of a query's fine cell, in that room.
    pub(super) fn query_at(&self, fine: [i64; 3]) -> DVec3 {
        self.middle(fine, self.position_bits + self.extra)
    }

    /// The fine grid line of a photon with this index.
    pub(super) fn line(&self, cell: i64) -> i64 {
        (cell << self.extra) + ((1 << self.extra) >> 1)
    }

    /// The scene's corner is the middle of block 0.
    fn middle(&self, index: [i64; 3], bits: u32) -> DVec3 {
        let blocks = DVec3::from(index.map(|i| (i as f64 + 0.5) / (1_u64 << bits) as f64));
        (blocks - 0.5) * self.edge(RADIUS)
    }
}
