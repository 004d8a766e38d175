//! Tests the method `lint`.

use super::{json, photoncube};

#[test]
fn a_machine_has_no_finding_and_the_planted_mistake_is_found() {
    let report = json(&["verify", "lint", "--machine", "stream"]);
    assert_eq!(report["method"], "lint");
    assert_eq!(report["findings"], serde_json::json!([]));
    assert_eq!(report["controls"][0]["control_found"], true);
    assert!(report["generated_blocks"].as_u64().unwrap() > 0);
    let line = &report["lines"][0];
    assert_eq!(line["volume"], report["generated_blocks"]);
    assert_eq!(line["machine"], "stream");
    assert_eq!(line["verilog_sha256"].as_str().unwrap().len(), 64);
}

/// The flag of earlier releases does what the subcommand does, and says so.
#[test]
fn the_old_flag_works_with_a_hint() {
    let said = |args: &[&str]| {
        let output = photoncube(args).assert().success();
        let output = output.get_output();
        let [out, err] = [&output.stdout, &output.stderr].map(|text| text.clone());
        [out, err].map(|text| String::from_utf8(text).unwrap())
    };
    let [flag, hint] = said(&["verify", "--machine", "stream", "--lint", "--json"]);
    let [subcommand, none] = said(&["verify", "lint", "--machine", "stream", "--json"]);
    assert_eq!((flag, none.as_str()), (subcommand, ""));
    assert_eq!(
        hint,
        "hint: `verify --lint` is now `verify lint`; the flag goes with the next release\n"
    );
}

#[test]
fn a_result_is_recorded_under_the_name_of_the_method() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("results.json");
    let record = ["verify", "lint", "--record", path.to_str().unwrap()];
    photoncube(&record).assert().success();
    let text = std::fs::read_to_string(&path).unwrap();
    let lines: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(lines[0]["method"], "lint");
    assert_eq!(
        lines[0]["command"],
        "photoncube verify lint --machine paper"
    );
}
