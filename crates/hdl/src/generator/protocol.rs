//! The words between this program and a generator.

use photoncube_spec::{Pin, SignalPlace};
use serde::{Deserialize, Serialize};

use crate::emit::BlockRam;

/// The argument that asks for a design, followed by the name of a level.
pub(super) const EMIT: &str = "emit";
/// The argument that asks for the lint.
pub(super) const LINT: &str = "lint";
/// The argument that starts a simulation, followed by the name of a level.
pub(super) const SIMULATE: &str = "simulate";

/// [`crate::Emitted`], without what follows from the machine and the level.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Design {
    pub text: String,
    pub top: String,
    pub ecp5_text: Option<String>,
    /// Name and width of each input.
    pub inputs: Vec<(String, u32)>,
    /// Name and width of each output.
    pub outputs: Vec<(String, u32)>,
    pub register_paths: Vec<String>,
    pub block_rams: Vec<BlockRam>,
}

/// A pin of the top, from its name and its width.
pub(super) fn pin((name, width): (String, u32)) -> Pin {
    Pin {
        name,
        width,
        place: SignalPlace::Top,
    }
}
