//! Tests `render --estimator`, and the estimators of `report`.

use std::fs;
use std::path::Path;

use serde_json::Value;

use super::json;

/// A small picture by an engine and an estimator: its bytes, and the `--json` output.
fn estimated(folder: &Path, engine: &str, estimator: &str) -> (Vec<u8>, Value) {
    let path = folder.join("x.png");
    let path = path.to_str().unwrap();
    let small = ["--photons", "5000", "--size", "16x16", "--samples", "1"];
    let how = ["--engine", engine, "--estimator", estimator];
    let report = json(&[&["render", "cornell", "-o", path][..], &small, &how].concat());
    assert_eq!(report["estimator"], estimator);
    (fs::read(path).unwrap(), report)
}

#[test]
fn every_engine_renders_with_every_estimator_it_can_make() {
    let folder = tempfile::tempdir().unwrap();
    for engine in ["f64", "model", "format"] {
        let render = |estimator| estimated(folder.path(), engine, estimator);
        let (fixed, _) = render("fixed");
        for estimator in ["knn:20", "ladder:2:cone", "ladder:4:epanechnikov"] {
            let (picture, report) = render(estimator);
            assert_ne!(picture, fixed, "{engine} {estimator}");
            let gathers = report["gathers_per_query"].as_f64().unwrap();
            let expected = match (engine, estimator) {
                ("f64", "knn:20") => 1.0..=1.0,
                // One gather where the radius holds fewer than 20 photons, else up to 16 bits and one.
                (_, "knn:20") => 2.0..=17.0,
                (_, "ladder:2:cone") => 2.0..=2.0,
                _ => 4.0..=4.0,
            };
            assert!(
                expected.contains(&gathers),
                "{engine} {estimator} {gathers}"
            );
        }
        assert_eq!(render("ladder:1:rectangle").0, fixed, "{engine}");
    }
    let (cone, _) = estimated(folder.path(), "f64", "cone");
    assert_ne!(cone, estimated(folder.path(), "f64", "epanechnikov").0);
}

/// The photons in range are those of an estimate, however many gathers or maps a query point takes.
#[test]
fn the_photons_in_range_are_averaged_over_the_estimates() {
    let folder = tempfile::tempdir().unwrap();
    let mean = |report: &Value| report["photons_in_range_mean"].as_f64().unwrap();
    for engine in ["f64", "model", "format"] {
        let report = |estimator| estimated(folder.path(), engine, estimator).1;
        let fixed = report("fixed");
        assert_eq!(fixed["estimates"], fixed["query_points"], "{engine}");
        // The k-th sets the radius and is left out; few places have fewer in the search radius.
        let nearest = mean(&report("knn:20"));
        assert!((15.0..=19.0).contains(&nearest), "{engine} {nearest}");
        let ladder = mean(&report("ladder:4:cone"));
        let share = ladder / mean(&fixed);
        assert!((0.8..=1.0).contains(&share), "{engine} {share}");
    }
}

#[test]
fn maps_of_their_own_and_gather_rays_are_estimates_too() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.png");
    let render = |scene: &str, options: &[&str]| {
        let out = ["render", scene, "-o", path.to_str().unwrap()];
        let small = ["--photons", "5000", "--size", "16x16", "--samples", "1"];
        json(&[&out[..], &small, &["--direct", "rays"], options].concat())
    };
    let number = |report: &Value, key: &str| report[key].as_f64().unwrap();
    for (scene, options) in [
        ("ring", ["--caustics", "own:50"]),
        ("cornell", ["--final-gather", "4"]),
    ] {
        let report = render(scene, &options);
        let estimates = number(&report, "estimates");
        assert!(estimates > 1.5 * number(&report, "query_points"), "{scene}");
        assert_eq!(report["gathers_per_query"], 1.0);
        assert!(number(&report, "photons_in_range_mean") < number(&report, "in_range"));
    }
}

/// The second table of `report` at its default of 200 photons in range.
pub fn check_rows(report: &Value) {
    let estimators = report["estimators"].as_array().unwrap();
    let estimator = |name: &str, engine: &str| {
        let found = |row: &&Value| row["estimator"] == name && row["engine"] == engine;
        estimators.iter().find(found).unwrap()
    };
    // A quarter of the 200 in range.
    assert_eq!(estimator("knn:50", "format")["reference"], "knn:50");
    for engine in ["f64", "format"] {
        let rungs = |rungs: u32| estimator(&format!("ladder:{rungs}:cone"), engine);
        let error = |n| rungs(n)["error_over_noise"].as_f64().unwrap();
        assert!(error(2) > error(4) && error(4) > error(8), "{engine}");
        assert_eq!(rungs(4)["gathers_per_query"], 4.0);
        assert_eq!(rungs(4)["reference"], "cone");
    }
}
