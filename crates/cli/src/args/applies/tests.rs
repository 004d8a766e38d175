//! Every method of `verify` and every engine with every option.

use clap::CommandFactory;

use super::*;
use crate::args::Args;

/// What each method's code reads of its arguments, written here a second time.
const VERIFY: &str = "
            machine against iterations seed record reader from hours state regressions property part
equivalence x       x       x          x    x      .      .    .     .     .           .        .
lint        x       .       .          .    x      .      .    .     .     .           .        .
fuzz        .       .       .          x    x      x      x    .     .     .           .        .
coverage    x       .       x          x    x      .      .    .     .     .           .        .
programs    x       x       .          x    x      .      .    .     .     .           .        .
mutants     x       .       x          x    x      .      .    .     .     .           .        x
campaign    .       .       .          .    x      .      .    x     x     x           .        .
exhaustive  .       x       .          .    x      .      .    .     .     .           .        .
faults      x       x       .          x    x      .      .    .     .     .           .        .
formal      x       .       .          .    x      .      .    .     .     .           x        .
placed      x       x       x          x    x      .      .    .     .     .           .        .
table       .       .       .          .    .      .      .    .     .     .           .        .
";

const RENDER: &str = "
            machine coordinate-bits dimension format
model       x       x               x         .
f64         .       .               .         .
format      .       .               .         x
";

/// Of every row and every column of a table: both names, and whether there is a cross.
fn pairs(table: &'static str) -> Vec<(&'static str, &'static str, bool)> {
    let mut lines = table.trim_matches('\n').lines();
    let header: Vec<_> = lines.next().unwrap().split_whitespace().collect();
    let mut pairs = Vec::new();
    for line in lines {
        let mut words = line.split_whitespace();
        let name = words.next().unwrap();
        let cells: Vec<_> = words.collect();
        assert_eq!(cells.len(), header.len(), "{line}");
        let cells = header.iter().zip(cells);
        pairs.extend(cells.map(|(option, cell)| (name, *option, cell == "x")));
    }
    pairs
}

/// A value that the option can have.
fn value(option: &str) -> &'static str {
    match option {
        "machine" => "paper",
        "against" => "text",
        "reader" => "listing",
        "property" => "units",
        "part" => "memory",
        "format" => "local8-rgb8e5",
        "hours" | "from" => "0",
        "record" | "state" | "regressions" => "file",
        _ => "5",
    }
}

fn method(name: &'static str) -> Vec<&'static str> {
    match name {
        "equivalence" => vec!["verify"],
        "lint" => vec!["verify", "--lint"],
        "fuzz" => vec!["verify", "--fuzz", "1"],
        "coverage" => vec!["verify", "--coverage"],
        "programs" => vec!["verify", "--programs", "1"],
        "mutants" => vec!["verify", "--mutants", "1"],
        "campaign" => vec!["verify", "--campaign", "--hours", "0"],
        "exhaustive" => vec!["verify", "--exhaustive"],
        "faults" => vec!["verify", "--faults"],
        "formal" => vec!["verify", "--formal"],
        "placed" => vec!["verify", "--placed"],
        "table" => vec!["verify", "--table"],
        engine => vec!["render", "cornell", "-o", "x.png", "--engine", engine],
    }
}

fn read(words: &[&str]) -> Result<Args, clap::Error> {
    Args::try_read([&["photoncube"], words].concat())
}

#[test]
fn an_option_is_taken_where_it_is_used_and_refused_elsewhere() {
    let mut counts = [0, 0];
    for (name, option, is_used) in [VERIFY, RENDER].into_iter().flat_map(pairs) {
        let mut words = method(name);
        let long = format!("--{option}");
        if !words.contains(&long.as_str()) {
            words.extend([&long, value(option)]);
        }
        counts[usize::from(is_used)] += 1;
        match (read(&words), is_used) {
            (Ok(_), true) => {}
            (Err(error), false) => {
                let message = error.to_string();
                assert!(
                    message.contains(&format!("does not use {long}: ")),
                    "{words:?}: {message}"
                );
                assert_eq!(error.exit_code(), 2);
            }
            (result, _) => panic!("{words:?}: {result:?}"),
        }
    }
    assert!(counts.iter().all(|count| *count > 10), "{counts:?}");
}

#[test]
fn a_refusal_names_the_method_what_it_takes_and_where_the_option_is_used() {
    let message = |words: &[&str]| read(words).unwrap_err().to_string();
    let said = message(&["verify", "--lint", "--against", "icarus"]);
    assert!(
        said.contains(
            "`verify --lint` does not use --against: it takes --machine, --coordinate-bits, --dimension, --record; --against is for \
             `verify` without a method, `verify --programs`, `verify --exhaustive`, `verify --faults`"
        ),
        "{said}"
    );
    let said = message(&["verify", "--property", "units::"]);
    assert!(
        said.contains("`verify` without a method does not use --property"),
        "{said}"
    );
    let said = message(&[
        "progressive",
        "ring",
        "-o",
        "x.png",
        "--format",
        "local8-rgb8e5",
    ]);
    assert!(
        said.contains(
            "`progressive --engine model` does not use --format: it takes --machine, \
             --coordinate-bits, --dimension; --format is for `progressive --engine format`"
        ),
        "{said}"
    );
    let said = message(&["verify", "--table", "--json", "--seed", "1"]);
    assert!(
        said.contains("it takes none of the options that others take"),
        "{said}"
    );
}

/// A new option of `verify` is in the table of this file, or the first test does not know it.
#[test]
fn the_table_has_every_option_and_every_method() {
    let command = Args::command();
    let verify = command.find_subcommand("verify").unwrap();
    let pairs = pairs(VERIFY);
    let is_known = |name: &str| {
        pairs
            .iter()
            .any(|(row, column, _)| name == *row || name == *column)
    };
    let mut count = 0;
    for argument in verify.get_arguments() {
        let name = argument.get_long().unwrap();
        count += 1;
        assert!(is_known(name) || OF_MACHINE.contains(&name), "--{name}");
    }
    assert!(count > 20, "{count}");
    // Names of the tables are names of options, so that no row is about nothing.
    let ids: Vec<_> = verify
        .get_arguments()
        .map(|a| a.get_long().unwrap())
        .collect();
    let named = METHODS[1..].iter().map(|way| way.0);
    for name in named.chain(METHODS.iter().flat_map(options)) {
        assert!(ids.contains(&name), "{name}");
    }
}

/// What the table of results says to run again can be run.
#[test]
fn the_recorded_commands_are_taken() {
    let lines = include_str!("../../../../../docs/measured/verification.json");
    let mut taken = 0;
    for line in crate::verified::parse(lines).unwrap() {
        let words: Vec<_> = line.command.split_whitespace().collect();
        // A campaign takes as long as one likes.
        let words = words
            .into_iter()
            .map(|word| if word == "H" { "1" } else { word });
        if let Err(error) = Args::try_read(words) {
            panic!("{}: {error}", line.command);
        }
        taken += 1;
    }
    assert!(taken > 100, "{taken}");
}
