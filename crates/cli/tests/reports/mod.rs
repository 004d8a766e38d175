//! Tests the figures of formats and machines in `report`, and the time of a machine.

use std::fs;

use serde_json::Value;

use super::shared::{REPORT, RUN, Written};
use super::{error, estimators, json, photoncube};

#[test]
fn report_measures_every_format_and_machine() {
    let (report, folder) = (&REPORT.report, &REPORT.folder);
    let rows = report["rows"].as_array().unwrap();
    let list = json(&["list"]);
    let listed =
        ["formats", "machines", "measured_cores"].map(|key| list[key].as_array().unwrap().len());
    assert_eq!(rows.len(), listed.iter().sum::<usize>());
    assert!(listed.iter().all(|rows| *rows > 0), "{listed:?}");
    let row = |name: &str| rows.iter().find(|row| row["name"] == name).unwrap();
    assert!(row("local8-rgb8e5")["bits_per_photon"].as_u64().unwrap() <= 56);
    assert_eq!(row("paper")["initiation_interval"], 9.0);
    assert_eq!(row("overlap")["initiation_interval"], 1.5);
    let error = |name| row(name)["error_over_noise"].as_f64().unwrap();
    assert!(error("local4-rgb8e5") > error("local8-rgb8e5"));
    assert!(rows.iter().any(|row| row["on_bits_front"] == true));
    for row in rows {
        let on_front = ["on_bits_front", "on_hardware_front", "on_speed_front"];
        let is_best = on_front.iter().any(|front| row[front] == true);
        assert!(!is_best || row["within_bound"] == true, "{row}");
        // A format has one figure on this CPU. A machine has none, because its model is that of its format.
        let has_speed = row["photon_tests_per_second"].is_number();
        assert_eq!(has_speed, row["kind"] == "format", "{row}");
        assert_eq!(
            row["photon_tests_per_second_spread"].is_number(),
            has_speed,
            "{row}"
        );
        if has_speed {
            let figure = |end: &str| {
                row[format!("photon_tests_per_second{end}")]
                    .as_f64()
                    .unwrap()
            };
            let (low, median, high) = (figure("_low"), figure(""), figure("_high"));
            assert!(low <= median && median <= high, "{row}");
        }
        assert_eq!(
            row["pictures_per_second"].is_number(),
            row["kind"] != "format",
            "{row}"
        );
    }
    let within = rows.iter().filter(|row| row["within_bound"] == true);
    // The formats of machines count too.
    let formats = within.filter(|row| row["format"].is_string());
    let fewest = formats
        .map(|row| row["bits_per_photon"].as_u64().unwrap())
        .min();
    assert_eq!(report["scene_needs"]["bits_per_photon"].as_u64(), fewest);
    estimators::check_rows(report);
    for name in [
        "report-cornell-speed.svg",
        "report-cornell-bits.svg",
        "report-cornell-hardware.svg",
        "report-cornell-dimensions.svg",
        "report-cornell.json",
    ] {
        let text = fs::read_to_string(folder.path().join(name)).unwrap();
        assert!(
            text.contains("local8-rgb8e5") || text.contains("Fmax"),
            "{name}"
        );
    }
}

#[test]
fn report_goes_on_where_a_machine_cannot_take_the_scene() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let many = [
        "--photons",
        "20000",
        "--size",
        "8x8",
        "--maps",
        "3",
        "--in-range",
        "2500",
    ];
    let args = [&["report", "--out", out][..], &many[..]].concat();
    let output = photoncube(&args).assert().success();
    let text = String::from_utf8(output.get_output().stdout.clone()).unwrap();
    let expected = "fit-cornell cannot take this scene: a query of ";
    assert!(
        text.contains(expected) && text.contains("--in-range"),
        "{text}"
    );
    let tiles = "tile-4, tile-5, tile-6, tile-7, tile-8, tile-9, tile-10, ";
    assert!(text.contains(tiles), "one reason, one line: {text}");
    assert!(
        text.starts_with("cornell: of the formats and machines listed below, "),
        "the verdict comes first: {text}"
    );
    let written = folder.path().join("report-cornell.json");
    let report: Value = serde_json::from_slice(&fs::read(written).unwrap()).unwrap();
    let row = |name: &str| {
        let rows = report["rows"].as_array().unwrap();
        rows.iter().find(|row| row["name"] == name).unwrap().clone()
    };
    assert!(
        row("fit-cornell")["cannot"]
            .as_str()
            .unwrap()
            .contains("over the 4096")
    );
    assert!(row("fit-cornell")["error_over_noise"].is_null());
    assert!(row("paper")["cannot"].is_null() && row("paper")["error_over_noise"].is_number());
}

/// With a given machine there is no fit, which is most of a run's time.
#[test]
fn run_with_a_machine_fits_nothing_and_says_the_seconds_of_a_picture() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let small = ["--photons", "5000", "--size", "8x8", "--samples", "1"];
    let run = [
        "run",
        "--machine",
        "tile-6",
        "--iterations",
        "20",
        "--out",
        out,
    ];
    let report = json(&[&run[..], &small[..]].concat());
    assert!(report["fitted"].is_null());
    let figure = |key: &str| report[key].as_f64().unwrap();
    let seconds = figure("clocks") / (figure("fmax_mhz") * 1e6);
    // A rounding of a division.
    assert!((figure("seconds_per_picture") / seconds - 1.0).abs() < 1e-12);
    assert!((figure("pictures_per_second") * seconds - 1.0).abs() < 1e-12);
    // With four engines, between one clock a group for all of them and one for each.
    let groups = figure("photon_groups");
    assert!(figure("clocks") >= groups / 4.0 && figure("clocks") <= groups + 100.0);
    assert_eq!(report["photons_asked"], 5000);
    assert!(report["photons"].as_u64() >= Some(5000));
}

#[test]
fn a_query_of_too_many_photons_is_told_with_the_option_that_helps() {
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("o.png");
    let picture = picture.to_str().unwrap();
    let many = ["--photons", "20000", "--size", "4x4", "--in-range", "2500"];
    for command in ["render", "progressive"] {
        let args = [command, "cornell", "-o", picture, "--direct", "map"];
        let args = [&args[..], &["--machine", "fit-cornell"]].concat();
        let message = error(&[&args[..], &many].concat(), 2);
        assert!(message.contains("give a smaller --in-range"), "{message}");
        assert_eq!(
            message.matches("a query of ").count(),
            1,
            "said once: {message}"
        );
    }
    let out = folder.path().join("out");
    let run = ["run", "--machine", "tile-6", "--out", out.to_str().unwrap()];
    let message = error(&[&run[..], &many].concat(), 2);
    assert!(message.contains("give a smaller --in-range"), "{message}");
    assert!(message.contains("a format with -n"), "{message}");
    assert!(!out.exists(), "it is refused before the Verilog is written");
}

/// Smaller batches have fewer tests of photons that cannot be in range. Of leaves of two sizes the tests hardly differ, as each group has a
/// box of its own: by which photons the last group of a run has.
#[test]
fn a_plan_has_a_row_for_each_size() {
    let small = [
        "--photons",
        "20000",
        "--size",
        "32x32",
        "--samples",
        "1",
        "--chain",
        "4,16",
        "--leaf",
        "8,16",
    ];
    let plan = json(&[&["plan", "cornell", "--engines", "32"][..], &small].concat());
    let rows = plan["schedules"].as_array().unwrap();
    assert_eq!(rows.len(), 4);
    for row in rows {
        let number = |key: &str| row[key].as_f64().unwrap();
        assert_eq!(number("chains") * number("chain_engines"), 32.0);
        assert_eq!(number("queries"), plan["query_points"].as_f64().unwrap());
        assert!(number("tests_per_photon_in_range") > 1.0);
        assert!(number("engines_with_query") <= 1.0 && number("reading") <= 1.0);
    }
    let tests = |row: usize| rows[row]["tests_per_photon_in_range"].as_f64().unwrap();
    // Rows 0 and 1 have chains of 4 engines, rows 2 and 3 of 16; of two the first has leaves of 8 photons, the second of 16.
    let differ_little =
        |small: usize, large: usize| (tests(large) / tests(small) - 1.0).abs() < 0.02;
    assert!(differ_little(0, 1) && differ_little(2, 3));
    assert!(tests(0) < tests(2) && tests(1) < tests(3));
    let longer = error(&["plan", "cornell", "--engines", "8", "--chain", "16"], 2);
    assert!(longer.contains("longer than the 8 engines"), "{longer}");
    let wrong = error(&["plan", "cornell", "--format", "local7"], 2);
    assert!(wrong.contains("there is no format `local7`"), "{wrong}");
}

/// The text of the page of a report.
fn page(written: &Written) -> String {
    fs::read_to_string(written.report["page"].as_str().unwrap()).unwrap()
}

/// `scripts/page/check.sh` opens the pages in a browser.
#[test]
fn pages_hold_all_that_they_show_and_say_what_the_report_says() {
    for (page, named) in [(page(&REPORT), "scene_needs"), (page(&RUN), "fitted")] {
        assert!(page.len() < 3_000_000, "{named}: {} bytes", page.len());
        // Pictures are in the page; addresses of other pages are in no attribute.
        for attribute in ["src=\"", "href=\""] {
            let values = page.split(attribute).skip(1);
            let values: Vec<_> = values.map(|rest| rest.split('"').next().unwrap()).collect();
            assert!(!values.is_empty(), "{named}: {attribute}");
            let is_inside = |value: &&str| value.starts_with("data:") || value.starts_with('#');
            let outside: Vec<_> = values.iter().filter(|value| !is_inside(value)).collect();
            assert!(outside.is_empty(), "{named}: {outside:?}");
        }
        assert!(page.contains("id=\"verdict\""), "{named}");
        assert!(page.contains("class=\"steps-data\""), "{named}");
    }
    let report = &REPORT.report["scene_needs"];
    let verdict = page(&REPORT).split("</section>").next().unwrap().to_owned();
    for key in ["format", "smallest_machine", "fastest_machine"] {
        let name = report[key].as_str().unwrap();
        assert!(verdict.contains(&format!(">{name}<")), "{key}: {name}");
    }
    let bits = report["bits_per_photon"].as_u64().unwrap();
    assert!(verdict.contains(&format!("needs at most {bits} bits a photon")));
    let run = page(&RUN);
    let machine = RUN.report["machine"].as_str().unwrap();
    assert!(run.contains(&format!("The machine is <strong>{machine}</strong>")));
}

/// Where no machine can hold the scene, the report has its figures, and its page says why there is no picture.
#[test]
fn a_page_says_what_it_cannot_show() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let many = ["--photons", "100000", "--in-range", "20000", "--maps", "3"];
    let small = ["--size", "4x4", "--picture-size", "6x6", "--out", out];
    let report = json(&[&["report", "ring"][..], &many, &small].concat());
    assert!(report["scene_needs"]["smallest_machine"].is_null());
    let page = fs::read_to_string(report["page"].as_str().unwrap()).unwrap();
    assert!(page.contains("Not shown: "), "{page}");
}
