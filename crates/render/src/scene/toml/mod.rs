//! Reads scene files in TOML; docs/scenes.md describes the format.

mod field;
mod materials;
mod shapes;
#[cfg(test)]
mod tests;

use std::path::Path;

use glam::DVec3;
use toml::de::DeTable;
use toml_parser::lexer::TokenKind;

use self::field::{Fields, Source};
use super::{LightChoice, Scene, SceneError};
use crate::view::{Camera, FovAxis};

/// Reads the scene in `text`. The files of meshes are relative to `folder`.
pub(super) fn parse(file: &str, text: &str, folder: &Path) -> Result<Scene, SceneError> {
    let source = Source { file, text };
    shallow(source)?;
    let table = DeTable::parse(text).map_err(|error| {
        let (line, column) = source.place(error.span().map_or(0, |span| span.start));
        SceneError::Toml {
            file: file.to_owned(),
            line,
            column,
            message: error.message().to_owned(),
        }
    })?;
    let top = Fields {
        source,
        table: table.get_ref(),
        start: 0,
        path: String::new(),
    };
    scene(&top, folder)
}

/// The most brackets that are open at once; a scene has at most four.
const DEEPEST: usize = 64;

/// Refuses brackets that are nested too deeply. The parser of the crate `toml` limits the nesting of values,
/// but not of the brackets that it skips after an error, and would overflow its stack.
fn shallow(source: Source<'_>) -> Result<(), SceneError> {
    let mut open = 0_usize;
    for token in toml_parser::Source::new(source.text).lex() {
        match token.kind() {
            TokenKind::LeftSquareBracket | TokenKind::LeftCurlyBracket => open += 1,
            TokenKind::RightSquareBracket | TokenKind::RightCurlyBracket => {
                open = open.saturating_sub(1);
            }
            _ => {}
        }
        if open > DEEPEST {
            let (line, column) = source.place(token.span().start());
            return Err(SceneError::Toml {
                file: source.file.to_owned(),
                line,
                column,
                message: format!("more than {DEEPEST} brackets are open; close them"),
            });
        }
    }
    Ok(())
}

fn scene(top: &Fields<'_>, folder: &Path) -> Result<Scene, SceneError> {
    top.only(&["name", "light_choice", "camera", "materials", "shapes"])?;
    let name = match top.get("name") {
        Some(name) => name.text("the scene's name")?,
        None => Path::new(top.source.file)
            .file_stem()
            .map_or("", |stem| stem.to_str().unwrap_or("")),
    };
    let camera = top.need("camera", "a table: where the picture is taken from")?;
    let camera = camera_of(&camera.table("a table")?)?;
    let materials = top.need("materials", "tables of materials by name")?;
    let materials = materials::read(&materials.table("tables of materials by name")?)?;
    let shapes = top.need("shapes", "tables of shapes, each under [[shapes]]")?;
    let (mut surfaces, mut files) = (Vec::new(), Vec::new());
    for shape in shapes.array("tables of shapes, each under [[shapes]]")? {
        surfaces.extend(shapes::read(&shape, &materials, folder)?);
        files.extend(shapes::mesh_file(&shape, folder)?);
    }
    if !surfaces.iter().any(|s| s.radiance != DVec3::ZERO) {
        let found = "no light".to_owned();
        return Err(shapes.error(found, "at least one quad or box with an emission over 0"));
    }
    let mut scene = Scene::new(name.to_owned(), camera, surfaces);
    scene.files = files;
    if let Some(choice) = top.get("light_choice") {
        let choices = [
            ("flux", LightChoice::Flux),
            ("uniform", LightChoice::Uniform),
        ];
        scene.light_choice = choice.choice(&choices)?;
    }
    Ok(scene)
}

fn camera_of(camera: &Fields<'_>) -> Result<Camera, SceneError> {
    camera.only(&["position", "target", "up", "fov_deg", "fov_axis"])?;
    let point = "an array of three numbers";
    let position = camera.need("position", point)?.point()?;
    let target_field = camera.need("target", point)?;
    let target = target_field.point()?;
    let up = match camera.get("up") {
        Some(up) => up.point()?,
        None => DVec3::Y,
    };
    let fov = camera.need("fov_deg", "an angle over 0 and below 180")?;
    let open = |angle| angle > 0.0 && angle < 180.0;
    let fov_deg = fov.number(open, "an angle over 0 and below 180")?;
    let axes = [
        ("smaller", FovAxis::Smaller),
        ("larger", FovAxis::Larger),
        ("x", FovAxis::X),
        ("y", FovAxis::Y),
    ];
    let axis = match camera.get("fov_axis") {
        Some(axis) => axis.choice(&axes)?,
        None => FovAxis::Smaller,
    };
    Camera::look_at(position, target, up, fov_deg, axis).ok_or_else(|| {
        let expected = "a place apart from the position, and not straight along up from it";
        target_field.error(target.to_string(), expected)
    })
}
