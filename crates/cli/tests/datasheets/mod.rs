//! Tests that the datasheets and pictures of docs/ are what `photoncube datasheet` writes.

use std::fs;
use std::path::Path;

use super::json_keys::are_explained;
use super::{error, json, photoncube};

const DOCS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs");

#[test]
fn the_datasheets_and_pictures_of_the_pages_are_current() {
    let check = ["datasheet", "--check", "--out", DOCS];
    let report = json(&check);
    are_explained("datasheet", &report);
    assert_eq!(report["stale"].as_array().unwrap().len(), 0);
    assert_eq!(report["families"].as_array().unwrap().len(), 7);
}

#[test]
fn a_file_that_is_changed_missing_or_not_ours_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let check = ["datasheet", "--check", "--out", out];
    photoncube(&["datasheet", "--out", out]).assert().success();
    photoncube(&check).assert().success();

    let change = |name: &str, from: &str, to: &str| {
        let path = folder.path().join(name);
        let text = fs::read_to_string(&path).unwrap();
        let changed = text.replacen(from, to, 1);
        assert_ne!(text, changed, "{name} has no {from}");
        fs::write(&path, changed).unwrap();
    };
    change("datasheets/tile.md", "| 14 ", "| 15 ");
    change("pictures/cell.svg", "8 bits", "9 bits");
    change("machine.svg", "0001", "0000");
    fs::remove_file(folder.path().join("pictures/timing-core.json")).unwrap();
    fs::write(folder.path().join("pictures/stray.svg"), "").unwrap();
    let message = error(&check, 1);
    for name in [
        "datasheets/tile.md",
        "pictures/cell.svg",
        "machine.svg",
        "pictures/timing-core.json",
        "pictures/stray.svg (not ours)",
    ] {
        assert!(message.contains(name), "{name}: {message}");
    }
    assert!(message.contains("holds 5 files"), "{message}");
}

#[test]
fn one_family_has_its_pages_and_the_pictures_that_they_show() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let report = json(&["datasheet", "core", "--html", "--out", out]);
    let files: Vec<_> = report["files"].as_array().unwrap().iter().collect();
    assert_eq!(
        files,
        [
            "pictures/timing-core.json",
            "datasheets/core.md",
            "datasheets/core.html",
            "pictures/core.svg",
            "pictures/timing-core.svg",
        ]
    );
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    let (markdown, html) = (read("datasheets/core.md"), read("datasheets/core.html"));
    for part in [
        "s_axis_photons_tdata",
        "under_way",
        "query_outside",
        "Known limitations",
    ] {
        assert!(markdown.contains(part) && html.contains(part), "{part}");
    }
    // Nothing is loaded from elsewhere.
    assert_eq!(html.matches("src=\"data:image/svg+xml;base64,").count(), 2);
    assert_eq!(html.matches("src=").count(), 2);
}

#[test]
fn an_unknown_family_and_a_folder_that_is_not_there_end_2() {
    assert!(error(&["datasheet", "tiles"], 2).contains("sequential"));
    let message = error(&["datasheet", "--check", "--out", "no-such-folder"], 2);
    assert!(message.contains("no-such-folder is no folder"), "{message}");
    assert!(!Path::new("no-such-folder").exists());
}
