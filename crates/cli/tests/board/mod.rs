//! Tests `board`: its files, its refusals, and a picture over the pseudo-terminal of a simulation.

use std::fs;

use photoncube_spec::CORES;

use super::json_keys::are_explained;
use super::{error, json};

/// The options of the committed core.
fn core() -> [String; 4] {
    let (chains, machine) = CORES[0];
    ["--machine", machine, "--chains", &chains.to_string()].map(str::to_owned)
}

#[test]
fn the_sources_of_a_board_are_written() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let report = json(&["board", "ulx3s", "--no-build", "--out", out]);
    are_explained("board", &report);
    assert_eq!(report["photons_held"], 3 * 2 * 8 * 8);
    let files = report["files"].as_array().unwrap();
    assert_eq!(files.len(), 6);
    assert!(
        files
            .iter()
            .all(|file| fs::metadata(file.as_str().unwrap()).is_ok())
    );
    assert_eq!(report["bitstream"], serde_json::Value::Null);
    let lpf = fs::read_to_string(folder.path().join("photoncube_ulx3s.lpf")).unwrap();
    assert!(
        lpf.contains("LOCATE COMP \"ftdi_txd\" SITE \"M1\";"),
        "{lpf}"
    );
}

#[test]
fn what_a_board_cannot_do_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let ulx3s = ["board", "ulx3s", "--out", out];
    let said = error(&[&ulx3s[..], &["--mhz", "47"]].concat(), 2);
    assert!(said.contains("47 MHz, expected one of ["), "{said}");
    let said = error(&[&ulx3s[..], &["--tools", out]].concat(), 2);
    assert!(
        said.contains("`photoncube setup --synthesis` installs it"),
        "{said}"
    );
    assert_eq!(fs::read_dir(out).unwrap().count(), 0);
    let core = core();
    let core = core.each_ref().map(String::as_str);
    let picture = folder.path().join("x.png");
    let render = [
        "render",
        "cornell",
        "-o",
        picture.to_str().unwrap(),
        "--engine",
        "core",
    ];
    let port = ["--port", "/dev/there-is-no-such-port"];
    let said = error(&[&render[..], &core, &port].concat(), 2);
    assert!(
        said.contains("cannot open the port /dev/there-is-no-such-port"),
        "{said}"
    );
}

/// Needs Verilator; without it the test says so, and with `REQUIRE_EDA=1` it fails.
#[cfg(unix)]
#[test]
fn a_picture_over_a_pseudo_terminal_is_that_of_the_direct_gather() {
    use std::io::{BufRead, BufReader};
    use std::process::{Child, Command, Stdio};

    struct Simulation(Child);

    impl Drop for Simulation {
        fn drop(&mut self) {
            let _ = self.0.kill();
            let _ = self.0.wait();
        }
    }

    if Command::new("verilator").arg("--version").output().is_err() {
        assert!(
            std::env::var("REQUIRE_EDA").is_err(),
            "found no verilator; scripts/setup.sh installs it"
        );
        eprintln!("SKIPPED: found no verilator; scripts/setup.sh installs it");
        return;
    }
    let core = core();
    let core = core.each_ref().map(String::as_str);
    let child = Command::new(assert_cmd::cargo::cargo_bin("photoncube"))
        .args(["board", "simulate"])
        .args(core)
        .stdout(Stdio::piped())
        .spawn();
    let mut simulation = Simulation(child.unwrap());
    let mut port = String::new();
    let mut said = BufReader::new(simulation.0.stdout.take().unwrap());
    said.read_line(&mut port).unwrap();
    let port = port.trim_end();
    assert!(port.starts_with("/dev/"), "{port}");

    let folder = tempfile::tempdir().unwrap();
    let by = |name: &str, engine: &[&str]| {
        let path = folder.path().join(name);
        let picture = ["render", "cornell", "-o", path.to_str().unwrap()];
        let small = [
            "--size",
            "4x4",
            "--samples",
            "1",
            "--photons",
            "300",
            "--in-range",
            "8",
        ];
        let report = json(&[&picture[..], &small, engine].concat());
        (fs::read(path).unwrap(), report)
    };
    let engine = ["--engine", "core", "--port", port];
    let (on_board, report) = by("board.exr", &[&engine[..], &core].concat());
    are_explained("render", &report);
    assert!(
        report["core"]["query_words"].as_u64().unwrap() >= 16,
        "{report}"
    );
    // A query of a small bank meets in several sets more photons than the machine's format lets it meet at once.
    let format = ["--engine", "format", "--format", "local7-rgb6d-n65536"];
    let (direct, _) = by("direct.exr", &format);
    assert!(on_board == direct, "the pictures differ");

    // The board has three chains.
    let two = [
        "render", "cornell", "-o", "x.png", "--engine", "core", "--port", port,
    ];
    let said = error(&[&two[..], &core[..2], &["--chains", "2"]].concat(), 2);
    assert!(
        said.contains("the board has a core of 3 chains of 2 engines"),
        "{said}"
    );
}
