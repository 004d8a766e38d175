//! The errors of the flow.

use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitStatus;

use thiserror::Error;

/// The error of a program that is missing or failed.
#[derive(Debug, Error)]
pub enum ToolError {
    /// The program is not there.
    #[error("found no {} in {place}", names.join(" or "))]
    Missing {
        /// The names of the program that were looked for.
        names: Vec<&'static str>,
        /// The place of the search: a folder, or the PATH.
        place: String,
    },
    /// The program could not be started.
    #[error("cannot run {}: {source}", program.display())]
    NotStarted {
        /// The path of the program.
        program: PathBuf,
        /// The error of the operating system.
        source: io::Error,
    },
    /// The program ended with an error.
    #[error("{} ended with {status}:\n{said}", program.display())]
    Failed {
        /// The path of the program.
        program: PathBuf,
        /// The exit status of the program.
        status: ExitStatus,
        /// The last lines of its output.
        said: String,
    },
    /// The program's output has no version.
    #[error("found no version in what {} says: {said}", program.display())]
    NoVersion {
        /// The path of the program.
        program: PathBuf,
        /// Its output.
        said: String,
    },
}

/// The reason why a step of the flow has no result.
#[derive(Debug, Error)]
pub enum FlowError {
    /// A program is missing or failed.
    #[error(transparent)]
    Tool(#[from] ToolError),
    /// A file could not be read or written.
    #[error("cannot {action} {}: {source}", path.display())]
    File {
        /// The action that failed: `read` or `write`.
        action: &'static str,
        /// The path of the file.
        path: PathBuf,
        /// The error of the operating system.
        source: io::Error,
    },
    /// A text is not the JSON that its writer makes.
    #[error("found no JSON as {writer} writes it: {source}")]
    Json {
        /// The command that writes such texts.
        writer: &'static str,
        /// The place and the fault.
        source: serde_json::Error,
    },
    /// A netlist, a report or a design is not as it must be. The text says what was found and expected.
    #[error("{0}")]
    Unexpected(String),
}

/// A result with the errors of the flow.
pub type Result<T, E = FlowError> = std::result::Result<T, E>;

/// An error of what was found, unless `holds`.
pub(crate) fn ensure(holds: bool, found: impl FnOnce() -> String) -> Result<()> {
    if holds {
        Ok(())
    } else {
        Err(unexpected(found()))
    }
}

pub(crate) fn unexpected(found: impl Into<String>) -> FlowError {
    FlowError::Unexpected(found.into())
}

pub(crate) fn read(path: &Path) -> Result<String> {
    std::fs::read_to_string(path).map_err(|source| FlowError::File {
        action: "read",
        path: path.to_owned(),
        source,
    })
}

pub(crate) fn write(path: &Path, text: &str) -> Result<()> {
    std::fs::write(path, text).map_err(|source| FlowError::File {
        action: "write",
        path: path.to_owned(),
        source,
    })
}
