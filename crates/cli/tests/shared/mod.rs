//! Runs that take seconds and that several tests look at: each is made once.

use std::sync::LazyLock;

use serde_json::Value;
use tempfile::TempDir;

use super::json;

/// Few photons and queries: what is fitted differs from the default's, how does not.
pub const SMALL_FIT: [&str; 6] = ["--photons", "20000", "--size", "24x24", "--maps", "4"];

/// A report, and the folder of what the command wrote.
pub struct Written {
    pub report: Value,
    pub folder: TempDir,
}

impl Written {
    fn by(command: &str, options: &[&str]) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let out = [command, "--out", folder.path().to_str().unwrap()];
        let report = json(&[&out[..], options].concat());
        Self { report, folder }
    }
}

/// `fit ring`.
pub static FIT: LazyLock<Value> =
    LazyLock::new(|| json(&[&["fit", "ring"][..], &SMALL_FIT[..]].concat()));

/// `run` of the default scene, with the machine that is fitted to it.
pub static RUN: LazyLock<Written> = LazyLock::new(|| {
    let small = ["--photons", "20000", "--size", "24x24", "--samples", "1"];
    Written::by("run", &[&small[..], &["--iterations", "40"]].concat())
});

/// `report` of the default scene.
pub static REPORT: LazyLock<Written> = LazyLock::new(|| {
    let small = ["--photons", "5000", "--size", "8x8", "--maps", "3"];
    Written::by("report", &small)
});

/// The hard cases in one format.
pub static HARD_CASES: LazyLock<Value> =
    LazyLock::new(|| json(&["hard-cases", "--format", "local7x1-mono8"]));
