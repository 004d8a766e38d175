//! The options that a command with `--engine` uses, by its engine.
//!
//! `render` and `progressive` have engines, none of which uses every option. An option that is given and not
//! used is refused: whoever reads the result would take it for one that used it.

use clap::error::ErrorKind;
use clap::parser::ValueSource;
use clap::{ArgMatches, Command};

/// A value of `--engine`: its name, and of the options that not every engine uses those that it does.
type Engine = (&'static str, &'static [&'static str]);

const ENGINES: [Engine; 4] = [
    ("model", &["machine", "coordinate-bits", "dimension"]),
    ("f64", &[]),
    ("format", &["format"]),
    ("core", &["machine", "port", "baud"]),
];

/// The commands with `--engine`.
const COMMANDS: [&str; 2] = ["render", "progressive"];

/// Commands whose result is no object: a shell's script, manual pages.
const WITHOUT_JSON: [&str; 2] = ["completions", "man"];

/// Refuses an option that was given and that the command does not use with its engine.
///
/// # Errors
/// Names the option, the engine, what that engine takes, and the engines that would use the option.
pub fn check(command: &mut Command, matches: &ArgMatches) -> Result<(), clap::Error> {
    let Some((name, matches)) = matches.subcommand() else {
        return Ok(());
    };
    if WITHOUT_JSON.contains(&name) && is_given(matches, "json") {
        let message = format!("`{name}` has no JSON form; leave out --json");
        return Err(command.error(ErrorKind::ArgumentConflict, message));
    }
    if !COMMANDS.contains(&name) {
        return Ok(());
    }
    let is_chosen = |engine: &&Engine| {
        let mut value = matches.get_raw("engine").into_iter().flatten();
        value.any(|value| value == engine.0)
    };
    let engine = ENGINES.iter().find(is_chosen).unwrap_or(&ENGINES[0]);
    let options = ENGINES.iter().flat_map(|engine| engine.1);
    let mut unused = options.filter(|option| !engine.1.contains(option));
    let Some(option) = unused.find(|option| is_given(matches, option)) else {
        return Ok(());
    };
    let refusal = refusal(name, engine, option);
    let command = command.find_subcommand_mut(name);
    let command = command.expect("the command line was read by it");
    Err(command.error(ErrorKind::ArgumentConflict, refusal))
}

/// Whether the user gave an option; one that was not given may have a value by default.
fn is_given(matches: &ArgMatches, option: &str) -> bool {
    let source = matches.value_source(&option.replace('-', "_"));
    source == Some(ValueSource::CommandLine)
}

fn refusal(command: &str, (engine, taken): &Engine, option: &str) -> String {
    let taken: Vec<_> = taken.iter().map(|name| format!("--{name}")).collect();
    let taken = match taken.is_empty() {
        true => "none of the options that others take".to_owned(),
        false => taken.join(", "),
    };
    let users = ENGINES.iter().filter(|engine| engine.1.contains(&option));
    let users: Vec<_> = users
        .map(|(engine, _)| format!("`{command} --engine {engine}`"))
        .collect();
    format!(
        "`{command} --engine {engine}` does not use --{option}: it takes {taken}; --{option} is for {}",
        users.join(", ")
    )
}

#[cfg(test)]
mod tests {
    use crate::args::Args;

    /// The arguments that the code of each engine reads, as an independent table.
    const USED: &str = "
                machine coordinate-bits dimension format port
    model       x       x               x         .      .
    f64         .       .               .         .      .
    format      .       .               .         x      .
    core        x       .               .         .      x
    ";

    /// Of every row and every column of the table: both names, and whether there is a cross.
    fn pairs() -> Vec<(&'static str, &'static str, bool)> {
        let mut lines = USED.lines().filter(|line| !line.trim().is_empty());
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

    fn read(words: &[&str]) -> Result<Args, clap::Error> {
        Args::try_read([&["photoncube"], words].concat())
    }

    #[test]
    fn an_option_is_taken_where_it_is_used_and_refused_elsewhere() {
        let mut counts = [0, 0];
        for (engine, option, is_used) in pairs() {
            let long = format!("--{option}");
            let value = match option {
                "machine" => "paper",
                "format" => "local8-rgb8e5",
                _ => "5",
            };
            let words = ["render", "cornell", "-o", "x.png", "--engine", engine];
            let words = [&words[..], &[&long, value]].concat();
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
        assert_eq!(counts, [14, 6]);
    }

    #[test]
    fn a_refusal_names_the_engine_what_it_takes_and_where_the_option_is_used() {
        let words = [
            "progressive",
            "ring",
            "-o",
            "x.png",
            "--format",
            "local8-rgb8e5",
        ];
        let said = read(&words).unwrap_err().to_string();
        assert!(
            said.contains(
                "`progressive --engine model` does not use --format: it takes --machine, \
                 --coordinate-bits, --dimension; --format is for `progressive --engine format`"
            ),
            "{said}"
        );
        let words = ["render", "ring", "-o", "x.png", "--engine", "f64"];
        let said = read(&[&words[..], &["--machine", "paper"]].concat()).unwrap_err();
        let expected = "it takes none of the options that others take";
        assert!(said.to_string().contains(expected), "{said}");
    }
}
