//! Every key that a command prints is explained.

use serde_json::Value;

use super::{SMALL_FIT, json};

const COMMITTED_FIGURES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/measured");

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
    let run = ["run", "--machine", "paper", "--out", out];
    let run = [&run[..], &["--iterations", "5"]].concat();
    let render = ["render", "cornell", "-o", picture];
    let report = ["report", "--out", out];
    let tiny = ["--photons", "2000", "--size", "6x6", "--maps", "3"];
    let fit = ["fit", "ring"];
    let exr = folder.path().join("x.exr");
    let exr = exr.to_str().unwrap();
    let progressive = ["progressive", "ring", "-o", exr, "--photons", "1000"];
    let state = folder.path().join("state.json");
    let state = state.to_str().unwrap();
    std::fs::write(state, CAMPAIGN).unwrap();
    let mut found = Vec::new();
    for args in [
        &["list"][..],
        &[&progressive[..], &["--size", "8x8", "--passes", "2"]].concat(),
        &["compare", exr, exr],
        &["microprogram"],
        &["hard-cases", "--format", "local6-rgb8"],
        &[&report[..], &tiny[..]].concat(),
        &[&fit[..], &SMALL_FIT[..]].concat(),
        &["generate", "--machine", "paper", "--out", out],
        &["synth", "--check", "--out", COMMITTED_FIGURES],
        &["verify", "--iterations", "5"],
        &["verify", "--fuzz", "5"],
        &["verify", "--lint"],
        &["verify", "--programs", "1"],
        &["verify", "--table"],
        &["verify", "--campaign", "--hours", "0", "--state", state],
        &[&render[..], &small[..]].concat(),
        &[&run[..], &small[..]].concat(),
    ] {
        keys(&json(args), &mut found);
    }
    assert!(found.len() > 50, "the commands print keys: {found:?}");
    // They need Verilator, Icarus and Yosys.
    if std::env::var_os("REQUIRE_EDA").is_some() {
        keys(&json(&["verify", "--faults"]), &mut found);
        keys(&json(&["verify", "--exhaustive"]), &mut found);
        let coverage = ["verify", "--coverage", "--iterations", "200000"];
        keys(&json(&coverage), &mut found);
        keys(
            &json(&["verify", "--mutants", "3", "--seed", "2"]),
            &mut found,
        );
        let formal = ["verify", "--formal", "--property", "units::"];
        keys(&json(&formal), &mut found);
    }
    let documented = include_str!("../../../../docs/json.md");
    found.retain(|key| !documented.contains(&format!("`{key}`")));
    assert!(found.is_empty(), "docs/json.md does not explain {found:?}");
}
