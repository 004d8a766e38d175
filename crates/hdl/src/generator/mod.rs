//! Generators of custom machines.
//!
//! rust-hdl's widths are const generics, so a machine whose widths are not compiled into this program needs a program of
//! its own. The *generator* of a machine is a small crate that names the widths and calls [`serve`]. This module writes
//! the crate, builds it with cargo, keeps the program in the user's cache under the digest of all its sources, and asks
//! it for what [`crate::emit`] and the simulation need. The named machines are rows of the same two functions,
//! [`sequential`], [`spatial`] and [`leaf`].

mod cache;
mod cargo;
mod package;
mod protocol;
mod serve;

use std::path::PathBuf;
use std::process::Command;

use photoncube_spec::{Machine, Pins, find_machine};
use serde::de::DeserializeOwned;
use thiserror::Error;

use crate::build::NotBuiltIn;
use crate::cache::CacheError;
use crate::emit::{Emitted, Linted};
use crate::level::Level;
use crate::pinned::with_registers;
use protocol::{Design, EMIT, LINT, SIMULATE};

pub use crate::build::{sequential, spatial};
pub use crate::leaf::leaf;
pub use crate::pinned::MachineBlock;
pub use serve::serve;

/// Builds the block of a machine at a level; `None` where the machine has no such level.
pub type Build = fn(&Machine, Level) -> Option<MachineBlock>;

/// The reason why the generator of a custom machine does not work.
#[derive(Debug, Error)]
pub enum GeneratorError {
    /// The machine is neither compiled in nor a custom machine.
    #[error(transparent)]
    NotBuiltIn(#[from] NotBuiltIn),
    /// cargo could not be started.
    #[error(
        "machine `{machine}` needs a generator, which cargo builds: cannot start {cargo}: {reason}; install Rust by rustup, \
         or set CARGO to the path of cargo"
    )]
    NoCargo {
        /// The name of the machine.
        machine: &'static str,
        /// The program that was tried.
        cargo: String,
        /// The error of the operating system.
        reason: String,
    },
    /// cargo could not build the generator.
    #[error("cargo cannot build the generator of machine `{machine}` in {folder}:\n{said}")]
    NotBuilt {
        /// The name of the machine.
        machine: &'static str,
        /// The folder of the generator's crate.
        folder: String,
        /// The last lines of cargo.
        said: String,
    },
    /// A file of the cache cannot be read or written.
    #[error(transparent)]
    Cache(#[from] CacheError),
    /// The generator ran and ended with an error.
    #[error("the generator of machine `{machine}` failed: {said}")]
    Failed {
        /// The name of the machine.
        machine: &'static str,
        /// The output of the generator.
        said: String,
    },
}

/// The steps of making a generator, for a progress bar.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step {
    /// cargo compiles a crate; the first generator compiles about a hundred, later ones compile one.
    Compiles(String),
}

/// The generator of a custom machine: built where the cache has none of today's sources, else the cached program.
/// `progress` is told what cargo does.
///
/// # Errors
/// The sources or cargo are missing, or the generator cannot be built or stored.
pub fn prepare(
    machine: &Machine,
    progress: &mut dyn FnMut(&Step),
) -> Result<PathBuf, GeneratorError> {
    let custom = find_machine(machine.name)
        .ok()
        .filter(|found| *found == machine);
    let custom = custom.ok_or_else(|| NotBuiltIn::of(machine, Level::Machine))?;
    cache::program(custom, progress)
}

/// The command that simulates a level of a custom machine in rust-hdl. It reads frames of rows from its standard input and
/// answers with rows on its standard output: a frame is a number of clocks, in 4 bytes, and their rows of inputs; all
/// numbers are little-endian, and a value of a row has 8 bytes.
///
/// # Errors
/// As [`prepare`].
pub fn simulation(machine: &Machine, level: Level) -> Result<Command, GeneratorError> {
    let mut command = Command::new(prepare(machine, &mut |_| ())?);
    command.args([SIMULATE, level.name()]);
    Ok(command)
}

/// Emits a level of a custom machine.
pub(crate) fn emit(machine: &Machine, level: Level) -> Result<Emitted, GeneratorError> {
    let design: Design = ask(machine, &[EMIT, level.name()])?;
    let outputs = design.outputs.len();
    let pins = match level {
        Level::Machine => Pins::of(machine),
        part => {
            let ports = Pins {
                inputs: design.inputs.into_iter().map(protocol::pin).collect(),
                observed: design.outputs.into_iter().map(protocol::pin).collect(),
                outputs,
            };
            with_registers(ports, machine, part)
        }
    };
    Ok(Emitted {
        text: design.text,
        top: design.top,
        ecp5_text: design.ecp5_text,
        clocked: level.is_clocked(),
        pins,
        register_paths: design.register_paths,
        block_rams: design.block_rams,
    })
}

/// Lints a custom machine.
pub(crate) fn lint(machine: &Machine) -> Result<Linted, GeneratorError> {
    ask(machine, &[LINT])
}

/// The answer of the generator, from JSON.
fn ask<T: DeserializeOwned>(machine: &Machine, arguments: &[&str]) -> Result<T, GeneratorError> {
    let program = prepare(machine, &mut |_| ())?;
    let failed = |said: String| GeneratorError::Failed {
        machine: machine.name,
        said,
    };
    let output = Command::new(program).args(arguments).output();
    let output = output.map_err(|error| failed(error.to_string()))?;
    if !output.status.success() {
        return Err(failed(String::from_utf8_lossy(&output.stderr).into_owned()));
    }
    serde_json::from_slice(&output.stdout).map_err(|error| failed(error.to_string()))
}
