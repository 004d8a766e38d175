//! Tests the commands on custom machines: an organisation with any photon format.

use std::fs;
use std::path::Path;
use std::sync::Mutex;

use photoncube_spec::find_machine;
use serde_json::Value;

use super::{RUN, SMALL_FIT, error, json, photoncube};

/// A format that no named machine has.
const FORMAT: &str = "local6x2-rgb4e2d-n4096";

fn generate<'a>(organisation: &'a str, format: &'a str, out: &'a Path) -> [&'a str; 7] {
    let out = out.to_str().unwrap();
    [
        "generate",
        "--format",
        format,
        "--organisation",
        organisation,
        "--out",
        out,
    ]
}

#[test]
fn a_machine_of_any_format_is_generated_and_checked() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = generate("stream", FORMAT, folder.path());
    let report = json(&arguments);
    let machine = format!("stream-{FORMAT}");
    assert_eq!(report["machines"], serde_json::json!([machine]));
    let top = format!("photoncube_{}", machine.replace('-', "_"));
    let path = folder.path().join(&machine).join(format!("{top}.v"));
    let text = fs::read_to_string(&path).unwrap();
    assert!(text.contains(&format!("module {top}(")));
    let check = [&arguments[..], &["--check"]].concat();
    json(&check);
    fs::write(&path, text + "// more\n").unwrap();
    let message = error(&check, 1);
    assert!(message.contains(&format!("{top}.v")), "{message}");
}

#[test]
fn a_machine_that_cannot_be_made_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    for (organisation, format, expected) in [
        (
            "core",
            FORMAT,
            "expected sequential, stream, stream-shallow, tile-4 to tile-10, tile-4-shallow to tile-10-shallow, tile-4-fine to tile-10-fine, leaf-4 to leaf-10",
        ),
        (
            "stream",
            "local6y2-rgb4",
            "there is no format `local6y2-rgb4`",
        ),
        (
            "stream",
            "local3-rgb4",
            "position_bits is 3, expected 4 to 12",
        ),
        (
            "tile-5",
            "local7-rgb16e8-n4294967296",
            "bits of a sum is 72",
        ),
    ] {
        let message = error(&generate(organisation, format, folder.path()), 2);
        assert!(message.contains(expected), "{message}");
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

/// The cache is empty, so that the generator would have to be built.
#[test]
fn without_cargo_the_message_says_what_to_do() {
    let (folder, cache) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let missing = folder.path().join("missing");
    let mut command = photoncube(&generate("stream", FORMAT, folder.path()));
    command
        .env("XDG_CACHE_HOME", cache.path())
        .env("CARGO", &missing);
    let output = command.assert().code(2).get_output().clone();
    let message = String::from_utf8(output.stderr).unwrap();
    let expected = "install Rust by rustup, or set CARGO";
    assert!(message.contains(expected), "{message}");
    assert!(message.contains(missing.to_str().unwrap()), "{message}");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

/// The machine of a run that was given none has exactly the format that the scene needs.
#[test]
fn a_run_takes_a_machine_of_the_fitted_format() {
    let machine = RUN.report["machine"].as_str().unwrap();
    let format = find_machine(machine).unwrap().format().unwrap();
    assert_eq!(RUN.report["fitted"]["format"], format.name());
}

/// A scene whose format no named machine has: `fit` writes a machine of exactly this format, and `run` compares one.
#[test]
fn fit_and_run_take_a_machine_of_exactly_the_fitted_format() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let fit = json(&[&["fit", "cornell", "--emit", out][..], &SMALL_FIT].concat());
    let machine = &fit["machine"];
    assert_eq!(machine["format"], fit["fitted"]["format"]);
    assert_eq!(
        machine["wider_than_needed"].as_array().map(Vec::len),
        Some(0)
    );
    let emitted = fit["emitted"].as_array().unwrap();
    assert!(
        emitted
            .iter()
            .all(|path| Path::new(path.as_str().unwrap()).is_file())
    );
    assert!(!emitted.is_empty());
    let run = json(&[
        "run",
        "cornell",
        "--out",
        out,
        "--photons",
        "20000",
        "--size",
        "24x24",
        "--samples",
        "1",
        "--iterations",
        "40",
        "--machine",
        machine["machine"].as_str().unwrap(),
    ]);
    assert_eq!(run["mismatches"], 0);
    assert!(run["vectors_compared"].as_u64() > Some(0));
    assert_eq!(run["fitted"], Value::Null);
}

/// The engine of both pictures, whose simulation is built once.
const CORE: [&str; 5] = [
    "core",
    "--machine",
    "leaf-6-local7-rgb6d-n4096",
    "--chains",
    "2",
];
/// Held while a picture is made, so that the second finds the simulation built.
static CORE_IS_BUILT: Mutex<()> = Mutex::new(());

/// A picture through the emitted Verilog of a core, from its ports to the pixels, pixel by pixel that of the direct gather.
#[test]
#[ignore = "needs Verilator: scripts/setup.sh installs it"]
fn the_emitted_verilog_of_a_core_renders_a_picture() {
    let _built = CORE_IS_BUILT.lock().unwrap();
    let folder = tempfile::tempdir().unwrap();
    let picture = |name: &str| folder.path().join(name).display().to_string();
    let render = |output: &str, engine: &[&str]| {
        let words = [
            "render",
            "cornell",
            "--size",
            "64x64",
            "--photons",
            "100000",
            "-o",
        ];
        json(&[&words[..], &[output, "--engine"], engine].concat())
    };
    let (by_verilog, by_gather) = (picture("verilog.exr"), picture("gather.exr"));
    let report = render(&by_verilog, &CORE);
    render(&by_gather, &["format", "--format", "local7-rgb6d-n4096"]);
    assert_eq!(fs::read(by_verilog).unwrap(), fs::read(by_gather).unwrap());
    let core = &report["core"];
    assert!(core["groups_played"].as_u64() > core["sets"].as_u64());
    assert_eq!(core["query_words"], report["query_points"]);
    assert_eq!(core["core"], "core-2-leaf-6-local7-rgb6d-n4096");
}

/// The rounds of a core, which its registers ask for: one word for each query.
#[test]
#[ignore = "needs Verilator: scripts/setup.sh installs it"]
fn the_emitted_verilog_of_a_core_does_rounds() {
    let _built = CORE_IS_BUILT.lock().unwrap();
    let machine = "leaf-6-radii-local7-rgb6d-n4096";
    let folder = tempfile::tempdir().unwrap();
    let picture = |name: &str| folder.path().join(name).display().to_string();
    for estimator in ["ladder:4:cone", "knn:50"] {
        let render = |output: &str, engine: &str| {
            let words = ["render", "cornell", "--size", "32x32", "--photons", "50000"];
            let of_engine = ["-o", output, "--engine", engine, "--machine", machine];
            json(&[&words[..], &of_engine, &["--estimator", estimator]].concat())
        };
        let (by_verilog, by_model) = (picture("verilog.exr"), picture("model.exr"));
        let report = render(&by_verilog, "core");
        render(&by_model, "model");
        assert_eq!(fs::read(by_verilog).unwrap(), fs::read(by_model).unwrap());
        let core = &report["core"];
        assert_eq!(core["query_words"], report["query_points"]);
        assert_eq!(core["queries_per_clock"], core["estimates_per_clock"]);
    }
}

/// Progressive passes, each through the emitted Verilog of a core.
#[test]
#[ignore = "needs Verilator: scripts/setup.sh installs it"]
fn the_emitted_verilog_of_a_core_renders_progressive_passes() {
    let _built = CORE_IS_BUILT.lock().unwrap();
    let folder = tempfile::tempdir().unwrap();
    let picture = |name: &str| folder.path().join(name).display().to_string();
    let passes = |output: &str, engine: &[&str]| {
        let words = [
            "progressive",
            "cornell",
            "--size",
            "32x32",
            "--photons",
            "20000",
            "--passes",
            "3",
            "-o",
        ];
        json(&[&words[..], &[output, "--engine"], engine].concat())
    };
    let (by_verilog, by_gather) = (picture("verilog.exr"), picture("gather.exr"));
    let report = passes(&by_verilog, &CORE);
    let gathered = passes(&by_gather, &["format", "--format", "local7-rgb6d-n4096"]);
    assert_eq!(fs::read(by_verilog).unwrap(), fs::read(by_gather).unwrap());
    // The estimate of the bias needs the gathers at half the squared radius.
    let estimated = |report: &Value| {
        let passes = report["progress"].as_array().unwrap().clone();
        let columns = ["estimated_noise", "estimated_bias", "error_bound"];
        let row = |pass: Value| columns.map(|column| pass[column].clone());
        passes.into_iter().map(row).collect::<Vec<_>>()
    };
    assert!(estimated(&report).last().unwrap()[1].as_f64() > Some(0.0));
    assert_eq!(estimated(&report), estimated(&gathered));
    assert!(report["core"]["query_words"].as_u64() > Some(0));
}

#[test]
fn a_machine_without_leaves_renders_no_picture_by_its_verilog() {
    let words = ["render", "cornell", "-o", "x.png", "--engine", "core"];
    let message = error(&[&words[..], &["--machine", "tile-5"]].concat(), 2);
    assert!(message.contains("`tile-5` is no leaf machine"), "{message}");
    let message = error(&words, 2);
    assert!(
        message.contains("`paper` is no leaf machine; expected one such as"),
        "{message}"
    );
    let words = ["progressive", "cornell", "-o", "x.png", "--engine", "core"];
    let message = error(&[&words[..], &["--machine", "tile-5"]].concat(), 2);
    assert!(message.contains("`tile-5` is no leaf machine"), "{message}");
    let chains = ["--machine", "leaf-6-local7-rgb6d-n4096", "--chains", "17"];
    let message = error(&[&words[..], &chains].concat(), 2);
    assert!(
        message.contains("found 17 chains, expected 1 to 16"),
        "{message}"
    );
}
