//! The errors of texts and files that are not scenes.

use std::io;
use std::path::PathBuf;

use photoncube_spec::did_you_mean;
use thiserror::Error;

use super::Scene;
use super::obj::ObjError;

/// The reason why a scene could not be read.
#[derive(Debug, Error)]
pub enum SceneError {
    /// No built-in scene has the name.
    #[error("no built-in scene is named `{found}`{}; there are: {}", did_you_mean(found, Scene::names()),
        Scene::names().collect::<Vec<_>>().join(", "))]
    Unknown {
        /// The name that was given.
        found: String,
    },
    /// The text is not JSON, or not a scene.
    #[error("{file}, line {line}, column {column}: {message}")]
    Json {
        /// The name of the file, as given.
        file: String,
        /// The line, counted from 1.
        line: usize,
        /// The column, counted from 1.
        column: usize,
        /// The value found there and the expected one.
        message: String,
    },
    /// The text is not TOML.
    #[error("{file}, line {line}, column {column}: {message}")]
    Toml {
        /// The name of the file, as given.
        file: String,
        /// The line, counted from 1.
        line: usize,
        /// The column, counted from 1.
        column: usize,
        /// The value found there and the expected one.
        message: String,
    },
    /// A field of a TOML text is unknown, missing or has no legal value.
    #[error("{file}, line {line}, {place}: found {found}, expected {expected}")]
    Field {
        /// The name of the file, as given.
        file: String,
        /// The line, counted from 1.
        line: usize,
        /// The field's path, such as `shapes[2].corners[0]`.
        place: String,
        /// The value found there.
        found: String,
        /// The legal values there.
        expected: String,
    },
    /// A mesh could not be read.
    #[error("{file}, line {line}, {place}: {mesh}")]
    Mesh {
        /// The name of the file, as given.
        file: String,
        /// The line, counted from 1.
        line: usize,
        /// The path of the field that names the mesh.
        place: String,
        /// The error of the mesh.
        mesh: Box<ObjError>,
    },
    /// A file that cannot be read.
    #[error("cannot read scene {}: {}", file.display(), reason(error))]
    Read {
        /// The path of the file.
        file: PathBuf,
        /// The error of the system. The message contains it, so it is not the error's source.
        error: io::Error,
    },
    /// A value that is not legal in a scene.
    #[error("{file}, {place}: found {found}, expected {expected}")]
    Value {
        /// The name of the file, as given.
        file: String,
        /// The field's path, such as `shapes.light.vertices`.
        place: String,
        /// The value found there.
        found: String,
        /// The legal values there.
        expected: String,
    },
}

/// The reason why a text cannot be read, in words where the system's error is not about the file.
fn reason(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "no such file".to_owned(),
        io::ErrorKind::IsADirectory => "found a folder, expected a file".to_owned(),
        io::ErrorKind::InvalidData => "not text (UTF-8)".to_owned(),
        _ => error.to_string(),
    }
}
