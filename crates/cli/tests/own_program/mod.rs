//! Tests `generate --program` and `verify --program`: a sequential machine with a microprogram of the user's.

use std::fs;

use super::{error, files_in, json, photoncube};

/// What `photoncube microprogram` prints is accepted unchanged, and gives the machine itself under another name.
#[test]
fn a_printed_listing_is_generated_checked_and_verified() {
    let folder = tempfile::tempdir().unwrap();
    let listing = folder.path().join("own.txt");
    let listing = listing.to_str().unwrap();
    let machine = ["--machine", "paper-5d"];
    let printed = photoncube(&[&["microprogram"], &machine[..]].concat()).output();
    fs::write(listing, printed.unwrap().stdout).unwrap();
    let read = [&["microprogram", "--file", listing], &machine[..]].concat();
    assert_eq!(json(&read)["accepted"], true);

    let out = folder.path().join("verilog");
    let to = ["--out", out.to_str().unwrap()];
    let program = [&machine[..], &["--program", listing]].concat();
    let generate = [&["generate"], &program[..], &to].concat();
    let report = json(&generate);
    assert_eq!(
        report["machines"],
        serde_json::json!(["paper-5d-program-own"])
    );
    photoncube(&[&generate[..], &["--check"]].concat())
        .assert()
        .success();
    let text = |name: &str| {
        let top = format!("photoncube_{}", name.replace('-', "_"));
        let path = out.join(name).join(format!("{top}.v"));
        let text = fs::read_to_string(path).unwrap();
        let code = text
            .lines()
            .filter(|line| !line.trim_start().starts_with("//"));
        code.collect::<Vec<_>>().join("\n").replace(&top, "top")
    };
    photoncube(&[&["generate"], &machine[..], &to].concat())
        .assert()
        .success();
    assert_eq!(text("paper-5d-program-own"), text("paper-5d"));

    let few = ["--against", "text", "--iterations", "100"];
    let report = json(&[&["verify"], &program[..], &few].concat());
    assert_eq!(report["program"], listing);
    assert_eq!(report["controls"][0]["control_found"], true);
    let planted = report["controls"][0]["planted"].as_str().unwrap();
    assert!(planted.starts_with("paper-5d-program-own: "), "{planted}");
    let command = report["lines"][0]["command"].as_str().unwrap();
    assert!(command.contains(&program.join(" ")), "{command}");
}

#[test]
fn a_program_that_the_checker_rejects_is_not_written() {
    let folder = tempfile::tempdir().unwrap();
    let listing = folder.path().join("own.txt");
    let no_gate = "query:\n0 ldq\niteration:\n0 ldp\n1 ldw\n2 sqd\n3 add z\n4 gate\n5 acc\n";
    fs::write(&listing, no_gate).unwrap();
    let listing = listing.to_str().unwrap();
    let out = folder.path().join("verilog");
    let to = ["--out", out.to_str().unwrap()];
    for command in [
        &[&["generate", "--program", listing], &to[..]].concat()[..],
        &["verify", "--program", listing],
        &["microprogram", "--file", listing],
    ] {
        let message = error(command, 1);
        let expected = "own.txt is rejected: iteration clock 4, node 0: `gate` reads v";
        assert!(message.contains(expected), "{command:?}: {message}");
    }
    let of_stream = [
        &["generate", "--program", listing, "--machine", "stream"],
        &to[..],
    ]
    .concat();
    assert!(error(&of_stream, 2).contains("expected one of paper, "));
    for refused in [["--chains", "2"], ["--format", "local7-rgb6d"]] {
        let words = [&["generate", "--program", listing], &refused[..], &to].concat();
        assert!(error(&words, 2).contains("cannot be used with"));
    }
    assert_eq!(files_in(&out), 0);
}
