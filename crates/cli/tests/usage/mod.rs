//! Tests correct and wrong options and names.

use std::fs;

use super::{error, files_in, json, photoncube};

/// Options that no method and no engine uses are refused; a unit test of the arguments covers every pair.
#[test]
fn an_option_that_is_not_used_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("x.png");
    let picture = picture.to_str().unwrap();
    let render = ["render", "cornell", "-o", picture];
    for (args, expected) in [
        (
            &["verify", "lint", "--against", "icarus"][..],
            "unexpected argument '--against' found",
        ),
        (
            &["verify", "table", "--iterations", "7"],
            "unexpected argument '--iterations' found",
        ),
        (
            &["verify", "--lint", "--against", "icarus"],
            "unexpected argument '--against' found",
        ),
        (
            &["verify", "--machine", "stream", "lint"],
            "unexpected argument 'lint' found",
        ),
        (
            &[&render[..], &["--format", "local8-rgb8e5"]].concat(),
            "--format is for `render --engine format`",
        ),
        (
            &[&render[..], &["--engine", "f64", "--machine", "paper"]].concat(),
            "--machine is for `render --engine model`",
        ),
        (&["man", "--json"], "`man` has no JSON form"),
        (
            &["completions", "bash", "--json"],
            "`completions` has no JSON form",
        ),
    ] {
        let message = error(args, 2);
        assert!(message.contains(expected), "{args:?}: {message}");
    }
    assert_eq!(files_in(folder.path()), 0);
}

#[test]
fn a_negative_number_is_a_value_that_is_refused_with_the_range() {
    for (args, expected) in [
        (
            &["run", "--photons", "-5"][..],
            "expected a whole number from 1 to 134217728",
        ),
        (
            &["report", "--seed", "-1"],
            "expected a whole number from 0 to",
        ),
        (&["fit", "--noise-ratio", "-1"], "expected a number above 0"),
        (&["fit", "--size", "-16x16"], "expected WxH"),
        (
            &["verify", "--iterations", "-1e3"],
            "expected a whole number from 1;",
        ),
        (
            &["verify", "coverage", "--iterations", "-5"],
            "expected a whole number from 1;",
        ),
    ] {
        let message = error(args, 2);
        assert!(message.contains(expected), "{args:?}: {message}");
        assert!(
            !message.contains("unexpected argument"),
            "{args:?}: {message}"
        );
    }
}

#[test]
fn counts_are_read_in_short_forms() {
    let report = json(&["verify", "--iterations", "2e1"]);
    assert_eq!(report["iterations"], 20);
    let report = json(&["verify", "--iterations", "0.02k"]);
    assert_eq!(report["iterations"], 20);
}

#[test]
fn a_name_with_a_slip_is_told_with_the_one_that_was_meant() {
    for (args, meant) in [
        (&["list", "Paper"][..], "paper"),
        (&["microprogram", "--machine", "papper"], "paper"),
        (&["fit", "cornel"], "cornell"),
        (&["verify", "--against", "verilatr"], "verilator"),
        (&["verify", "fuzz", "1", "--reader", "lsting"], "listing"),
        (
            &["hard-cases", "--format", "local8-rbg8e5"],
            "local8-rgb8e5",
        ),
    ] {
        let message = error(args, 2);
        let expected = format!("(did you mean `{meant}`?)");
        assert!(message.contains(&expected), "{args:?}: {message}");
    }
    for (slip, meant) in [("rnu", "run"), ("rendr", "render"), ("reprot", "report")] {
        let message = error(&[slip], 2);
        assert!(message.contains(&format!("'{meant}'")), "{slip}: {message}");
    }
    let message = error(&["run", "--scene", "cornell"], 2);
    assert!(message.contains("a scene needs no option"), "{message}");
    let message = error(&["generate", "--scene", "cornell"], 2);
    assert!(!message.contains("a scene needs no option"), "{message}");
}

#[test]
fn what_microprogram_prints_is_a_listing() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("own.txt");
    for machine in ["paper", "paper-5d"] {
        let printed = photoncube(&["microprogram", "--machine", machine]).assert();
        fs::write(&path, &printed.success().get_output().stdout).unwrap();
        let file = ["microprogram", "--machine", machine, "--file"];
        let report = json(&[&file[..], &[path.to_str().unwrap()]].concat());
        let own = json(&["microprogram", "--machine", machine]);
        assert_eq!(report["accepted"], true, "{machine}");
        assert_eq!(report["listing"], own["listing"], "{machine}");
    }
}

/// The message of an error has each cause once, without the names of temporary files.
#[test]
fn a_message_says_each_cause_once() {
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join("folder.toml");
    fs::create_dir(&scene).unwrap();
    let message = error(&["fit", scene.to_str().unwrap()], 2);
    assert!(
        message.ends_with("folder.toml: found a folder, expected a file\n"),
        "{message}"
    );
    let picture = folder.path().join("x.exr");
    fs::create_dir(&picture).unwrap();
    let small = ["--photons", "500", "--size", "4x4", "--engine", "f64"];
    let render = ["render", "cornell", "-o", picture.to_str().unwrap()];
    let message = error(&[&render[..], &small].concat(), 2);
    assert!(
        message.ends_with("x.exr: found a folder, expected the name of a file\n"),
        "{message}"
    );
}

/// File names are bytes and need not be UTF-8.
#[cfg(unix)]
#[test]
fn paths_need_not_be_utf_8() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;

    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join(OsStr::from_bytes(b"sc\xe9ne.toml"));
    let picture = folder.path().join(OsStr::from_bytes(b"b\xffild.png"));
    let example = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/scenes/room.toml");
    fs::copy(example, &scene).unwrap();
    let small = [
        "--photons",
        "500",
        "--size",
        "4x4",
        "--engine",
        "f64",
        "--json",
    ];
    let mut render = photoncube(&["render"]);
    let output = render.arg(&scene).arg("-o").arg(&picture).args(small);
    let output = output.assert().success();
    let report: serde_json::Value = serde_json::from_slice(&output.get_output().stdout).unwrap();
    assert!(
        report["scene"].as_str().unwrap().ends_with("ne.toml"),
        "{report}"
    );
    assert!(picture.is_file());
    assert_eq!(files_in(folder.path()), 2);
}

pub fn text(args: &[&str]) -> String {
    let output = photoncube(args).assert().success();
    String::from_utf8(output.get_output().stdout.clone()).unwrap()
}

/// The first line that is wider than a terminal. A command between backquotes is not broken, so its line may be longer.
pub fn too_wide(text: &str) -> Option<&str> {
    let mut lines = text.lines();
    lines.find(|line| line.chars().count() > 100 && !line.contains('`'))
}

#[test]
fn printed_lines_fit_a_terminal_unless_all_of_a_table_is_asked_for() {
    let core = ["list", "core-6-leaf-7-local7-rgb6d-n4096"];
    let hdl_out = concat!(env!("CARGO_MANIFEST_DIR"), "/../../hdl-out");
    let plan = ["plan", "cornell", "--size", "16x16", "--photons", "2000"];
    for words in [
        &["list"][..],
        &["list", "paper"],
        &core,
        &["microprogram"],
        &["microprogram", "--machine", "overlap"],
        &["microprogram", "--machine", "tile-6"],
        &["hard-cases", "--format", "local7-rgb6d"],
        &plan,
        &[
            "generate",
            "--check",
            "--machine",
            "paper",
            "--out",
            hdl_out,
        ],
        &["verify", "table"],
        &["verify", "--against", "text", "--iterations", "10"],
    ] {
        assert_eq!(too_wide(&text(words)), None, "{words:?}");
    }
    for words in [&["list"][..], &core, &["verify", "table"]] {
        let wide = text(&[words, &["--wide"]].concat());
        assert!(too_wide(&wide).is_some(), "{words:?}");
    }
}

#[test]
fn a_listing_is_refused_for_a_machine_that_runs_none() {
    let message = error(
        &["microprogram", "--machine", "stream", "--file", "own.txt"],
        2,
    );
    assert!(
        message.contains("`stream` runs no microprogram, expected one of paper"),
        "{message}"
    );
}

#[test]
fn list_has_all_of_one_machine() {
    let list = text(&["list"]);
    for name in ["cornell", "tile-6-mixed", "local8-rgb8e5", "list MACHINE"] {
        assert!(list.contains(name), "{name}");
    }
    let wide = text(&["list", "--wide"]);
    assert!(wide.contains("| verified against") && wide.contains("critical path"));
    let sheet = json(&["list", "stream"]);
    assert_eq!(sheet["machine"], "stream");
    assert_eq!(sheet["verilog_module"], "photoncube_stream");
    assert!(!sheet["lines"].as_array().unwrap().is_empty());
    let sheet = text(&["list", "stream"]);
    assert!(sheet.contains("\n  input          query_valid "), "{sheet}");
}
