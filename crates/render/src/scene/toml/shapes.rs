//! Reads the tables `[[shapes]]`.

use std::path::{Path, PathBuf};

use glam::DVec3;

use super::field::{Field, Fields};
use super::materials::{Materials, find};
use crate::geometry::{Geometry, Mesh, Quad, Sphere};
use crate::scene::transform::Transform;
use crate::scene::{Bsdf, MAX_RADIANCE, SceneError, Surface, obj};

#[derive(Clone, Copy)]
enum Kind {
    Quad,
    Box,
    Sphere,
    Mesh,
}

/// The fields that shapes of every kind have.
const COMMON: [&str; 4] = ["type", "name", "material", "transform"];

/// The surfaces of a shape.
pub(super) fn read(
    shape: &Field<'_>,
    materials: &Materials<'_>,
    folder: &Path,
) -> Result<Vec<Surface>, SceneError> {
    let fields = shape.table("a table")?;
    let kinds = [
        ("quad", Kind::Quad),
        ("box", Kind::Box),
        ("sphere", Kind::Sphere),
        ("mesh", Kind::Mesh),
    ];
    let kind = fields.need("type", "`quad`, `box`, `sphere` or `mesh`")?;
    let kind = kind.choice(&kinds)?;
    let own: &[&str] = match kind {
        Kind::Quad => &["corners", "emission"],
        Kind::Box => &["low", "high", "inward", "emission"],
        Kind::Sphere => &["center", "radius"],
        Kind::Mesh => &["file"],
    };
    refuse_emission(&fields, kind)?;
    fields.only(&[&COMMON, own].concat())?;
    let bsdf = find(
        materials,
        &fields.need("material", "the name of a material")?,
    )?;
    let transform = transform(&fields)?;
    let geometries = match kind {
        Kind::Quad => vec![Geometry::Quad(quad(&fields, &transform)?)],
        Kind::Box => cuboid(&fields, &transform)?,
        Kind::Sphere => vec![Geometry::Sphere(sphere(&fields, &transform)?)],
        Kind::Mesh => vec![Geometry::Mesh(mesh(&fields, &transform, folder)?)],
    };
    let name = match fields.get("name") {
        Some(name) => name.text("the shape's name")?.to_owned(),
        None => shape.path.clone(),
    };
    let radiance = emission(&fields, bsdf)?;
    let surface = |geometry| Surface {
        shape: name.clone(),
        geometry,
        bsdf,
        radiance,
    };
    Ok(geometries.into_iter().map(surface).collect())
}

/// The file of a shape that is a mesh; `None` for other kinds.
pub(super) fn mesh_file(shape: &Field<'_>, folder: &Path) -> Result<Option<PathBuf>, SceneError> {
    let file = shape.table("a table")?.get("file");
    let path = |file: Field<'_>| Ok(folder.join(file.text("the name of an OBJ file")?));
    file.map(path).transpose()
}

/// Refuses an emission of a sphere or a mesh, which is meant as a lamp, with a message of its own.
fn refuse_emission(fields: &Fields<'_>, kind: Kind) -> Result<(), SceneError> {
    match (kind, fields.get("emission")) {
        (Kind::Sphere | Kind::Mesh, Some(field)) => {
            let found = "an emission on a sphere or a mesh".to_owned();
            Err(field.error(found, "none: only quads and boxes can emit"))
        }
        _ => Ok(()),
    }
}

fn emission(fields: &Fields<'_>, bsdf: Bsdf) -> Result<DVec3, SceneError> {
    let Some(field) = fields.get("emission") else {
        return Ok(DVec3::ZERO);
    };
    if !matches!(bsdf, Bsdf::Diffuse { .. }) {
        let found = "an emission on a mirror or a dielectric".to_owned();
        return Err(field.error(found, "none, or a diffuse material"));
    }
    let possible = |part| (0.0..=MAX_RADIANCE).contains(&part);
    field.three(possible, "a number from 0 to 1e30")
}

fn transform(fields: &Fields<'_>) -> Result<Transform, SceneError> {
    let mut transform = Transform::default();
    let Some(field) = fields.get("transform") else {
        return Ok(transform);
    };
    let fields = field.table("a table of scale, rotate_deg and translate")?;
    fields.only(&["scale", "rotate_deg", "translate"])?;
    if let Some(scale) = fields.get("scale") {
        transform.scale = factors(&scale)?;
    }
    if let Some(angles) = fields.get("rotate_deg") {
        let expected = "a number from -360 to 360";
        transform.rotate_deg = angles.three(|angle| angle.abs() <= 360.0, expected)?;
    }
    if let Some(offset) = fields.get("translate") {
        transform.translate = offset.point()?;
    }
    Ok(transform)
}

/// One factor for all axes, or one for each axis.
fn factors(field: &Field<'_>) -> Result<DVec3, SceneError> {
    let expected = "a number over 0, up to 1e12, or three of them";
    let possible = |factor: f64| factor > 0.0 && factor <= 1e12;
    match field.array(expected) {
        Ok(_) => field.three(possible, expected),
        Err(_) => Ok(DVec3::splat(field.number(possible, expected)?)),
    }
}

fn quad(fields: &Fields<'_>, transform: &Transform) -> Result<Quad, SceneError> {
    let expected = "four corners, counter-clockwise as seen from the front";
    let field = fields.need("corners", expected)?;
    let [a, b, c, d] = field.items(expected)?;
    let corners = [a.point()?, b.point()?, c.point()?, d.point()?];
    let corners = corners.map(transform.of_point());
    Quad::from_corners(corners).ok_or_else(|| {
        let found = corners.map(|corner| corner.to_string()).join(" ");
        field.error(found, "the corners of a parallelogram, in order")
    })
}

/// The faces of a box by the numbers of its corners, whose bits mean: 1 high in x, 2 in y, 4 in z. Their
/// fronts are outside.
const FACES: [[usize; 4]; 6] = [
    [0, 4, 6, 2],
    [1, 3, 7, 5],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 2, 3, 1],
    [4, 5, 7, 6],
];

fn cuboid(fields: &Fields<'_>, transform: &Transform) -> Result<Vec<Geometry>, SceneError> {
    let point = "an array of three numbers";
    let low = fields.need("low", point)?.point()?;
    let high_field = fields.need("high", point)?;
    let high = high_field.point()?;
    let inward = fields.get("inward").map(|field| field.boolean());
    let inward = inward.transpose()?.unwrap_or(false);
    let place = transform.of_point();
    let corner = |number: usize| {
        let axis = |axis: usize| if number >> axis & 1 == 1 { high } else { low }[axis];
        place(DVec3::new(axis(0), axis(1), axis(2)))
    };
    let quad = |mut face: [usize; 4]| {
        if inward {
            face.reverse();
        }
        let quad = Quad::from_corners(face.map(corner)).map(Geometry::Quad);
        quad.filter(|_| low.cmplt(high).all()).ok_or_else(|| {
            high_field.error(
                high.to_string(),
                &format!("clearly more than low, {low}, on every axis"),
            )
        })
    };
    FACES.into_iter().map(quad).collect()
}

fn sphere(fields: &Fields<'_>, transform: &Transform) -> Result<Sphere, SceneError> {
    let centre = fields
        .need("center", "an array of three numbers")?
        .point()?;
    let field = fields.need("radius", "a number over 0, up to 1e12")?;
    let radius = field.length()?;
    let uniform = transform.uniform_scale();
    let sphere =
        uniform.and_then(|scale| Sphere::new(transform.of_point()(centre), scale * radius));
    sphere.ok_or_else(|| {
        let found = format!("a sphere scaled by {}", transform.scale);
        field.error(found, "one factor for all axes: it stays a sphere")
    })
}

fn mesh(fields: &Fields<'_>, transform: &Transform, folder: &Path) -> Result<Mesh, SceneError> {
    let field = fields.need("file", "the name of an OBJ file")?;
    let name = field.text("the name of an OBJ file")?;
    let mesh = obj::load(&folder.join(name), transform);
    mesh.map_err(|mesh| SceneError::Mesh {
        file: fields.source.file.to_owned(),
        line: field.line(),
        place: field.path.clone(),
        mesh: Box::new(mesh),
    })
}
