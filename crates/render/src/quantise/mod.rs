//! Quantisation: the photons and queries of a photon map in integers.
//!
//! [`QuantisedMap`] has the plain numbers of a machine, and [`FormatMap`] the numbers of a photon format.
//! [`MachineMap`] holds the one of the two that a machine uses, and makes the words of its streams.

mod format_map;
mod machine_map;
mod power_scale;
mod quantised_map;

pub use format_map::{FormatMap, FormatMapError};
pub use machine_map::MachineMap;
pub use quantised_map::{QuantiseError, QuantisedMap};
