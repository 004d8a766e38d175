//! Tests scene files on the command line.

use std::fs;

use super::{error, files_in, json};

/// Every command reads scene files, and names file, line and field of an error.
#[test]
fn scenes_in_toml_are_rendered_or_refused() {
    let folder = tempfile::tempdir().unwrap();
    let examples = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/scenes");
    let out = folder.path().to_str().unwrap();
    let picture = folder.path().join("knots.png");
    let picture = picture.to_str().unwrap();
    let few = ["--photons", "5000", "--size", "16x16", "--engine", "f64"];
    let knots = format!("{examples}/knots.toml");
    let knots = [&["render", &knots, "-o", picture], &few[..]].concat();
    let report = json(&knots);
    assert!(report["photons"].as_u64().unwrap() >= 5000);
    fs::remove_file(picture).unwrap();

    let text = fs::read_to_string(format!("{examples}/knots.toml")).unwrap();
    let scene = folder.path().join("my.toml");
    let mesh = folder.path().join("knot.obj");
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 1 3 4\n";
    for (from, to, obj, expected) in [
        (
            "[0.25, 0.6, 0.4]",
            "[0.25, 6, 0.4]",
            square,
            "my.toml, line 15, materials.jade.reflectance[1]: found 6, expected a number from 0 to 1",
        ),
        (
            "file =",
            "path =",
            square,
            "my.toml, line 33, shapes[1].path: found a field of no meaning here, expected one of type, name, material, transform, file",
        ),
        ("", "", square, "my.toml, line 33, shapes[1].file: "),
        (
            "",
            "",
            square,
            "knot.obj, line 5: found \"f 1 3 4\", expected indices from 1 to 3",
        ),
        (
            "\"knot.obj\"",
            "\"none.obj\"",
            square,
            "none.obj: No such file",
        ),
    ] {
        fs::write(&scene, text.replacen(from, to, 1)).unwrap();
        fs::write(&mesh, obj).unwrap();
        for command in ["render", "fit", "report", "run"] {
            let mut args = vec![command, scene.to_str().unwrap()];
            match command {
                "render" => args.extend(["-o", picture]),
                "fit" => (),
                _ => args.extend(["--out", out]),
            }
            let message = error(&args, 2);
            assert!(message.contains(expected), "{command}: {message}");
        }
        assert_eq!(files_in(folder.path()), 2, "something was left behind");
    }
}
