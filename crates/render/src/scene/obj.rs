//! Meshes of OBJ files, which the crate `tobj` reads.
//!
//! It is handed positions and the faces' position indices alone: texture coordinates, normals, groups and
//! materials mean nothing here, and so cannot be wrong either. The line numbers stay the file's.

use std::fs;
use std::io::{self, BufRead, Read};
use std::path::{Path, PathBuf};

use glam::DVec3;
use thiserror::Error;
use tobj::{LoadError, LoadOptions, Model};

use super::transform::Transform;
use crate::geometry::{Mesh, MeshError};

/// Why a file is no mesh.
#[derive(Debug, Error)]
pub enum ObjError {
    /// It is not there, or cannot be read.
    #[error("{}: {source}", file.display())]
    Read {
        /// The file.
        file: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// A line that is no OBJ.
    #[error("{}, line {line}: found {found:?}, expected {expected}", file.display())]
    Line {
        /// The file.
        file: PathBuf,
        /// Counted from 1.
        line: usize,
        /// The line.
        found: String,
        /// What could stand there.
        expected: String,
    },
    /// Lines that are OBJ, and no mesh together.
    #[error("{}, {mesh}", file.display())]
    Mesh {
        /// The file.
        file: PathBuf,
        /// What is wrong.
        mesh: MeshError,
    },
}

/// The mesh of all faces in a file, transformed.
pub(super) fn load(file: &Path, transform: &Transform) -> Result<Mesh, ObjError> {
    let bytes = fs::read(file).map_err(|source| ObjError::Read {
        file: file.to_owned(),
        source,
    })?;
    // Comments and names may be in any encoding.
    let text = String::from_utf8_lossy(&bytes);
    read(file, &text, transform)
}

fn read(file: &Path, text: &str, transform: &Transform) -> Result<Mesh, ObjError> {
    let kept = text.lines().map(kept).collect::<Vec<_>>().join("\n");
    let mut lines = Lines {
        rest: kept.as_bytes(),
        begun: 0,
    };
    let options = LoadOptions {
        triangulate: true,
        ignore_points: true,
        ignore_lines: true,
        ..LoadOptions::default()
    };
    let no_materials = |_: &Path| Err(LoadError::GenericFailure);
    let models = tobj::load_obj_buf(&mut lines, &options, no_materials);
    let (models, _) = models.map_err(|error| line_error(file, text, lines.begun, error))?;
    if let Some(line) = text.lines().position(is_not_finite) {
        return Err(at_line(file, text, line + 1, "finite numbers"));
    }
    mesh(&models, transform).map_err(|mesh| ObjError::Mesh {
        file: file.to_owned(),
        mesh,
    })
}

/// Of a line what makes a mesh: a vertex's coordinates, a face's vertices.
fn kept(line: &str) -> String {
    let mut words = line
        .split('#')
        .next()
        .unwrap_or_default()
        .split_whitespace();
    match words.next() {
        Some("v") => format!("v {}", words.take(3).collect::<Vec<_>>().join(" ")),
        Some("f") => {
            let vertex = |word: &str| word.split('/').next().map(|index| format!(" {index}"));
            format!("f{}", words.filter_map(vertex).collect::<String>())
        }
        _ => String::new(),
    }
}

fn mesh(models: &[Model], transform: &Transform) -> Result<Mesh, MeshError> {
    let place = transform.of_point();
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for Model { mesh, .. } in models {
        let first = vertices.len() as u32;
        let positions = mesh.positions.chunks_exact(3);
        vertices.extend(positions.map(|p| place(DVec3::from_slice(p))));
        let corners = mesh.indices.chunks_exact(3);
        triangles.extend(corners.map(|t| [t[0], t[1], t[2]].map(|index| first + index)));
    }
    Mesh::new(vertices, triangles)
}

/// Whether the line is a vertex with a NaN or an infinity, which are numbers to a parser.
fn is_not_finite(line: &str) -> bool {
    let kept = kept(line);
    let mut words = kept.split(' ');
    words.next() == Some("v")
        && words.any(|word| word.parse::<f64>().is_ok_and(|number| !number.is_finite()))
}

fn line_error(file: &Path, text: &str, line: usize, error: LoadError) -> ObjError {
    if error == LoadError::FaceVertexOutOfBounds {
        let vertices = text
            .lines()
            .filter(|line| kept(line).starts_with('v'))
            .count();
        let expected = format!("indices from 1 to {vertices}, or from -1 down to the first vertex");
        return at_line(
            file,
            text,
            stray_face(text, vertices).unwrap_or(line),
            &expected,
        );
    }
    let expected = match error {
        LoadError::PositionParseError => "three numbers after v".to_owned(),
        LoadError::FaceParseError => "indices of vertices after f".to_owned(),
        other => format!("a line of OBJ ({other})"),
    };
    at_line(file, text, line, &expected)
}

fn at_line(file: &Path, text: &str, line: usize, expected: &str) -> ObjError {
    ObjError::Line {
        file: file.to_owned(),
        line,
        found: text
            .lines()
            .nth(line.max(1) - 1)
            .unwrap_or_default()
            .to_owned(),
        expected: expected.to_owned(),
    }
}

/// The line of the first face with a vertex that is not there. The library finds it at the end of the file.
fn stray_face(text: &str, vertices: usize) -> Option<usize> {
    let mut before = 0_i64;
    let stray = |line: &str| {
        let kept = kept(line);
        before += i64::from(kept.starts_with('v'));
        let mut indices = kept.strip_prefix('f')?.split_whitespace();
        let is_stray = |index: &str| match index.parse::<i64>() {
            Ok(index) if index < 0 => before.saturating_add(index) < 0,
            Ok(index) => index == 0 || index > vertices as i64,
            Err(_) => true,
        };
        indices.any(is_stray).then_some(())
    };
    text.lines()
        .map(stray)
        .position(|line| line.is_some())
        .map(|line| line + 1)
}

/// A text that counts the lines that were begun.
struct Lines<'a> {
    rest: &'a [u8],
    begun: usize,
}

impl Read for Lines<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.rest.read(buffer)
    }
}

impl BufRead for Lines<'_> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        Ok(self.rest)
    }

    fn consume(&mut self, amount: usize) {
        let (read, rest) = self.rest.split_at(amount);
        // Readers of lines take them whole.
        self.begun += usize::from(!read.is_empty());
        self.rest = rest;
    }
}
