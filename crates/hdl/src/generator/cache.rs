//! The cache of generators: `photoncube/generators` in the user's cache folder, or in that of temporary files.
//!
//! A generator is stored under the digest of its crate and of every source that it is built from, so a change of a source
//! makes another generator.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

use photoncube_spec::Machine;

use super::{GeneratorError, Step, cargo, package};
use crate::cache::{Files, cache, digest, failed, unpacked, write};

/// The sources that a generator is built from: paths from the project's root, and the texts. They are those that this
/// program was built from, wherever its clone is now.
const SOURCES: &Files = &include!(concat!(env!("OUT_DIR"), "/sources.rs"));

/// The generators that this process has used. The sources are not expected to change while it runs.
static FOUND: Mutex<BTreeMap<&'static str, PathBuf>> = Mutex::new(BTreeMap::new());

/// The program of the generator of a machine, from the cache or built now.
pub(super) fn program(
    machine: &'static Machine,
    progress: &mut dyn FnMut(&Step),
) -> Result<PathBuf, GeneratorError> {
    // The lock is kept while cargo builds: another thread that needs the generator waits for it.
    let mut found = FOUND.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(program) = found.get(machine.name) {
        return Ok(program.clone());
    }
    let text = package::program(machine);
    let of_sources = digest(SOURCES);
    let digest = digest(&[("", of_sources.as_bytes()), ("", text.as_bytes())]);
    let cache = cache("generators");
    let program = cache.join(&digest);
    if !program.is_file() {
        let sources = unpacked(&cache.join("sources"), SOURCES)?;
        let folder =
            tempfile::tempdir().map_err(failed("make a folder in", &std::env::temp_dir()))?;
        let folder = folder.path();
        let manifest = package::manifest(&sources, &digest);
        write(&folder.join("Cargo.toml"), manifest.as_bytes())?;
        write(&folder.join("src/main.rs"), text.as_bytes())?;
        let lock = sources.join("Cargo.lock");
        fs::copy(&lock, folder.join("Cargo.lock")).map_err(failed("copy", &lock))?;
        let built = cargo::build(machine.name, folder, &cache.join("target"), progress)?;
        // A rename is atomic: another process sees all of the program or none. Where another process built the same program
        // at the same time, it may have been the first to move it.
        let moved = fs::rename(&built, &program);
        moved.or_else(|error| match program.is_file() {
            true => Ok(()),
            false => Err(failed("write", &program)(error)),
        })?;
    }
    found.insert(machine.name, program.clone());
    Ok(program)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn the_sources_are_todays_without_tests() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        for (path, text) in SOURCES {
            assert_eq!(*text, fs::read(root.join(path)).unwrap(), "{path}");
            assert!(!path.contains("/tests/"), "{path}");
        }
        for expected in [
            "Cargo.lock",
            "Cargo.toml",
            "crates/hdl/build.rs",
            "crates/hdl/src/generator/cache.rs",
            "crates/hdl/src/core/registers.v",
            "crates/spec/src/lib.rs",
            "crates/svg/Cargo.toml",
        ] {
            assert!(SOURCES.iter().any(|(path, _)| *path == expected));
        }
    }
}
