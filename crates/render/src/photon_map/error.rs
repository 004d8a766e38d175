//! The errors of photons and radii that make no photon map.

use glam::DVec3;
use thiserror::Error;

use super::INDEX_BITS;

/// The reason why a photon map could not be built.
#[derive(Debug, Error, PartialEq)]
pub enum MapError {
    /// The radius allows no grid, or only one too fine to index.
    #[error("search radius: found {found}, expected {min} to {max} for this scene")]
    Radius {
        /// The radius that was given.
        found: f64,
        /// The smallest: the scene's size over 2^20.
        min: f64,
        /// The largest: 2^20 times the scene's size.
        max: f64,
    },
    /// The edge leaves photons in range outside the 27 blocks, or makes one block of all photons.
    #[error("block edge: found {found}, expected {min} to {max} for this search radius")]
    Edge {
        /// The edge that was given.
        found: f64,
        /// The smallest: the search radius.
        min: f64,
        /// The largest: 2^20 times the search radius.
        max: f64,
    },
    /// A photon that no surface of the scene can hold.
    #[error("photon {index}: found {found}, expected {expected}")]
    Photon {
        /// The index of the photon in the list.
        index: usize,
        /// The value that is wrong.
        found: String,
        /// The legal values.
        expected: String,
    },
}

pub(super) fn check_radius(scene_size: f64, radius: f64) -> Result<(), MapError> {
    let blocks = f64::from(1u32 << (INDEX_BITS - 1));
    let (min, max) = (scene_size / blocks, scene_size * blocks);
    if (min..=max).contains(&radius) {
        return Ok(());
    }
    Err(MapError::Radius {
        found: radius,
        min,
        max,
    })
}

pub(super) fn check_edge(radius: f64, edge: f64) -> Result<(), MapError> {
    let (min, max) = (radius, radius * f64::from(1u32 << (INDEX_BITS - 1)));
    if (min..=max).contains(&edge) {
        return Ok(());
    }
    Err(MapError::Edge {
        found: edge,
        min,
        max,
    })
}

/// The first coordinate that is outside the scene by more than `slack`, with the excess.
pub(super) fn outside(position: DVec3, low: DVec3, high: DVec3, slack: f64) -> Option<String> {
    (0..3).find_map(|axis| {
        let (at, low, high) = (position[axis], low[axis], high[axis]);
        let past = (low - at).max(at - high);
        let name = ["x", "y", "z"][axis];
        // A NaN is not inside.
        let inside = past <= slack;
        (!inside).then(|| match at.is_nan() {
            true => format!("{name} is NaN"),
            false => format!("{name} is {at}, {past} past the scene's {low} to {high}"),
        })
    })
}
