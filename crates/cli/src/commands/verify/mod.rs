//! The command `verify`: verifies a machine by one of several methods.

mod campaign;
mod coverage;
mod equivalence;
mod exhaustive;
mod faults;
mod formal;
mod fuzz;
mod lint;
mod mutants;
mod placed;
mod programs;

use std::collections::BTreeSet;

use anyhow::Result;

use crate::args::VerifyArgs;
use crate::failure::CheckFailed;
use crate::{output, verified};

pub use self::equivalence::{verdict_table, verify_with_bar};

/// Runs the requested method.
pub fn execute(args: &VerifyArgs, json: bool) -> Result<()> {
    if args.table {
        return results(json);
    }
    if args.lint {
        return lint::execute(args, json);
    }
    if let (true, Some(hours)) = (args.campaign, args.hours) {
        return campaign::execute(args, hours, json);
    }
    if args.coverage {
        return coverage::execute(args, json);
    }
    if let Some(wanted) = args.mutants {
        return mutants::execute(args, wanted, json);
    }
    if let Some(programs) = args.programs {
        return programs::execute(args, programs, json);
    }
    if args.exhaustive {
        return exhaustive::execute(args, json);
    }
    if args.faults {
        return faults::execute(args, json);
    }
    if args.formal {
        return formal::execute(args, json);
    }
    if args.placed {
        return placed::execute(args, json);
    }
    if let Some(inputs) = args.fuzz {
        return fuzz::execute(args, inputs, json);
    }
    equivalence::execute(args, json)
}

/// Prints the results about today's Verilog. Fails if there are results about other Verilog, which are not
/// printed.
fn results(json: bool) -> Result<()> {
    let table = verified::committed()?;
    output::print(json, &table, || verified::table(&table.lines))?;
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
