//! The command line.

use std::ffi::OsString;
use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Args as ClapArgs, CommandFactory, FromArgMatches, Parser, Subcommand};
use clap_complete::Shell;
use photoncube_render::{MAX_PIXELS, ViewOptions};
use photoncube_spec::{CustomOrganisation, nearest};

use self::numbers::with_negative_values;
use crate::commands::{VerifyArgs, family_names, with_method};
use crate::machines::MachineArgs;
use crate::narrow::WideArgs;
use crate::own_program::ProgramArgs;

mod applies;
mod board;
mod compare;
mod fit;
mod merge;
mod numbers;
#[cfg(test)]
mod pages;
mod picture;
mod plan;
mod progressive;
mod render;
mod report;
mod run;
mod synth;

pub use self::board::{BoardArgs, BoardCommand, SimulateArgs, Ulx3sArgs};
pub use self::compare::CompareArgs;
pub use self::fit::FitArgs;
pub use self::merge::MergeArgs;
pub use self::numbers::{count, seed, short};
pub use self::picture::PictureArgs;
pub use self::plan::PlanArgs;
pub use self::progressive::ProgressiveArgs;
pub use self::render::{EngineArgs, EngineReport, LightArgs, LightingReport, RenderArgs};
pub use self::report::ReportArgs;
pub use self::run::RunArgs;
pub use self::synth::SynthArgs;

/// From a scene to a verified photon-mapping processor.
///
/// Traces a scene, builds its photon map, emits the processor that gathers it as Verilog, compares
/// that Verilog with a golden model bit for bit, and renders the picture with that model.
#[derive(Parser, Debug)]
#[command(version, arg_required_else_help = true, after_help = EXAMPLES)]
pub struct Args {
    /// Print one JSON object on standard output, and nothing else there
    #[arg(long, global = true)]
    pub json: bool,
    #[command(subcommand)]
    pub command: Command,
}

impl Args {
    /// The arguments of this process. What is wrong with them is printed and ends it with code 2; so does, with
    /// code 0, what only asks for help.
    pub fn read() -> Self {
        let (words, hint) = with_method(std::env::args_os().collect());
        if let Some(hint) = hint {
            eprintln!("{hint}");
        }
        Self::try_read(words).unwrap_or_else(|error| error.exit())
    }

    /// The arguments in `words`, of which the first is the program's name.
    ///
    /// # Errors
    /// What clap refuses, and an option that the command does not use in the way that was chosen.
    pub fn try_read<T: Into<OsString>>(
        words: impl IntoIterator<Item = T>,
    ) -> Result<Self, clap::Error> {
        let mut command = with_negative_values(Self::command());
        let (words, _) = with_method(words.into_iter().map(Into::into).collect());
        let matches = command.try_get_matches_from_mut(&words);
        let matches = matches.map_err(|error| with_tip(error, &command, &words))?;
        applies::check(&mut command, &matches)?;
        Self::from_arg_matches(&matches).map_err(|error| error.format(&mut command))
    }
}

/// Adds what was probably meant to an error.
fn with_tip(mut error: clap::Error, command: &clap::Command, words: &[OsString]) -> clap::Error {
    let invalid = error.get(ContextKind::InvalidArg).map(ToString::to_string);
    let of_command = words.get(1).and_then(|name| command.find_subcommand(name));
    let has_scene = of_command.is_some_and(|command| {
        let mut arguments = command.get_arguments();
        arguments.any(|argument| argument.get_id() == "scene")
    });
    let is_unknown = error.kind() == ErrorKind::UnknownArgument;
    if is_unknown && has_scene && invalid.as_deref() == Some("--scene") {
        let tip = "a scene needs no option: give its name or its file alone";
        error.insert(
            ContextKind::Suggested,
            ContextValue::StyledStrs(vec![tip.into()]),
        );
    }
    with_nearest_command(error, command, words)
}

/// Adds the nearest command to the error about an unknown one, where clap, which looks for letters at nearly the same places, found none.
fn with_nearest_command(
    mut error: clap::Error,
    command: &clap::Command,
    words: &[OsString],
) -> clap::Error {
    let found = words.get(1).map(|word| word.to_string_lossy());
    let is_unknown = error.kind() == ErrorKind::InvalidSubcommand
        && error.get(ContextKind::SuggestedSubcommand).is_none();
    let names = command.get_subcommands().map(clap::Command::get_name);
    if let (true, Some(name)) = (is_unknown, found.and_then(|found| nearest(&found, names))) {
        let suggested = ContextValue::Strings(vec![name.to_owned()]);
        error.insert(ContextKind::SuggestedSubcommand, suggested);
    }
    error
}

const EXAMPLES: &str = "\
Examples:
  photoncube run                                  the whole path on the built-in Cornell box
  photoncube fit ring                             the smallest machine that the scene needs
  photoncube verify --against verilator --iterations 1000000
  photoncube generate --machine paper --out /tmp/verilog
  photoncube datasheet --html --out sheets        ports, timing, area, clock of each family
  photoncube render cornell -o box.png --engine f64
  photoncube progressive cornell -o box.png --error-target 0.1
  photoncube report ring                          formats by error and speed, with a plot
  photoncube plan cornell                         how many chains of how many engines
  photoncube hard-cases                           what breaks other arithmetic, and not this
  photoncube synth --machine paper                area and clock, by Yosys and nextpnr
  photoncube board ulx3s --out board              a bitstream for a board, with a serial line
  photoncube microprogram --machine paper-5d

Exit codes: 0 all holds; 1 a check failed; 2 bad usage or bad input.";

/// What to do.
#[derive(Subcommand, Debug)]
pub enum Command {
    /// Trace, build the photon map, emit the machine, compare its Verilog on this scene, render
    Run(RunArgs),
    /// Find the smallest photon format and machine whose error stays below a part of the noise
    Fit(FitArgs),
    /// List the scenes and the machines, each with its figures; or print the datasheet of one machine or core
    List(ListArgs),
    /// Write the datasheets of the families of machines, with pictures of the hardware and timing diagrams
    Datasheet(DatasheetArgs),
    /// Write the Verilog of the machines, with project files for Yosys and Quartus
    Generate(GenerateArgs),
    /// Verify a machine by one of several methods; without one, compare it with the golden model, bit for bit
    Verify(VerifyArgs),
    /// Render a scene to a picture
    Render(RenderArgs),
    /// Render a picture that gets better pass by pass, until its error is as small as asked for
    Progressive(ProgressiveArgs),
    /// Put the state files of shards together: the file that one machine would have written
    Merge(MergeArgs),
    /// How far a picture is from another: relMSE, and a map of the error
    Compare(CompareArgs),
    /// Forecast the photon tests of a picture's queries on a chip, by the size of leaves, chains and batches
    Plan(PlanArgs),
    /// Speed against error: every photon format and machine on a scene, as a table and a plot
    Report(ReportArgs),
    /// Run the inputs at which some arithmetic is known to fail, in every photon format
    HardCases(HardCasesArgs),
    /// Area and clock of the machines by Yosys and nextpnr: LUTs, gates, Fmax, what binds it
    Synth(SynthArgs),
    /// Put a core on a board, at the end of a serial line: its bitstream, or a simulation with a pseudo-terminal
    Board(BoardArgs),
    /// Print a microprogram: listing by clock, utilisation, and the schedule checker's verdict
    Microprogram(MicroprogramArgs),
    /// Install the simulators, Yosys and what places and routes, each in its pinned version
    Setup(SetupArgs),
    /// Print the completions for a shell
    Completions {
        /// The shell
        shell: Shell,
    },
    /// Write the manual pages, one for each command
    Man {
        /// The folder to write
        #[arg(long, default_value = "man", value_name = "DIR")]
        out: PathBuf,
    },
}

/// `list`
#[derive(ClapArgs, Debug)]
#[command(after_help = "\
Examples:
  photoncube list
  photoncube list stream                   its ports, numbers, clocks, area, Fmax, and how it was verified
  photoncube list --wide                   every figure of every machine, far wider than a terminal
  photoncube list core-6-leaf-7-local7-rgb6d-n4096
  photoncube list tile-6 --json")]
pub struct ListArgs {
    /// Only this machine or core, with its datasheet
    #[arg(value_name = "MACHINE")]
    pub machine: Option<String>,
    #[command(flatten)]
    pub wide: WideArgs,
}

/// `datasheet`
#[derive(ClapArgs, Debug)]
#[command(after_help = "\
Examples:
  photoncube datasheet                     all datasheets and pictures into docs/
  photoncube datasheet --check             fails where docs/ is not what would be written
  photoncube datasheet tile --html --out sheets

A datasheet is DIR/datasheets/FAMILY.md, its pictures are in DIR/pictures: cell, hypercube, tile and
core from the specification, and timing diagrams from the golden model, as SVG and as WaveJSON.
--html also writes DIR/datasheets/FAMILY.html, one file with the pictures in it. `photoncube list
MACHINE` names the family of a machine.")]
pub struct DatasheetArgs {
    /// Only this family [default: all, and the overview of the hardware]
    #[arg(value_name = "FAMILY", value_parser = family_names())]
    pub family: Option<String>,
    /// The folder to write
    #[arg(long, default_value = "docs", value_name = "DIR")]
    pub out: PathBuf,
    /// Also write each datasheet as one HTML file
    #[arg(long)]
    pub html: bool,
    /// Write nothing; fail if the folder holds anything else than would be written
    #[arg(long)]
    pub check: bool,
}

/// `generate`
#[derive(ClapArgs, Debug)]
#[command(after_help = "\
Examples:
  photoncube generate                      all named machines into hdl-out/
  photoncube generate --check              fails where hdl-out/ is not what would be written
  photoncube generate --machine paper --coordinate-bits 12 --out /tmp/verilog
  photoncube generate --machine paper-5d --program mine.txt --out /tmp/verilog
  photoncube generate --format local6x2-rgb4d-n4096 --organisation stream --out /tmp/verilog
  photoncube generate --machine leaf-7-local7-rgb6d-n4096 --chains 4 --out /tmp/verilog

With --chains: a core of that many leaf machines behind AXI4-Stream and AXI4-Lite, with its
registers in SystemRDL and the words of its streams in JSON.

With --program: a sequential machine, `paper` where --machine names none, with the microprogram of
a listing as `photoncube microprogram` prints it. What the schedule checker rejects is not written.
The machine is named after the file, as paper-program-mine; `verify --program FILE` compares it.

A machine of a format of one's own is compiled when it is used for the first time, by cargo and
from the sources of photoncube. Its name, such as stream-local6x2-rgb4d-n4096, is accepted by
--machine of every command.")]
pub struct GenerateArgs {
    /// Only this machine [default: all]
    #[arg(long, value_name = "M")]
    pub machine: Option<String>,
    /// The variant of it with coordinates of N bits
    #[arg(long, value_name = "N", requires = "machine")]
    pub coordinate_bits: Option<u32>,
    /// The variant of it on a hypercube of N dimensions
    #[arg(long, value_name = "N", requires = "machine")]
    pub dimension: Option<u32>,
    #[command(flatten)]
    pub program: ProgramArgs,
    /// A machine of this photon format, by name (see docs/formats.md)
    #[arg(
        long,
        value_name = "F",
        requires = "organisation",
        conflicts_with_all = ["machine", "program"]
    )]
    pub format: Option<String>,
    /// The organisation of the machine of that format: sequential, stream, stream-shallow, tile-4 to tile-10, tile-4-shallow to
    /// tile-10-shallow, tile-4-fine to tile-10-fine, leaf-4 to leaf-10, or leaf-4-radii to leaf-10-radii
    #[arg(long, value_name = "O", requires = "format", value_parser = CustomOrganisation::from_name)]
    pub organisation: Option<CustomOrganisation>,
    /// A core of N of this leaf machine, behind AXI4-Stream and AXI4-Lite
    #[arg(long, value_name = "N", conflicts_with = "program")]
    pub chains: Option<u32>,
    /// The folder to write, one folder in it for each machine
    #[arg(long, default_value = "hdl-out", value_name = "DIR")]
    pub out: PathBuf,
    /// Write nothing; fail if the folder holds anything else than would be written
    #[arg(long)]
    pub check: bool,
}

/// `hard-cases`
#[derive(ClapArgs, Debug)]
#[command(after_help = "\
Examples:
  photoncube hard-cases
  photoncube hard-cases --format local7x1-mono8 --json

For each case: what could break, the result in the worst format, its bound and why, and as contrast
what an arithmetic that is known to fail gives on the same input. A row fails where the result is
past its bound, or where, in all formats together, the contrast is not bad enough to be one.")]
pub struct HardCasesArgs {
    /// Only this photon format (see `photoncube list`; any legal name is one) [default: all of them]
    #[arg(long, value_name = "F")]
    pub format: Option<String>,
    #[command(flatten)]
    pub wide: WideArgs,
}

/// `setup`
#[derive(ClapArgs, Debug)]
#[command(after_help = "\
Examples:
  photoncube setup                 simulators, Yosys, and what checks cores
  photoncube setup --synthesis     also nextpnr, for `synth` and `board`
  photoncube setup --where         the folder of the programs from PyPI; installs nothing

From the distribution, which must be Debian 12 or have its versions: Icarus Verilog, Verilator,
Yosys, g++, make, Python. From PyPI, in environments of their own in the user's cache: Yosys,
pyslang, cocotb, PeakRDL, FuseSoC, LiteX, mdBook. What is there is not changed. This is
`scripts/setup.sh` of the project, which has more options.")]
pub struct SetupArgs {
    /// Also what places and routes: nextpnr for ECP5 and iCE40
    #[arg(long)]
    pub synthesis: bool,
    /// Also what `synth --asic` needs: OpenSTA and the standard cells osu018
    #[arg(long)]
    pub asic: bool,
    /// Also ccache, which shortens repeated Verilator builds
    #[arg(long)]
    pub ccache: bool,
    /// Only mdBook; this needs Python 3 with venv, and no Debian
    #[arg(long, conflicts_with_all = ["synthesis", "asic", "ccache"])]
    pub book: bool,
    /// Install nothing: print the folder of the programs, or fail if they are not there
    #[arg(long = "where", conflicts_with_all = ["synthesis", "asic", "ccache"])]
    pub place: bool,
}

/// `microprogram`
#[derive(ClapArgs, Debug)]
#[command(after_help = "\
Examples:
  photoncube microprogram
  photoncube microprogram --machine paper-5d --json
  photoncube microprogram > mine.txt           a listing to change: docs/microprograms.md
  photoncube microprogram --file mine.txt      check it (exit 1 if rejected)
  photoncube generate --program mine.txt --out /tmp/verilog       the machine that runs it
  photoncube verify --program mine.txt         compare that machine with the golden model")]
pub struct MicroprogramArgs {
    #[command(flatten)]
    pub machine: MachineArgs,
    /// A listing to check for that machine's network, instead of the machine's own
    #[arg(long, value_name = "FILE")]
    pub file: Option<PathBuf>,
}

/// Pixels a picture may have in one direction; it bounds memory.
const MAX_SIDE: u32 = 16_384;

/// A picture's size in pixels, written WxH.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Size {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

impl Size {
    fn of(view: &ViewOptions) -> Self {
        Self {
            width: view.width,
            height: view.height,
        }
    }
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width, self.height)
    }
}

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let side = |text: &str| {
            let side = text.parse().ok();
            side.filter(|side| (1..=MAX_SIDE).contains(side))
        };
        let size = text.split_once('x').and_then(|(width, height)| {
            Some(Self {
                width: side(width)?,
                height: side(height)?,
            })
        });
        size.filter(|size| u64::from(size.width) * u64::from(size.height) <= MAX_PIXELS)
            .ok_or_else(|| {
                format!(
                    "expected WxH, each from 1 to {MAX_SIDE} and at most {MAX_PIXELS} pixels, such as 256x256"
                )
            })
    }
}
