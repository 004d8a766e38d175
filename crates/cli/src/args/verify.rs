//! The arguments of `verify`.

use std::path::PathBuf;

use clap::{ArgGroup, Args as ClapArgs};

use super::numbers::{count, seed};
use crate::machines::MachineArgs;

/// `verify`. Which method uses which option stands in `applies`.
#[derive(ClapArgs, Debug)]
#[command(
    group = ArgGroup::new("method"),
    after_help = "\
Examples:
  photoncube verify                     in rust-hdl, and the emitted text; needs no tool
  photoncube verify --against icarus,verilator --iterations 2000
  photoncube verify --against verilator --iterations 1000000 --json
  photoncube verify --machine paper-5d --against all --seed 7
  photoncube verify --fuzz 100000       everything that reads files, on wrong ones
  photoncube verify --coverage --machine stream --iterations 200000
  photoncube verify --programs 1000 --machine paper-5d --against text
  photoncube verify --mutants 700 --machine overlap
  photoncube verify --campaign --hours 8          all machines; the next one goes on with it
  photoncube verify --exhaustive        all inputs of what is finite
  photoncube verify --faults --machine overlap    needs Icarus
  photoncube verify --formal --machine paper
  photoncube verify --placed --machine stream     needs Yosys of scripts/setup.sh --synthesis, and Verilator
  photoncube verify --table             what was verified so far; docs/measured/verification.md"
)]
pub struct VerifyArgs {
    #[command(flatten)]
    pub machine: MachineArgs,
    /// What to compare the golden model with: rust-hdl, text, icarus, verilator, netlist; comma-separated, or all
    /// [default: rust-hdl,text; with --programs text; with --exhaustive and --faults verilator, or text where that is
    /// missing]
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub against: Option<Vec<String>>,
    /// Iterations (groups of photons) to compare in each
    #[arg(long, default_value_t = 20_000, value_name = "N", value_parser = count(1..=u64::MAX))]
    pub iterations: u64,
    /// Seed of the stimulus
    #[arg(long, default_value_t = 1, value_name = "S", value_parser = seed)]
    pub seed: u64,
    /// Put what was found into this table of results, a JSON file
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,
    /// Check that every statement of the machine which rust-hdl generates means in Verilog what it means in Rust
    #[arg(long, group = "method")]
    pub lint: bool,
    /// Give everything that reads scenes, meshes, listings, pictures, tables and command lines N inputs that are
    /// nearly right: it must read or refuse them, and never panic, hang or take memory without bound
    #[arg(long, group = "method", value_name = "N", value_parser = count(1..=(1_u64 << 39) - 1))]
    pub fuzz: Option<u64>,
    /// Only the reader of that name
    #[arg(long, value_name = "NAME")]
    pub reader: Option<String>,
    /// Begin with that input
    #[arg(long, default_value_t = 0, value_name = "I", value_parser = count(0..=(1_u64 << 39) - 1))]
    pub from: u64,
    /// Count what a verification in Verilator uses of the emitted lines, branches and bits, and list what it does not
    #[arg(long, group = "method")]
    pub coverage: bool,
    /// Draw N different microprograms, gathers and any others that end, and compare each in one cell and in the
    /// machine; one that differs is made as short as it can be
    #[arg(long, group = "method", value_name = "N", value_parser = count(1..=(1_u64 << 20) - 1))]
    pub programs: Option<u64>,
    /// Plant about N mutations in the emitted Verilog, one at a time, and see whether the stimulus finds each.
    /// Each mutant that is not found in --iterations must be proven equivalent; otherwise the run fails
    #[arg(long, group = "method", value_name = "N", value_parser = count(1..=(1_u64 << 15) - 1))]
    pub mutants: Option<u64>,
    /// Only that part of the machine, for itself: memory, whose --iterations are clocks
    #[arg(long, value_name = "NAME")]
    pub part: Option<String>,
    /// Verify all machines with seed after seed, on all cores; what is done stands in the file of --state, so that a
    /// campaign that was stopped or killed goes on, and a difference becomes a regression case
    #[arg(long, group = "method", requires = "hours")]
    pub campaign: bool,
    /// Begin no job of about 20 seconds after so long; 0: print what the campaign has done
    #[arg(long, value_name = "H", value_parser = hours)]
    pub hours: Option<f64>,
    /// The state of the campaign
    #[arg(long, value_name = "FILE", default_value = "out/campaign.json")]
    pub state: PathBuf,
    /// Where regression cases are kept; `cargo test` replays those of this folder
    #[arg(long, value_name = "DIR", default_value = "testbenches/regressions")]
    pub regressions: PathBuf,
    /// Every pair of inputs of every unit at 6 and at 8 bits, and every difference with every radius at 8 bits through
    /// the lanes of a machine
    #[arg(long, group = "method")]
    pub exhaustive: bool,
    /// Faults from outside, by class: streams that wait at random, long and in patterns, a reset in every clock of a query;
    /// and in Icarus, whatever --against says, unknown words on idle pins and power-up without reset
    #[arg(long, group = "method")]
    pub faults: bool,
    /// Prove properties of the emitted text for all inputs, by Yosys: units, control block, streams, sums, and each
    /// module against its netlist
    #[arg(long, group = "method")]
    pub formal: bool,
    /// Only the properties whose names begin so; the result of some is not recorded
    #[arg(long, conflicts_with = "record", value_name = "NAME")]
    pub property: Option<String>,
    /// Map the machine as `synth` does for an ECP5, prove the passes over its netlist, and simulate the netlist as Yosys
    /// makes it and after each pass, with models of its cells; the last is what is placed. --against takes verilator and
    /// icarus
    #[arg(long, group = "method")]
    pub placed: bool,
    /// Print the committed table of results, and verify nothing
    #[arg(long, group = "method")]
    pub table: bool,
}

/// A time that a clock can hold.
fn hours(text: &str) -> Result<f64, String> {
    let hours: f64 = text.parse().map_err(|_| "expected a number".to_owned())?;
    match (0.0..=24.0 * 366.0).contains(&hours) {
        true => Ok(hours),
        false => Err("expected 0 up to a year".to_owned()),
    }
}
