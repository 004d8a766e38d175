//! Finds a scene by its name or its file.

use std::ffi::OsString;
use std::fmt;
use std::path::PathBuf;

use anyhow::{Result, bail};
use photoncube_render::{Geometry, Scene};
use photoncube_spec::did_you_mean;

/// A scene as the user names it: a built-in scene, or a file, whose name need not be UTF-8.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SceneName(PathBuf);

impl From<OsString> for SceneName {
    fn from(name: OsString) -> Self {
        Self(name.into())
    }
}

impl fmt::Display for SceneName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.display().fmt(f)
    }
}

/// The built-in scene of that name, or the scene in that file: TOML by its extension, else JSON.
pub fn load(name: &SceneName) -> Result<Scene> {
    let names: Vec<_> = Scene::names().collect();
    let built_in = names.iter().find(|known| name.0.as_os_str() == **known);
    if let Some(built_in) = built_in {
        return Ok(Scene::built_in(built_in)?);
    }
    if !name.0.exists() {
        bail!(no_scene(name, &names));
    }
    let scene = Scene::from_file(&name.0)?;
    warn_of_dropped(&scene);
    Ok(scene)
}

/// The error of an unknown scene. A name with a folder or an ending is treated as a file's.
fn no_scene(name: &SceneName, names: &[&str]) -> String {
    let known = names.join(", ");
    match name.0.extension().is_some() || name.0.components().count() > 1 {
        true => {
            format!("{name}: no such file; expected a scene file or a built-in scene ({known})")
        }
        false => {
            let meant = did_you_mean(&name.to_string(), names.iter().copied());
            format!(
                "there is no scene `{name}`{meant}: expected a built-in scene ({known}) or a scene file"
            )
        }
    }
}

/// Warns on standard error about meshes with triangles that no ray can meet.
fn warn_of_dropped(scene: &Scene) {
    for surface in scene.surfaces() {
        if let Geometry::Mesh(mesh) = &surface.geometry
            && mesh.dropped() > 0
        {
            let (shape, dropped) = (&surface.shape, mesh.dropped());
            let all = dropped + mesh.triangles();
            eprintln!("scene: {shape}: {dropped} of {all} triangles have no area and are left out");
        }
    }
}

/// The scene's name in file names: that of a built-in scene, or a file's name without folder and extension.
pub fn stem(SceneName(name): &SceneName) -> String {
    let stem = name.file_stem().unwrap_or_default();
    stem.to_string_lossy().into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scene_that_is_not_there_is_told_as_the_name_or_the_file_that_it_is() {
        let message = |name: &str| load(&OsString::from(name).into()).unwrap_err().to_string();
        assert!(
            message("cornel").starts_with("there is no scene `cornel` (did you mean `cornell`?):")
        );
        assert!(message("sponza").starts_with("there is no scene `sponza`: expected a built-in"));
        for file in ["none.toml", "folder/none"] {
            let expected =
                format!("{file}: no such file; expected a scene file or a built-in scene (");
            assert!(message(file).starts_with(&expected), "{}", message(file));
        }
    }
}
