//! Stage 1, the scene: named surfaces with their reflectance and emission, and a camera.

mod error;
mod file;
#[cfg(test)]
pub(crate) mod fixtures;
mod fresnel;
mod hierarchy;
mod joins;
mod json;
mod lights;
mod obj;
mod surface;
mod toml;
mod transform;

use std::fs;
use std::path::{Path, PathBuf};

use glam::DVec3;
use sha2::{Digest, Sha256};

pub use error::SceneError;
pub(crate) use lights::{Lights, emitters};
pub use obj::ObjError;
pub(crate) use surface::Scattered;
pub use surface::{Bsdf, Surface};

use self::hierarchy::Hierarchy;
use self::joins::Joins;

use crate::geometry::Hit;
use crate::view::{Camera, Ray};

/// The built-in scenes: name and text.
const BUILT_IN: [(&str, &str); 3] = [
    ("cornell", include_str!("../../scenes/cornell.json")),
    ("ring", include_str!("../../scenes/ring.json")),
    ("range", include_str!("../../scenes/range.json")),
];

/// The distance, as a fraction of the scene's diagonal, within which a ray that leaves a surface ignores
/// hits. It is 25 times the tilt of the reference scene's single-precision geometry (4e-8), and far below its
/// smallest gap (0.01 between light and ceiling).
const LEAVE_DISTANCE: f64 = 1e-6;

/// The largest radiance: far above any light, and a sum of squares of such numbers does not overflow.
const MAX_RADIANCE: f64 = 1e30;

/// The frequency with which each light is chosen to emit a photon. The mean of the light that photons carry
/// to a place is independent of it; the number and the powers of photons there are not.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum LightChoice {
    /// In proportion to its flux: all photons start with about equal power.
    #[default]
    Flux,
    /// Every light with equal probability, for a scene where only a weak light reaches some place: by flux,
    /// hardly any photon would arrive there. Initial powers then differ as the lights' fluxes do.
    Uniform,
}

/// A scene: surfaces and a camera.
#[derive(Debug, Clone)]
pub struct Scene {
    name: String,
    camera: Camera,
    surfaces: Vec<Surface>,
    light_choice: LightChoice,
    leave_distance: f64,
    hierarchy: Hierarchy,
    joins: Joins,
    files: Vec<PathBuf>,
}

impl Scene {
    /// The names of the built-in scenes:
    /// - `cornell`, the Cornell box: diffuse, coloured, evenly lit;
    /// - `ring`, the caustic of a metal ring: 96 flat mirrors on a floor, lit from the side, all
    ///   light of one colour and all photons of equal power, their density far from even. Written
    ///   by `examples/ring_scene.rs`;
    /// - `range`, a wide dynamic range: two rooms parted by a thin wall, their lamps 2,000,000 : 1
    ///   in flux and as often chosen, so that photons differ by as much across that wall within a
    ///   block, and within the bright room (which has a night lamp too) on one surface. The dim
    ///   room's floor, ceiling and back are 0.2 off the bright room's, so with a search radius
    ///   below that (with 200 in range, from 50,000 photons up) no estimate mixes the two.
    pub fn names() -> impl Iterator<Item = &'static str> {
        BUILT_IN.iter().map(|(name, _)| *name)
    }

    /// The built-in scene of that name.
    ///
    /// # Errors
    /// [`SceneError::Unknown`], which lists the names that exist.
    pub fn built_in(name: &str) -> Result<Self, SceneError> {
        let found = BUILT_IN.iter().find(|(known, _)| *known == name);
        let (name, text) = found.ok_or_else(|| SceneError::Unknown { found: name.into() })?;
        Self::from_json(name, text)
    }

    /// The scene in the JSON text `text`, in the form of `scenes/cornell.json`; `file` is used only in error
    /// messages. `scenes/ring.json` shows a shape of many quads and mirrors (a `conductor` of material
    /// `none`, in `twosided` where its back is a mirror too). `scenes/range.json` shows a `light_choice`,
    /// whose default is `flux`. `docs/scenes/spheres.json` shows spheres of glass (a `dielectric`, in the
    /// words of the reference renderer) and of metal.
    ///
    /// # Errors
    /// [`SceneError::Json`] or [`SceneError::Value`], with the place.
    pub fn from_json(file: &str, text: &str) -> Result<Self, SceneError> {
        json::parse(file, text)
    }

    /// Reads the scene in a file: with the extension `toml` by [`Self::from_toml`], with any other by
    /// [`Self::from_json`].
    ///
    /// # Errors
    /// [`SceneError::Read`], and the errors of either form.
    pub fn from_file(file: &Path) -> Result<Self, SceneError> {
        let text = fs::read_to_string(file).map_err(|error| SceneError::Read {
            file: file.to_owned(),
            error,
        })?;
        let name = file.display().to_string();
        let is_toml = file
            .extension()
            .is_some_and(|e| e.eq_ignore_ascii_case("toml"));
        let mut scene = if is_toml {
            let folder = file.parent().unwrap_or(Path::new(""));
            Self::from_toml(&name, &text, folder)?
        } else {
            Self::from_json(&name, &text).map_err(|error| read_as_json(file, error))?
        };
        scene.files.push(file.to_owned());
        Ok(scene)
    }

    /// The scene in the TOML text `text`, in the form that `docs/scenes.md` states. `file` is used only in
    /// error messages; the files of meshes are relative to `folder`.
    ///
    /// # Errors
    /// [`SceneError::Toml`], [`SceneError::Field`] or [`SceneError::Mesh`], with line and field.
    pub fn from_toml(file: &str, text: &str, folder: &Path) -> Result<Self, SceneError> {
        toml::parse(file, text, folder)
    }

    /// `surfaces` must not be empty.
    fn new(name: String, camera: Camera, surfaces: Vec<Surface>) -> Self {
        let mut scene = Self {
            name,
            hierarchy: Hierarchy::new(&surfaces, camera.position()),
            camera,
            surfaces,
            light_choice: LightChoice::default(),
            leave_distance: 0.0,
            joins: Joins::default(),
            files: Vec::new(),
        };
        let [low, high] = scene.bounds();
        scene.leave_distance = LEAVE_DISTANCE * low.distance(high);
        scene.joins = Joins::of(&scene.surfaces, low.distance(high));
        scene
    }

    /// The scene's name, as stated in its text.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// SHA-256 of all that a picture of the scene follows from, in hexadecimal digits. The name of the scene and the place
    /// and the form of its files are not part of it.
    #[must_use]
    pub fn sha256(&self) -> String {
        let Self {
            camera,
            surfaces,
            light_choice,
            leave_distance,
            ..
        } = self;
        // `Debug` prints a number with the fewest digits that are read as the same number.
        let text = format!("{camera:?} {surfaces:?} {light_choice:?} {leave_distance:?}");
        let digest = Sha256::digest(text);
        digest.iter().map(|byte| format!("{byte:02x}")).collect()
    }

    /// The files that the scene was read from: its own, if it is in one, and those of its meshes.
    #[must_use]
    pub fn files(&self) -> &[PathBuf] {
        &self.files
    }

    /// The camera of the view.
    #[must_use]
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// All surfaces. Photons and hits refer to a surface by its index here.
    #[must_use]
    pub fn surfaces(&self) -> &[Surface] {
        &self.surfaces
    }

    /// The rule that divides photons among the lights.
    #[must_use]
    pub fn light_choice(&self) -> LightChoice {
        self.light_choice
    }

    /// The smallest and the largest corner of the bounding box of all surfaces, in scene units.
    #[must_use]
    pub fn bounds(&self) -> [DVec3; 2] {
        let corners = self.surfaces.iter().flat_map(|s| s.geometry.bounds());
        corners.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], c| {
            [low.min(c), high.max(c)]
        })
    }

    /// The surfaces, in order, whose photons may count for a query of that search radius on `surface`: those joined with it, of normals
    /// whose cosine exceeds `cosine`. A curved surface has normals of all directions.
    pub(crate) fn joined(&self, surface: u32, radius: f64, cosine: f64) -> Vec<u32> {
        let flat = |surface: u32| self.surfaces[surface as usize].geometry.flat_normal();
        let own = flat(surface);
        let alike = |other| match (own, flat(other)) {
            (Some(own), Some(other)) => own.dot(other) > cosine,
            _ => true,
        };
        self.joins.around(surface, radius, alike)
    }

    /// The nearest hit of a ray and its surface's index. Hits at the ray's start are ignored, so that a ray
    /// can leave a surface.
    #[must_use]
    pub fn intersect(&self, ray: &Ray) -> Option<(usize, Hit)> {
        self.hierarchy
            .nearest(&self.surfaces, ray, self.leave_distance)
    }
}

/// Adds to the error of a text that is not JSON that it was read as JSON, unless its name has that extension.
fn read_as_json(file: &Path, mut error: SceneError) -> SceneError {
    let is_json = file
        .extension()
        .is_some_and(|e| e.eq_ignore_ascii_case("json"));
    if let (SceneError::Json { message, .. }, false) = (&mut error, is_json) {
        *message += "; it is read as JSON, since its name does not end in .toml";
    }
    error
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cornell_is_the_reference_scene() {
        let scene = Scene::built_in("cornell").unwrap();
        // Six single quads (the front is open) and two boxes.
        assert_eq!(scene.surfaces().len(), 6 + 2 * 6);
        let lights: Vec<_> = scene
            .surfaces()
            .iter()
            .filter(|s| s.radiance != DVec3::ZERO)
            .collect();
        assert_eq!(lights.len(), 1);
        assert!(
            (lights[0].geometry.area() - 0.46 * 0.38).abs() < 1e-6,
            "single-precision corners"
        );
        assert!(lights[0].geometry.flat_normal().unwrap().y < -0.999);
        let [low, high] = scene.bounds();
        // The bounds that the reference's own file states.
        assert!(low.distance(DVec3::new(-1.0, -1.01, -1.0)) < 1e-6);
        assert!(high.distance(DVec3::ONE) < 1e-6);
    }

    #[test]
    fn boxes_face_outwards_and_walls_inwards() {
        let scene = Scene::built_in("cornell").unwrap();
        for surface in scene.surfaces() {
            let same: Vec<_> = scene
                .surfaces()
                .iter()
                .filter(|s| s.shape == surface.shape)
                .collect();
            let middle = |s: &Surface| {
                let [low, high] = s.geometry.bounds();
                low.midpoint(high)
            };
            let centre = same.iter().map(|s| middle(s)).sum::<DVec3>() / same.len() as f64;
            let is_box = same.len() == 6;
            let inside = if is_box { centre } else { DVec3::ZERO };
            let outward = (middle(surface) - inside).dot(surface.geometry.flat_normal().unwrap());
            assert_eq!(outward > 0.0, is_box, "{}", surface.shape);
        }
    }

    #[test]
    fn the_nearest_surface_is_hit() {
        let scene = Scene::built_in("cornell").unwrap();
        let ray = Ray {
            origin: DVec3::ZERO,
            direction: DVec3::Y,
        };
        let (index, hit) = scene.intersect(&ray).unwrap();
        assert_eq!(scene.surfaces()[index].shape, "light");
        assert!(hit.front);
        let ray = Ray {
            origin: DVec3::ZERO,
            direction: DVec3::Z,
        };
        assert!(scene.intersect(&ray).is_none(), "the front is open");
    }

    #[test]
    fn an_unknown_name_lists_the_known() {
        let message = Scene::built_in("sponza").unwrap_err().to_string();
        assert!(
            message.contains("`sponza`;") && message.contains("cornell, ring, range"),
            "{message}"
        );
        let message = Scene::built_in("cornel").unwrap_err().to_string();
        assert!(message.contains("(did you mean `cornell`?)"), "{message}");
    }

    #[test]
    fn what_cannot_be_read_is_told_by_what_it_is() {
        let folder = tempfile::tempdir().unwrap();
        let error = |name: &str, bytes: Option<&[u8]>| {
            let file = folder.path().join(name);
            if let Some(bytes) = bytes {
                fs::write(&file, bytes).unwrap();
            }
            Scene::from_file(&file).unwrap_err().to_string()
        };
        assert!(error("none.toml", None).ends_with("none.toml: no such file"));
        let bytes = [0xff, 0xfe, 0x00];
        assert!(error("binary.toml", Some(&bytes)).ends_with("binary.toml: not text (UTF-8)"));
        assert!(error("", None).ends_with(": found a folder, expected a file"));
        let told = "; it is read as JSON, since its name does not end in .toml";
        assert!(error("mesh.obj", Some(b"v 0 0 0")).ends_with(told));
        assert!(error("plain", Some(b"[camera]")).ends_with(told));
        assert!(!error("scene.json", Some(b"[camera]")).contains("is read as"));
        assert!(!error("scene.toml", Some(b"camera")).contains("is read as"));
    }

    #[test]
    fn built_in_scenes_are_read_by_their_own_names() {
        for name in Scene::names() {
            assert_eq!(Scene::built_in(name).unwrap().name(), name);
        }
    }
}
