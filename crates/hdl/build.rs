//! Lists the sources that a generator is built from, so that a program has them in it and needs no clone of the project.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs};

/// The folders and files of the project that a generator is built from. Cargo.toml has the versions that the crates inherit,
/// Cargo.lock those of all other crates.
const SOURCES: [&str; 7] = [
    "Cargo.lock",
    "Cargo.toml",
    "crates/hdl",
    "crates/rust-hdl-lint",
    "crates/spec",
    "crates/svg",
    "crates/verilog-eval",
];

fn main() {
    let variable = |name| env::var(name).expect("cargo sets it");
    let root = Path::new(&variable("CARGO_MANIFEST_DIR")).join("../..");
    // A generator builds no generators.
    let is_generator = env::var_os("CARGO_FEATURE_NAMED_MACHINES").is_none();
    let mut files = Vec::new();
    if !is_generator {
        for source in SOURCES {
            println!("cargo::rerun-if-changed={}", root.join(source).display());
            collect(&root.join(source), &mut files);
        }
        files.sort();
    }
    let mut text = String::from("[\n");
    for file in files {
        let name = file.strip_prefix(&root).expect("it is below the root");
        let file = file.canonicalize().expect("it is there");
        writeln!(text, "    ({name:?}, include_bytes!({file:?})),").expect("a string grows");
    }
    text += "]\n";
    let list = Path::new(&variable("OUT_DIR")).join("sources.rs");
    fs::write(list, text).expect("cargo makes OUT_DIR");
}

/// The file, or all files below the folder but those of tests and benchmarks.
fn collect(path: &Path, files: &mut Vec<PathBuf>) {
    if path.is_file() {
        files.push(path.to_owned());
        return;
    }
    let entries = fs::read_dir(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    for entry in entries {
        let path = entry.expect("a folder can be read on").path();
        let name = path.file_name().unwrap_or_default();
        if !["tests", "benches", "snapshots"]
            .iter()
            .any(|other| name == *other)
        {
            collect(&path, files);
        }
    }
}
