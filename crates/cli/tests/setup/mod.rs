//! Tests `setup`, without an installation: it needs a network.

use std::fs;
use std::path::Path;

use assert_cmd::Command;

use super::photoncube;

/// `setup` outside of any clone, with tools in the folder.
fn setup(args: &[&str], tools: &Path) -> Command {
    let mut command = photoncube(&[&["setup"], args].concat());
    command.current_dir(tools).env("PHOTONCUBE_TOOLS", tools);
    command
}

#[test]
fn the_place_of_the_tools_is_known_outside_of_a_clone() {
    let tools = tempfile::tempdir().unwrap();
    for options in [&["--where"][..], &["--where", "--book"]] {
        let output = setup(options, tools.path()).assert().code(1);
        let said = String::from_utf8(output.get_output().stderr.clone()).unwrap();
        assert!(
            said.contains("error: the tools are not installed; leave out --where"),
            "{said}"
        );
        // The script names the folder, which has another name for other versions.
        let folder = said
            .split("found no ")
            .nth(1)
            .unwrap()
            .split(';')
            .next()
            .unwrap();
        assert!(Path::new(folder).starts_with(tools.path()), "{folder}");
        fs::create_dir_all(folder).unwrap();
        fs::write(Path::new(folder).join("complete"), "").unwrap();
        setup(options, tools.path())
            .assert()
            .success()
            .stdout(format!("{folder}/bin\n"));
        let options = [options, &["--json"]].concat();
        let output = setup(&options, tools.path()).assert().success();
        let report: serde_json::Value =
            serde_json::from_slice(&output.get_output().stdout).unwrap();
        assert_eq!(
            report,
            serde_json::json!({ "tools": format!("{folder}/bin") })
        );
    }
}

#[test]
fn what_does_not_fit_together_is_refused() {
    let tools = tempfile::tempdir().unwrap();
    for options in [["--where", "--synthesis"], ["--book", "--ccache"]] {
        setup(&options, tools.path()).assert().code(2);
    }
    assert_eq!(fs::read_dir(tools.path()).unwrap().count(), 0);
}
