//! Reads JSON scene files in the reference renderer's format: the camera and the shapes.

use glam::DVec3;
use photoncube_spec::did_you_mean;

use super::file::{
    BsdfFile, CameraFile, ConductorFile, DielectricFile, EmitterFile, Kind, LightChoiceFile,
    SceneFile, ShapeFile, SheetFile, Spectrum,
};
use super::{Bsdf, LightChoice, MAX_RADIANCE, Scene, SceneError, Surface};
use crate::geometry::{Geometry, Quad, Sphere};
use crate::view::Camera;

/// The least cosine between a stated normal and the normal of the corners. A stated normal only serves to
/// detect a wrong winding, so one degree is enough.
const NORMAL_COSINE: f64 = 0.9998;

pub(super) fn parse(file: &str, text: &str) -> Result<Scene, SceneError> {
    let parsed: SceneFile = serde_json::from_str(text).map_err(|error| json_error(file, &error))?;
    let reader = Reader { file };
    let camera = reader.camera(&parsed.camera)?;
    let mut surfaces = Vec::new();
    for (name, shape) in &parsed.shapes {
        surfaces.extend(reader.shape(name, shape)?);
    }
    if !surfaces.iter().any(|s| s.radiance != DVec3::ZERO) {
        return Err(reader.error(
            "shapes",
            "no emitter",
            "at least one with a radiance over 0",
        ));
    }
    let mut scene = Scene::new(parsed.name, camera, surfaces);
    scene.light_choice = match parsed.light_choice {
        LightChoiceFile::Flux => LightChoice::Flux,
        LightChoiceFile::Uniform => LightChoice::Uniform,
    };
    Ok(scene)
}

fn json_error(file: &str, error: &serde_json::Error) -> SceneError {
    let message = error.to_string();
    // serde_json ends its message with the place, which the error has in its own fields.
    let end = message.rfind(" at line ").unwrap_or(message.len());
    SceneError::Json {
        file: file.to_owned(),
        line: error.line(),
        column: error.column(),
        message: with_meant(&message[..end]),
    }
}

/// Adds a suggestion to serde's message about an unknown name. The message has all known names in backquotes,
/// after the one that was found.
fn with_meant(message: &str) -> String {
    let mut quoted = message.split('`').skip(1).step_by(2);
    match quoted.next() {
        Some(found) if message.starts_with("unknown ") => {
            let named = format!("`{found}`");
            let meant = did_you_mean(found, quoted);
            message.replacen(&named, &format!("{named}{meant}"), 1)
        }
        _ => message.to_owned(),
    }
}

/// Checks values; it knows the file's name for its errors.
struct Reader<'a> {
    file: &'a str,
}

impl Reader<'_> {
    fn error(&self, place: &str, found: impl ToString, expected: &str) -> SceneError {
        SceneError::Value {
            file: self.file.to_owned(),
            place: place.to_owned(),
            found: found.to_string(),
            expected: expected.to_owned(),
        }
    }

    fn camera(&self, camera: &CameraFile) -> Result<Camera, SceneError> {
        Camera::new(camera.fov_deg, camera.to_world).ok_or_else(|| {
            let found = format!(
                "fov_deg {} and to_world {:?}",
                camera.fov_deg, camera.to_world
            );
            let expected = "an angle between 0 and 180 and an invertible affine matrix";
            self.error("camera", found, expected)
        })
    }

    fn shape(&self, name: &str, shape: &ShapeFile) -> Result<Vec<Surface>, SceneError> {
        let place = format!("shapes.{name}");
        let bsdf = self.bsdf(&format!("{place}.bsdf"), &shape.bsdf)?;
        let radiance = match shape.emitter {
            Some(EmitterFile::Area {
                radiance: Spectrum::Rgb { value },
            }) => value,
            None => [0.0; 3],
        };
        let at = format!("{place}.emitter.radiance.value");
        self.spectrum(&at, radiance, MAX_RADIANCE, "numbers from 0 to 1e30")?;
        if shape.emitter.is_some() {
            let other = match bsdf {
                Bsdf::Mirror { .. } => Some("a mirror with an emitter"),
                Bsdf::Dielectric { .. } => Some("a dielectric with an emitter"),
                Bsdf::Diffuse { .. } => None,
            };
            if let Some(found) = other {
                return Err(self.error(&place, found, "one or the other"));
            }
        }
        let surface = |geometry| Surface {
            shape: name.to_owned(),
            geometry,
            bsdf,
            radiance: radiance.into(),
        };
        if shape.kind == Kind::Sphere {
            if let Bsdf::Diffuse { .. } = bsdf {
                let expected =
                    "a conductor or a dielectric; scenes in TOML may have diffuse spheres";
                return Err(self.error(&format!("{place}.bsdf"), "a diffuse sphere", expected));
            }
            return Ok(vec![surface(Geometry::Sphere(self.sphere(&place, shape)?))]);
        }
        let quads = self.quads(&place, shape)?.into_iter();
        Ok(quads.map(|quad| surface(Geometry::Quad(quad))).collect())
    }

    fn sphere(&self, place: &str, shape: &ShapeFile) -> Result<Sphere, SceneError> {
        let expected = "a center and a radius over 0, and no vertices, normal or faces";
        let no_corners = shape.vertices.is_empty()
            && shape.normal.is_none()
            && shape.quads_ccw_outward.is_none();
        if let (Some(centre), Some(radius), true) = (shape.center, shape.radius, no_corners)
            && let Some(sphere) = Sphere::new(centre.into(), radius)
        {
            return Ok(sphere);
        }
        let found = format!(
            "center {:?}, radius {:?} and {} vertices",
            shape.center,
            shape.radius,
            shape.vertices.len()
        );
        Err(self.error(place, found, expected))
    }

    fn bsdf(&self, place: &str, bsdf: &BsdfFile) -> Result<Bsdf, SceneError> {
        match bsdf {
            BsdfFile::Diffuse { reflectance } => {
                let reflectance = self.reflectance(&format!("{place}.reflectance"), reflectance)?;
                Ok(Bsdf::Diffuse { reflectance })
            }
            BsdfFile::Conductor(conductor) => self.mirror(place, conductor, false),
            BsdfFile::Dielectric(dielectric) => self.dielectric(place, dielectric),
            BsdfFile::TwoSided {
                bsdf: SheetFile::Conductor(conductor),
            } => self.mirror(&format!("{place}.bsdf"), conductor, true),
        }
    }

    fn dielectric(&self, place: &str, file: &DielectricFile) -> Result<Bsdf, SceneError> {
        for (field, ior) in [("int_ior", file.int_ior), ("ext_ior", file.ext_ior)] {
            // From the index of X-rays in any medium to more than that of every crystal.
            if !(0.5..=10.0).contains(&ior) {
                return Err(self.error(
                    &format!("{place}.{field}"),
                    ior,
                    "a number from 0.5 to 10",
                ));
            }
        }
        Ok(Bsdf::Dielectric {
            ratio: file.int_ior / file.ext_ior,
        })
    }

    fn mirror(
        &self,
        place: &str,
        conductor: &ConductorFile,
        two_sided: bool,
    ) -> Result<Bsdf, SceneError> {
        let at = format!("{place}.specular_reflectance");
        let reflectance = self.reflectance(&at, &conductor.specular_reflectance)?;
        Ok(Bsdf::Mirror {
            reflectance,
            two_sided,
        })
    }

    fn reflectance(&self, place: &str, spectrum: &Spectrum) -> Result<DVec3, SceneError> {
        let Spectrum::Rgb { value } = *spectrum;
        let at = format!("{place}.value");
        self.spectrum(&at, value, 1.0, "numbers from 0 to 1")?;
        Ok(value.into())
    }

    fn spectrum(
        &self,
        place: &str,
        rgb: [f64; 3],
        max: f64,
        expected: &str,
    ) -> Result<(), SceneError> {
        match rgb.iter().position(|v| !(0.0..=max).contains(v)) {
            Some(channel) => {
                Err(self.error(&format!("{place}[{channel}]"), rgb[channel], expected))
            }
            None => Ok(()),
        }
    }

    fn quads(&self, place: &str, shape: &ShapeFile) -> Result<Vec<Quad>, SceneError> {
        if shape.center.is_some() || shape.radius.is_some() {
            return Err(self.error(place, "center or radius", "those of a sphere only"));
        }
        let faces: &[[usize; 4]] = match (shape.kind, &shape.quads_ccw_outward) {
            (Kind::Quad, None) => &[[0, 1, 2, 3]],
            (Kind::Box, Some(faces)) if faces.len() == 6 => faces,
            (Kind::Quads, Some(faces)) if !faces.is_empty() => faces,
            (Kind::Quad, Some(_)) => {
                return Err(self.error(
                    place,
                    "a quad with quads_ccw_outward",
                    "a quad without it",
                ));
            }
            (_, faces) => {
                let at = format!("{place}.quads_ccw_outward");
                let found = format!("{} faces", faces.as_ref().map_or(0, Vec::len));
                let expected = match shape.kind {
                    Kind::Box => "the 6 faces of a box",
                    _ => "one face or more",
                };
                return Err(self.error(&at, found, expected));
            }
        };
        let quads = faces.iter().enumerate().map(|(index, face)| {
            let at = match shape.kind {
                Kind::Quad => format!("{place}.vertices"),
                _ => format!("{place}.quads_ccw_outward[{index}]"),
            };
            self.quad(&at, face, shape)
        });
        quads.collect()
    }

    fn quad(&self, place: &str, face: &[usize; 4], shape: &ShapeFile) -> Result<Quad, SceneError> {
        let mut corners = [DVec3::ZERO; 4];
        for (corner, &index) in corners.iter_mut().zip(face) {
            let vertex = shape.vertices.get(index).ok_or_else(|| {
                let found = format!("corner {index} of {} vertices", shape.vertices.len());
                self.error(place, found, "corners that are among the vertices")
            })?;
            *corner = DVec3::from(*vertex);
        }
        let quad = Quad::from_corners(corners).ok_or_else(|| {
            let found = corners.map(|c| c.to_string()).join(" ");
            self.error(place, found, "the corners of a parallelogram, in order")
        })?;
        if let Some(normal) = shape.normal.map(DVec3::from) {
            let cosine = normal.normalize_or_zero().dot(quad.normal());
            if cosine < NORMAL_COSINE {
                let found = format!("normal {normal}");
                let expected = format!("the normal of the corners, {}", quad.normal());
                return Err(self.error(place, found, &expected));
            }
        }
        Ok(quad)
    }
}

#[cfg(test)]
mod tests;
