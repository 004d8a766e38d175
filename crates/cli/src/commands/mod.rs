//! The commands, one file each.

mod generate;
mod list;
mod microprogram;
mod render;
mod run;
mod verify;

use anyhow::Result;
use clap::CommandFactory;

use crate::args::{Args, Command};
use crate::output;

/// Does what the command line asks for.
pub fn execute(args: Args) -> Result<()> {
    let json = args.json;
    match args.command {
        Command::Run(options) => run::execute(&options, json),
        Command::List => list::execute(json),
        Command::Generate(options) => generate::execute(&options, json),
        Command::Verify(options) => verify::execute(&options, json),
        Command::Render(options) => render::execute(&options, json),
        Command::Microprogram(options) => microprogram::execute(&options, json),
        Command::Completions { shell } => {
            let mut command = Args::command();
            let mut text = Vec::new();
            clap_complete::generate(shell, &mut command, env!("CARGO_BIN_NAME"), &mut text);
            output::write(&String::from_utf8_lossy(&text))
        }
    }
}
