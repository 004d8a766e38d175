//! Finds and runs a program, and reads its version.

use std::env;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::error::ToolError;

/// The lines of a failed program's output that its error has.
const LAST_LINES: usize = 20;

/// A program: its names, and how it tells its version.
#[derive(Debug, PartialEq, Eq)]
pub struct Program {
    /// The name of its package on PyPI, under which that package installs it, and its common name.
    pub names: [&'static str; 2],
    pub(crate) version_option: &'static str,
    pub(crate) version_after: &'static str,
}

impl Program {
    /// The path of the program in a folder, or on the PATH.
    pub(crate) fn find(&self, folder: Option<&Path>) -> Result<PathBuf, ToolError> {
        let folders = match folder {
            Some(folder) => vec![folder.to_owned()],
            None => env::split_paths(&env::var_os("PATH").unwrap_or_default()).collect(),
        };
        let of_name = |name: &&str| {
            let mut paths = folders.iter().map(|folder| folder.join(name));
            paths.find(|path| path.is_file())
        };
        let found = self.names.iter().find_map(of_name);
        found.ok_or_else(|| ToolError::Missing {
            names: self.names.to_vec(),
            place: folder.map_or("the PATH".to_owned(), |folder| folder.display().to_string()),
        })
    }

    /// The version in the program's output. The rest of the line is left out: the folders and compilers of
    /// the build.
    pub(crate) fn version(&self, said: &str) -> Option<String> {
        let (_, rest) = said.split_once(self.version_after)?;
        let version: String = rest.chars().take_while(|c| !" ,)\n".contains(*c)).collect();
        let rest = &rest[version.len()..];
        let commit = rest.strip_prefix(" (git sha1 ").map(|rest| {
            let commit = rest.chars().take_while(char::is_ascii_alphanumeric);
            format!(" (git sha1 {})", commit.collect::<String>())
        });
        Some(version + &commit.unwrap_or_default())
    }
}

/// The output of a program, which runs in a folder.
///
/// # Errors
/// The program does not start, or fails; the error then has the end of the output.
pub(crate) fn run<S: AsRef<OsStr>>(
    program: &Path,
    arguments: impl IntoIterator<Item = S>,
    folder: &Path,
) -> Result<String, ToolError> {
    let output = Command::new(program)
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::null())
        .output();
    let output = output.map_err(|source| ToolError::NotStarted {
        program: program.to_owned(),
        source,
    })?;
    let said = [&output.stdout[..], &output.stderr[..]].concat();
    let said = String::from_utf8_lossy(&said).into_owned();
    if output.status.success() {
        return Ok(said);
    }
    let lines: Vec<_> = said.trim_end().lines().collect();
    Err(ToolError::Failed {
        program: program.to_owned(),
        status: output.status,
        said: lines[lines.len().saturating_sub(LAST_LINES)..].join("\n"),
    })
}

/// Writes a program of a test. Another process writes it: while this one has the file open, another test's program that starts may
/// inherit it open, and an open file cannot be run.
#[cfg(all(test, unix))]
pub(crate) fn write_program(path: &Path, text: &str) {
    let writes = "printf %s \"$1\" >\"$2\" && chmod 755 \"$2\"";
    let arguments = ["-c", writes, "sh", text];
    let status = Command::new("sh").args(arguments).arg(path).status();
    assert!(status.unwrap().success(), "{}", path.display());
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tool_that_fails_is_quoted() {
        let folder = tempfile::tempdir().unwrap();
        let error = run(
            Path::new("sh"),
            ["-c", "echo ERROR: no top; exit 3"],
            folder.path(),
        );
        let error = error.unwrap_err().to_string();
        assert!(
            error.contains("ERROR: no top") && error.contains('3'),
            "{error}"
        );
    }
}
