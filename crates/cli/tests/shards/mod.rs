//! Work that is shared out: shards, and their merging.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use super::{error, json};

/// Nine passes of a small picture.
const PICTURE: [&str; 10] = [
    "progressive",
    "ring",
    "--passes",
    "9",
    "--size",
    "12x12",
    "--photons",
    "1000",
    "--samples",
    "1",
];

/// A sweep of two scenes, 168 jobs of some milliseconds.
const SWEEP: [&str; 14] = [
    "report",
    "--sweep",
    "cornell",
    "ring",
    "--in-range",
    "50,200",
    "--photons",
    "2000",
    "--maps",
    "3",
    "--size",
    "6x6",
    "--picture-size",
    "8x8",
];

/// Two jobs of a machine that the built-in evaluator runs.
const CAMPAIGN: [&str; 8] = [
    "verify",
    "campaign",
    "--jobs",
    "2",
    "--iterations",
    "100",
    "--machine",
    "tile-8",
];

/// The paths of files in a folder, as arguments.
fn paths(folder: &Path, names: &[&str]) -> Vec<String> {
    let path = |name: &&str| folder.join(name).to_str().unwrap().to_owned();
    names.iter().map(path).collect()
}

/// Runs each shard of `of` by the command, and returns their files.
fn shards(folder: &Path, command: &[&str], of: u64) -> Vec<String> {
    let run = |index: u64| {
        let state = paths(folder, &[&format!("{index}-{of}")]).remove(0);
        let shard = [format!("{index}/{of}"), state.clone()];
        let more = ["--shard", &shard[0], "--state", &shard[1]];
        json(&[command, &more].concat());
        state
    };
    (1..=of).map(run).collect()
}

/// Merges files, in the order of their names, and returns the bytes of the merged file.
fn merged(folder: &Path, files: &[String], more: &[&str]) -> Vec<u8> {
    let to = folder.join("merged");
    let files = files.iter().map(String::as_str);
    let words = ["merge", "-o", to.to_str().unwrap()];
    let words: Vec<_> = words
        .into_iter()
        .chain(files)
        .chain(more.iter().copied())
        .collect();
    json(&words);
    fs::read(to).unwrap()
}

#[test]
fn the_merged_file_is_that_of_one_shard_whatever_their_number_and_order() {
    for (command, numbers) in [
        (&PICTURE[..], &[2, 7][..]),
        (&SWEEP[..], &[2, 7][..]),
        (&CAMPAIGN[..], &[2][..]),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let one = shards(folder.path(), command, 1);
        let expected = merged(folder.path(), &one, &[]);
        for &of in numbers {
            let mut files = shards(folder.path(), command, of);
            files.reverse();
            files.push(files[0].clone());
            let found = merged(folder.path(), &files, &[]);
            assert!(found == expected, "{command:?} {of}");
        }
    }
}

#[test]
fn a_merged_picture_is_byte_for_byte_that_of_one_run() {
    let folder = tempfile::tempdir().unwrap();
    let [whole, of_shards, state] =
        ["whole.exr", "shards.exr", "merged"].map(|name| paths(folder.path(), &[name]).remove(0));
    let of_one = json(&[&PICTURE[..], &["-o", &whole]].concat());
    let files = shards(folder.path(), &PICTURE, 4);
    merged(folder.path(), &files, &[]);
    let go_on = ["-o", &of_shards, "--state", &state, "--resume"];
    let of_four = json(&[&PICTURE[..], &go_on].concat());
    assert_eq!(of_four["resumed_passes"], 9);
    assert_eq!(fs::read(whole).unwrap(), fs::read(of_shards).unwrap());
    for key in ["photon_tests", "query_points"] {
        assert_eq!(of_four[key], of_one[key], "{key}");
    }
    for key in ["passes", "photons", "error_bound", "search_radius"] {
        let last = |report: &serde_json::Value| {
            report["progress"].as_array().unwrap().last().unwrap()[key].clone()
        };
        assert_eq!(last(&of_four), last(&of_one), "{key}");
    }
}

#[test]
fn a_merged_sweep_has_nothing_left_to_do_and_the_results_of_one_run() {
    let folder = tempfile::tempdir().unwrap();
    let [out, state] = ["out", "merged"].map(|name| paths(folder.path(), &[name]).remove(0));
    let of_one = json(&[&SWEEP[..], &["--out", &out]].concat());
    let files = shards(folder.path(), &SWEEP, 2);
    merged(folder.path(), &files, &[]);
    let of_two = json(&[&SWEEP[..], &["--out", &out, "--state", &state]].concat());
    assert_eq!(of_two, of_one);
    assert_eq!(of_one["needs"].as_array().unwrap().len(), 4);
    let points = of_one["points"].as_array().unwrap();
    assert_eq!(points.len() as u64, of_one["jobs"].as_u64().unwrap());
    // The formats differ in their errors, so the rows are not those of one format.
    let errors = points
        .iter()
        .map(|point| point["error_over_noise"].to_string());
    assert!(errors.collect::<std::collections::BTreeSet<_>>().len() > 20);
}

#[test]
fn shards_can_be_merged_in_steps() {
    let folder = tempfile::tempdir().unwrap();
    let files = shards(folder.path(), &PICTURE, 4);
    let expected = merged(folder.path(), &files, &[]);
    let pair = |names: [usize; 2], to: &str| {
        let step = merged(
            folder.path(),
            &names.map(|name| files[name].clone()),
            &["--partial"],
        );
        let to = folder.path().join(to);
        fs::write(&to, step).unwrap();
        to.to_str().unwrap().to_owned()
    };
    let steps = [pair([0, 2], "even"), pair([3, 1], "odd")];
    assert!(merged(folder.path(), &steps, &[]) == expected);
    // A file whose shards are in a merged one counts once.
    let twice = [&steps[..], &files[..1]].concat();
    assert!(merged(folder.path(), &twice, &[]) == expected);
    let to = paths(folder.path(), &["to"]).remove(0);
    let overlapping = pair([0, 1], "first");
    let said = error(&["merge", "-o", &to, &steps[0], &overlapping], 2);
    assert!(said.contains("shards 1 are in another file too"), "{said}");
    assert!(!Path::new(&to).exists());
}

#[test]
fn what_cannot_be_merged_is_named_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let to = paths(folder.path(), &["to"]).remove(0);
    let files = shards(folder.path(), &SWEEP, 2);
    let foreign = paths(folder.path(), &["foreign"]).remove(0);
    let other = ["--seed", "7", "--shard", "2/2", "--state", &foreign];
    json(&[&SWEEP[..], &other].concat());
    let picture = shards(folder.path(), &PICTURE, 1);
    let absent = paths(folder.path(), &["absent"]);
    let [half, text] = ["half", "text"].map(|name| paths(folder.path(), &[name]).remove(0));
    let whole = fs::read(&files[0]).unwrap();
    fs::write(&half, &whole[..whole.len() - 10]).unwrap();
    fs::write(&text, "# a listing\n").unwrap();
    for (inputs, expected) in [
        (
            [&files[0], &files[0]],
            "shards 2 of 2 are missing; give their files, or --partial",
        ),
        (
            [&files[0], &foreign],
            "--seed: found 7, expected 1; all files must be of the work of",
        ),
        (
            [&files[1], &half],
            "shard 1 of 2 has 83 of 84 jobs; run its command again",
        ),
        (
            [&files[0], &text],
            "found a file that begins with \"# a listing\", expected a state file",
        ),
        (
            [&files[0], &picture[0]],
            "found a state of `progressive`, expected one of `report --sweep`",
        ),
        ([&files[0], &absent[0]], "No such file"),
    ] {
        let said = error(&["merge", "-o", &to, inputs[0], inputs[1]], 2);
        assert!(said.contains(expected), "{said}");
        assert!(!Path::new(&to).exists());
    }
    let said = error(&["merge", "-o", &files[0], &files[0], &files[1]], 2);
    assert!(said.contains(&files[0]), "{said}");
    assert_eq!(fs::read(&files[0]).unwrap(), whole);
}

#[test]
fn a_shard_takes_no_options_that_need_the_whole() {
    let chi = ["--caustics", "map", "--shard", "1/2", "--state", "unused"];
    let said = error(&[&PICTURE[..], &chi].concat(), 2);
    assert!(said.contains("give --radius-rule schedule"), "{said}");
    let stop = [
        "--error-target",
        "0.1",
        "--shard",
        "1/2",
        "--state",
        "unused",
    ];
    let said = error(&[&PICTURE[..], &stop].concat(), 2);
    assert!(said.contains("cannot be used with"), "{said}");
    let said = error(
        &[&PICTURE[..], &["--shard", "3/2", "--state", "unused"]].concat(),
        2,
    );
    assert!(said.contains("expected I/N"), "{said}");
    let said = error(&["report", "--shard", "1/2", "--state", "unused"], 2);
    assert!(said.contains("--sweep"), "{said}");
    let said = error(&["report", "cornell", "ring"], 2);
    assert!(said.contains("found 2 scenes"), "{said}");
}

/// Begins a worker of the sweep.
fn worker(state: &Path) -> Child {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("photoncube"));
    command
        .args(SWEEP)
        .args(["--shard", "1/1", "--state", state.to_str().unwrap()]);
    command
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap()
}

/// The whole lines of a state file.
fn lines(state: &Path) -> Vec<String> {
    let bytes = fs::read(state).unwrap_or_default();
    let whole = bytes
        .iter()
        .rposition(|byte| *byte == b'\n')
        .map_or(0, |end| end + 1);
    let text = String::from_utf8(bytes[..whole].to_vec()).unwrap();
    text.lines().map(ToOwned::to_owned).collect()
}

/// What is reported done is in the file. A worker is killed a hundred times: at a random moment, or at a random moment after it has written
/// some results.
#[test]
fn a_hundred_kills_lose_nothing_that_was_reported_done() {
    const KILLS: u64 = 100;
    let folder = tempfile::tempdir().unwrap();
    let [killed, whole] = ["killed", "whole"].map(|name| folder.path().join(name));
    let (mut kills, mut while_at_work) = (0, 0);
    let mut reported: Vec<String> = Vec::new();
    while kills < KILLS {
        let mut child = worker(&killed);
        let wanted = match kills % 4 {
            0 => 0,
            more => reported.len() + more as usize,
        };
        while lines(&killed).len() < wanted && child.try_wait().unwrap().is_none() {
            sleep(Duration::from_millis(1));
        }
        // Each number once in a hundred kills.
        sleep(Duration::from_micros(200 * (kills * 37 % KILLS)));
        let before = lines(&killed);
        child.kill().unwrap();
        let ended = child.wait().unwrap();
        let now = lines(&killed);
        for line in reported.iter().chain(&before) {
            assert!(now.contains(line), "kill {kills} lost {line}");
        }
        if ended.success() {
            // The work is done: begin anew.
            fs::remove_file(&killed).unwrap();
            reported.clear();
            continue;
        }
        while_at_work += u64::from(now.len() > reported.len());
        reported = now;
        kills += 1;
    }
    assert!(
        while_at_work > KILLS / 2,
        "{while_at_work} kills came after results"
    );
    assert!(worker(&killed).wait().unwrap().success());
    assert!(worker(&whole).wait().unwrap().success());
    assert!(fs::read(killed).unwrap() == fs::read(whole).unwrap());
}
