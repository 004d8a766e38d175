//! Quantisation: the photons and queries of a photon map in the integers of a machine.

mod planes;
mod power_scale;
mod quantised_map;

pub use quantised_map::{QuantiseError, QuantisedMap};
