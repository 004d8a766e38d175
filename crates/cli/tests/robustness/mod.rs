//! Tests bad conditions: wrong inputs, hostile sizes, a process that is killed while it writes.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use super::photoncube;

#[test]
fn hostile_sizes_are_refused_with_the_reason() {
    for (args, expected) in [
        (
            &[
                "render",
                "cornell",
                "-o",
                "x.png",
                "--photons",
                "1000000000000",
            ][..],
            "'--photons <N>': expected a whole number from 1 to 134217728",
        ),
        (
            &["render", "cornell", "-o", "x.png", "--size", "16384x16384"],
            "expected WxH",
        ),
        (
            &[
                "render",
                "cornell",
                "-o",
                "x.png",
                "--size",
                "99999999999x1",
            ],
            "expected WxH",
        ),
        (
            &["verify", "--iterations", "99999999999999999999"],
            "invalid value '99999999999999999999'",
        ),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let output = photoncube(args).current_dir(&folder).assert().code(2);
        let said = String::from_utf8_lossy(&output.get_output().stderr).into_owned();
        assert!(said.contains(expected), "{args:?}: {said}");
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 0, "{args:?}");
    }
}

/// The files of a folder, without the temporary files of a killed process.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if path.is_dir() {
            let within = files(&path).into_iter();
            found.extend(within.map(|(inner, bytes)| (format!("{name}/{inner}"), bytes)));
        } else if !name.starts_with(".tmp") {
            found.insert(name, fs::read(&path).unwrap());
        }
    }
    found
}

/// Kills a command at moments all over its run. Each file must then be the old one, or the one that the
/// command writes.
fn is_whole_whenever_killed(args: &[&str]) {
    const KILLS: u32 = 12;
    let finished = tempfile::tempdir().unwrap();
    let run = |folder: &Path| {
        Command::new(env!("CARGO_BIN_EXE_photoncube"))
            .args(args)
            .current_dir(folder)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap()
    };
    let begun = Instant::now();
    assert!(run(finished.path()).wait().unwrap().success());
    let whole = begun.elapsed();
    let new = files(finished.path());
    assert!(!new.is_empty());
    let (mut killed, mut written) = (0, 0);
    for kill in 0..KILLS {
        let folder = tempfile::tempdir().unwrap();
        for name in new.keys() {
            let path = folder.path().join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, "old").unwrap();
        }
        let mut child = run(folder.path());
        thread::sleep(whole * (kill + 1) / (KILLS + 1) + Duration::from_millis(1));
        child.kill().unwrap();
        killed += u32::from(!child.wait().unwrap().success());
        let left = files(folder.path());
        assert!(left.keys().eq(new.keys()), "{:?}", left.keys());
        for (name, bytes) in &left {
            let is_new = *bytes == new[name];
            assert!(is_new || bytes == b"old", "{name}: {} bytes", bytes.len());
            written += u32::from(is_new);
        }
    }
    assert!(
        killed > 0,
        "the command was killed in its work at least once"
    );
    println!("{args:?}: {killed} of {KILLS} were killed, {written} files were written before");
}

#[test]
fn a_killed_generate_leaves_each_file_old_or_new() {
    is_whole_whenever_killed(&["generate", "--machine", "tile-6", "--out", "."]);
}

#[test]
fn a_killed_render_leaves_the_picture_old_or_new() {
    let small = ["--photons", "2000", "--size", "64x64", "--samples", "1"];
    is_whole_whenever_killed(&[&["render", "cornell", "-o", "x.exr"], &small[..]].concat());
}
