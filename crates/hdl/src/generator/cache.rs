//! The cache of generators: `photoncube/generators` in the user's cache folder, or in that of temporary files.
//!
//! A generator is stored under the digest of its crate and of every source that it is built from, so a change of a source
//! makes another generator.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use photoncube_spec::Machine;
use sha2::{Digest, Sha256};

use super::{GeneratorError, Step, cargo, package};

/// The folders of the project that a generator is built from, and the versions of all other crates.
const SOURCES: [&str; 6] = [
    "crates/hdl",
    "crates/rust-hdl-lint",
    "crates/spec",
    "crates/svg",
    "crates/verilog-eval",
    "Cargo.lock",
];

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
    let sources = sources(machine)?;
    let text = package::program(machine);
    let digest = digest(&sources, &text)?;
    let cache = user_cache().unwrap_or_else(std::env::temp_dir);
    let cache = cache.join("photoncube/generators");
    let program = cache.join(&digest);
    if !program.is_file() {
        let folder =
            tempfile::tempdir().map_err(failed("make a folder in", &std::env::temp_dir()))?;
        let folder = folder.path();
        let manifest = package::manifest(&sources, &digest);
        write(&folder.join("Cargo.toml"), &manifest)?;
        write(&folder.join("src/main.rs"), &text)?;
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

/// The folder of the project's sources: that of PHOTONCUBE_SOURCES, or where this crate was compiled.
fn sources(machine: &'static Machine) -> Result<PathBuf, GeneratorError> {
    let compiled = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let folder = std::env::var_os("PHOTONCUBE_SOURCES").map_or_else(compiled, PathBuf::from);
    let is_there = SOURCES.iter().all(|source| folder.join(source).exists());
    match folder.canonicalize().ok().filter(|_| is_there) {
        Some(folder) => Ok(folder),
        None => Err(GeneratorError::NoSources {
            machine: machine.name,
            path: folder.display().to_string(),
        }),
    }
}

/// SHA-256 of this text and of all files of [`SOURCES`] with their paths, in hexadecimal digits.
fn digest(sources: &Path, text: &str) -> Result<String, GeneratorError> {
    let mut files = Vec::new();
    for source in SOURCES {
        collect(&sources.join(source), &mut files)?;
    }
    files.sort();
    let mut hasher = Sha256::new();
    let mut update = |bytes: &[u8]| {
        hasher.update((bytes.len() as u64).to_le_bytes());
        hasher.update(bytes);
    };
    update(text.as_bytes());
    for file in files {
        update(file.as_os_str().as_encoded_bytes());
        update(&fs::read(&file).map_err(failed("read", &file))?);
    }
    Ok(hasher
        .finalize()
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect())
}

/// The file, or all files below the folder.
fn collect(path: &Path, files: &mut Vec<PathBuf>) -> Result<(), GeneratorError> {
    if path.is_file() {
        files.push(path.to_owned());
        return Ok(());
    }
    for entry in fs::read_dir(path).map_err(failed("read", path))? {
        collect(&entry.map_err(failed("read", path))?.path(), files)?;
    }
    Ok(())
}

fn write(path: &Path, text: &str) -> Result<(), GeneratorError> {
    let folder = path.parent().unwrap_or(path);
    fs::create_dir_all(folder).map_err(failed("make", folder))?;
    fs::write(path, text).map_err(failed("write", path))
}

fn failed(action: &'static str, path: &Path) -> impl Fn(io::Error) -> GeneratorError {
    let path = path.display().to_string();
    move |error| GeneratorError::File {
        action,
        path: path.clone(),
        reason: error.to_string(),
    }
}

/// The user's cache folder, by the XDG rules; `None` where there is none.
pub fn user_cache() -> Option<PathBuf> {
    let folder = |name| std::env::var_os(name).map(PathBuf::from);
    let absolute = |path: &PathBuf| path.is_absolute();
    folder("XDG_CACHE_HOME")
        .filter(absolute)
        .or_else(|| Some(folder("HOME").filter(absolute)?.join(".cache")))
}
