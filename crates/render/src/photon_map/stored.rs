//! A photon as the map stores it.

use glam::DVec3;

use crate::trace::Photon;

/// A photon of a photon map. Its surface and its facing are those of its run, so a photon of the map takes 48 bytes, and a traced
/// one 56.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StoredPhoton {
    /// The position of the hit in scene units.
    pub position: DVec3,
    /// The radiant flux that arrived, for red, green and blue; not yet reflected.
    pub power: DVec3,
}

impl From<Photon> for StoredPhoton {
    fn from(photon: Photon) -> Self {
        Self {
            position: photon.position,
            power: photon.power,
        }
    }
}
