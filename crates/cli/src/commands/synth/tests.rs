use std::fs;

use clap::Parser;
use fpga_flow::{Placer, Resource, Router};
use serde_json::Value;

use super::*;
use crate::args::{Args, Command};
use crate::measured;
use crate::project::ABC9_TARGET_PS;

fn arguments(arguments: &[&str]) -> SynthArgs {
    let arguments = [&["photoncube", "synth"][..], arguments].concat();
    let Command::Synth(args) = Args::parse_from(arguments).command else {
        panic!("parsed as another command");
    };
    args
}

fn plan(of: &[&str]) -> Plan {
    let args = arguments(of);
    let subjects = machines(&args.machines).unwrap();
    let subjects = subjects.into_iter().map(|machine| subject(machine, "00"));
    Plan::new(&args, subjects.collect())
}

fn subject(machine: &'static Machine, verilog_sha256: &str) -> Subject {
    Subject {
        name: machine.name.to_owned(),
        machine,
        design: fpga_flow::Design::default(),
        verilog_sha256: verilog_sha256.to_owned(),
    }
}

/// The speed grades and seeds of a plan.
fn tries(plan: &Plan) -> Vec<(u32, u32)> {
    let tries = plan.tries().into_iter();
    let grade = |what: &fpga_flow::Try| what.speed_grade.expect("an ECP5 has speed grades");
    tries.map(|what| (grade(&what), what.seed)).collect()
}

#[test]
fn without_a_word_everything_is_measured() {
    let plan = plan(&[]);
    assert_eq!(plan.subjects.len(), MACHINES.len());
    assert_eq!(plan.flows.len(), 6);
    assert_eq!(
        tries(&plan),
        [(6, 1), (6, 2), (6, 3), (8, 1), (8, 2), (8, 3)]
    );
    let (areas, places) = plan.groups();
    assert_eq!(areas.len(), 6 * MACHINES.len());
    assert_eq!(places.len(), 2 * MACHINES.len());
}

#[test]
fn what_is_named_is_measured_alone_and_once() {
    let named = plan(&[
        "--machine",
        "paper",
        "--machine",
        "paper",
        "--flow",
        "gates",
        "--grade",
        "8",
    ]);
    assert_eq!(named.subjects.len(), 1);
    assert_eq!(named.flows, [Flow::find("gates").unwrap()]);
    assert!(tries(&named).is_empty());
    let placed = plan(&[
        "--flow", "place", "--grade", "8", "--grade", "7", "--seeds", "2",
    ]);
    assert!(placed.flows.is_empty() && placed.groups().0.is_empty());
    assert_eq!(tries(&placed), [(7, 1), (7, 2), (8, 1), (8, 2)]);
    let one_seed = plan(&[
        "--flow", "place", "--grade", "8", "--seed", "2", "--placer", "static",
    ]);
    assert_eq!(tries(&one_seed), [(8, 2)]);
    let how: Vec<_> = one_seed
        .tries()
        .iter()
        .map(|t| (t.placer, t.router))
        .collect();
    assert_eq!(how, [(Placer::Static, Router::Router1)]);
}

/// A machine that needs so many logic cells.
fn used(needed: u64) -> DeviceUse {
    let lacking = needed.saturating_sub(5280);
    DeviceUse {
        machine: "paper".to_owned(),
        fits: lacking == 0,
        resources: vec![Resource {
            resource: "ICESTORM_LC".to_owned(),
            needed,
            available: 5280,
            lacking,
        }],
    }
}

#[test]
fn a_device_of_another_family_is_measured_by_its_flows_without_speed_grades() {
    let plan = plan(&["--machine", "paper", "--device", "up5k", "--seeds", "2"]);
    let names: Vec<_> = plan.flows.iter().map(|flow| flow.name).collect();
    assert_eq!(names, ["ice40", "ice40-up"]);
    let tries: Vec<_> = plan
        .tries()
        .iter()
        .map(|t| (t.speed_grade, t.seed))
        .collect();
    assert_eq!(tries, [(None, 1), (None, 2)]);
}

#[test]
fn a_machine_that_does_not_fit_ends_1_and_says_what_is_lacking() {
    let mut report = Report {
        device: "iCE40UP5K",
        device_use: vec![used(5280)],
        ..report()
    };
    assert!(conclusion(&report).is_ok());
    assert!(text(&report).contains("| paper   | fits          | ICESTORM_LC 5280 of 5280 |"));
    report.device_use = vec![used(5290)];
    assert!(text(&report).contains("| paper   | does not fit  | ICESTORM_LC 5290 of 5280 |"));
    let error = conclusion(&report).unwrap_err();
    assert!(error.is::<CheckFailed>());
    assert_eq!(
        error.to_string(),
        "paper does not fit in iCE40UP5K: 5290 ICESTORM_LC needed, 5280 available, 10 lacking"
    );
}

/// All machines, each with the digest of its Verilog that the committed figures record: nothing is stale.
fn committed_subjects(folder: &Path) -> Vec<Subject> {
    let recorded = |file: &str| -> Value {
        let text = fs::read_to_string(folder.join(file)).unwrap();
        serde_json::from_str::<Value>(&text).unwrap()["verilog_sha256"].take()
    };
    let (areas, places) = (recorded("synthesis.json"), recorded("place.json"));
    let subject = |machine: &'static Machine| {
        let digests = [&areas[machine.name], &places[machine.name]];
        let digest = digests.into_iter().find_map(Value::as_str);
        subject(machine, digest.expect("it is measured"))
    };
    MACHINES.iter().map(subject).collect()
}

#[test]
fn rows_too_many_or_too_few_are_named() {
    let committed = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/measured");
    let subjects = committed_subjects(&committed);
    let folder = tempfile::tempdir().unwrap();
    let args = arguments(&["--check", "--out", folder.path().to_str().unwrap()]);
    for name in ["synthesis.json", "place.json"] {
        fs::copy(committed.join(name), folder.path().join(name)).unwrap();
    }
    let unchanged = checked(&args, &subjects).unwrap();
    assert_eq!(unchanged.stale, [""; 0]);
    assert_eq!(unchanged.machines.len(), MACHINES.len());
    let edit = |name: &str, change: fn(&mut Vec<Value>)| {
        let path = folder.path().join(name);
        let mut file: Value = serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        change(file["rows"].as_array_mut().unwrap());
        fs::write(&path, file.to_string()).unwrap();
    };
    edit("synthesis.json", |rows| {
        let mut row = rows[0].clone();
        row["machine"] = "pentium".into();
        rows.push(row);
    });
    edit("place.json", |rows| {
        rows.retain(|row| row["machine"] != "paper" || row["speed_grade"] != 8);
    });
    assert_eq!(
        checked(&args, &subjects).unwrap().stale,
        [
            "synthesis.json: pentium is no machine any more",
            "place.json: paper has no speed grade 8",
        ]
    );
}

/// A report from the committed figures, as `--json` prints it.
fn report() -> Report {
    let plan = plan(&["--machine", "paper"]);
    let measured = measured::Measured::of(plan.subjects[0].machine).unwrap();
    Report {
        machines: verilog_rows(&plan),
        device: plan.device.name,
        package: plan.device.package,
        target_mhz: TARGET_MHZ,
        abc9_target_ps: ABC9_TARGET_PS,
        tool_versions: [("yosys".to_owned(), "0.70".to_owned())].into(),
        scripts: script_rows(&plan, ABC9_TARGET_PS),
        areas: measured.areas,
        placements: Vec::new(),
        fmax_by_grade: measured.fmax_by_grade,
        device_use: Vec::new(),
        files: Vec::new(),
    }
}

#[test]
fn the_text_has_tables_tools_and_what_was_written() {
    let mut report = report();
    let printed = text(&report);
    for expected in [
        "Area, ECP5 without DSP blocks (ecp5-nodsp):",
        "Clock, LFE5U-85F, post-route:",
        "| paper   | ecp5-nodsp | 6     |",
        "By yosys 0.70. Nothing was written",
    ] {
        assert!(printed.contains(expected), "{expected}: {printed}");
    }
    report.files = vec!["docs/measured/place.json".to_owned()];
    assert!(text(&report).ends_with("Wrote docs/measured/place.json.\n"));
}

#[test]
fn every_key_is_documented() {
    fn keys(value: &Value, found: &mut Vec<String>) {
        match value {
            Value::Object(map) => map.iter().for_each(|(key, value)| {
                found.push(key.clone());
                keys(value, found);
            }),
            Value::Array(values) => values.iter().for_each(|value| keys(value, found)),
            _ => {}
        }
    }
    let mut report = report();
    report.device_use = vec![used(5281)];
    let mut report = serde_json::to_value(report).unwrap();
    report["tool_versions"] = Value::Null;
    let mut found = Vec::new();
    keys(&report, &mut found);
    let documented = include_str!("../../../../../docs/json.md");
    found.retain(|key| !documented.contains(&format!("`{key}`")));
    assert!(found.is_empty(), "docs/json.md does not explain {found:?}");
}
