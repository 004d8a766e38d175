//! A scene by name or by file.

use std::path::Path;

use anyhow::{Result, bail};
use photoncube_render::{Geometry, Scene};

/// The built-in scene of that name, or the scene in that file: TOML by its extension, else JSON.
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
    let scene = Scene::from_file(Path::new(name))?;
    warn_of_dropped(&scene);
    Ok(scene)
}

/// Says on standard error which meshes have triangles that no ray can meet.
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

/// The scene's name for files: a built-in scene's own, or a file's without folder and extension.
pub fn stem(name: &str) -> String {
    let stem = Path::new(name).file_stem().unwrap_or_default();
    stem.to_string_lossy().into_owned()
}
