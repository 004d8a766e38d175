//! What `photoncube synth --json` printed of one machine or core, read from a file of `docs/measured/`.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::figures::{AreaRow, PlaceRow};
#[cfg(test)]
use crate::table::grouped;

/// The area and the clocks of what was measured.
#[derive(Deserialize)]
pub struct Measurements {
    /// What was measured.
    pub machines: Vec<Text>,
    /// The device.
    pub device: String,
    /// The programs that measured, and their versions.
    pub tool_versions: BTreeMap<String, String>,
    /// The areas.
    pub areas: Vec<AreaRow>,
    /// The clocks, one for each seed and speed grade.
    pub placements: Vec<PlaceRow>,
}

/// A machine or core, and the digest of the Verilog that was measured.
#[derive(Deserialize)]
pub struct Text {
    /// Its name.
    pub machine: String,
    /// The digest.
    pub verilog_sha256: String,
}

/// "34,826 (42 %)": cells, and their part of those of the device, as pages have it.
#[cfg(test)]
pub fn part(cells: u64, of: u64) -> String {
    let percent = 100.0 * cells as f64 / of as f64;
    format!("{} ({percent:.0} %)", grouped(cells))
}
