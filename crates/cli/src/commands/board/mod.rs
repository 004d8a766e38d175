//! The command `board`: a core on a board, at the end of a serial line.

mod simulate;
mod ulx3s;

use anyhow::Result;

use crate::args::{BoardArgs, BoardCommand};

/// Makes or simulates a board.
pub fn execute(args: &BoardArgs, json: bool) -> Result<()> {
    match &args.command {
        BoardCommand::Ulx3s(args) => ulx3s::execute(args, json),
        BoardCommand::Simulate(args) => simulate::execute(args, json),
    }
}
