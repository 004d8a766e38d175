//! The structure of a JSON scene file, before any value is checked.

use std::collections::BTreeMap;

use serde::Deserialize;

#[derive(Deserialize)]
pub(super) struct SceneFile {
    pub name: String,
    pub camera: CameraFile,
    #[serde(default)]
    pub light_choice: LightChoiceFile,
    // The map is sorted, so that the order of the surfaces does not depend on the parser.
    pub shapes: BTreeMap<String, ShapeFile>,
}

#[derive(Deserialize, Default, Clone, Copy)]
#[serde(rename_all = "lowercase")]
pub(super) enum LightChoiceFile {
    #[default]
    Flux,
    Uniform,
}

#[derive(Deserialize)]
pub(super) struct CameraFile {
    pub fov_deg: f64,
    // The field is read only to refuse any other axis.
    #[serde(rename = "fov_axis")]
    _fov_axis: FovAxis,
    pub to_world: [[f64; 4]; 4],
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum FovAxis {
    Smaller,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ShapeFile {
    pub kind: Kind,
    #[serde(default)]
    pub vertices: Vec<[f64; 3]>,
    pub center: Option<[f64; 3]>,
    pub radius: Option<f64>,
    pub normal: Option<[f64; 3]>,
    pub quads_ccw_outward: Option<Vec<[usize; 4]>>,
    pub bsdf: BsdfFile,
    pub emitter: Option<EmitterFile>,
}

#[derive(Deserialize, Clone, Copy, PartialEq)]
#[serde(rename_all = "lowercase")]
pub(super) enum Kind {
    Quad,
    Box,
    Quads,
    Sphere,
}

#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "lowercase", deny_unknown_fields)]
pub(super) enum BsdfFile {
    Diffuse { reflectance: Spectrum },
    Conductor(ConductorFile),
    Dielectric(DielectricFile),
    TwoSided { bsdf: SheetFile },
}

/// The materials of a two-sided surface: only mirrors have two sides.
#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "lowercase", deny_unknown_fields)]
pub(super) enum SheetFile {
    Conductor(ConductorFile),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ConductorFile {
    // The field is read only to refuse a metal, whose reflectance would depend on the angle.
    #[serde(rename = "material")]
    _material: Material,
    pub specular_reflectance: Spectrum,
}

/// The indices of refraction behind the surface and before it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct DielectricFile {
    pub int_ior: f64,
    pub ext_ior: f64,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Material {
    None,
}

#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "lowercase", deny_unknown_fields)]
pub(super) enum EmitterFile {
    Area { radiance: Spectrum },
}

#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "lowercase", deny_unknown_fields)]
pub(super) enum Spectrum {
    Rgb { value: [f64; 3] },
}
