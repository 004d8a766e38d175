use std::path::Path;

use glam::DVec3;
use proptest::prelude::*;

use super::super::{Scene, SceneError};

/// A scene of two shapes; line 1 is `[camera]`.
const SCENE: &str = "[camera]
position = [0, 0, 3]
target = [0, 0, 0]
fov_deg = 40

[materials.white]
type = \"diffuse\"
reflectance = [0.5, 0.5, 0.5]

[materials.glass]
type = \"dielectric\"
ior = 1.5

[[shapes]]
type = \"quad\"
corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
material = \"white\"
emission = [1, 1, 1]

[[shapes]]
type = \"sphere\"
center = [0, 0, 0]
radius = 1
material = \"white\"
";

fn read(text: &str) -> Result<Scene, SceneError> {
    Scene::from_toml("my.toml", text, Path::new(env!("CARGO_MANIFEST_DIR")))
}

/// The error of the scene with `from` replaced by `to`.
fn message(from: &str, to: &str) -> String {
    assert!(SCENE.contains(from), "{from}");
    read(&SCENE.replacen(from, to, 1)).unwrap_err().to_string()
}

#[test]
fn the_scene_is_read() {
    let scene = read(SCENE).unwrap();
    assert_eq!(scene.name(), "my");
    assert_eq!(scene.surfaces().len(), 2);
    assert_eq!(scene.surfaces()[1].shape, "shapes[1]");
}

#[test]
fn errors_name_file_line_field_found_and_expected() {
    for (from, to, expected) in [
        (
            "position = [0, 0, 3]\n",
            "",
            "my.toml, line 1, camera.position: found nothing, expected an array of three numbers",
        ),
        (
            "[0, 0, 3]",
            "[0, 3]",
            "my.toml, line 2, camera.position: found an array of 2, expected an array of three numbers",
        ),
        (
            "[0, 0, 3]",
            "[0, \"0\", 3]",
            "my.toml, line 2, camera.position[1]: found \"0\", expected a number from -1e12 to 1e12",
        ),
        ("[0, 0, 3]", "[0, nan, 3]", "camera.position[1]: found nan"),
        ("[0, 0, 3]", "[0, 0, inf]", "camera.position[2]: found inf"),
        (
            "[0, 0, 3]",
            "[0, 0, 0]",
            "my.toml, line 3, camera.target: found [0, 0, 0], expected a place apart from the position",
        ),
        (
            "fov_deg = 40",
            "fov_deg = 180",
            "my.toml, line 4, camera.fov_deg: found 180, expected an angle over 0 and below 180",
        ),
        (
            "fov_deg = 40",
            "fov_deg = 40\nfov_axis = \"up\"",
            "my.toml, line 5, camera.fov_axis: found \"up\", expected `smaller`, `larger`, `x`, `y`",
        ),
        (
            "fov_deg = 40",
            "fov = 40",
            "my.toml, line 4, camera.fov: found a field of no meaning here, expected one of position, target, up, fov_deg, fov_axis",
        ),
        (
            "\"diffuse\"",
            "\"matte\"",
            "my.toml, line 7, materials.white.type: found \"matte\", expected `diffuse`, `mirror`, `dielectric`",
        ),
        (
            "reflectance =",
            "reflectence =",
            "materials.white.reflectence: found a field of no meaning here (did you mean `reflectance`?), expected",
        ),
        (
            "material = \"white\"",
            "material = \"whit\"",
            "shapes[0].material: found \"whit\" (did you mean `white`?), expected `glass`, `white`",
        ),
        (
            "0.5, 0.5, 0.5",
            "0.5, 1.5, 0.5",
            "my.toml, line 8, materials.white.reflectance[1]: found 1.5, expected a number from 0 to 1",
        ),
        (
            "ior = 1.5",
            "ior = 0",
            "my.toml, line 12, materials.glass.ior: found 0, expected a number from 0.5 to 10",
        ),
        (
            "ior = 1.5",
            "",
            "my.toml, line 10, materials.glass.ior: found nothing",
        ),
        (
            "ior = 1.5",
            "ior = 1.5\nreflectance = [1, 1, 1]",
            "my.toml, line 13, materials.glass.reflectance: found a field of no meaning here, expected one of type, ior, outside_ior",
        ),
        (
            "type = \"quad\"\n",
            "",
            "my.toml, line 14, shapes[0].type: found nothing, expected `quad`, `box`, `sphere` or `mesh`",
        ),
        (
            "[1, 1, 0], [0, 1, 0]]",
            "[1, 2, 0], [0, 1, 0]]",
            "my.toml, line 16, shapes[0].corners: found [0, 0, 0] [1, 0, 0] [1, 2, 0] [0, 1, 0], expected the corners of a parallelogram, in order",
        ),
        (
            "[1, 1, 0], [0, 1, 0]]",
            "[1, 1, 0]]",
            "shapes[0].corners: found an array of 3, expected four corners",
        ),
        (
            "[1, 1, 0], [0, 1, 0]]",
            "[1, 1], [0, 1, 0]]",
            "shapes[0].corners[2]: found an array of 2",
        ),
        (
            "material = \"white\"",
            "material = \"wood\"",
            "my.toml, line 17, shapes[0].material: found \"wood\", expected `glass`, `white`",
        ),
        (
            "material = \"white\"",
            "material = \"glass\"",
            "my.toml, line 18, shapes[0].emission: found an emission on a mirror or a dielectric",
        ),
        (
            "emission = [1, 1, 1]",
            "emission = [1, -1, 1]",
            "my.toml, line 18, shapes[0].emission[1]: found -1, expected a number from 0 to 1e30",
        ),
        (
            "emission = [1, 1, 1]",
            "emission = [0, 0, 0]",
            "shapes: found no light, expected at least one quad or box with an emission over 0",
        ),
        (
            "radius = 1",
            "radius = -1",
            "my.toml, line 23, shapes[1].radius: found -1, expected a number over 0",
        ),
        (
            "radius = 1",
            "radius = 1\nemission = [1, 1, 1]",
            "my.toml, line 24, shapes[1].emission: found an emission on a sphere or a mesh, expected none: only quads and boxes can emit",
        ),
        (
            "radius = 1",
            "radius = 1\ncorners = []",
            "my.toml, line 24, shapes[1].corners: found a field of no meaning here, expected one of type, name, material, transform, center, radius",
        ),
        (
            "radius = 1",
            "radius = 1\ntransform = { scale = [1, 2, 1] }",
            "my.toml, line 23, shapes[1].radius: found a sphere scaled by [1, 2, 1], expected one factor",
        ),
        (
            "radius = 1",
            "radius = 1\ntransform = { scale = 0 }",
            "my.toml, line 24, shapes[1].transform.scale: found 0, expected a number over 0",
        ),
        (
            "radius = 1",
            "radius = 1\ntransform = { scale = [1, 1, -1] }",
            "my.toml, line 24, shapes[1].transform.scale[2]: found -1",
        ),
        (
            "radius = 1",
            "radius = 1\ntransform = { turn = 1 }",
            "shapes[1].transform.turn: found a field of no meaning here, expected one of scale, rotate_deg, translate",
        ),
        (
            "radius = 1",
            "radius = 1\ntransform = 1",
            "shapes[1].transform: found 1, expected a table of scale",
        ),
        (
            "[camera]",
            "light_choice = \"best\"\n[camera]",
            "my.toml, line 1, light_choice: found \"best\", expected `flux`, `uniform`",
        ),
        (
            "[camera]",
            "title = \"x\"\n[camera]",
            "my.toml, line 1, title: found a field of no meaning here, expected one of name, light_choice",
        ),
    ] {
        let message = message(from, to);
        assert!(message.starts_with("my.toml, line "), "{message}");
        assert!(
            message.contains(expected),
            "{from} -> {to}:\n{message}\n{expected}"
        );
    }
}

#[test]
fn what_is_no_toml_names_line_and_column() {
    let text = message("fov_deg = 40", "fov_deg = = 40");
    assert!(text.starts_with("my.toml, line 4, column 11: "), "{text}");
    let text = message("fov_deg = 40", "fov_deg = 40\nfov_deg = 41");
    assert!(
        text.starts_with("my.toml, line 5, column 1: ") && text.contains("duplicate"),
        "{text}"
    );
    for text in ["", "shapes = 1", "[camera]\n[camera]", "\u{0}"] {
        assert!(read(text).is_err());
    }
}

/// Input 948055 of the fuzzer with seed 1, which overflowed the stack.
#[test]
fn brackets_without_end_are_refused_where_they_are_too_deep() {
    for deep in ["a = {[0.5]\n", "a = [", "a = {b = ", "[["] {
        let error = read(&deep.repeat(100_000)).unwrap_err().to_string();
        assert!(
            error.contains("line ") && error.contains("64 brackets"),
            "{error}"
        );
    }
    let closed = format!("a = [{}]\n", "[1], ".repeat(1_000));
    let error = read(&closed).unwrap_err().to_string();
    assert!(!error.contains("brackets are open"), "{error}");
}

#[test]
fn boxes_must_have_room() {
    let shape =
        "[[shapes]]\ntype = \"box\"\nlow = [0, 0, 0]\nhigh = [1, 1, 0]\nmaterial = \"white\"\n";
    let text = format!("{SCENE}\n{shape}");
    let error = read(&text).unwrap_err().to_string();
    let expected = "my.toml, line 29, shapes[2].high: found [1, 1, 0], expected clearly more than low, [0, 0, 0]";
    assert!(error.starts_with(expected), "{error}");
}

#[test]
fn numbers_may_be_written_as_toml_allows() {
    let scene = read(&SCENE.replace("radius = 1", "radius = +1_0.5e-1")).unwrap();
    let [low, high] = scene.surfaces()[1].geometry.bounds();
    assert_eq!((low, high), (DVec3::splat(-1.05), DVec3::splat(1.05)));
}

proptest! {
    /// A text with one byte changed is read or refused with a line, without a panic.
    #[test]
    fn spoilt_text_is_refused_with_a_line(at in 0..SCENE.len(), byte in 32..127_u8) {
        let mut bytes = SCENE.as_bytes().to_vec();
        bytes[at] = byte;
        let text = String::from_utf8(bytes).unwrap();
        if let Err(error) = read(&text) {
            prop_assert!(error.to_string().starts_with("my.toml, line "), "{error}");
        }
    }
}
