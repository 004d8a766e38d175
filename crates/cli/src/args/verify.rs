//! The arguments of `verify`.

use std::path::PathBuf;

use clap::{ArgGroup, Args as ClapArgs};

use crate::machines::MachineArgs;

/// `verify`
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
  photoncube verify --coverage --machine stream
  photoncube verify --formal --machine paper
  photoncube verify --table             what was verified so far, as docs/verification.md has it"
)]
pub struct VerifyArgs {
    #[command(flatten)]
    pub machine: MachineArgs,
    /// What to compare the golden model with: rust-hdl, text, icarus, verilator, netlist; comma-separated, or all
    #[arg(
        long,
        default_value = "rust-hdl,text",
        value_name = "LIST",
        value_delimiter = ','
    )]
    pub against: Vec<String>,
    /// Iterations (groups of photons) to compare in each
    #[arg(long, default_value_t = 20_000, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub iterations: u64,
    /// Seed of the stimulus
    #[arg(long, default_value_t = 1, value_name = "S")]
    pub seed: u64,
    /// Put what was found into this table of results, a JSON file
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,
    /// Show the lint every planted mistake, in which Rust and Verilog differ, and what replaces it
    #[arg(long, group = "method")]
    pub lint: bool,
    /// Give everything that reads scenes, meshes, listings, pictures, tables and command lines N inputs that are
    /// nearly right: it must read or refuse them, and never panic, hang or take memory without bound
    #[arg(long, group = "method", value_name = "N", value_parser = clap::value_parser!(u64).range(1..1 << 39))]
    pub fuzz: Option<u64>,
    /// Only the reader of that name
    #[arg(long, requires = "fuzz", value_name = "NAME")]
    pub reader: Option<String>,
    /// Begin with that input
    #[arg(long, requires = "fuzz", default_value_t = 0, value_name = "I", value_parser = clap::value_parser!(u64).range(..1 << 39))]
    pub from: u64,
    /// Count what a verification in Verilator uses of the emitted lines, branches and bits, and list what it does not
    #[arg(long, group = "method")]
    pub coverage: bool,
    /// Prove properties of the emitted text for all inputs, by Yosys: units, control block, streams, sums, and each
    /// module against its netlist; for `paper`, `overlap` and `stream`
    #[arg(long, group = "method")]
    pub formal: bool,
    /// Only the properties whose names begin so
    #[arg(long, requires = "formal", value_name = "NAME")]
    pub property: Option<String>,
    /// Print the committed table of results, and verify nothing
    #[arg(long, group = "method")]
    pub table: bool,
}
