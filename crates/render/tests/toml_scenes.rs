//! Tests the examples of the scene format, docs/scenes/*.toml: each is read and rendered, and the description
//! names each.

#[path = "../examples/knot_mesh.rs"]
mod knot_mesh;

use std::fs;
use std::path::{Path, PathBuf};

use glam::DVec3;
use photoncube_render::{
    Bsdf, Engine, Geometry, PhotonMap, Rendering, Scene, TraceOptions, ViewOptions, render, trace,
};
use photoncube_spec::find_photon_format;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/scenes")
}

fn examples() -> Vec<PathBuf> {
    let entries = fs::read_dir(folder())
        .unwrap()
        .map(|entry| entry.unwrap().path());
    let mut files: Vec<_> = entries
        .filter(|file| file.extension().is_some_and(|e| e == "toml"))
        .collect();
    files.sort();
    files
}

fn scene(name: &str) -> Scene {
    Scene::from_file(&folder().join(name)).unwrap()
}

/// A command must not overwrite the files of its scene.
#[test]
fn a_scene_knows_the_files_that_it_was_read_from() {
    let files = |name: &str| scene(name).files().to_vec();
    let knots = files("knots.toml");
    assert!(knots.contains(&folder().join("knots.toml")), "{knots:?}");
    assert!(knots.contains(&folder().join("knot.obj")), "{knots:?}");
    assert_eq!(files("boxes.toml"), [folder().join("boxes.toml")]);
    assert_eq!(files("spheres.json"), [folder().join("spheres.json")]);
    assert!(Scene::built_in("cornell").unwrap().files().is_empty());
}

fn rendered(scene: &Scene, photons: u64, engine: Engine) -> Rendering {
    let options = TraceOptions { photons, seed: 1 };
    let photons = trace(scene, &options, &|_| ()).unwrap().photons;
    let radius = PhotonMap::radius_for(scene, photons.len() as u64, 100.0);
    let map = PhotonMap::new(scene, photons, radius).unwrap();
    let view = ViewOptions {
        width: 32,
        height: 32,
        samples_per_axis: 1,
        seed: 1,
    };
    render(scene, &map, engine, &view, &|_| ()).unwrap()
}

#[test]
fn every_example_renders_by_both_engines() {
    let format = find_photon_format("local8-rgb8e5").unwrap();
    assert!(examples().len() >= 7);
    for file in examples() {
        let scene = Scene::from_file(&file).unwrap();
        assert_eq!(
            scene.name(),
            file.file_stem().unwrap(),
            "{}",
            file.display()
        );
        let by_f64 = rendered(&scene, 20_000, Engine::F64);
        let by_format = rendered(&scene, 20_000, Engine::from(&format));
        let sum = |r: &Rendering| {
            r.image
                .pixels()
                .iter()
                .map(|p| p.element_sum())
                .sum::<f64>()
        };
        let lit = by_f64
            .image
            .pixels()
            .iter()
            .filter(|p| p.element_sum() > 0.0);
        assert!(lit.count() > 32 * 32 / 2, "{}", file.display());
        // The default format's bias is far below a percent.
        let ratio = sum(&by_format) / sum(&by_f64);
        assert!((ratio - 1.0).abs() < 0.01, "{}: {ratio}", file.display());
    }
}

#[test]
fn the_description_has_every_example() {
    let text = fs::read_to_string(folder().join("../scenes.md")).unwrap();
    for file in examples() {
        let name = file.file_name().unwrap().to_string_lossy();
        assert!(text.contains(&format!("scenes/{name}")), "{name}");
    }
}

#[test]
fn the_knot_is_what_its_generator_writes() {
    let file = fs::read_to_string(folder().join("knot.obj")).unwrap();
    let expected = knot_mesh::text(knot_mesh::ALONG, knot_mesh::AROUND);
    assert!(file == expected, "see examples/knot_mesh.rs");
    let knots = scene("knots.toml");
    for surface in knots.surfaces() {
        if let Geometry::Mesh(mesh) = &surface.geometry {
            assert_eq!(mesh.triangles(), 2 * knot_mesh::ALONG * knot_mesh::AROUND);
            // The divergence theorem: fronts outside enclose a volume over 0.
            let volume = |[a, b, c]: [DVec3; 3]| a.dot(b.cross(c)) / 6.0;
            let volume: f64 = (0..mesh.triangles()).map(|i| volume(mesh.corners(i))).sum();
            assert!(volume > 0.0, "{volume}");
        }
    }
}

/// The scene in TOML and in JSON: all surfaces are equal, up to the single precision of the JSON.
#[test]
fn the_spheres_are_those_of_the_json() {
    let [toml, json] = ["spheres.toml", "spheres.json"].map(scene);
    assert_eq!(toml.surfaces().len(), json.surfaces().len());
    for (ours, theirs) in toml.surfaces().iter().zip(json.surfaces()) {
        assert_eq!(ours.shape, theirs.shape);
        assert_eq!((ours.bsdf, ours.radiance), (theirs.bsdf, theirs.radiance));
        let [a, b] = [ours, theirs].map(|s| s.geometry.bounds());
        assert!(a[0].distance(b[0]) < 1e-6 && a[1].distance(b[1]) < 1e-6);
        let normals = [ours, theirs].map(|s| s.geometry.flat_normal());
        if let [Some(a), Some(b)] = normals {
            assert!(a.distance(b) < 1e-6, "{}", ours.shape);
        }
    }
    let [a, b] = [&toml, &json].map(|scene| scene.camera().ray(3.0, 5.0, 64, 64));
    assert!(a.origin.distance(b.origin) < 1e-6 && a.direction.distance(b.direction) < 1e-6);
}

#[test]
fn boxes_face_outwards_or_inwards() {
    let boxes = scene("boxes.toml");
    for name in ["room", "tall", "tilted"] {
        let faces: Vec<_> = boxes
            .surfaces()
            .iter()
            .filter(|s| s.shape == name)
            .collect();
        assert_eq!(faces.len(), 6);
        let middle = |[low, high]: [DVec3; 2]| low.midpoint(high);
        let centre = faces
            .iter()
            .map(|s| middle(s.geometry.bounds()))
            .sum::<DVec3>()
            / 6.0;
        for face in faces {
            let out = middle(face.geometry.bounds()) - centre;
            let normal = face.geometry.flat_normal().unwrap();
            assert_eq!(out.dot(normal) > 0.0, name != "room", "{name}");
            assert!(out.normalize().dot(normal).abs() > 0.999, "{name}");
        }
    }
}

#[test]
fn materials_and_lights_are_as_written() {
    let bsdf = |scene: &Scene, name: &str| {
        let surface = scene.surfaces().iter().find(|s| s.shape == name);
        surface.unwrap().bsdf
    };
    let mirrors = scene("mirrors.toml");
    let two_sided = |name| match bsdf(&mirrors, name) {
        Bsdf::Mirror { two_sided, .. } => two_sided,
        other => panic!("{name}: {other:?}"),
    };
    assert!(!two_sided("block") && two_sided("sheet"));
    let knots = scene("knots.toml");
    assert_eq!(bsdf(&knots, "glass-knot"), Bsdf::Dielectric { ratio: 1.5 });
    let lights = scene("lights.toml");
    let emitting = lights
        .surfaces()
        .iter()
        .filter(|s| s.radiance != DVec3::ZERO);
    assert_eq!(emitting.count(), 7);
}
