//! Runs a board's Verilog in Verilator, at the pins of its serial line, bit by bit.

use std::collections::VecDeque;
use std::io::{self, Read, Write};
use std::process::Command;

use photoncube_hdl::{Ulx3s, Ulx3sFiles};
use photoncube_spec::Serial;
use tempfile::TempDir;

use super::process::Process;
use super::simulation::hdl_error;
use super::verilator::{Sources, build_or_reuse};
use super::{DeviceError, scratch_folder};
use crate::tools::Tool;
use crate::trace::TRACE;

/// A board in a running Verilator simulation, and the other end of its serial line.
///
/// What is written is sent when something is read. A read then runs the simulation until a byte comes, or until none has come for the
/// clocks of [`Self::SILENT_BYTES`].
pub struct BoardSimulation {
    process: Process,
    clocks_of_bit: u32,
    clocks: u64,
    fault: u64,
    written: Vec<Symbol>,
    read: VecDeque<u8>,
    #[expect(dead_code, reason = "the folder lives as long as the process")]
    folder: TempDir,
}

/// What is sent in the time of a byte.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Symbol {
    /// A byte.
    Byte(u8),
    /// A byte without a stop bit, and a rest of two bits.
    Broken(u8),
    /// The board's button is pressed, for less than a bit.
    Reset,
}

impl Symbol {
    /// Its code for the harness: bit 8 says that there is no stop bit, bit 9 that it is the button.
    fn code(self) -> u16 {
        match self {
            Self::Byte(byte) => byte.into(),
            Self::Broken(byte) => u16::from(byte) | 1 << 8,
            Self::Reset => 1 << 9,
        }
    }
}

impl BoardSimulation {
    /// The times of a byte without a byte after which a read ends without one.
    pub const SILENT_BYTES: u64 = 64;

    /// Emits the Verilog of a board, compiles it unless the cache has it, and starts it.
    ///
    /// # Errors
    /// The board is not emitted, or Verilator or a C++ compiler is missing or refuses the text.
    pub fn new(board: &Ulx3s) -> Result<Self, DeviceError> {
        let files = board.files().map_err(hdl_error(board.core().machine))?;
        Self::of_files(board, &files)
    }

    /// As [`Self::new`], of these files of the board.
    ///
    /// # Errors
    /// Verilator or a C++ compiler is missing or refuses the text.
    pub fn of_files(board: &Ulx3s, files: &Ulx3sFiles) -> Result<Self, DeviceError> {
        let version = Tool::Verilator.version()?;
        let folder = scratch_folder()?;
        let clocks_of_bit = board.clocks_of_bit();
        let design = [
            &files.board,
            &files.pll_model,
            &files.core.text,
            &wrapper(&files.top),
        ];
        let sources = Sources {
            design: design.map(String::as_str).join("\n"),
            harness: HARNESS.replace("@CLOCKS@", &clocks_of_bit.to_string()),
            coverage: false,
        };
        let program = build_or_reuse(&sources, &version, folder.path())?;
        let mut command = Command::new(program);
        let process = Process::start(
            "verilator",
            command.current_dir(folder.path()),
            folder.path(),
        )?;
        Ok(Self {
            process,
            clocks_of_bit,
            clocks: 0,
            fault: 0,
            written: Vec::new(),
            read: VecDeque::new(),
            folder,
        })
    }

    /// The clocks since power-up.
    pub fn clocks(&self) -> u64 {
        self.clocks
    }

    /// Makes the planted fault of that number act from now on; 0 is none. See [`FAULT`].
    pub(crate) fn set_fault(&mut self, number: usize) {
        self.fault = number as u64;
    }

    /// Sends symbols, then runs until a byte has come, or none has for the time of so many bytes. Returns what has come.
    ///
    /// # Errors
    /// The simulation ends, or the board sends a byte without a stop bit.
    pub fn exchange(
        &mut self,
        symbols: &[Symbol],
        silent_bytes: u64,
    ) -> Result<Vec<u8>, DeviceError> {
        let clocks_of_byte = u64::from(self.clocks_of_bit * Serial::BITS_OF_BYTE);
        let mut frame = Vec::new();
        frame.extend((symbols.len() as u64).to_ne_bytes());
        frame.extend((silent_bytes * clocks_of_byte).to_ne_bytes());
        frame.extend(self.fault.to_ne_bytes());
        frame.extend(
            symbols
                .iter()
                .flat_map(|symbol| symbol.code().to_ne_bytes()),
        );
        let mut bytes = Vec::new();
        let clocks = &mut self.clocks;
        self.process.converse(
            |stdin| stdin.write_all(&frame),
            |stdout| {
                let mut number = [0; 8];
                stdout.read_exact(&mut number)?;
                bytes.resize(u64::from_ne_bytes(number) as usize, 0);
                stdout.read_exact(&mut number)?;
                *clocks = u64::from_ne_bytes(number);
                stdout.read_exact(&mut bytes)
            },
        )?;
        Ok(bytes)
    }
}

impl Write for BoardSimulation {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.written.extend(bytes.iter().copied().map(Symbol::Byte));
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Read for BoardSimulation {
    fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
        if self.read.is_empty() || !self.written.is_empty() {
            let written = std::mem::take(&mut self.written);
            let bytes = self.exchange(&written, Self::SILENT_BYTES);
            self.read.extend(bytes.map_err(io::Error::other)?);
        }
        match self.read.read(to)? {
            0 => Err(io::ErrorKind::TimedOut.into()),
            count => Ok(count),
        }
    }
}

/// The number of the planted fault that acts, as an expression in any module: a port of the top, which is [`TRACE`].
pub(crate) const FAULT: &str = "photoncube_trace.fault";

/// The top of simulations, around that of the board.
fn wrapper(top: &str) -> String {
    format!(
        "module {TRACE}(clock, button, fault, rx, tx);\n  \
         input wire clock;\n  \
         input wire button;\n  \
         input wire [7:0] fault;\n  \
         input wire rx;\n  \
         output wire tx;\n  \
         {top} board(.clk_25mhz(clock), .btn(button), .ftdi_txd(rx), .ftdi_rxd(tx), .led(), .wifi_gpio0());\n\
         endmodule\n"
    )
}

const HARNESS: &str = include_str!("board.cpp");
