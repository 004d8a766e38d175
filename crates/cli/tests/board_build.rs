//! Makes the bitstream of a board. It takes minutes and needs the tools of `scripts/setup.sh --synthesis`:
//! `cargo test -p photoncube --test board_build -- --ignored`.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use serde_json::Value;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// The folder of the tools.
fn tools() -> PathBuf {
    let output = Command::new("scripts/setup.sh")
        .arg("--where")
        .current_dir(ROOT)
        .output()
        .unwrap();
    assert!(
        output.status.success(),
        "scripts/setup.sh --synthesis installs the tools"
    );
    PathBuf::from(String::from_utf8(output.stdout).unwrap().trim())
}

fn board(args: &[&str]) -> Value {
    let output = assert_cmd::Command::cargo_bin("photoncube")
        .unwrap()
        .args(["board", "ulx3s", "--json"])
        .args(args)
        .assert()
        .success();
    serde_json::from_slice(&output.get_output().stdout).unwrap()
}

#[test]
#[ignore = "takes minutes, and needs nextpnr: scripts/setup.sh --synthesis installs it"]
fn a_bitstream_is_made_and_its_clock_is_reached() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let report = board(&["--out", out]);
    let bytes = fs::read(report["bitstream"].as_str().unwrap()).unwrap();
    assert_eq!(report["bitstream_bytes"], bytes.len());
    // The preamble of a bitstream.
    let preamble = [0xff, 0xff, 0xbd, 0xb3];
    assert!(bytes.windows(4).any(|bytes| bytes == preamble));
    let clocks = report["fmax_by_clock"].as_array().unwrap();
    assert!(!clocks.is_empty());
    for clock in clocks {
        assert!(
            clock["fmax_mhz"].as_f64() >= clock["needed_mhz"].as_f64(),
            "{clock}"
        );
    }
}

/// The numbers of a PLL, by the names of its parameters.
fn numbers(text: &str) -> Vec<String> {
    let names = [
        "CLKI_DIV",
        "CLKFB_DIV",
        "CLKOP_DIV",
        "CLKOP_CPHASE",
        "FEEDBK_PATH",
    ];
    let number = |name: &str| {
        let (_, rest) = text.split_once(&format!(".{name}(")).unwrap();
        format!("{name} {}", rest.split(')').next().unwrap())
    };
    names.map(number).into()
}

#[test]
#[ignore = "needs ecppll: scripts/setup.sh --synthesis installs it"]
fn the_pll_is_that_of_ecppll() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    for mhz in ["40", "50", "60", "75"] {
        board(&["--no-build", "--mhz", mhz, "--out", out]);
        let ours = fs::read_to_string(folder.path().join("photoncube_ulx3s_pll.v")).unwrap();
        let made = Command::new(tools().join("yowasp-ecppll"))
            .args(["-i", "25", "-o", mhz, "-f", "pll.v"])
            .current_dir(folder.path())
            .output()
            .unwrap();
        assert!(made.status.success(), "{made:?}");
        let expected = fs::read_to_string(folder.path().join("pll.v")).unwrap();
        assert_eq!(numbers(&ours), numbers(&expected), "{mhz} MHz");
    }
}
