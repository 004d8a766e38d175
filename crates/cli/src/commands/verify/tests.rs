//! The list of methods: each has its files, its results and its page under its name.

use std::collections::BTreeSet;
use std::path::Path;

use clap::CommandFactory;

use super::*;
use crate::args;

fn exists(path: &str) -> bool {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    root.join(path).exists()
}

#[test]
fn each_method_has_a_file_and_a_test_of_its_name() {
    for Entry { name, .. } in METHODS {
        let source = format!("crates/cli/src/commands/verify/{name}");
        assert!(
            exists(&format!("{source}.rs")) || exists(&source),
            "no source of {name}"
        );
        let tests = [
            format!("testbenches/tests/{name}.rs"),
            format!("crates/cli/tests/{name}/mod.rs"),
        ];
        assert!(tests.iter().any(|test| exists(test)), "no test of {name}");
    }
}

#[test]
fn each_method_has_results_of_its_name() {
    let lines = verified::committed().unwrap().lines;
    let recorded: BTreeSet<_> = lines.iter().map(|line| line.method.as_str()).collect();
    let names = METHODS.map(|entry| entry.name);
    assert_eq!(recorded, BTreeSet::from(names));
}

#[test]
fn each_method_is_described_with_its_command() {
    let page = include_str!("../../../../../docs/verification.md");
    for Entry { name, .. } in METHODS {
        let command = format!("| `photoncube verify {name}");
        assert!(page.contains(&command), "docs/verification.md: {command}");
    }
}

#[test]
fn each_method_has_options_of_its_own_and_examples_that_are_read() {
    let command = args::Args::command();
    let verify = command.find_subcommand("verify").unwrap();
    for entry in METHODS {
        let method = verify.find_subcommand(entry.name).unwrap();
        assert!(method.get_about().is_some());
        let options: Vec<_> = method
            .get_arguments()
            .map(|a| a.get_id().as_str())
            .collect();
        assert!(options.contains(&"record"), "{}: {options:?}", entry.name);
        assert!(!entry.examples.is_empty());
        for example in entry.examples {
            args::Args::try_read(example.split_whitespace()).unwrap();
        }
    }
    let lint = verify.find_subcommand("lint").unwrap();
    assert!(
        lint.get_arguments()
            .all(|option| option.get_id() != "against")
    );
}

/// The command line of each recorded result is accepted.
#[test]
fn the_recorded_commands_are_taken() {
    let table = verified::committed().unwrap();
    for line in &table.lines {
        // The user chooses the duration of a campaign.
        let words = line.command.split_whitespace();
        let words = words.map(|word| if word == "H" { "1" } else { word });
        if let Err(error) = args::Args::try_read(words) {
            panic!("{}: {error}", line.command);
        }
    }
    assert!(!table.lines.is_empty());
}
