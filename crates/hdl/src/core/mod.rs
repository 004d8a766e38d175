//! The Verilog of cores: leaf machines behind AXI4-Stream and AXI4-Lite.
//!
//! The leaf machines are those of [`crate::emit`], their text unchanged. The modules around them only move words, count and answer accesses, and
//! are written here in Verilog: rust-hdl has no way to name ports as AXI does, and one text with a loop over the chains
//! serves every core. They follow the rules of [`photoncube_spec::Core`]; `photoncube verify core` compares them with the model, clock by clock.

mod chain;
mod header;
mod inputs;
mod registers;
mod results;
mod rounds;
mod rows;
mod stages;
mod top;
mod within;

use photoncube_spec::Core;
use verilog_eval::{Refusal, instances_in};

use crate::emit::{EmitError, Emitted, emit, sha256};
use crate::level::Level;

pub use rows::core_rows;
pub use within::core_within;

/// The Verilog of a core.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EmittedCore {
    /// The text of all modules, the top first.
    pub text: String,
    /// The name of the top module.
    pub top: String,
    /// The digest of the configuration, as in the registers `DigestLow` and `DigestHigh`: the first 64 bits of the SHA-256 of
    /// the chains' text, with the number of chains added.
    pub digest: u64,
    /// The chains.
    pub machine: Emitted,
}

impl EmittedCore {
    /// SHA-256 of the text without its comment lines, as in [`Emitted::verilog_sha256`].
    pub fn verilog_sha256(&self) -> String {
        sha256([self.text.as_str()])
    }

    /// SHA-256 of the text with the overrides for an ECP5, as in [`Emitted::ecp5_sha256`].
    pub fn ecp5_sha256(&self) -> String {
        let overrides = self.machine.ecp5_text.as_deref();
        sha256([self.text.as_str()].into_iter().chain(overrides))
    }
}

/// Verilator takes an always block as a whole. A block that computes a valid and a ready makes a loop for it with the block of the
/// other side; bit by bit there is none, which Yosys checks.
const NO_LOOPS: &str = "\
// Blocks that compute several signals look like loops to Verilator; bit by bit there is none.
// verilator lint_off UNOPTFLAT
";

/// The modules that do not depend on the core but by parameters.
const COMMON: [&str; 9] = [
    include_str!("slice.v"),
    include_str!("slice_part.v"),
    include_str!("place.v"),
    include_str!("link.v"),
    include_str!("stage.v"),
    include_str!("photon_port.v"),
    include_str!("queue.v"),
    include_str!("photon_queue.v"),
    include_str!("merge.v"),
];

/// Emits the Verilog of a core.
///
/// # Errors
/// Its leaf machine cannot be emitted.
pub fn emit_core(core: &Core) -> Result<EmittedCore, EmitError> {
    let machine = emit(core.machine, Level::Machine)?;
    let digest = digest(core, &machine);
    let top = core.top();
    let mut text = header::header(core, digest) + NO_LOOPS;
    text += &core_top(core);
    text += "\n";
    text += &registers::registers(core, digest);
    text += "\n";
    for common in COMMON {
        text += "\n";
        text += &common.replace("@TOP@", &top);
    }
    if let Some(rounds) = rounds::module(core) {
        text += "\n";
        text += &rounds;
    }
    text += "\n";
    text += &machine.text;
    Ok(EmittedCore {
        text,
        top,
        digest,
        machine,
    })
}

/// The instances in a core's top module, in the order of the text: the name of each, and the name of its module. They need no
/// generator of the core's leaf machine.
///
/// # Errors
/// The text of the module is outside the subset of Verilog that the built-in evaluator reads.
pub fn core_instances(core: &Core) -> Result<Vec<(String, String)>, Refusal> {
    instances_in(&core_top(core), &core.top())
}

/// The text of a core's top module alone.
fn core_top(core: &Core) -> String {
    top::top(core, &core.machine.module_prefix())
}

/// The digest of a core's configuration.
fn digest(core: &Core, machine: &Emitted) -> u64 {
    let sha256 = machine.verilog_sha256();
    let first = u64::from_str_radix(&sha256[..16], 16);
    first
        .expect("a digest has hexadecimal digits")
        .wrapping_add(core.chains.into())
}
