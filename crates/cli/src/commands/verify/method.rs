//! The one shape of a method of verification.

use std::fmt::Debug;

use anyhow::Result;
use clap::{ArgMatches, Args, Command};
use photoncube_testbench::Tool;

use super::outcome::Outcome;

/// A method of verification. Its options are the fields of the type that implements it.
pub trait Method: Args + Debug {
    /// The name: of its file or folder here, of its subcommand, of its test file, and of its lines in a table of
    /// results.
    const NAME: &'static str;
    /// A description of the method, for its help.
    const ABOUT: &'static str;
    /// Command lines of the method, for its help.
    const EXAMPLES: &'static [&'static str];

    /// Checks what needs no tool, before a tool is looked for.
    ///
    /// # Errors
    /// Options do not go together.
    fn check(&self) -> Result<()> {
        Ok(())
    }

    /// The external tools that it needs with these options.
    fn tools(&self) -> Vec<Tool>;

    /// Runs the method. An outcome cannot be made without a planted fault.
    ///
    /// # Errors
    /// The method cannot be run, or it ended at its first finding.
    fn run(&self) -> Result<Outcome>;
}

/// A method with its options.
pub trait Chosen: Debug {
    /// See [`Method::check`].
    fn check(&self) -> Result<()>;
    /// See [`Method::tools`].
    fn tools(&self) -> Vec<Tool>;
    /// See [`Method::run`].
    fn run(&self) -> Result<Outcome>;
}

impl<M: Method> Chosen for M {
    fn check(&self) -> Result<()> {
        Method::check(self)
    }

    fn tools(&self) -> Vec<Tool> {
        Method::tools(self)
    }

    fn run(&self) -> Result<Outcome> {
        Method::run(self)
    }
}

/// A row of the list of methods.
#[derive(Copy, Clone)]
pub struct Entry {
    /// See [`Method::NAME`].
    pub name: &'static str,
    about: &'static str,
    /// See [`Method::EXAMPLES`].
    pub examples: &'static [&'static str],
    augment: fn(Command) -> Command,
    read: fn(&ArgMatches) -> Result<Box<dyn Chosen>, clap::Error>,
}

impl Entry {
    /// The row of a method.
    pub const fn of<M: Method + 'static>() -> Self {
        Self {
            name: M::NAME,
            about: M::ABOUT,
            examples: M::EXAMPLES,
            augment: M::augment_args,
            read: |matches| Ok(Box::new(M::from_arg_matches(matches)?)),
        }
    }

    /// The subcommand of the method, with the method's options alone.
    pub fn command(&self) -> Command {
        (self.augment)(Command::new(self.name))
            .about(self.about)
            .after_help(format!("Examples:\n  {}", self.examples.join("\n  ")))
    }

    /// The method with the options of its subcommand.
    pub fn chosen(&self, matches: &ArgMatches) -> Result<Box<dyn Chosen>, clap::Error> {
        (self.read)(matches)
    }
}
