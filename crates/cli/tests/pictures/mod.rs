//! Tests pictures that are compared, lit in other ways, and rendered in passes.

use std::fs;
use std::path::{Path, PathBuf};

use super::usage::text;
use super::{error, files_in, json, photoncube};

const SMALL: [&str; 4] = ["--photons", "20000", "--samples", "2"];

/// A picture of the Cornell box, 16 x 16 pixels; its path.
fn rendered(folder: &Path, name: &str, options: &[&str]) -> PathBuf {
    rendered_in(folder, name, "16x16", options)
}

fn rendered_in(folder: &Path, name: &str, size: &str, options: &[&str]) -> PathBuf {
    let path = folder.join(name);
    let render = [
        "render",
        "cornell",
        "-o",
        path.to_str().unwrap(),
        "--size",
        size,
    ];
    json(&[&render[..], &SMALL[..], options].concat());
    path
}

fn compare(a: &Path, b: &Path, options: &[&str]) -> serde_json::Value {
    let files = ["compare", a.to_str().unwrap(), b.to_str().unwrap()];
    json(&[&files[..], options].concat())
}

#[test]
fn a_picture_is_compared_with_another() {
    let folder = tempfile::tempdir().unwrap();
    let f64 = rendered(folder.path(), "f64.exr", &["--engine", "f64"]);
    let format = rendered(folder.path(), "format.exr", &["--engine", "format"]);
    let other = rendered(folder.path(), "other.exr", &["--seed", "2"]);
    let rel_mse = |a, b| compare(a, b, &[])["rel_mse"].as_f64().unwrap();
    assert_eq!(rel_mse(&f64, &f64), 0.0);
    // The format's error is less than a tenth of the noise, which is a hundredth by relMSE. Two seeds differ
    // by twice the noise.
    assert!(rel_mse(&format, &f64) > 0.0);
    assert!(rel_mse(&format, &f64) < rel_mse(&other, &f64) / 100.0);

    let map = folder.path().join("map.svg");
    compare(&other, &f64, &["--error-map", map.to_str().unwrap()]);
    let svg = fs::read_to_string(map).unwrap();
    assert!(
        svg.contains("data:image/png") && svg.contains("left out"),
        "light"
    );
    let names = [&other, &f64].map(|path| path.to_str().unwrap());
    let message = error(&["compare", names[0], names[1], "--max-rel-mse", "1e-9"], 1);
    assert!(message.contains("expected at most 1.000e-9"), "{message}");
}

#[test]
fn pictures_that_cannot_be_compared_are_errors() {
    let folder = tempfile::tempdir().unwrap();
    let a = rendered(folder.path(), "a.exr", &[]);
    let b = rendered_in(folder.path(), "b.exr", "8x8", &[]);
    let png = rendered(folder.path(), "c.png", &[]);
    let name = |path: &Path| path.to_str().unwrap().to_owned();
    let message = error(&["compare", &name(&a), &name(&b)], 2);
    assert!(message.contains("expected (8, 8)"), "{message}");
    let message = error(&["compare", &name(&a), &name(&png)], 2);
    assert!(
        message.contains("c.png") && message.contains("OpenEXR"),
        "{message}"
    );
    let jpg = name(&folder.path().join("d.jpg"));
    let message = error(&["render", "cornell", "-o", &jpg], 2);
    assert!(
        message.contains("ends in .jpg, expected .png or .exr"),
        "{message}"
    );
    assert_eq!(files_in(folder.path()), 3);
}

#[test]
fn light_that_does_not_fit_together_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.png");
    for (options, expected) in [
        (&["--final-gather", "4"][..], "by shadow rays (`rays`)"),
        (
            &["--final-gather", "4", "--direct", "rays"],
            "a map of their own (`own`)",
        ),
        (
            &["--area", "covered", "--estimator", "knn:50"],
            "the estimator knn:50",
        ),
        (&["--direct", "rays:0"], "map or rays[:N]"),
        (&["--caustics", "own:x"], "map or own[:N]"),
    ] {
        let render = ["render", "ring", "-o", path.to_str().unwrap()];
        let message = error(&[&render[..], &SMALL[..], options].concat(), 2);
        assert!(message.contains(expected), "{options:?}: {message}");
    }
    assert_eq!(files_in(folder.path()), 0);
}

#[test]
fn passes_go_on_until_the_error_is_small_enough() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (picture, plot, map) = (at("p.png"), at("plot.svg"), at("map.svg"));
    let start = ["progressive", "cornell", "--size", "16x16"];
    // Other photons, a third of the error, and a smaller radius.
    let (reference, long) = (at("reference.exr"), ["--passes", "100", "--seed", "1000"]);
    let long = [&start[..], &long, &["--engine", "f64", "--in-range", "50"]].concat();
    json(&[&long[..], &["-o", &reference]].concat());
    let start = [&start[..], &["-o", &picture, "--engine", "format"]].concat();
    let files = ["--plot", &plot, "--error-map", &map, "--snapshots"];
    let files = [&files[..], &["--reference", &reference]].concat();
    let target = ["--error-target", "0.05", "--passes", "100"];
    let report = json(&[&start[..], &files, &target].concat());
    let rows = report["progress"].as_array().unwrap();
    let last = rows.last().unwrap();
    assert!(last["error_bound"].as_f64().unwrap() <= 0.05, "{last}");
    assert!(
        (3..100).contains(&last["passes"].as_u64().unwrap()),
        "{last}"
    );
    // 90 % of 256 pixels, with three standard deviations of 1.9 %.
    assert!(last["bounded_share"].as_f64().unwrap() >= 0.84, "{last}");
    let rel_mse = |row: &serde_json::Value| row["rel_mse"].as_f64().unwrap();
    assert!(rel_mse(last) < rel_mse(&rows[0]));
    // The picture is as good as was asked, within a fifth.
    assert!(rel_mse(last).sqrt() < 1.2 * 0.05, "{last}");
    assert!(rows[0]["error_bound"].is_null(), "one pass tells nothing");
    for file in ["p.png", "p-0001.png", "p-0002.png", "plot.svg", "map.svg"] {
        assert!(folder.path().join(file).exists(), "{file}");
    }

    let never = ["--error-target", "1e-6", "--passes", "3"];
    let message = error(&[&start[..], &never].concat(), 1);
    assert!(message.contains("1e-6 is not reached"), "{message}");
    let wrong = ["--alpha", "1", "--passes", "2"];
    let message = error(&[&start[..], &wrong].concat(), 2);
    assert!(message.contains("alpha: found 1, expected"), "{message}");
}

/// A room whose fronts face inwards, seen from outside, as in a user's first scene.
const OUTSIDE: &str = r#"
[camera]
position = [0, 1, 3.8]
target = [0, 1, 0]
fov_deg = 40
[materials.grey]
type = "diffuse"
reflectance = [0.5, 0.5, 0.5]
[[shapes]]
name = "room"
type = "box"
low = [-1, 0, -1]
high = [1, 2, 1]
inward = true
material = "grey"
[[shapes]]
name = "lamp"
type = "quad"
emission = [5, 5, 5]
material = "grey"
corners = [[-0.3, 1.9, -0.3], [0.3, 1.9, -0.3], [0.3, 1.9, 0.3], [-0.3, 1.9, 0.3]]
"#;

#[test]
fn a_camera_that_sees_only_backs_is_refused_with_what_it_sees() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (scene, picture) = (at("mine.toml"), at("o.png"));
    fs::write(&scene, OUTSIDE).unwrap();
    let out = at("out");
    for args in [
        &["render", &scene, "-o", &picture][..],
        &["progressive", &scene, "-o", &picture],
        &["run", &scene, "--out", &out],
        &["fit", &scene],
        &["report", &scene, "--out", &out],
    ] {
        let message = error(args, 2);
        assert!(
            message.contains(
                "no pixel sees a lit surface: the camera at [0, 1, 3.8] sees the back of `room`"
            ),
            "{message}"
        );
    }
    assert_eq!(files_in(folder.path()), 1);
}

/// The wall between hides the lamp from everything that the camera sees.
const DARK: &str = r#"
[[shapes]]
name = "floor"
type = "quad"
material = "grey"
corners = [[9, 0, 1], [11, 0, 1], [11, 0, -1], [9, 0, -1]]
"#;

#[test]
fn a_picture_without_light_is_refused_with_what_the_camera_sees() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (scene, picture) = (at("dark.toml"), at("o.png"));
    let aside = OUTSIDE.replace("[0, 1, 3.8]", "[10, 2, 0.1]");
    let aside = aside.replace("target = [0, 1, 0]", "target = [10, 0, 0]");
    fs::write(&scene, aside + DARK).unwrap();
    let small = ["--photons", "1000", "--size", "8x8"];
    for command in [&["render"][..], &["progressive", "--passes", "2"]] {
        let args = [command, &[&scene, "-o", &picture], &small].concat();
        let message = error(&args, 2);
        let expected = "no light reaches what the camera sees: ";
        assert!(
            message.contains(expected) && message.contains("the front of `floor`"),
            "{message}"
        );
    }
    assert_eq!(files_in(folder.path()), 1);
}

#[cfg(unix)]
#[test]
fn an_interrupted_picture_is_the_mean_of_its_passes() {
    use std::process::{Command, Stdio};
    let folder = tempfile::tempdir().unwrap();
    let endless = [
        "--passes",
        "100000000",
        "--photons",
        "1000",
        "--size",
        "8x8",
    ];
    let child = Command::new(env!("CARGO_BIN_EXE_photoncube"))
        .args([
            "progressive",
            "cornell",
            "-o",
            "p.exr",
            "--snapshots",
            "--state",
            "p.state",
            "--json",
        ])
        .args(endless)
        .current_dir(folder.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // After the second pass the command is in the middle of its work.
    while !folder.path().join("p-0002.exr").exists() {
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    let kill = ["-TERM", &child.id().to_string()].map(ToOwned::to_owned);
    assert!(Command::new("kill").args(kill).status().unwrap().success());
    let ended = child.wait_with_output().unwrap();
    assert_eq!(ended.status.code(), Some(1));
    let report: serde_json::Value = serde_json::from_slice(&ended.stdout).unwrap();
    assert_eq!(report["interrupted"], true);
    let passes = report["progress"].as_array().unwrap().last().unwrap()["passes"].as_u64();
    let said = String::from_utf8(ended.stderr).unwrap();
    let expected = format!(
        "interrupted after {} of 100000000 passes; p.exr is their mean; the same command with --resume",
        passes.unwrap()
    );
    assert!(said.contains(&expected), "{said}");
    assert!(folder.path().join("p.exr").is_file());
    let kept = fs::read(folder.path().join("p.state")).unwrap();
    assert!(kept.starts_with(b"{\"photoncube\":\"progressive\","));
}

/// Runs that end after some passes and go on, with an engine of floats and one of integers, against one run.
#[test]
fn a_resumed_picture_is_byte_for_byte_that_of_one_run() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    for engine in ["f64", "format"] {
        let run = |picture: &str, more: &[&str]| {
            let small = ["--size", "12x12", "--photons", "1000", "--engine", engine];
            let start = ["progressive", "ring", "-o", picture];
            let mut report = json(&[&start[..], &small, more].concat());
            for row in report["progress"].as_array_mut().unwrap() {
                row.as_object_mut().unwrap().remove("seconds");
            }
            report
        };
        let (whole, parts, state) = (at("whole.exr"), at("parts.exr"), at("state"));
        let whole_report = run(&whole, &["--passes", "5"]);
        run(&parts, &["--passes", "3", "--state", &state]);
        let go_on = ["--state", &state, "--resume", "--passes", "5"];
        let parts_report = run(&parts, &go_on);
        assert_eq!(fs::read(&parts).unwrap(), fs::read(&whole).unwrap());
        for key in ["progress", "photon_tests", "query_points"] {
            assert_eq!(parts_report[key], whole_report[key], "{key}");
        }
        assert_eq!(parts_report["resumed_passes"], 3);
        // There is nothing left to do, and the picture is written again.
        fs::remove_file(&parts).unwrap();
        assert_eq!(run(&parts, &go_on)["progress"], whole_report["progress"]);
        assert_eq!(fs::read(&parts).unwrap(), fs::read(&whole).unwrap());
        fs::remove_file(state).unwrap();
    }
}

#[test]
fn a_state_that_cannot_be_continued_is_refused_and_stays() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (picture, state, foreign) = (at("p.png"), at("state"), at("foreign"));
    let start = ["--size", "8x8", "--photons", "500", "--engine", "f64"];
    let start = [&["progressive", "cornell", "-o", &picture], &start[..]].concat();
    let with = |more: &[&'static str]| [&start[..], more].concat();
    let kept = with(&["--passes", "3"]);
    let kept = [&kept[..], &["--state", &state]].concat();
    photoncube(&kept).assert().success();
    let before = fs::read(&state).unwrap();
    fs::write(&foreign, "# a listing\n").unwrap();
    let resume = |words: &[&str], state: &str| {
        let go_on = ["--resume", "--state", state].map(ToOwned::to_owned);
        let words = words.iter().map(|word| (*word).to_owned()).chain(go_on);
        words.collect::<Vec<_>>()
    };
    let of_light = with(&["--direct", "rays:2", "--seed", "7"]);
    let of_scene: Vec<_> = start
        .iter()
        .map(|word| word.replace("cornell", "ring"))
        .collect();
    let of_scene: Vec<_> = of_scene.iter().map(String::as_str).collect();
    for (words, expected) in [
        (
            kept.iter().map(|word| (*word).to_owned()).collect(),
            "found a file, expected none without --resume",
        ),
        (
            resume(&of_light, &state),
            "--direct: found rays:1, expected rays:2; --seed: found 1, expected 7; give the options",
        ),
        (resume(&of_scene, &state), "scene, its SHA-256: found "),
        (
            resume(&with(&["--passes", "2"]), &state),
            "found 3 passes, expected at most --passes 2",
        ),
        (
            resume(&start, &foreign),
            "begins with \"# a listing\", expected a state file of photoncube",
        ),
        (
            resume(&start, &at("none")),
            "leave out --resume to begin a new picture: No such file",
        ),
        (
            resume(&start, folder.path().to_str().unwrap()),
            "found a folder",
        ),
    ] {
        let words: Vec<_> = words.iter().map(String::as_str).collect();
        let message = error(&words, 2);
        assert!(message.contains(expected), "{words:?}: {message}");
    }
    assert!(error(&with(&["--resume"]), 2).contains("--state"));
    assert_eq!(fs::read(&state).unwrap(), before);
}

/// Powers of two million to one do not fit the 16 bits of `paper`; an exponent holds them.
#[test]
fn photons_that_lose_their_power_are_told() {
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("x.png");
    let picture = picture.to_str().unwrap();
    let small = ["--size", "8x8", "--samples", "1", "--photons", "5000"];
    let render = ["render", "range", "-o", picture, "--machine"];
    let of = |machine| [&render[..], &[machine], &small].concat();
    let lost = json(&of("paper"))["photons_without_power"]
        .as_u64()
        .unwrap();
    assert!(lost > 1000, "{lost}");
    let said = text(&of("paper"));
    assert!(said.contains("photons give no light"), "{said}");
    assert_eq!(json(&of("local"))["photons_without_power"], 0);
    assert!(!text(&of("local")).contains("no light"));
}
