//! Reads meshes from OBJ files, with the crate `tobj`.
//!
//! Only positions and the faces' position indices are passed to it. Texture coordinates, normals, groups and
//! materials are ignored, so they cannot be wrong. Line numbers are those of the file.

use std::fs;
use std::io::{self, BufRead, Read};
use std::path::{Path, PathBuf};

use glam::DVec3;
use thiserror::Error;
use tobj::{LoadError, LoadOptions, Model};

use super::transform::Transform;
use crate::geometry::{Mesh, MeshError};

/// The reason why a file is not a mesh.
#[derive(Debug, Error)]
pub enum ObjError {
    /// The file is missing or cannot be read.
    #[error("{}: {source}", file.display())]
    Read {
        /// The path of the file.
        file: PathBuf,
        /// The error of the system.
        source: io::Error,
    },
    /// A line of the file is not legal OBJ.
    #[error("{}, line {line}: found {found:?}, expected {expected}", file.display())]
    Line {
        /// The path of the file.
        file: PathBuf,
        /// The line, counted from 1.
        line: usize,
        /// The text of the line.
        found: String,
        /// The legal text there.
        expected: String,
    },
    /// The lines are legal OBJ but do not make a mesh.
    #[error("{}, {mesh}", file.display())]
    Mesh {
        /// The path of the file.
        file: PathBuf,
        /// The error of the mesh.
        mesh: MeshError,
    },
}

/// Reads the mesh of all faces in a file and transforms it.
pub(super) fn load(file: &Path, transform: &Transform) -> Result<Mesh, ObjError> {
    let bytes = fs::read(file).map_err(|source| ObjError::Read {
        file: file.to_owned(),
        source,
    })?;
    // Comments and names may have any encoding.
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

/// The part of a line that matters for a mesh: a vertex's coordinates or a face's vertices.
fn kept(line: &str) -> String {
    let mut words = line
        .split('#')
        .next()
        .unwrap_or_default()
        .split_whitespace();
    match words.next() {
        Some("v") => format!("v {}", words.take(3).collect::<Vec<_>>().join(" ")),
        Some("f") => {
            let index = |word: &str| match word.split('/').next() {
                // 0 is the number of no vertex.
                None | Some("") => " 0".to_owned(),
                Some(index) => format!(" {index}"),
            };
            format!("f{}", words.map(index).collect::<String>())
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

/// Whether the line is a vertex with a NaN or an infinity, which parsers accept as numbers.
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

/// The line of the first face with a missing vertex. The library reports this error only at the end of the
/// file.
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

/// A text that counts the lines that a reader has begun.
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
        // Readers of lines consume whole lines.
        self.begun += usize::from(!read.is_empty());
        self.rest = rest;
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn parsed(text: &str) -> Result<Mesh, ObjError> {
        read(Path::new("my.obj"), text, &Transform::default())
    }

    fn message(text: &str) -> String {
        parsed(text).unwrap_err().to_string()
    }

    const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    #[test]
    fn faces_become_triangles_with_their_fronts() {
        for face in [
            "f 1 2 3 4",
            "f 1/7 2/8/9 3//1 4",
            "f -4 -3 -2 -1",
            "f 1 2 3\nf 1 3 4",
        ] {
            let mesh = parsed(&format!("{SQUARE}{face}\n")).unwrap();
            assert_eq!((mesh.triangles(), mesh.area()), (2, 1.0), "{face}");
            let [a, b, c] = mesh.corners(1);
            assert_eq!((b - a).cross(c - a), DVec3::Z, "{face}");
        }
    }

    #[test]
    fn what_means_nothing_here_is_passed_over() {
        let text = format!(
            "#!\nmtllib none.mtl\no a\n{SQUARE}vn x\nvt\nusemtl\ng\nl 1 2 3\np 1\ns off\nf 1 2 3 # front\nf 1 2\nf 3 4 1\n"
        );
        assert_eq!(parsed(&text).unwrap().triangles(), 2);
        let coloured = SQUARE.replace("0 0\n", "0 0 0.5 0.5 0.5\n");
        assert_eq!(
            parsed(&format!("{coloured}f 1 2 3")).unwrap().triangles(),
            1
        );
    }

    #[test]
    fn errors_name_file_line_and_what_stands_there() {
        for (text, expected) in [
            (
                "v 0 0\n",
                "my.obj, line 1: found \"v 0 0\", expected three numbers after v",
            ),
            (
                "\n# x\nv 0 a 0\n",
                "my.obj, line 3: found \"v 0 a 0\", expected three numbers",
            ),
            (
                "v 0 0 0\nv 1 nan 0\nf 1 2 2",
                "my.obj, line 2: found \"v 1 nan 0\", expected finite numbers",
            ),
            (
                "v 0 0 0\nv 1 0 -inf",
                "my.obj, line 2: found \"v 1 0 -inf\", expected finite numbers",
            ),
            (
                "",
                "my.obj, triangles: found 0, none with an area, expected at least one with an area",
            ),
            (SQUARE, "my.obj, triangles: found 0, none with an area"),
            (
                "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3",
                "my.obj, triangles: found 1, none with an area",
            ),
        ] {
            assert!(message(text).starts_with(expected), "{}", message(text));
        }
        for face in [
            "f 1 2 9",
            "f 1 0 2",
            "f 1 2 -9",
            "f 1 2 /3",
            "f 1 2 -9223372036854775808",
        ] {
            let text = message(&format!("f 1 2 3\n{SQUARE}\n{face}\n"));
            let line = format!("my.obj, line 7: found {face:?}, expected indices from 1 to 4");
            assert!(text.starts_with(&line), "{text}");
        }
        let text = message(&format!("{SQUARE}f 1 2 x\n{SQUARE}"));
        assert!(
            text.starts_with("my.obj, line 5: found \"f 1 2 x\", expected indices"),
            "{text}"
        );
        let missing = load(Path::new("no/such.obj"), &Transform::default());
        assert!(
            missing
                .unwrap_err()
                .to_string()
                .starts_with("no/such.obj: ")
        );
    }

    proptest! {
        /// OBJ keywords in any order are read or refused, without a panic.
        #[test]
        fn any_words_are_read_or_refused(words in prop::collection::vec(
            prop::sample::select(vec![
                "v ", "f ", "l ", "o ", "vn ", "vt ", "usemtl ", "mtllib ", "\n", "\n", "\n", "1 ", "2 ", "-1 ", "0.5 ",
                "1//2 ", "1/2 ", "/", "#", "\\", "1e999 ", "99999999999999999999 ", "\u{e9} ", "\r\n",
            ]), 0..60,
        )) {
            if let Err(error) = parsed(&words.concat()) {
                prop_assert!(error.to_string().starts_with("my.obj, "), "{error}");
            }
        }
    }
}
