//! Options and names as users give them, rightly and wrongly.

use super::{error, files_in, json};

/// What no method and no engine would use is refused; every pair is a unit test of the arguments.
#[test]
fn an_option_that_is_not_used_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("x.png");
    let picture = picture.to_str().unwrap();
    let render = ["render", "cornell", "-o", picture];
    for (args, expected) in [
        (
            &["verify", "--lint", "--against", "icarus"][..],
            "`verify --lint` does not use --against",
        ),
        (
            &["verify", "--table", "--iterations", "7"],
            "`verify --table` does not use --iterations",
        ),
        (
            &[&render[..], &["--format", "local8-rgb8e5"]].concat(),
            "--format is for `render --engine format`",
        ),
        (
            &[&render[..], &["--engine", "f64", "--machine", "paper"]].concat(),
            "--machine is for `render --engine model`",
        ),
        (&["man", "--json"], "`man` has no JSON form"),
        (
            &["completions", "bash", "--json"],
            "`completions` has no JSON form",
        ),
    ] {
        let message = error(args, 2);
        assert!(message.contains(expected), "{args:?}: {message}");
    }
    assert_eq!(files_in(folder.path()), 0);
}

#[test]
fn a_negative_number_is_a_value_that_is_refused_with_the_range() {
    for (args, expected) in [
        (
            &["run", "--photons", "-5"][..],
            "expected a whole number from 1 to 134217728",
        ),
        (
            &["report", "--seed", "-1"],
            "expected a whole number from 0 to",
        ),
        (&["fit", "--noise-ratio", "-1"], "expected a number above 0"),
        (&["fit", "--size", "-16x16"], "expected WxH"),
        (
            &["verify", "--iterations", "-1e3"],
            "expected a whole number from 1;",
        ),
    ] {
        let message = error(args, 2);
        assert!(message.contains(expected), "{args:?}: {message}");
        assert!(
            !message.contains("unexpected argument"),
            "{args:?}: {message}"
        );
    }
}

#[test]
fn counts_are_read_in_short_forms() {
    let report = json(&["verify", "--iterations", "2e1"]);
    assert_eq!(report["iterations"], 20);
    let report = json(&["verify", "--iterations", "0.02k"]);
    assert_eq!(report["iterations"], 20);
}
