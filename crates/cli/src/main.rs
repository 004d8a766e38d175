//! `photoncube`: from a scene to a verified photon-mapping processor.

mod args;
mod chains;
mod commands;
mod core;
mod cores;
mod digests;
mod failure;
mod files;
mod fitted;
mod hardware;
mod interrupt;
mod machines;
mod measured;
mod measured_fits;
mod narrow;
mod output;
mod outputs;
mod own_program;
mod page;
mod pictures;
mod plots;
mod port;
mod progress;
mod project;
mod rows;
mod scenes;
mod shards;
mod sight;
mod stages;
mod synth;
mod table;
mod verified;

use std::process::ExitCode;

fn main() -> ExitCode {
    let args = args::Args::read();
    match commands::execute(args) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {}", failure::message(&error));
            failure::exit_code(&error)
        }
    }
}
