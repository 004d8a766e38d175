//! A scene by name or by file.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail};
use photoncube_render::Scene;

/// The built-in scene of that name, or the scene in that file.
pub fn load(name: &str) -> Result<Scene> {
    let names: Vec<_> = Scene::names().collect();
    if names.contains(&name) {
        return Ok(Scene::built_in(name)?);
    }
    if !Path::new(name).exists() {
        bail!(
            "there is no scene `{name}`: expected a built-in scene ({}) or a scene file",
            names.join(", ")
        );
    }
    let text = fs::read_to_string(name).with_context(|| format!("cannot read scene {name}"))?;
    Ok(Scene::from_json(name, &text)?)
}

/// The scene's name for files: a built-in scene's own, or a file's without folder and extension.
pub fn stem(name: &str) -> String {
    let stem = Path::new(name).file_stem().unwrap_or_default();
    stem.to_string_lossy().into_owned()
}
