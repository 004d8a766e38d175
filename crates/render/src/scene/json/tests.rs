//! Tests of JSON scene files, legal and illegal.

use serde_json::{Value, json};

use super::*;

fn changed(pointer: &str, value: Value) -> String {
    let mut scene: Value =
        serde_json::from_str(include_str!("../../../scenes/cornell.json")).unwrap();
    *scene.pointer_mut(pointer).expect("a field of the scene") = value;
    scene.to_string()
}

fn message(text: &str) -> String {
    Scene::from_json("my.json", text).unwrap_err().to_string()
}

#[test]
fn errors_name_file_place_found_and_expected() {
    let cases = [
        (
            "/shapes/floor/bsdf/reflectance/value",
            json!([0.5, 1.5, 0.5]),
            "my.json, shapes.floor.bsdf.reflectance.value[1]: found 1.5, expected numbers from 0 to 1",
        ),
        (
            "/shapes/light/emitter/radiance/value",
            json!([-1, 0, 0]),
            "shapes.light.emitter.radiance.value[0]: found -1",
        ),
        (
            "/shapes/light/emitter",
            json!(null),
            "my.json, shapes: found no emitter",
        ),
        (
            "/shapes/back/normal",
            json!([0, 0, -1]),
            "shapes.back.vertices: found normal [0, 0, -1], expected the normal of the corners",
        ),
        (
            "/shapes/back/normal",
            json!([0, 0, 0]),
            "shapes.back.vertices: found normal",
        ),
        (
            "/shapes/back/vertices",
            json!([]),
            "shapes.back.vertices: found corner 0 of 0 vertices",
        ),
        (
            "/shapes/back/vertices/2",
            json!([1, 1, 7]),
            "expected the corners of a parallelogram",
        ),
        (
            "/shapes/small-box/quads_ccw_outward",
            json!([[0, 1, 3, 2]]),
            "shapes.small-box.quads_ccw_outward: found 1 faces",
        ),
        (
            "/shapes/back/kind",
            json!("box"),
            "shapes.back.quads_ccw_outward: found 0 faces",
        ),
        (
            "/shapes/small-box/kind",
            json!("quad"),
            "a quad with quads_ccw_outward",
        ),
        (
            "/shapes/small-box",
            json!({"kind": "quads", "vertices": [], "quads_ccw_outward": [], "bsdf": conductor("none")}),
            "shapes.small-box.quads_ccw_outward: found 0 faces, expected one face or more",
        ),
        (
            "/shapes/light/bsdf",
            conductor("none"),
            "shapes.light: found a mirror with an emitter",
        ),
        (
            "/shapes/floor/bsdf",
            json!({"type": "conductor", "material": "none",
                "specular_reflectance": {"type": "rgb", "value": [1, 2, 1]}}),
            "shapes.floor.bsdf.specular_reflectance.value[1]: found 2",
        ),
        (
            "/shapes/floor/kind",
            json!("sphere"),
            "shapes.floor.bsdf: found a diffuse sphere, expected a conductor or a dielectric",
        ),
        (
            "/shapes/floor",
            json!({"kind": "sphere", "bsdf": glass(1.5), "center": [0, 0, 0]}),
            "shapes.floor: found center Some([0.0, 0.0, 0.0]), radius None and 0 vertices",
        ),
        (
            "/shapes/floor",
            json!({"kind": "sphere", "bsdf": glass(1.5), "center": [0, 0, 0], "radius": -1}),
            "radius Some(-1.0) and 0 vertices, expected a center and a radius over 0",
        ),
        (
            "/shapes/floor",
            json!({"kind": "quad", "bsdf": glass(1.5), "radius": 1}),
            "shapes.floor: found center or radius, expected those of a sphere only",
        ),
        (
            "/shapes/floor/bsdf",
            glass(0.0),
            "shapes.floor.bsdf.int_ior: found 0, expected a number from 0.5 to 10",
        ),
        (
            "/shapes/light/bsdf",
            glass(1.5),
            "shapes.light: found a dielectric with an emitter",
        ),
        (
            "/camera/fov_deg",
            json!(0),
            "my.json, camera: found fov_deg 0",
        ),
    ];
    for (pointer, value, expected) in cases {
        let message = message(&changed(pointer, value));
        assert!(message.contains(expected), "{pointer}: {message}");
    }
}

fn grey() -> Value {
    json!({"type": "rgb", "value": [0.5, 0.5, 0.5]})
}

fn conductor(material: &str) -> Value {
    json!({"type": "conductor", "material": material, "specular_reflectance": grey()})
}

fn glass(ior: f64) -> Value {
    json!({"type": "dielectric", "int_ior": ior, "ext_ior": 1.0})
}

fn two_sided(bsdf: Value) -> Value {
    json!({"type": "twosided", "bsdf": bsdf})
}

#[test]
fn mirrors_have_one_side_or_two() {
    for (bsdf, two_sided) in [
        (conductor("none"), false),
        (two_sided(conductor("none")), true),
    ] {
        let text = changed("/shapes/floor/bsdf", bsdf);
        let scene = Scene::from_json("my.json", &text).unwrap();
        let floor = scene.surfaces().iter().find(|s| s.shape == "floor");
        let expected = Bsdf::Mirror {
            reflectance: DVec3::splat(0.5),
            two_sided,
        };
        assert_eq!(floor.unwrap().bsdf, expected);
    }
}

#[test]
fn spheres_are_of_glass_or_of_metal() {
    for (bsdf, expected) in [
        (glass(1.5), Bsdf::Dielectric { ratio: 1.5 }),
        (
            conductor("none"),
            Bsdf::Mirror {
                reflectance: DVec3::splat(0.5),
                two_sided: false,
            },
        ),
    ] {
        let ball =
            json!({"kind": "sphere", "center": [0.1, 0.2, 0.3], "radius": 0.25, "bsdf": bsdf});
        let scene = Scene::from_json("my.json", &changed("/shapes/floor", ball)).unwrap();
        let floor = scene
            .surfaces()
            .iter()
            .find(|s| s.shape == "floor")
            .unwrap();
        assert_eq!(floor.bsdf, expected);
        let sphere = Sphere::new(DVec3::new(0.1, 0.2, 0.3), 0.25).unwrap();
        assert_eq!(floor.geometry, Geometry::Sphere(sphere));
    }
}

#[test]
fn lights_are_chosen_by_flux_unless_the_file_says_otherwise() {
    let with = |choice: &str| {
        let mut scene: Value = serde_json::from_str(&changed("/name", json!("x"))).unwrap();
        scene["light_choice"] = json!(choice);
        Scene::from_json("my.json", &scene.to_string())
    };
    let cornell = Scene::built_in("cornell").unwrap();
    assert_eq!(cornell.light_choice(), LightChoice::Flux);
    assert_eq!(with("flux").unwrap().light_choice(), LightChoice::Flux);
    assert_eq!(
        with("uniform").unwrap().light_choice(),
        LightChoice::Uniform
    );
    let error = with("brightest").unwrap_err().to_string();
    assert!(error.contains("`flux` or `uniform`"), "{error}");
}

#[test]
fn malformed_files_name_line_and_column() {
    let message = message("{\n \"name\": 3\n}");
    assert!(message.starts_with("my.json, line 2, column "), "{message}");
    assert!(
        !message.contains("at line"),
        "the place stands once: {message}"
    );
    for (pointer, value) in [
        ("/camera/fov_axis", json!("x")),
        ("/shapes/floor/bsdf/type", json!("glass")),
        ("/shapes/floor/kind", json!("cone")),
        (
            "/shapes/floor/bsdf",
            two_sided(json!({"type": "diffuse", "reflectance": grey()})),
        ),
        ("/shapes/floor/bsdf", conductor("Au")),
        ("/shapes/floor", json!({"kind": "quad", "colour": 1})),
    ] {
        let error = Scene::from_json("my.json", &changed(pointer, value)).unwrap_err();
        assert!(
            matches!(error, SceneError::Json { .. }),
            "{pointer}: {error}"
        );
    }
}

#[test]
fn a_name_with_a_slip_is_told_with_the_one_that_was_meant() {
    let kind = changed("/shapes/floor/kind", json!("sphear"));
    let error = Scene::from_json("my.json", &kind).unwrap_err().to_string();
    let expected = "unknown variant `sphear` (did you mean `sphere`?), expected one of `quad`, ";
    assert!(error.contains(expected), "{error}");
    assert_eq!(with_meant("missing field `name`"), "missing field `name`");
}
