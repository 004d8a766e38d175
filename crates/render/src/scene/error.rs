//! What is no scene.

use std::io;
use std::path::PathBuf;

use photoncube_spec::did_you_mean;
use thiserror::Error;

use super::Scene;
use super::obj::ObjError;

/// Why a scene could not be had.
#[derive(Debug, Error)]
pub enum SceneError {
    /// No built-in scene has the name.
    #[error("no built-in scene is named `{found}`{}; there are: {}", did_you_mean(found, Scene::names()),
        Scene::names().collect::<Vec<_>>().join(", "))]
    Unknown {
        /// The name asked for.
        found: String,
    },
    /// The text is no JSON, or not of the scene's shape.
    #[error("{file}, line {line}, column {column}: {message}")]
    Json {
        /// The file's name, as given.
        file: String,
        /// Counted from 1.
        line: usize,
        /// Counted from 1.
        column: usize,
        /// What was found and expected there.
        message: String,
    },
    /// The text is no TOML.
    #[error("{file}, line {line}, column {column}: {message}")]
    Toml {
        /// The file's name, as given.
        file: String,
        /// Counted from 1.
        line: usize,
        /// Counted from 1.
        column: usize,
        /// What was found and expected there.
        message: String,
    },
    /// A field of a TOML text that no scene can have, or must have.
    #[error("{file}, line {line}, {place}: found {found}, expected {expected}")]
    Field {
        /// The file's name, as given.
        file: String,
        /// Counted from 1.
        line: usize,
        /// The field's path, such as `shapes[2].corners[0]`.
        place: String,
        /// What stands there.
        found: String,
        /// What could stand there.
        expected: String,
    },
    /// A mesh that cannot be had.
    #[error("{file}, line {line}, {place}: {mesh}")]
    Mesh {
        /// The file's name, as given.
        file: String,
        /// Counted from 1.
        line: usize,
        /// The path of the field that names the mesh.
        place: String,
        /// What is wrong with it.
        mesh: Box<ObjError>,
    },
    /// A file that cannot be read.
    #[error("cannot read scene {}: {}", file.display(), reason(error))]
    Read {
        /// The file.
        file: PathBuf,
        /// What the system said; it is told in the words above, so it is no source.
        error: io::Error,
    },
    /// A value that no scene can have.
    #[error("{file}, {place}: found {found}, expected {expected}")]
    Value {
        /// The file's name, as given.
        file: String,
        /// The field's path, such as `shapes.light.vertices`.
        place: String,
        /// What stands there.
        found: String,
        /// What could stand there.
        expected: String,
    },
}

/// Why a text cannot be read, in words where the system's are not about the file.
fn reason(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "no such file".to_owned(),
        io::ErrorKind::IsADirectory => "found a folder, expected a file".to_owned(),
        io::ErrorKind::InvalidData => "not text (UTF-8)".to_owned(),
        _ => error.to_string(),
    }
}
