//! Tests that every JSON key that a command prints is explained in docs/json.md, under that command or under the
//! keys of several commands.

use serde_json::Value;

use super::shared::{FIT, HARD_CASES, REPORT, RUN};
use super::{json, photoncube};

const PAGE: &str = include_str!("../../../../docs/json.md");
const COMMITTED_FIGURES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/measured");

/// A case that `verify campaign` wrote.
pub const CASE: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../testbenches/regressions/planted-adder.json"
);

/// A campaign with a job.
const CAMPAIGN: &str = r#"{"seed": 1, "jobs": [{"job": 0, "seconds": 1.5, "machine": "paper",
    "device": "verilator", "tool_version": "5", "seed": 1, "iterations": 2, "results_compared": 1,
    "vectors_compared": 9}], "failures": []}"#;

/// Every key of a JSON value, at any depth.
fn keys(value: &Value, found: &mut Vec<String>) {
    match value {
        Value::Object(map) => {
            for (key, value) in map {
                found.push(key.clone());
                keys(value, found);
            }
        }
        Value::Array(values) => values.iter().for_each(|value| keys(value, found)),
        _ => {}
    }
}

#[test]
fn every_json_key_is_documented() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let picture = folder.path().join("x.png");
    let picture = picture.to_str().unwrap();
    let small = ["--photons", "1000", "--size", "8x8", "--samples", "1"];
    let render = ["render", "cornell", "-o", picture];
    let exr = folder.path().join("x.exr");
    let exr = exr.to_str().unwrap();
    let progressive = ["progressive", "ring", "-o", exr, "--photons", "1000"];
    let waves = folder.path().join("x.vcd");
    let waves = waves.to_str().unwrap();
    let state = folder.path().join("state.json");
    let state = state.to_str().unwrap();
    std::fs::write(state, CAMPAIGN).unwrap();
    for args in [
        &["list"][..],
        &["list", "tile-6"],
        &["list", "core-6-leaf-7-local7-rgb6d-n4096"],
        &[&progressive[..], &["--size", "8x8", "--passes", "2"]].concat(),
        &["compare", exr, exr],
        &["microprogram"],
        &["generate", "--machine", "paper", "--out", out],
        &[&["plan"][..], &small[..]].concat(),
        &[
            "synth",
            "--check",
            "--machine",
            "paper",
            "--out",
            COMMITTED_FIGURES,
        ],
        &["verify", "--iterations", "5", "--waves", waves],
        &["verify", "equivalence", "--case", CASE, "--waves", waves],
        &["verify", "fuzz", "5"],
        &["verify", "lint"],
        &["verify", "programs", "1"],
        &["verify", "table"],
        &["verify", "campaign", "--hours", "0", "--state", state],
        &[&render[..], &small[..]].concat(),
    ] {
        are_explained(args[0], &json(args));
    }
    let shard = folder.path().join("shard");
    let shard = ["--shard", "1/1", "--state", shard.to_str().unwrap()];
    let few = ["--size", "4x4", "--passes", "2", "--photons", "500"];
    let of_shard = [&["progressive", "ring"], &few[..], &shard].concat();
    are_explained("progressive", &json(&of_shard));
    let merged = folder.path().join("merged");
    let merge = ["merge", shard[3], "-o", merged.to_str().unwrap()];
    are_explained("merge", &json(&merge));
    let few = ["--photons", "1000", "--maps", "3", "--size", "4x4"];
    let sweep = [&["report", "--sweep", "--out", out], &few[..]].concat();
    are_explained("report", &json(&sweep));
    for (command, report) in [
        ("run", &RUN.report),
        ("report", &REPORT.report),
        ("fit", &FIT),
        ("hard-cases", &HARD_CASES),
    ] {
        are_explained(command, report);
    }
}

/// Fails where docs/json.md does not explain a key of `report`, an output of `command`.
#[track_caller]
pub fn are_explained(command: &str, report: &Value) {
    let mut found = Vec::new();
    keys(report, &mut found);
    assert!(!found.is_empty(), "{command} prints keys");
    let mut sections = PAGE.split("\n## ").map(|text| text.split_once('\n'));
    let command = format!("`{command}`");
    let of_command = |heading: &str| heading.contains(&command);
    let own = sections
        .clone()
        .flatten()
        .find(|(heading, _)| of_command(heading));
    let shared = sections.find_map(|section| section.filter(|(h, _)| *h == "Several commands"));
    let (Some((_, own)), Some((_, shared))) = (own, shared) else {
        panic!("docs/json.md has no section of {command}");
    };
    found.retain(|key| {
        [own, shared]
            .iter()
            .all(|text| !text.contains(&format!("`{key}`")))
    });
    assert!(found.is_empty(), "docs/json.md, {command}: no {found:?}");
}

#[test]
fn a_key_is_explained_once_and_no_line_is_wider_than_the_page() {
    let rows = PAGE.lines().filter_map(|line| line.strip_prefix("- `"));
    let mut explained: Vec<_> = rows
        .filter_map(|row| row.split_once(": "))
        .flat_map(|(keys, _)| keys.split('`').step_by(2))
        .collect();
    assert!(explained.len() > 200, "{explained:?}");
    explained.sort_unstable();
    let twice = explained.windows(2).filter(|pair| pair[0] == pair[1]);
    assert_eq!(twice.collect::<Vec<_>>(), [[""; 2]; 0]);
    let wide = PAGE.lines().filter(|line| line.chars().count() > 120);
    assert_eq!(wide.collect::<Vec<_>>(), [""; 0]);
}

/// The keys of methods that need Verilator, Icarus or Yosys. Each must end with `code`.
pub fn of_a_method_with_tools(args: &[&str], code: i32) {
    let output = photoncube(args).arg("--json").assert().code(code);
    let report = serde_json::from_slice(&output.get_output().stdout).unwrap();
    are_explained(args[0], &report);
}

#[test]
#[ignore = "needs simulators and Yosys: scripts/setup.sh installs them"]
fn keys_of_faults() {
    of_a_method_with_tools(&["verify", "faults", "--machine", "stream"], 0);
}

#[test]
#[ignore = "needs simulators and Yosys: scripts/setup.sh installs them"]
fn keys_of_what_is_finite() {
    of_a_method_with_tools(&["verify", "exhaustive"], 0);
}

#[test]
#[ignore = "needs simulators and Yosys: scripts/setup.sh installs them"]
fn keys_of_coverage() {
    // Few iterations leave gaps, whose keys are then in the object.
    let few = ["--machine", "stream", "--iterations", "2k"];
    of_a_method_with_tools(&[&["verify", "coverage"][..], &few].concat(), 1);
}

#[test]
#[ignore = "needs simulators and Yosys: scripts/setup.sh installs them"]
fn keys_of_mutants() {
    // The memory alone is the smallest design that has mutants.
    let memory = ["--machine", "tile-6-mixed", "--part", "memory"];
    of_a_method_with_tools(&[&["verify", "mutants", "3"][..], &memory].concat(), 0);
    let folder = tempfile::tempdir().unwrap();
    let waves = folder.path().join("x.vcd");
    let one = ["--mutant", "1", "--waves", waves.to_str().unwrap()];
    of_a_method_with_tools(
        &[&["verify", "mutants", "3"][..], &one, &memory].concat(),
        0,
    );
}

#[test]
#[ignore = "needs simulators and Yosys: scripts/setup.sh installs them"]
fn keys_of_proofs() {
    of_a_method_with_tools(&["verify", "formal", "--property", "units::"], 0);
}
