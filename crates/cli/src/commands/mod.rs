//! The commands of the program, one file each.

mod board;
mod compare;
mod datasheet;
mod fit;
mod generate;
mod hard_cases;
mod list;
mod merge;
mod microprogram;
mod plan;
mod progressive;
mod render;
mod report;
mod run;
mod setup;
mod synth;
mod verify;

use std::error::Error;
use std::path::{Path, PathBuf};

use anyhow::{Result, anyhow};
use clap::CommandFactory;
use clap_complete::Shell;
use photoncube_model::GatherError;
use photoncube_testbench::{StimulusError, VerifyError};

pub use self::datasheet::{Family, family_names};
pub use self::verify::{METHODS, VerifyArgs, WavesArgs, with_method};
use crate::args::{Args, Command};
use crate::{files, output, outputs};

/// Runs the command of the arguments.
pub fn execute(args: Args) -> Result<()> {
    let json = args.json;
    match args.command {
        Command::Run(options) => with_hint(run::execute(&options, json)),
        Command::Fit(options) => with_hint(fit::execute(&options, json)),
        Command::List(options) => list::execute(&options, json),
        Command::Datasheet(options) => datasheet::execute(&options, json),
        Command::Generate(options) => generate::execute(&options, json),
        Command::Verify(options) => verify::execute(&options, json),
        Command::Render(options) => with_hint(render::execute(&options, json)),
        Command::Progressive(options) => with_hint(progressive::execute(&options, json)),
        Command::Merge(options) => merge::execute(&options, json),
        Command::Compare(options) => compare::execute(&options, json),
        Command::Plan(options) => plan::execute(&options, json),
        Command::Report(options) => report::execute(&options, json),
        Command::HardCases(options) => hard_cases::execute(&options, json),
        Command::Synth(options) => synth::execute(&options, json),
        Command::Board(options) => board::execute(&options, json),
        Command::Microprogram(options) => microprogram::execute(&options, json),
        Command::Setup(options) => setup::execute(&options, json),
        Command::Completions { shell } => completions(shell),
        Command::Man { out } => manual(&out),
    }
}

/// Whether a query has more photons than the sums of a machine hold.
fn is_full(cause: &(dyn Error + 'static)) -> bool {
    // The errors of a verification show this cause as themselves, so it is not in the chain.
    let stimulus = match cause.downcast_ref() {
        Some(VerifyError::Stimulus(StimulusError::Gather(gather))) => Some(gather),
        _ => None,
    };
    let gather = stimulus.or_else(|| cause.downcast_ref());
    matches!(gather, Some(GatherError::Count(_)))
}

/// Adds to an error of too many photons the option that makes the sums of a machine larger.
fn with_hint(result: Result<()>) -> Result<()> {
    result.map_err(|error| match error.chain().any(is_full) {
        true => anyhow!("{error:#}: give a smaller --in-range"),
        false => error,
    })
}

fn completions(shell: Shell) -> Result<()> {
    let mut command = Args::command();
    let mut text = Vec::new();
    clap_complete::generate(shell, &mut command, env!("CARGO_BIN_NAME"), &mut text);
    output::write(&String::from_utf8_lossy(&text))
}

fn manual(out: &Path) -> Result<()> {
    outputs::check_folder("--out", out)?;
    let mut command = Args::command();
    command.build();
    let mut pages = Vec::new();
    pages_of(&command, out, &mut pages)?;
    files::write_all(pages.iter().map(|(path, text)| (path.clone(), &text[..])))
}

/// The pages of a command and of its subcommands, with their paths in a folder.
fn pages_of(
    command: &clap::Command,
    out: &Path,
    pages: &mut Vec<(PathBuf, Vec<u8>)>,
) -> Result<()> {
    let page = clap_mangen::Man::new(command.clone());
    let mut text = Vec::new();
    page.render(&mut text)?;
    pages.push((out.join(page.get_filename()), text));
    let commands = command.get_subcommands();
    let mut commands = commands.filter(|command| command.get_name() != "help");
    commands.try_for_each(|command| pages_of(command, out, pages))
}
