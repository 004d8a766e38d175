//! The user's cache folder, and the files that a program has in it and unpacks there.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

/// Paths from a folder, and the texts of the files.
pub type Files = [(&'static str, &'static [u8])];

/// The error of a folder or file that cannot be read or written.
#[derive(Debug, thiserror::Error)]
#[error("cannot {action} {path}")]
pub struct CacheError {
    /// The action that failed.
    pub action: &'static str,
    /// The path of the file or folder.
    pub path: String,
    /// The error of the operating system.
    pub source: io::Error,
}

/// The user's cache folder, by the XDG rules; `None` where there is none.
pub fn user_cache() -> Option<PathBuf> {
    let folder = |name| std::env::var_os(name).map(PathBuf::from);
    let absolute = |path: &PathBuf| path.is_absolute();
    folder("XDG_CACHE_HOME")
        .filter(absolute)
        .or_else(|| Some(folder("HOME").filter(absolute)?.join(".cache")))
}

/// The folder of this name in the part of the user's cache, or of the temporary files, that is photoncube's.
#[must_use]
pub fn cache(name: &str) -> PathBuf {
    let cache = user_cache().unwrap_or_else(std::env::temp_dir);
    cache.join("photoncube").join(name)
}

/// Writes the files to a folder in `parent` that is named after their digest, unless it is there.
///
/// # Errors
/// A folder or file cannot be written.
pub fn unpacked(parent: &Path, files: &Files) -> Result<PathBuf, CacheError> {
    let folder = parent.join(digest(files));
    if folder.is_dir() {
        return Ok(folder);
    }
    fs::create_dir_all(parent).map_err(failed("make", parent))?;
    let new = tempfile::tempdir_in(parent).map_err(failed("make a folder in", parent))?;
    for (path, text) in files {
        write(&new.path().join(path), text)?;
    }
    // A rename is atomic: another process sees all of the files or none, and may have been the first to write them.
    let moved = fs::rename(new.path(), &folder);
    moved.or_else(|error| match folder.is_dir() {
        true => Ok(()),
        false => Err(failed("write", &folder)(error)),
    })?;
    Ok(folder)
}

/// SHA-256 of texts with their paths, in hexadecimal digits.
#[must_use]
pub fn digest(files: &[(&str, &[u8])]) -> String {
    let mut hasher = Sha256::new();
    for (path, text) in files {
        for bytes in [path.as_bytes(), text] {
            hasher.update((bytes.len() as u64).to_le_bytes());
            hasher.update(bytes);
        }
    }
    let digest = hasher.finalize();
    digest.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Writes a file, and the folders above it.
pub(crate) fn write(path: &Path, text: &[u8]) -> Result<(), CacheError> {
    let folder = path.parent().unwrap_or(path);
    fs::create_dir_all(folder).map_err(failed("make", folder))?;
    fs::write(path, text).map_err(failed("write", path))
}

/// The error of an action with a path.
pub(crate) fn failed(action: &'static str, path: &Path) -> impl Fn(io::Error) -> CacheError {
    let path = path.display().to_string();
    move |source| CacheError {
        action,
        path: path.clone(),
        source,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_unpacked_whole_and_once() {
        let folder = tempfile::tempdir().unwrap();
        let parent = folder.path().join("new");
        let files: &Files = &[("a.txt", b"1"), ("b/c.txt", b"2")];
        let unpacked = || unpacked(&parent, files).unwrap();
        assert_eq!(fs::read(unpacked().join("b/c.txt")).unwrap(), b"2");
        fs::write(unpacked().join("a.txt"), "changed").unwrap();
        assert_eq!(fs::read(unpacked().join("a.txt")).unwrap(), b"changed");
        assert_eq!(fs::read_dir(&parent).unwrap().count(), 1);
    }

    #[test]
    fn a_folder_that_cannot_be_made_is_an_error() {
        let file = tempfile::NamedTempFile::new().unwrap();
        let error = unpacked(&file.path().join("x"), &[]).unwrap_err();
        assert!(error.to_string().starts_with("cannot make "), "{error}");
    }

    #[test]
    fn another_text_or_path_is_another_digest() {
        let of = |path, text: &str| digest(&[(path, text.as_bytes())]);
        assert_ne!(of("a", "b"), of("a", "c"));
        assert_ne!(of("a", "b"), of("ab", ""));
    }
}
