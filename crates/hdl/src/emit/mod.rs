//! The only code that makes Verilog.
//!
//! rust-hdl prints one module for each *instance*. This module checks the design (with rust-hdl's checks and
//! our lint), prints the module of each different block, and merges equal modules, bottom-up, under readable names.
//! The result is plain Verilog-2001, and every run gives the same text.

mod channels;
mod checks;
mod digest;
mod distinct;
mod ecp5;
mod header;
mod merge;
mod modules;

use photoncube_spec::{CellTables, Machine, Pins, SignalPlace};
use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::build::{NotBuiltIn, build};
use crate::generator::{self, GeneratorError};
use crate::level::Level;
use crate::pinned::{Pinned, pins};
use crate::registers::{Answer, Ask};
use crate::unit::{Unit, build_unit, label, unit_pins};

pub(crate) use channels::ChannelNames;
use checks::check;
pub(crate) use digest::sha256;
use header::{header, override_header, unit_header};

pub(crate) use checks::lint_block;
pub use checks::{Linted, lint_control, lint_machine};
pub(crate) use header::push;
pub use header::{generate_command, interface_text, ports_text};

/// Emitted Verilog, with the data that a simulation of it needs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Emitted {
    /// The Verilog text of all modules.
    pub text: String,
    /// The name of the top module.
    pub top: String,
    /// Overrides: second texts of some modules, made of an ECP5's carry cells, DSP blocks and block RAMs,
    /// which Yosys does not infer in this way. `None` where no module has one. `scripts/yosys/ecp5.sh` proves
    /// that each equals its module.
    pub ecp5_text: Option<String>,
    /// Whether the top has a `clock` pin.
    pub clocked: bool,
    /// The pins, under the names that they have in the text.
    pub pins: Pins,
    /// The path of each observed register in the top instance, in the order of
    /// `pins.observed[pins.outputs..]`.
    pub register_paths: Vec<String>,
    /// The memories whose words have no initial value.
    pub block_rams: Vec<BlockRam>,
}

/// A memory in an emitted design whose words have no initial value. The golden model's memory starts as
/// zeros, and registers store what is read from it. A simulation must therefore fill the memory with zeros
/// before the first clock.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct BlockRam {
    /// The path of the array in the top instance.
    pub path: String,
    /// The number of words.
    pub words: usize,
}

impl Emitted {
    /// SHA-256 of the text without its comment lines, in hexadecimal digits. A recorded result is about the
    /// text with this digest. `grep -v '^ *//' FILE.v | sha256sum` prints it.
    pub fn verilog_sha256(&self) -> String {
        sha256([self.text.as_str()])
    }

    /// SHA-256 of the text that is synthesised for an ECP5: the text, then its overrides if it has any,
    /// without comment lines, as in [`Self::verilog_sha256`].
    pub fn ecp5_sha256(&self) -> String {
        sha256(
            [self.text.as_str()]
                .into_iter()
                .chain(self.ecp5_text.as_deref()),
        )
    }
}

/// The reason why a design is not emitted.
#[derive(Debug, Error)]
pub enum EmitError {
    /// The unit's widths are not compiled in.
    #[error(transparent)]
    NotBuiltIn(#[from] NotBuiltIn),
    /// The machine is not compiled in, and has no generator either.
    #[error(transparent)]
    Generator(#[from] GeneratorError),
    /// rust-hdl's own checks found an open signal, a loop or an input that is written.
    #[error("the design of machine `{machine}` does not pass rust-hdl's checks: {reason}")]
    Check {
        /// The name of the machine.
        machine: String,
        /// The message of rust-hdl.
        reason: String,
    },
    /// The lint found a statement whose Verilog may differ from its Rust.
    #[error("the design of machine `{machine}` does not pass the lint:\n{findings}")]
    Lint {
        /// The name of the machine.
        machine: String,
        /// The lint's findings, one a line.
        findings: String,
    },
    /// Two names of one module would be mapped to one name.
    #[error("module `{module}`: `{first}` and `{second}` would both be named `{name}`; rename one")]
    Name {
        /// The module with the two names.
        module: String,
        /// The first of the two names.
        first: String,
        /// The second of the two names.
        second: String,
        /// The name that both would have in the text.
        name: String,
    },
}

/// Emits the Verilog of a machine at a level.
///
/// # Errors
/// The machine is neither built in nor has a generator, or the design does not pass the checks or the lint.
pub fn emit(machine: &Machine, level: Level) -> Result<Emitted, EmitError> {
    match build(machine, level) {
        Ok(block) => emit_block(machine, level, block.as_ref()),
        Err(_) => Ok(generator::emit(machine, level)?),
    }
}

/// Emits the Verilog of a block, which is a machine at a level.
pub(crate) fn emit_block(
    machine: &Machine,
    level: Level,
    block: &dyn Pinned,
) -> Result<Emitted, EmitError> {
    let prefix = match level {
        Level::Machine => machine.module_prefix(),
        part => format!("{}_{}", machine.module_prefix(), part.name()),
    };
    let channels = ChannelNames::of(machine);
    let part = level.name();
    let merged = printed([machine.name, part], block, &prefix, &channels)?;
    let pins = match level {
        Level::Machine => Pins::of(machine),
        part => pins(block, machine, part),
    };
    Ok(Emitted {
        ecp5_text: ecp5::second_texts(&merged)
            .map(|texts| override_header(machine, &texts) + &texts),
        text: header(machine, level) + &merged,
        top: prefix,
        clocked: level.is_clocked(),
        register_paths: pins.observed[pins.outputs..]
            .iter()
            .map(|pin| {
                let own = block.register(pin.place, Ask::Path);
                own.map(Answer::path).unwrap_or_else(|| {
                    let tables = machine.cell().expect("it has cells");
                    register_path(tables, level, pin.place)
                })
            })
            .collect(),
        block_rams: block.block_rams(),
        pins,
    })
}

/// Emits the Verilog of a unit on its own, with operands of `bits` bits. A simulation observes only its
/// outputs.
///
/// # Errors
/// The unit is not built at that width, or does not pass the checks or the lint.
pub fn emit_unit(unit: Unit, bits: u32) -> Result<Emitted, EmitError> {
    let block = build_unit(unit, bits)?;
    let name = label(unit, bits);
    let top = format!("photoncube_{name}");
    let names = [name.as_str(), unit.name()];
    let merged = printed(names, block.as_ref(), &top, &ChannelNames::none())?;
    Ok(Emitted {
        text: unit_header(&format!("The unit {unit}, {bits}-bit operands.")) + &merged,
        top,
        ecp5_text: None,
        clocked: unit.is_clocked(),
        pins: unit_pins(unit, bits)?,
        register_paths: Vec::new(),
        block_rams: Vec::new(),
    })
}

/// The text of a block that has passed the checks and the lint, with merged modules named after the top.
/// Messages name the machine or unit; the list of blocks written by hand has the names of blocks.
fn printed(
    [name, part]: [&str; 2],
    block: &dyn Pinned,
    top: &str,
    channels: &ChannelNames,
) -> Result<String, EmitError> {
    check(name, part, block)?;
    let blocks = distinct::distinct(block, TOP);
    let modules = blocks.iter().map(|different| different.module(&blocks));
    merge::merge(modules.collect(), TOP, top, channels)
}

/// The name under which rust-hdl prints the outermost block.
const TOP: &str = "top";

/// The path of a register of a machine with a program. Registers are instances of a register module, whose
/// output is `q`.
fn register_path(tables: &CellTables, level: Level, place: SignalPlace) -> String {
    match place {
        SignalPlace::Control(index) => format!("control.{}.q", tables.control_registers[index]),
        SignalPlace::Cell { node, register } => {
            let name = tables.register(register).name;
            match level {
                Level::Cell => format!("{name}.q"),
                _ => format!("cell_{node}.{name}.q"),
            }
        }
        _ => unreachable!("a spatial machine knows its registers, and pins are none"),
    }
}
