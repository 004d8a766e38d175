//! Writes files atomically.

use std::error::Error;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, anyhow};
use tempfile::NamedTempFile;

/// The most links that are followed to a file, as on Linux.
const MAX_LINKS: usize = 40;

/// Makes a folder and its parents.
pub fn make_folder(folder: &Path) -> Result<()> {
    fs::create_dir_all(folder).with_context(|| {
        format!(
            "cannot make the folder {}; expected a name for a folder that can be written",
            folder.display()
        )
    })
}

/// Writes a file beside its place and renames it. If the path is a link, the link stays and its target is
/// written.
pub fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    put(path, stage(path, bytes)?)
}

/// Writes a file as its contents are made, beside its place, and renames it when it is whole.
pub fn write_with(
    path: &Path,
    contents: impl FnOnce(&mut NamedTempFile) -> Result<()>,
) -> Result<()> {
    let mut file = stage(path, &[])?;
    contents(&mut file)?;
    put(path, file)
}

/// Writes all of the files, or none where one cannot be written.
pub fn write_all<'a>(files: impl IntoIterator<Item = (PathBuf, &'a [u8])>) -> Result<()> {
    let staged = files.into_iter().map(|(path, bytes)| {
        let file = stage(&path, bytes)?;
        Ok((path, file))
    });
    // All files are on the disk before the first is renamed.
    let staged = staged.collect::<Result<Vec<_>>>()?;
    staged
        .into_iter()
        .try_for_each(|(path, file)| put(&path, file))
}

/// Writes a temporary file with the contents beside the file's place.
fn stage(path: &Path, bytes: &[u8]) -> Result<NamedTempFile> {
    let folder = folder_of(&target(path));
    make_folder(&folder)?;
    let attempt = || -> io::Result<NamedTempFile> {
        let mut file = temporary(&folder)?;
        file.write_all(bytes)?;
        Ok(file)
    };
    attempt().map_err(|error| cannot_write(path, &error))
}

fn put(path: &Path, file: NamedTempFile) -> Result<()> {
    let put = file.persist(target(path));
    put.map_err(|error| cannot_write(path, &error.error))?;
    Ok(())
}

/// Makes an empty temporary file in a folder.
pub fn temporary(folder: &Path) -> io::Result<NamedTempFile> {
    tempfile::Builder::new()
        .permissions(permissions())
        .tempfile_in(folder)
}

/// The error of a file that cannot be written: the system's message without the name of the temporary file.
pub fn cannot_write(path: &Path, error: &io::Error) -> anyhow::Error {
    let mut cause: &dyn Error = error;
    if let Some(inner) = error.get_ref() {
        cause = inner;
    }
    while let Some(deeper) = cause.source() {
        cause = deeper;
    }
    anyhow!("cannot write {}: {cause}", path.display())
}

/// The path at the end of the links, if the path is a link. The path is not made canonical, because the file
/// need not exist.
pub fn target(path: &Path) -> PathBuf {
    let mut target = path.to_owned();
    for _ in 0..MAX_LINKS {
        match fs::read_link(&target) {
            Ok(next) => target = folder_of(&target).join(next),
            Err(_) => break,
        }
    }
    target
}

/// The folder of a file.
pub fn folder_of(path: &Path) -> PathBuf {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder.to_owned(),
        _ => PathBuf::from("."),
    }
}

/// The permissions of a plain file; temporary files are private by default.
#[cfg(unix)]
fn permissions() -> fs::Permissions {
    use std::os::unix::fs::PermissionsExt;
    fs::Permissions::from_mode(0o644)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_and_nothing_is_left_beside_it() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a/b.txt");
        write(&path, b"old").unwrap();
        write(&path, b"new").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert_eq!(fs::read_dir(path.parent().unwrap()).unwrap().count(), 1);
    }

    #[test]
    fn a_folder_that_cannot_be_made_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        write(&file, b"").unwrap();
        let error = write(&file.join("x"), b"").unwrap_err();
        assert!(
            format!("{error:#}").contains("cannot make the folder"),
            "{error:#}"
        );
    }

    #[cfg(unix)]
    #[test]
    fn a_link_stays_and_its_file_is_written() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("far")).unwrap();
        // Two links, the second relative to its own folder, to a file that does not exist yet.
        std::os::unix::fs::symlink("far/second", at("first")).unwrap();
        std::os::unix::fs::symlink("file", at("far/second")).unwrap();
        for text in [b"old", b"new"] {
            write(&at("first"), text).unwrap();
            assert_eq!(fs::read(at("far/file")).unwrap(), text);
        }
        assert!(at("first").is_symlink() && at("far/second").is_symlink());
    }

    #[test]
    fn where_one_file_cannot_be_written_none_is() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        write(&at("file"), b"").unwrap();
        let files = ["one", "file/two"].map(|name| (at(name), &b"text"[..]));
        assert!(write_all(files).is_err());
        assert!(!at("one").exists());
        let files = ["one", "two"].map(|name| (at(name), &b"text"[..]));
        write_all(files).unwrap();
        assert!(at("one").exists() && at("two").exists());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 3);
    }

    #[test]
    fn a_cause_is_said_once_and_without_the_temporary_name() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("taken");
        fs::create_dir_all(path.join("by a folder")).unwrap();
        let said = format!("{:#}", write(&path, b"").unwrap_err());
        let cause = said.strip_prefix(&format!("cannot write {}: ", path.display()));
        let cause = cause.unwrap_or_else(|| panic!("{said}"));
        assert_eq!(cause.matches("os error").count(), 1, "{said}");
        assert!(!cause.contains(".tmp"), "{said}");
    }
}
