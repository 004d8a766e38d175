//! Runs that take seconds and that several tests use; each is made once.

use std::sync::LazyLock;

use serde_json::Value;
use tempfile::TempDir;

use super::json;

/// Few photons and queries: the fit differs from the default's, but it is made in the same way.
pub const SMALL_FIT: [&str; 6] = ["--photons", "20000", "--size", "24x24", "--maps", "4"];

/// A report, with the folder of the command's files.
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

/// The output of `fit ring`.
pub static FIT: LazyLock<Value> =
    LazyLock::new(|| json(&[&["fit", "ring"][..], &SMALL_FIT[..]].concat()));

/// The output of `run` for the default scene, with the machine that is fitted to it.
pub static RUN: LazyLock<Written> = LazyLock::new(|| {
    let small = ["--photons", "20000", "--size", "24x24", "--samples", "1"];
    let few = ["--iterations", "40", "--maps", "3"];
    Written::by("run", &[&small[..], &few].concat())
});

/// The output of `report` for the default scene.
pub static REPORT: LazyLock<Written> = LazyLock::new(|| {
    let small = ["--photons", "5000", "--size", "8x8", "--maps", "3"];
    let small = [&small[..], &["--picture-size", "48x48"]].concat();
    Written::by("report", &small)
});

/// The output of `hard-cases` in one format.
pub static HARD_CASES: LazyLock<Value> =
    LazyLock::new(|| json(&["hard-cases", "--format", "local7x1-mono8"]));
