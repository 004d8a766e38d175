//! Tests that output files are checked before the work: names of the wrong kind, files that are inputs, files
//! that cannot be written.

use std::fs;
use std::path::Path;

use super::{error, photoncube};

/// Each pass takes longer than a test may, so a command that detects its mistake late would not end.
const LONG: [&str; 4] = ["--passes", "1000000", "--size", "512x512"];

/// The contents of files that a command must not change.
const PRECIOUS: &str = "precious";

fn precious(path: &Path) -> String {
    fs::write(path, PRECIOUS).unwrap();
    path.to_str().unwrap().to_owned()
}

#[test]
fn progressive_refuses_plots_of_wrong_names_before_its_work() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let [png, obj, svg] = ["o.png", "pyramid.obj", "map.svg"].map(|name| precious(&at(name)));
    let picture = at("p.png");
    let picture = picture.to_str().unwrap();
    let snapshot = precious(&at("p-0064.exr"));
    let exr = at("p.exr");
    let exr = exr.to_str().unwrap();
    for (outputs, expected) in [
        (
            &["-o", picture, "--plot", &png][..],
            "o.png: found a name that ends in .png, expected .svg",
        ),
        (
            &["-o", picture, "--error-map", &obj],
            "pyramid.obj: found a name that ends in .obj, expected .svg",
        ),
        (&["-o", &png, "--plot", &png], "expected .svg"),
        (
            &["-o", picture, "--plot", &svg, "--error-map", &svg],
            "found the same file as --plot",
        ),
        (&["-o", "/proc/x.png"], "cannot write"),
        (
            &["-o", picture, "--plot", "/proc/x.svg"],
            "--plot /proc/x.svg: cannot write",
        ),
        (
            &["-o", picture, "--plot", "none/of/these/"],
            "without an ending",
        ),
        (
            &["-o", "o"],
            "-o o: found a name without an ending, expected .png or .exr",
        ),
    ] {
        let message = error(
            &[&["progressive", "cornell"][..], outputs, &LONG].concat(),
            2,
        );
        assert!(message.contains(expected), "{outputs:?}: {message}");
    }
    let read = ["--snapshots", "--reference", &snapshot];
    let start = ["progressive", "cornell", "-o", exr];
    let message = error(&[&start[..], &read, &LONG].concat(), 2);
    assert!(message.contains("p-0064.exr, which is read"), "{message}");
    for name in ["o.png", "pyramid.obj", "map.svg", "p-0064.exr"] {
        assert_eq!(fs::read_to_string(at(name)).unwrap(), PRECIOUS, "{name}");
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 4);
}

#[test]
fn compare_writes_no_map_over_what_it_reads_or_into_another_kind() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let [a, b, mesh] = ["a.exr", "b.svg", "mesh.obj"].map(|name| precious(&at(name)));
    let message = error(&["compare", &a, &b, "--error-map", &b], 2);
    assert!(
        message.contains("which is read, expected another file"),
        "{message}"
    );
    let message = error(&["compare", &a, &b, "--error-map", &mesh], 2);
    assert!(message.contains("ends in .obj, expected .svg"), "{message}");
    for path in [a, b, mesh] {
        assert_eq!(fs::read_to_string(path).unwrap(), PRECIOUS);
    }
}

/// Three files or none; a name of another kind is refused before the work, whose length has no end.
#[test]
fn a_waveform_is_written_with_the_files_that_set_up_viewers() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let endless = ["verify", "--against", "text", "--iterations", "1e15"];
    let save = precious(&at("kept.gtkw"));
    let message = error(&[&endless[..], &["--waves", &save]].concat(), 2);
    assert!(
        message.contains("ends in .gtkw, expected .vcd"),
        "{message}"
    );
    let message = error(&["verify", "--case", &save, "--waves", &save], 2);
    assert!(
        message.contains("ends in .gtkw, expected .vcd"),
        "{message}"
    );
    let vcd = at("kept.vcd");
    let vcd = vcd.to_str().unwrap();
    let message = error(&["verify", "--case", &save, "--waves", vcd], 2);
    assert!(
        message.contains("which is read, expected another"),
        "{message}"
    );
    assert_eq!(fs::read_to_string(&save).unwrap(), PRECIOUS);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);

    let short = ["verify", "--against", "text", "--iterations", "5"];
    let vcd = at("w.vcd");
    let vcd = vcd.to_str().unwrap();
    let mut output = photoncube(&[&short[..], &["--waves", vcd, "--waves-clocks", "40"]].concat());
    let output = output.assert().success();
    let text = String::from_utf8_lossy(&output.get_output().stdout).into_owned();
    for name in ["w.vcd", "w.sucl", "w.gtkw"] {
        assert!(text.contains(name), "{text}");
        assert!(fs::metadata(at(name)).unwrap().len() > 100, "{name}");
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 4);
    // The names are those of the other commands too.
    // Without a tool on the PATH: what is wrong with the options is said before a tool is asked for.
    let mut wrong = photoncube(&["verify", "mutants", "9", "--waves", vcd]);
    let wrong = wrong.env("PATH", "").assert().code(2);
    let message = String::from_utf8_lossy(&wrong.get_output().stderr).into_owned();
    assert!(message.contains("found no --mutant"), "{message}");
}

/// The built-in scene as a file.
const CORNELL: &str = include_str!("../../../render/scenes/cornell.json");

#[test]
fn no_command_writes_over_its_scene() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let out = folder.path().to_str().unwrap();
    for (name, args) in [
        ("run.json", &["run", &at("run.json"), "--out", out][..]),
        ("x.png", &["render", &at("x.png"), "-o", &at("x.png")]),
        ("x.png", &["progressive", &at("x.png"), "-o", &at("x.png")]),
    ] {
        fs::write(at(name), CORNELL).unwrap();
        let message = error(args, 2);
        assert!(
            message.contains("which is read, expected another file"),
            "{message}"
        );
        assert_eq!(fs::read_to_string(at(name)).unwrap(), CORNELL);
    }
}

#[test]
fn a_folder_in_the_pictures_place_is_found_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("d.png");
    fs::create_dir(&path).unwrap();
    let render = ["render", "cornell", "-o", path.to_str().unwrap()];
    let endless = ["--photons", "100000000"];
    let message = error(&[&render[..], &endless].concat(), 2);
    assert!(
        message.contains("d.png: found a folder, expected the name of a file"),
        "{message}"
    );
}

#[cfg(unix)]
#[test]
fn a_picture_is_written_through_a_link() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    precious(&at("real.png"));
    std::os::unix::fs::symlink("real.png", at("link.png")).unwrap();
    let small = ["--photons", "1000", "--size", "4x4", "--samples", "1"];
    let render = ["render", "cornell", "-o", "link.png"];
    let mut command = photoncube(&[&render[..], &small].concat());
    command.current_dir(folder.path()).assert().success();
    assert!(at("link.png").is_symlink());
    assert!(fs::read(at("real.png")).unwrap().starts_with(b"\x89PNG"));
}

/// Messages must not name options that the command does not have.
#[test]
fn a_folder_that_cannot_be_made_is_told_by_the_commands_own_option() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    let file = precious(&file);
    let below = format!("{file}/o.png");
    let message = error(&["render", "cornell", "-o", &below], 2);
    assert!(
        message.contains("-o ") && !message.contains("--out"),
        "{message}"
    );
    for command in ["run", "report", "generate", "man"] {
        let message = error(&[command, "--out", &below], 2);
        assert!(message.contains("--out "), "{command}: {message}");
        assert!(
            message.contains("cannot make the folder"),
            "{command}: {message}"
        );
    }
}
