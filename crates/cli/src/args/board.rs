//! The arguments of `board`.

use std::path::PathBuf;

use anyhow::Result;
use clap::{Args as ClapArgs, Subcommand};
use photoncube_hdl::Ulx3s;
use photoncube_spec::CORES;

use crate::machines::{self, CoreArgs};

/// `board`
#[derive(ClapArgs, Debug)]
#[command(after_help = "\
Examples:
  photoncube board ulx3s --out board                the sources, a bitstream, and what it takes
  photoncube board ulx3s --out board --no-build     the sources alone
  photoncube board simulate                         prints the path PATH of a serial line
  photoncube render cornell -o core.png --engine core --port PATH \\
      --machine leaf-5-local7-rgb6d-n64 --chains 3  (in another terminal)

docs/board.md has the whole way to a board. It was never tried on one: what works here ends at the
pins of the FPGA, in simulation.")]
pub struct BoardArgs {
    /// What to do
    #[command(subcommand)]
    pub command: BoardCommand,
}

/// What to do with a board.
#[derive(Subcommand, Debug)]
pub enum BoardCommand {
    /// Write the Verilog and the constraints of a core on a ULX3S (ECP5 85F), and make its bitstream
    Ulx3s(Ulx3sArgs),
    /// Simulate the same Verilog in Verilator, with its serial line at a pseudo-terminal
    Simulate(SimulateArgs),
}

/// The core on a board.
#[derive(ClapArgs, Clone, Debug)]
pub struct OnBoardArgs {
    /// The leaf machine of each chain
    #[arg(long, value_name = "M", default_value = CORES[0].1)]
    pub machine: String,
    #[command(flatten)]
    pub core: CoreArgs,
}

impl OnBoardArgs {
    /// The board at that clock, behind a line of so many bits a second. The generator of its machine is built.
    pub fn board(&self, mhz: u32, baud: u32) -> Result<Ulx3s> {
        let core = self.core.find(&self.machine)?;
        let board = Ulx3s::new(&core, mhz, baud)?;
        machines::prepare(core.machine)?;
        Ok(board)
    }
}

/// `board ulx3s`
#[derive(ClapArgs, Debug)]
#[command(after_help = "\
Examples:
  photoncube board ulx3s --out board
  photoncube board ulx3s --machine leaf-6-local7-rgb6d-n1024 --chains 2 --mhz 60 --out board --json
  photoncube board ulx3s --out board --no-build

Yosys maps the core, nextpnr places and routes it in the package CABGA381 at speed grade 6, ecppack
writes the bitstream; minutes for a small core. A core that the FPGA cannot hold, or that does not
reach the clock, ends with exit code 1, and no bitstream is written.
`photoncube setup --synthesis` installs the tools.")]
pub struct Ulx3sArgs {
    #[command(flatten)]
    pub on_board: OnBoardArgs,
    /// The clock of the core in MHz, which a PLL makes
    #[arg(long, default_value_t = 50, value_name = "F")]
    pub mhz: u32,
    /// Bits a second on the serial line
    #[arg(long, default_value_t = Ulx3s::BAUD, value_name = "N")]
    pub baud: u32,
    /// The folder to write
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Write the sources alone
    #[arg(long)]
    pub no_build: bool,
    /// The seed of placement
    #[arg(
        long,
        default_value_t = 1,
        value_name = "S",
        conflicts_with = "no_build"
    )]
    pub seed: u32,
    /// The folder of the tools [default: where `photoncube setup --synthesis` installed them]
    #[arg(long, value_name = "DIR", conflicts_with = "no_build")]
    pub tools: Option<PathBuf>,
}

/// `board simulate`
#[derive(ClapArgs, Debug)]
#[command(after_help = "\
Examples:
  photoncube board simulate
  photoncube board simulate --machine leaf-5-local7-rgb6d-n64 --chains 3 --json

The Verilog is that of `board ulx3s`; only the PLL is a model. It runs until it is ended (Ctrl-C). A
simulation takes as long as its clocks, so the line is the fastest of the slowest clock.
Pseudo-terminals are there on Linux and on other Unix systems.")]
pub struct SimulateArgs {
    #[command(flatten)]
    pub on_board: OnBoardArgs,
    /// The clock of the core in MHz
    #[arg(long, default_value_t = Ulx3s::BOARD_MHZ, value_name = "F")]
    pub mhz: u32,
    /// Bits a second on the serial line
    #[arg(long, default_value_t = Ulx3s::MOST_BAUD, value_name = "N")]
    pub baud: u32,
}
