//! Options and names as users give them, rightly and wrongly.

use super::{error, files_in};

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
