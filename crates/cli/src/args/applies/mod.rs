//! Which options a command uses, by the way in which it is told to work.
//!
//! `verify` has methods besides the plain comparison, `render` and `progressive` have three engines, and no way
//! of working uses every option. An option that is given and not used is refused: whoever reads the result would
//! take it for one that used it.

#[cfg(test)]
mod tests;

use clap::error::ErrorKind;
use clap::parser::ValueSource;
use clap::{ArgMatches, Command};

/// A way for a command to work: its name, and of the options that not every way uses those that it does.
type Way = (&'static str, &'static str);

/// The methods of `verify`. Each is an option of its own, but for the first, which needs none.
const METHODS: [Way; 12] = [
    ("equivalence", "machine against iterations seed record"),
    ("lint", "machine record"),
    ("fuzz", "reader from seed record"),
    ("coverage", "machine iterations seed record"),
    ("programs", "machine against seed record"),
    ("mutants", "machine part iterations seed record"),
    ("campaign", "hours state regressions record"),
    ("exhaustive", "against record"),
    ("faults", "machine against seed record"),
    ("formal", "machine property record"),
    ("placed", "machine against iterations seed record"),
    ("table", ""),
];

/// The values of `--engine`.
const ENGINES: [Way; 3] = [("model", "machine"), ("f64", ""), ("format", "format")];

/// What goes with `--machine`, wherever that does.
const OF_MACHINE: [&str; 2] = ["coordinate-bits", "dimension"];

/// Commands whose result is no object: a shell's script, manual pages.
const WITHOUT_JSON: [&str; 2] = ["completions", "man"];

/// A command that can work in several ways.
struct Choice {
    command: &'static str,
    /// The option whose value is the way; without it each way is an option.
    option: Option<&'static str>,
    ways: &'static [Way],
}

const CHOICES: [Choice; 3] = [
    Choice {
        command: "verify",
        option: None,
        ways: &METHODS,
    },
    Choice {
        command: "render",
        option: Some("engine"),
        ways: &ENGINES,
    },
    Choice {
        command: "progressive",
        option: Some("engine"),
        ways: &ENGINES,
    },
];

/// Refuses an option that was given and that the command does not use in the way that was chosen.
///
/// # Errors
/// Names the option, the way, what that way takes, and the ways that would use the option.
pub fn check(command: &mut Command, matches: &ArgMatches) -> Result<(), clap::Error> {
    let Some((name, matches)) = matches.subcommand() else {
        return Ok(());
    };
    if WITHOUT_JSON.contains(&name) && is_given(matches, "json") {
        let message = format!("`{name}` has no JSON form; leave out --json");
        return Err(command.error(ErrorKind::ArgumentConflict, message));
    }
    let Some(choice) = CHOICES.iter().find(|choice| choice.command == name) else {
        return Ok(());
    };
    let way = choice.chosen(matches);
    let unused = choice.ways.iter().flat_map(options);
    let unused = unused.filter(|option| !uses(way, option));
    let Some(option) = unused.into_iter().find(|option| is_given(matches, option)) else {
        return Ok(());
    };
    let command = command.find_subcommand_mut(name);
    let command = command.expect("the command line was read by it");
    Err(command.error(ErrorKind::ArgumentConflict, choice.refusal(way, option)))
}

/// The long names of the options that a way uses, of those that not every way does.
fn options(&(_, options): &Way) -> impl Iterator<Item = &'static str> + use<> {
    options.split_whitespace().flat_map(|option| {
        let with: &[&str] = if option == "machine" {
            &OF_MACHINE
        } else {
            &[]
        };
        std::iter::once(option).chain(with.iter().copied())
    })
}

fn uses(way: &Way, option: &str) -> bool {
    options(way).any(|used| used == option)
}

/// Whether the user gave an option; one that was not given may have a value by default.
fn is_given(matches: &ArgMatches, option: &str) -> bool {
    let source = matches.value_source(&option.replace('-', "_"));
    source == Some(ValueSource::CommandLine)
}

impl Choice {
    fn chosen(&self, matches: &ArgMatches) -> &'static Way {
        let is_chosen = |&&(name, _): &&Way| match self.option {
            Some(option) => {
                let mut value = matches.get_raw(option).into_iter().flatten();
                value.any(|value| value == name)
            }
            None => name != self.ways[0].0 && is_given(matches, name),
        };
        self.ways.iter().find(is_chosen).unwrap_or(&self.ways[0])
    }

    /// The way as it is written on the command line.
    fn written(&self, &(name, _): &Way) -> String {
        match self.option {
            Some(option) => format!("`{} --{option} {name}`", self.command),
            None if name == self.ways[0].0 => format!("`{}` without a method", self.command),
            None => format!("`{} --{name}`", self.command),
        }
    }

    fn refusal(&self, way: &Way, option: &str) -> String {
        let taken: Vec<_> = options(way).map(|name| format!("--{name}")).collect();
        let taken = match taken.is_empty() {
            true => "none of the options that others take".to_owned(),
            false => taken.join(", "),
        };
        let users = self.ways.iter().filter(|way| uses(way, option));
        let users: Vec<_> = users.map(|way| self.written(way)).collect();
        format!(
            "{} does not use --{option}: it takes {taken}; --{option} is for {}",
            self.written(way),
            users.join(", ")
        )
    }
}
