//! Runs a core's Verilog in Verilator over its ports: the harness offers words as fast as the core takes them, takes every result
//! at once, and reads the counters through AXI4-Lite. Nothing is compared here, so a picture takes seconds.

use std::io::{Read, Write};
use std::process::Command;

use photoncube_hdl::{core_within, emit_core};
use photoncube_spec::{
    Core, CoreAnswer, CoreRegister, CoreStreams, CoreWords, CounterRow, Direction, ResultWord,
    StreamWord,
};
use tempfile::TempDir;

use super::process::Process;
use super::simulation::hdl_error;
use super::verilator::{Sources, build_or_reuse};
use super::{DeviceError, scratch_folder};
use crate::tools::Tool;
use crate::trace::TRACE;

/// A core in a running Verilator simulation.
pub struct CoreSimulation {
    core: Core,
    results: StreamWord,
    process: Process,
    #[expect(dead_code, reason = "the folder lives as long as the process")]
    folder: TempDir,
}

/// The clock of the module that is simulated.
const CLOCK: &str = "aclk";

/// Bytes of a result beside its data: `tlast`, `tid`, `tuser`.
const RESULT_FLAGS: usize = 3;

impl CoreSimulation {
    /// Emits the core's Verilog, compiles it unless the cache has it, and starts it in a reset.
    ///
    /// # Errors
    /// The core is not emitted, or Verilator or a C++ compiler is missing or refuses the text.
    pub fn new(core: &Core) -> Result<Self, DeviceError> {
        let version = Tool::Verilator.version()?;
        let emitted = emit_core(core).map_err(hdl_error(core.machine))?;
        let folder = scratch_folder()?;
        let sources = Sources {
            design: emitted.text.clone() + &core_within(TRACE, CLOCK, core, &emitted),
            harness: harness(core, emitted.digest),
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
            core: *core,
            results: CoreStreams::of(core).results,
            process,
            folder,
        })
    }

    /// The core.
    pub fn core(&self) -> &Core {
        &self.core
    }

    /// Gives the core words, and waits until it has answered every query among them.
    ///
    /// # Errors
    /// The core hangs, or the simulation ends before its answer.
    pub fn exchange(&mut self, words: &CoreWords) -> Result<CoreAnswer, DeviceError> {
        let frame = frame(&self.core, words);
        let data_bytes = self.results.bits as usize / 8;
        let count = words.results();
        let silent_clocks = self.core.silent_clocks();
        let mut answer = CoreAnswer::default();
        self.process.converse(
            |stdin| stdin.write_all(&frame),
            |stdout| {
                let found = read_number(stdout)? as usize;
                let mut bytes = vec![0; found * (data_bytes + RESULT_FLAGS)];
                stdout.read_exact(&mut bytes)?;
                let words = bytes.chunks_exact(data_bytes + RESULT_FLAGS);
                answer.results = words.map(|word| result(word, data_bytes)).collect();
                for _ in CounterRow::ALL {
                    answer.counters.push(read_number(stdout)?);
                }
                match found == count {
                    true => Ok(()),
                    false => Err(std::io::Error::other(format!(
                        "the core moved no word for {silent_clocks} clocks, with {found} of {count} results"
                    ))),
                }
            },
        )?;
        Ok(answer)
    }
}

fn read_number(stdout: &mut impl Read) -> std::io::Result<u64> {
    let mut bytes = [0; 8];
    stdout.read_exact(&mut bytes)?;
    Ok(u64::from_ne_bytes(bytes))
}

fn result(word: &[u8], data_bytes: usize) -> ResultWord {
    let (data, flags) = word.split_at(data_bytes);
    ResultWord {
        data: data.to_vec(),
        last: flags[0] != 0,
        id: flags[1].into(),
        outside: flags[2] != 0,
    }
}

/// The words in bytes: the numbers of leaves, queries, results and registers to write; the address and the word of each register; each
/// word's data, `tlast` and `tdest`.
fn frame(core: &Core, words: &CoreWords) -> Vec<u8> {
    // The digest changes no address.
    let rows = CoreRegister::all(core, 0);
    let registers = words.rounds.registers(core);
    let counts = [
        words.photons.len(),
        words.queries.len(),
        words.results(),
        registers.len(),
    ];
    let mut frame = Vec::new();
    for count in counts {
        frame.extend((count as u64).to_ne_bytes());
    }
    for (register, word) in registers {
        let row = rows.iter().find(|row| row.register == register);
        let address = row.expect("the map has all registers").address;
        frame.extend([address, word].map(u32::to_ne_bytes).concat());
    }
    for beat in words.photons.iter().chain(&words.queries) {
        frame.extend(&beat.data);
        // A core has at most 16 chains.
        frame.extend([u8::from(beat.last), beat.dest as u8]);
    }
    frame
}

/// The C++ harness. It reads frames and answers each with the number of results, 8 bytes, the results and the counters. The first clock
/// of the simulation is a reset.
fn harness(core: &Core, digest: u64) -> String {
    let streams = CoreStreams::of(core);
    let rows = CoreRegister::all(core, digest);
    let address = |register| {
        let row = rows.iter().find(|row| row.register == register);
        row.expect("the map has all registers").address.to_string()
    };
    let counters: Vec<_> = CounterRow::ALL
        .iter()
        .map(|row| address(CoreRegister::CounterLow(row.counter)))
        .collect();
    let idle: String = core
        .ports()
        .iter()
        .filter(|port| port.direction == Direction::Input && port.width <= u64::BITS)
        .map(|port| format!("  top.{} = 0;\n", port.name))
        .collect();
    let parts = [
        ("PHOTON_BYTES", (streams.photons.bits / 8).to_string()),
        ("QUERY_BYTES", (streams.queries.bits / 8).to_string()),
        ("RESULT_BYTES", (streams.results.bits / 8).to_string()),
        ("SILENT", core.silent_clocks().to_string()),
        ("CONTROL", address(CoreRegister::Control)),
        ("CLEAR", CoreRegister::CLEAR_COUNTERS.to_string()),
        ("COUNTERS", counters.join(", ")),
        ("IDLE", idle),
    ];
    parts.iter().fold(HARNESS.to_owned(), |text, (name, part)| {
        text.replace(&format!("@{name}@"), part)
    })
}

const HARNESS: &str = include_str!("core.cpp");
