//! Tests the commands as a user sees them: their output, their files, their exit codes.

mod board;
mod custom;
mod datasheets;
mod estimators;
mod fuzz;
mod json_keys;
mod lint;
mod outputs;
mod own_program;
mod pictures;
mod placed;
mod reports;
mod robustness;
mod scenes;
mod setup;
mod shards;
mod shared;
mod usage;

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use serde_json::Value;

use self::shared::{FIT, HARD_CASES, RUN, SMALL_FIT};

fn photoncube(args: &[&str]) -> Command {
    let mut command = Command::cargo_bin("photoncube").unwrap();
    command.args(args);
    command
}

/// Standard output of a command that must succeed, as one JSON object.
fn json(args: &[&str]) -> Value {
    let output = photoncube(args).arg("--json").assert().success();
    serde_json::from_slice(&output.get_output().stdout).unwrap()
}

/// Standard error of a command that must end with `code`.
fn error(args: &[&str], code: i32) -> String {
    let output = photoncube(args).assert().code(code);
    String::from_utf8(output.get_output().stderr.clone()).unwrap()
}

fn files_in(folder: &Path) -> usize {
    fs::read_dir(folder).map_or(0, Iterator::count)
}

#[test]
fn the_paper_takes_nine_clocks_for_four_photons() {
    let report = json(&["microprogram"]);
    assert_eq!(report["initiation_interval"], 9);
    assert_eq!(report["photons_per_iteration"], 4);
    assert_eq!(report["accepted"], true);
}

#[test]
fn a_rejected_microprogram_names_clock_and_node_and_ends_1() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("program.txt");
    let listing = "query:\n0 ldq\niteration:\n0 ldp\n1 ldw\n2 sqd\n3 add z\n4 gate\n5 acc\n";
    fs::write(&path, listing).unwrap();
    let message = error(&["microprogram", "--file", path.to_str().unwrap()], 1);
    assert!(
        message.contains("iteration clock 4, node 0: `gate` reads v"),
        "{message}"
    );
}

#[test]
fn a_listing_that_cannot_be_read_names_file_and_line_and_ends_2() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("program.txt");
    fs::write(&path, "query:\n0 ldq\niteration:\n0 jump\n").unwrap();
    let message = error(&["microprogram", "--file", path.to_str().unwrap()], 2);
    assert!(
        message.contains("program.txt: line 4: found `jump`"),
        "{message}"
    );
    let message = error(&["microprogram", "--file", "no-such-file"], 2);
    assert!(message.contains("no-such-file"), "{message}");
}

#[test]
fn generated_files_are_checked_byte_for_byte() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let generate = ["generate", "--machine", "paper", "--out", out];
    let check = ["generate", "--machine", "paper", "--out", out, "--check"];
    assert_eq!(json(&generate)["files"].as_array().unwrap().len(), 6);
    photoncube(&check).assert().success();

    let verilog = folder.path().join("paper/photoncube_paper.v");
    let text = fs::read_to_string(&verilog).unwrap();
    fs::write(&verilog, text.replacen("a - b", "a + b", 1)).unwrap();
    let message = error(&check, 1);
    assert!(message.contains("paper/photoncube_paper.v"), "{message}");

    photoncube(&generate).assert().success();
    fs::write(folder.path().join("paper/stray.v"), "").unwrap();
    assert!(error(&check, 1).contains("stray.v (not ours)"));
}

#[test]
fn the_files_of_a_core_are_written_and_checked() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let core = ["--machine", "leaf-4-local7-rgb6d-n64", "--chains", "2"];
    let generate = [&["generate"], &core[..], &["--out", out]].concat();
    photoncube(&generate).assert().success();
    let top = "photoncube_core_2_leaf_4_local7_rgb6d_n64";
    let written = folder.path().join("core-2-leaf-4-local7-rgb6d-n64");
    for ending in [
        ".v",
        "_ecp5.v",
        "_tb.v",
        ".rdl",
        ".streams.json",
        "_hw.tcl",
        ".ys",
        ".qsf",
    ] {
        let file = written.join(format!("{top}{ending}"));
        assert!(file.exists(), "{} is missing", file.display());
    }
    let check = [&generate[..], &["--check"]].concat();
    photoncube(&check).assert().success();
    let registers = written.join(format!("{top}.rdl"));
    fs::write(&registers, "").unwrap();
    let message = error(&check, 1);
    assert!(message.contains(&format!("{top}.rdl")), "{message}");
}

#[test]
fn what_is_committed_is_what_is_generated() {
    let committed = concat!(env!("CARGO_MANIFEST_DIR"), "/../../hdl-out");
    let said = usage::text(&["generate", "--check", "--out", committed]);
    assert_eq!(usage::too_wide(&said), None);
}

#[test]
fn bad_input_ends_2_says_what_was_expected_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "").unwrap();
    let below_a_file = file.join("x.png");
    let below_a_file = below_a_file.to_str().unwrap();
    let picture = folder.path().join("x.png");
    let picture = picture.to_str().unwrap();
    let cases: &[(&[&str], &str)] = &[
        (
            &["generate", "--machine", "pentium", "--out", out],
            "the machines are paper",
        ),
        (
            &[
                "generate",
                "--machine",
                "tile-6",
                "--chains",
                "2",
                "--out",
                out,
            ],
            "machine `tile-6` is no leaf machine",
        ),
        (
            &["synth", "--machine", "tile-6", "--chains", "2"],
            "machine `tile-6` is no leaf machine",
        ),
        (
            &["generate", "--out", below_a_file],
            "cannot make the folder",
        ),
        (
            &[
                "generate",
                "--machine",
                "paper",
                "--coordinate-bits",
                "9",
                "--out",
                out,
            ],
            "not built in",
        ),
        (&["generate", "--coordinate-bits", "9"], "--machine"),
        (&["generate", "--check", "--out", below_a_file], "no folder"),
        (
            &["verify", "--machine", "pentium"],
            "the machines are paper",
        ),
        (&["verify", "--iterations", "0"], "a whole number from 1;"),
        (&["verify", "--against", "modelsim"], "rust-hdl"),
        (&["hard-cases", "--format", "float"], "no format `float`"),
        (&["microprogram", "--dimension", "9"], "not built in"),
        (
            &["run", "atlantis", "--out", out],
            "built-in scene (cornell, ring, range)",
        ),
        (
            &["run", "--machine", "pentium", "--out", out],
            "the machines are paper",
        ),
        (&["run", "--out", below_a_file], "cannot make the folder"),
        (
            &["run", "--photons", "0", "--out", out],
            "a whole number from 1 to 134217728",
        ),
        (
            &["render", "cornell", "-o", picture, "--size", "0x9"],
            "expected WxH",
        ),
        (
            &["render", "cornell", "-o", picture, "--in-range=0"],
            "number above 0",
        ),
        (
            &["render", "cornell", "-o", picture, "--engine", "gpu"],
            "f64",
        ),
        (
            &["render", "cornell", "-o", picture, "--estimator", "knn:1"],
            "k: found `1`, expected a whole number from 2",
        ),
        (
            &[
                "render",
                "cornell",
                "-o",
                picture,
                "--estimator",
                "ladder:99",
            ],
            "rungs: found `99`, expected 1 to 64",
        ),
        (
            &["render", "cornell", "-o", picture, "--estimator", "nearest"],
            "expected fixed, knn:K, cone, epanechnikov or ladder:RUNGS[:KERNEL]",
        ),
        (
            &["render", "cornell", "-o", picture, "--estimator", "cone"],
            "expected its ladder, such as ladder:4:cone",
        ),
        (
            &["render", "cornell", "-o", below_a_file],
            "cannot make the folder",
        ),
    ];
    for (args, expected) in cases {
        let message = error(args, 2);
        assert!(message.contains(expected), "{args:?}: {message}");
        assert_eq!(files_in(folder.path()), 1, "{args:?} left something behind");
    }
}

#[test]
fn verify_reports_what_it_compared() {
    let report = json(&["verify", "--machine", "paper-5d", "--iterations", "50"]);
    assert_eq!(report["mismatches"], 0);
    assert!(report["vectors_compared"].as_u64().unwrap() >= 50 * 10);
    assert_eq!(report["devices"][0]["device"], "rust-hdl");
    assert_eq!(report["devices"][1]["device"], "text");
    for device in report["devices"].as_array().unwrap() {
        assert_eq!(device["registers_compared"], true);
        assert!(device["clocks_per_second"].as_u64().unwrap() > 0);
    }
}

#[test]
fn render_is_the_same_for_a_seed_and_another_for_another() {
    let folder = tempfile::tempdir().unwrap();
    let render = |name: &str, seed: &str, engine: &str| {
        let path = folder.path().join(name);
        let path = path.to_str().unwrap();
        let small = ["--photons", "5000", "--size", "16x16", "--samples", "1"];
        let args = [
            "render", "cornell", "-o", path, "--seed", seed, "--engine", engine,
        ];
        let report = json(&[&args[..], &small[..]].concat());
        assert!(report["photons"].as_u64().unwrap() >= 5000);
        fs::read(path).unwrap()
    };
    let first = render("a.png", "1", "model");
    assert_eq!(first, render("b.png", "1", "model"));
    assert_ne!(first, render("c.png", "2", "model"));
    assert_ne!(
        first,
        render("d.png", "1", "f64"),
        "the formats' error is not zero"
    );
}

#[test]
fn run_takes_the_whole_path() {
    let (report, folder) = (&RUN.report, &RUN.folder);
    // Without --machine the machine is the one that the scene needs.
    let fitted = &report["fitted"];
    assert_eq!(fitted["holds"], true);
    let error = fitted["measurement"]["error_over_noise"].as_f64().unwrap();
    assert!(error <= fitted["noise_ratio"].as_f64().unwrap());
    let machine = report["machine"].as_str().unwrap();
    assert_ne!(machine, "paper");
    assert_eq!(report["mismatches"], 0);
    assert!(report["photons"].as_u64().unwrap() >= 20_000);
    let groups = report["photon_groups"].as_u64().unwrap();
    let queries = report["query_points"].as_u64().unwrap();
    let program = json(&["microprogram", "--machine", machine]);
    let expected = match report["initiation_interval"].as_f64().unwrap() {
        1.0 => groups + program["latency_clocks"].as_u64().unwrap(),
        _ => 9 * groups + 2 * queries,
    };
    assert_eq!(report["clocks"].as_u64().unwrap(), expected, "{machine}");
    assert!(report["rms_relative_error"].as_f64().unwrap() > 0.0);
    // Every simulator is either compared or named as missing.
    let compared = report["devices"].as_array().unwrap().len();
    let missing = report["devices_not_found"].as_array().unwrap().len();
    assert_eq!(compared + missing, 4);
    // The emitted text is verified whatever tools are installed.
    assert_eq!(report["devices"][1]["device"], "text");
    let vectors = |of: &Value| of["vectors_compared"].as_u64().unwrap();
    assert!(vectors(&report["devices"][1]) > 0);
    assert!(vectors(report) >= vectors(&report["devices"][1]));
    for name in ["cornell.png", "cornell-f64.png", "run.json"] {
        assert!(folder.path().join(name).is_file(), "{name}");
    }
    let verilog = format!("{machine}/photoncube_{}.v", machine.replace('-', "_"));
    assert!(folder.path().join(&verilog).is_file(), "{verilog}");
}

#[test]
fn fit_finds_a_format_that_holds_and_shows_that_less_breaks() {
    let report = &*FIT;
    let bound = report["noise_ratio"].as_f64().unwrap();
    let error = |row: &Value| row["measurement"]["error_over_noise"].as_f64().unwrap();
    assert!(error(&report["fitted"]) <= bound);
    let removals = report["removals"].as_array().unwrap();
    assert!(!removals.is_empty() && removals.iter().all(|row| error(row) > bound));
    assert_eq!(report["one_colour"], true);
    let format = report["fitted"]["format"].as_str().unwrap();
    assert!(format.contains("-mono1"), "{format}");
    let machine = report["machine"]["machine"].as_str().unwrap();
    let next = report["next"].as_str().unwrap();
    assert!(next.contains(&format!("--machine {machine} ")), "{next}");
    let saved = report["comparison"].as_array().unwrap().iter();
    let saved = |name| saved.clone().find(|row| row["name"] == name).unwrap();
    let saved = &saved("paper")["bits_per_photon_saved"];
    assert!(saved.as_i64().unwrap() > 0);
}

#[test]
fn fit_says_what_it_found_to_people() {
    let args = [&["fit", "ring"][..], &SMALL_FIT[..]].concat();
    let output = photoncube(&args).assert().success();
    let text = String::from_utf8(output.get_output().stdout.clone()).unwrap();
    for expected in [
        "less: position bit",
        "| fitted | saved | because",
        "go on with:\n  photoncube run ring --machine ",
    ] {
        assert!(text.contains(expected), "{expected}: {text}");
    }
}

#[test]
fn a_ratio_that_nothing_meets_ends_1_and_one_of_nothing_ends_2() {
    let tiny = ["--photons", "2000", "--size", "6x6", "--maps", "3"];
    let fit = |ratio| [&["fit", "cornell", "--noise-ratio", ratio][..], &tiny[..]].concat();
    let message = error(&fit("0.000001"), 1);
    assert!(
        message.contains("larger --noise-ratio, at least "),
        "{message}"
    );
    for ratio in ["0", "nan"] {
        assert!(error(&fit(ratio), 2).contains("number above 0"), "{ratio}");
    }
}

#[test]
fn hard_cases_print_a_row_each_with_bound_reason_and_contrast() {
    let report = &*HARD_CASES;
    let cases = report["cases"].as_array().unwrap();
    assert!(cases.len() > 20, "{cases:?}");
    assert_eq!(report["failed"].as_array().unwrap().len(), 0);
    for case in cases {
        assert_eq!(case["holds"], true, "{case}");
        assert!(case["looked_at"].as_u64().unwrap() > 0, "{case}");
        assert!(!case["why"].as_str().unwrap().is_empty(), "{case}");
        assert!(case["contrast"].is_number(), "{case}");
    }
    let output = photoncube(&["hard-cases", "--format", "local6-rgb8"])
        .assert()
        .success();
    let table = String::from_utf8(output.get_output().stdout.clone()).unwrap();
    for text in [
        "what could break",
        "boundary-ties-f64",
        "permuted",
        "0 failed",
    ] {
        assert!(table.contains(text), "{table}");
    }
}

/// Two photons are too few for cases with more photons: the cases are refused and their rows are named.
#[test]
fn a_hard_case_that_fails_is_named_and_ends_1() {
    let message = error(&["hard-cases", "--format", "local8-rgb8e5-n2"], 1);
    assert!(
        message.contains("hard case `boundary-ties-f32`: "),
        "{message}"
    );
    assert!(message.contains("over the 2 that format"), "{message}");
}

#[test]
fn list_names_scenes_machines_and_formats() {
    let report = json(&["list"]);
    assert_eq!(report["scenes"][0]["scene"], "cornell");
    assert_eq!(report["machines"][0]["machine"], "paper");
    assert_eq!(report["machines"][0]["radius_sq_bits"], 18);
}

#[test]
fn completions_and_manual_pages_name_every_command() {
    let commands = [
        "run",
        "fit",
        "list",
        "datasheet",
        "generate",
        "verify",
        "render",
        "synth",
        "setup",
        "microprogram",
    ];
    let output = photoncube(&["completions", "bash"]).assert().success();
    let text = String::from_utf8(output.get_output().stdout.clone()).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    photoncube(&["man", "--out", out]).assert().success();
    for command in commands {
        assert!(
            text.contains(&format!("photoncube__subcmd__{command}")),
            "{command}"
        );
        let page = folder.path().join(format!("photoncube-{command}.1"));
        assert!(
            fs::read_to_string(page).unwrap().contains(".TH"),
            "{command}"
        );
    }
}

#[test]
fn help_has_examples() {
    for command in [
        "run",
        "fit",
        "list",
        "datasheet",
        "generate",
        "verify",
        "render",
        "progressive",
        "compare",
        "plan",
        "report",
        "hard-cases",
        "synth",
        "setup",
        "board",
        "board ulx3s",
        "board simulate",
        "microprogram",
    ] {
        let words: Vec<_> = command.split(' ').chain(["--help"]).collect();
        let output = photoncube(&words).assert().success();
        let help = String::from_utf8(output.get_output().stdout.clone()).unwrap();
        insta::assert_snapshot!(format!("help_{}", command.replace(' ', "_")), help);
        assert!(help.contains("Examples:"), "{command}");
    }
    let output = photoncube(&["--help"]).assert().success();
    let help = String::from_utf8(output.get_output().stdout.clone()).unwrap();
    insta::assert_snapshot!("help", help);
}
