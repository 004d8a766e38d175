//! The command `verify`: finds out in one of several ways whether a machine, or the program itself, is right.
//!
//! A way is a [`method::Method`] in a file or folder of its name and a row of [`METHODS`]. The subcommands, the order of the
//! table of results and the names in it are those of the rows.

mod campaign;
mod core;
mod coverage;
mod equivalence;
mod exhaustive;
mod faults;
mod formal;
mod fuzz;
mod lint;
mod method;
mod mutants;
mod old_flags;
mod options;
mod outcome;
mod placed;
mod programs;
#[cfg(test)]
mod tests;
mod waves;

use std::collections::BTreeSet;
use std::path::PathBuf;

use anyhow::Result;
use clap::{Arg, ArgMatches, Args, Command, FromArgMatches, value_parser};

use crate::failure::CheckFailed;
use crate::narrow::WideArgs;
use crate::{output, verified};

use self::core::CoreMethod;
pub use self::equivalence::{verdict_table, verify_with_bar};
pub use self::old_flags::with_method;
pub use self::waves::{WavesArgs, Written};
use campaign::Campaign;
use coverage::Coverage;
use equivalence::Equivalence;
use exhaustive::Exhaustive;
use faults::Faults;
use formal::Formal;
use fuzz::Fuzz;
use lint::Lint;
use method::{Chosen, Entry};
use mutants::Mutants;
use placed::Placed;
use programs::Programs;

/// All methods. The first is the one of `verify` without a method.
pub const METHODS: [Entry; 12] = [
    Entry::of::<Equivalence>(),
    Entry::of::<Lint>(),
    Entry::of::<Exhaustive>(),
    Entry::of::<Faults>(),
    Entry::of::<Programs>(),
    Entry::of::<Coverage>(),
    Entry::of::<Mutants>(),
    Entry::of::<Campaign>(),
    Entry::of::<Formal>(),
    Entry::of::<Placed>(),
    Entry::of::<CoreMethod>(),
    Entry::of::<Fuzz>(),
];

/// The subcommand that prints the table of results.
const TABLE: &str = "table";

/// `verify`
#[derive(Debug)]
pub struct VerifyArgs {
    /// The method; `None` for the table of results.
    method: Option<Box<dyn Chosen>>,
    record: Option<PathBuf>,
    wide: WideArgs,
}

impl Args for VerifyArgs {
    fn augment_args(command: Command) -> Command {
        let record = Arg::new("record")
            .long("record")
            .value_name("FILE")
            .value_parser(value_parser!(PathBuf))
            .help("Put what was found into this table of results, a JSON file, if the run passes");
        let methods = METHODS.map(|entry| WideArgs::augment_args(entry.command().arg(&record)));
        let table = Command::new(TABLE).about(
            "Print the committed table of results, docs/measured/verification.md; verifies nothing",
        );
        let table = WideArgs::augment_args(table);
        let examples = METHODS.map(|entry| format!("\n  {}", entry.examples[0]));
        command
            .subcommand_required(true)
            .override_usage("photoncube verify [METHOD] [OPTIONS]")
            .subcommand_value_name("METHOD")
            .subcommand_help_heading("Methods")
            .subcommands(methods)
            .subcommand(table)
            .after_help(format!(
                "Without METHOD it is {}, with its options.\n\nExamples:\n  photoncube verify{}",
                METHODS[0].name,
                examples.concat()
            ))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for VerifyArgs {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let (name, matches) = matches.subcommand().unwrap_or((TABLE, matches));
        let wide = WideArgs::from_arg_matches(matches)?;
        let Some(entry) = METHODS.iter().find(|entry| entry.name == name) else {
            let (method, record) = (None, None);
            return Ok(Self {
                method,
                record,
                wide,
            });
        };
        Ok(Self {
            method: Some(entry.chosen(matches)?),
            record: matches.get_one("record").cloned(),
            wide,
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// Runs the method, prints its outcome, and records it if it passes.
pub fn execute(args: &VerifyArgs, json: bool) -> Result<()> {
    let Some(method) = &args.method else {
        return results(json, args.wide);
    };
    method.check()?;
    if let Some(missing) = method.tools().iter().find_map(|tool| tool.find().err()) {
        return Err(missing.into());
    }
    let outcome = method.run()?;
    output::print_tables(json, args.wide, &outcome, || outcome.text())?;
    outcome.conclusion()?;
    match &args.record {
        Some(path) => verified::record(path, outcome.recorded()),
        None => Ok(()),
    }
}

/// Prints the results about today's Verilog. Fails if there are results about other Verilog, which are not
/// printed.
fn results(json: bool, wide: WideArgs) -> Result<()> {
    let table = verified::committed()?;
    output::print_tables(json, wide, &table, || verified::table(&table.lines))?;
    let stale: BTreeSet<_> = table
        .stale
        .iter()
        .map(|line| line.command.as_str())
        .collect();
    if stale.is_empty() {
        return Ok(());
    }
    Err(CheckFailed(format!(
        "{} results in docs/measured/verification.json are about other Verilog than that in hdl-out and \
         are left out; run these again, with --record:\n{}",
        table.stale.len(),
        stale.into_iter().collect::<Vec<_>>().join("\n")
    ))
    .into())
}
