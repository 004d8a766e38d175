//! Reads the tables `[materials.NAME]`.

use std::collections::BTreeMap;

use super::field::{Field, Fields};
use crate::scene::{Bsdf, SceneError};

/// The materials by name.
pub(super) type Materials<'a> = BTreeMap<&'a str, Bsdf>;

pub(super) fn read<'a>(materials: &Fields<'a>) -> Result<Materials<'a>, SceneError> {
    let materials = materials.all().into_iter();
    let read = materials.map(|(name, field)| Ok((name, material(&field)?)));
    read.collect()
}

/// The material that a shape names.
pub(super) fn find(materials: &Materials<'_>, name: &Field<'_>) -> Result<Bsdf, SceneError> {
    let choices: Vec<_> = materials
        .iter()
        .map(|(name, bsdf)| (*name, *bsdf))
        .collect();
    name.choice(&choices)
}

#[derive(Clone, Copy)]
enum Kind {
    Diffuse,
    Mirror,
    Dielectric,
}

fn material(field: &Field<'_>) -> Result<Bsdf, SceneError> {
    let fields = field.table("a table")?;
    let kinds = [
        ("diffuse", Kind::Diffuse),
        ("mirror", Kind::Mirror),
        ("dielectric", Kind::Dielectric),
    ];
    let kind = fields.need("type", "`diffuse`, `mirror` or `dielectric`")?;
    match kind.choice(&kinds)? {
        Kind::Diffuse => {
            fields.only(&["type", "reflectance"])?;
            let reflectance = reflectance(&fields)?;
            Ok(Bsdf::Diffuse { reflectance })
        }
        Kind::Mirror => {
            fields.only(&["type", "reflectance", "two_sided"])?;
            let two_sided = fields.get("two_sided").map(|field| field.boolean());
            Ok(Bsdf::Mirror {
                reflectance: reflectance(&fields)?,
                two_sided: two_sided.transpose()?.unwrap_or(false),
            })
        }
        Kind::Dielectric => {
            fields.only(&["type", "ior", "outside_ior"])?;
            let inside = index(&fields.need("ior", INDEX)?)?;
            let outside = fields.get("outside_ior").map(|field| index(&field));
            Ok(Bsdf::Dielectric {
                ratio: inside / outside.transpose()?.unwrap_or(1.0),
            })
        }
    }
}

/// From the index of X-rays in any medium to more than that of every crystal.
const INDEX: &str = "a number from 0.5 to 10";

fn index(field: &Field<'_>) -> Result<f64, SceneError> {
    field.number(|ior| (0.5..=10.0).contains(&ior), INDEX)
}

fn reflectance(fields: &Fields<'_>) -> Result<glam::DVec3, SceneError> {
    let field = fields.need("reflectance", "three numbers from 0 to 1")?;
    field.three(|part| (0.0..=1.0).contains(&part), "a number from 0 to 1")
}
