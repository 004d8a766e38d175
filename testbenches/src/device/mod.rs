//! Devices: whatever can be given rows of inputs and shows rows of signals.

mod icarus;
mod mutant;
mod netlist;
mod packing;
mod process;
mod simulation;
mod text;
mod verilator;

use std::fmt;

use photoncube_hdl::{Emitted, Level, Unit, emit, emit_unit};
use photoncube_spec::{Machine, did_you_mean};
use serde::{Serialize, Serializer};
use thiserror::Error;

use crate::compare::Actual;
use crate::tools::{MissingTool, Tool, ToolError};

pub use icarus::Icarus;
pub use mutant::Mutant;
pub(crate) use netlist::netlist_text;
pub use netlist::{netlist, with_outputs_alone};
pub use simulation::RustHdl;
pub(crate) use simulation::{hdl_error, hdl_error_of};
pub use text::Text;
pub use verilator::Verilator;

/// Something that is compared with the golden model. It keeps its state between calls and starts
/// as after power-up.
pub trait Device {
    /// Its name in reports and on the command line.
    fn name(&self) -> &str;

    /// The tool behind it, with its version.
    fn tool_version(&self) -> &str;

    /// How many of [`photoncube_spec::Pins::observed`] it shows; the outputs at least.
    fn visible(&self) -> usize;

    /// For each row of inputs: drives it, lets the design settle, samples all that is visible,
    /// and makes the rising clock edge. Appends one row of values for each row of inputs.
    ///
    /// # Errors
    /// The device's tool fails.
    fn replay(&mut self, inputs: &[u64], observed: &mut Observed) -> Result<(), DeviceError>;
}

/// Rows of observed values.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Observed {
    /// The values, row after row; 0 where the value is unknown.
    pub values: Vec<u64>,
    /// The values with bits that are neither 0 nor 1, in order; only 4-state devices have them.
    pub unknown: Vec<Unknown>,
}

/// A value with bits that are neither 0 nor 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unknown {
    /// Its index in [`Observed::values`].
    pub index: usize,
    /// It, in hexadecimal with x and z, as the device writes it.
    pub text: String,
}

impl Observed {
    /// One value.
    pub(crate) fn at(&self, index: usize) -> Actual {
        match self.unknown.iter().find(|unknown| unknown.index == index) {
            Some(unknown) => Actual::Unknown(unknown.text.clone()),
            None => Actual::Known(self.values[index]),
        }
    }

    /// Forgets all rows and keeps the memory.
    pub fn clear(&mut self) {
        self.values.clear();
        self.unknown.clear();
    }
}

/// Why a device cannot run.
#[derive(Debug, Error)]
pub enum DeviceError {
    /// A tool is missing or fails.
    #[error(transparent)]
    Tool(#[from] ToolError),
    /// The HDL generator has no such machine, or its checks fail.
    #[error("the HDL of machine `{machine}` cannot be made")]
    Hdl {
        /// The machine.
        machine: &'static str,
        /// Why.
        source: Box<dyn std::error::Error + Send + Sync>,
    },
    /// The emitted Verilog is outside the subset that the device `text` knows.
    #[error(transparent)]
    Refused(#[from] verilog_eval::Refusal),
    /// A file cannot be written or read.
    #[error("cannot {action} {path}")]
    File {
        /// What was to be done.
        action: &'static str,
        /// The file or folder.
        path: String,
        /// Why.
        source: std::io::Error,
    },
    /// A running simulation ended or answered nonsense.
    #[error("the simulation in {device} broke off: {message}")]
    BrokeOff {
        /// The device.
        device: String,
        /// What it said last, or what was wrong with its answer.
        message: String,
    },
}

impl From<MissingTool> for DeviceError {
    fn from(missing: MissingTool) -> Self {
        Self::Tool(missing.into())
    }
}

/// The devices that a machine can be verified in.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum DeviceKind {
    /// rust-hdl's own simulation; it proves the Rust source, not the Verilog.
    RustHdl,
    /// The emitted Verilog in the testbench's own evaluator; it needs no tool.
    Text,
    /// The emitted Verilog in Icarus, 4-state.
    Icarus,
    /// The emitted Verilog in Verilator, 2-state and fast.
    Verilator,
    /// The emitted Verilog as gates, by Yosys, in Icarus; its registers have lost their names, so
    /// only its output pins are compared.
    Netlist,
}

/// No device has that name.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("there is no device `{found}`{meant}; the devices are {expected}")]
pub struct UnknownDevice {
    /// The name asked for.
    pub found: String,
    /// The name that was meant, as [`did_you_mean`] tells it.
    pub meant: String,
    /// The names there are.
    pub expected: String,
}

impl DeviceKind {
    /// All devices.
    pub const ALL: [Self; 5] = [
        Self::RustHdl,
        Self::Text,
        Self::Icarus,
        Self::Verilator,
        Self::Netlist,
    ];

    /// The device's name on the command line and in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::RustHdl => "rust-hdl",
            Self::Text => "text",
            Self::Icarus => "icarus",
            Self::Verilator => "verilator",
            Self::Netlist => "netlist",
        }
    }

    /// The device of that name.
    ///
    /// # Errors
    /// There is none; the error lists those there are.
    pub fn from_name(name: &str) -> Result<Self, UnknownDevice> {
        let found = Self::ALL.into_iter().find(|kind| kind.name() == name);
        found.ok_or_else(|| UnknownDevice {
            found: name.to_owned(),
            meant: did_you_mean(name, Self::ALL.map(Self::name)),
            expected: Self::ALL.map(Self::name).join(", "),
        })
    }

    /// The tools that the device needs.
    pub fn tools(self) -> &'static [Tool] {
        match self {
            Self::RustHdl | Self::Text => &[],
            Self::Icarus => &[Tool::Iverilog, Tool::Vvp],
            Self::Verilator => &[Tool::Verilator, Tool::Make, Tool::Gxx],
            Self::Netlist => &[Tool::Yosys, Tool::Iverilog, Tool::Vvp],
        }
    }

    /// The first of those tools that is not there.
    pub fn missing_tool(self) -> Option<MissingTool> {
        self.tools().iter().find_map(|tool| tool.find().err())
    }

    /// The device with a machine in it, or a part of one.
    ///
    /// # Errors
    /// A tool is missing or fails, or the machine's HDL cannot be made.
    pub fn open(self, machine: &Machine, level: Level) -> Result<Box<dyn Device>, DeviceError> {
        if self == Self::RustHdl {
            return Ok(Box::new(RustHdl::new(machine, level)?));
        }
        self.open_emitted(&emit(machine, level).map_err(hdl_error(machine))?)
    }

    /// The device with an emitted text in it, if its tools are there.
    ///
    /// # Errors
    /// A tool is missing or fails.
    ///
    /// # Panics
    /// For rust-hdl, which simulates blocks and no text.
    pub(crate) fn open_emitted(self, design: &Emitted) -> Result<Box<dyn Device>, DeviceError> {
        match self.missing_tool() {
            Some(missing) => Err(missing.into()),
            None => self.open_text(design),
        }
    }

    /// The device with a unit for itself in it.
    ///
    /// # Errors
    /// A tool is missing or fails, or the unit is not built at that width.
    pub fn open_unit(self, unit: Unit, bits: u32) -> Result<Box<dyn Device>, DeviceError> {
        if let Some(missing) = self.missing_tool() {
            return Err(missing.into());
        }
        if self == Self::RustHdl {
            return Ok(Box::new(RustHdl::of_unit(unit, bits)?));
        }
        self.open_text(&emit_unit(unit, bits).map_err(hdl_error_of(unit.name()))?)
    }

    /// The device with an emitted text in it.
    ///
    /// # Panics
    /// For rust-hdl, which simulates blocks and no text.
    pub(crate) fn open_text(self, design: &Emitted) -> Result<Box<dyn Device>, DeviceError> {
        Ok(match self {
            Self::RustHdl => unreachable!("rust-hdl simulates blocks, not text"),
            Self::Text => Box::new(Text::new(design)?),
            Self::Verilator => Box::new(Verilator::new(design)?),
            Self::Netlist => Box::new(Icarus::of_netlist(design)?),
            Self::Icarus => Box::new(Icarus::new(design)?),
        })
    }

    /// The fastest device that runs the emitted text here: Verilator, or where it is missing the
    /// testbench's own evaluator.
    pub fn fastest() -> Self {
        match Self::Verilator.missing_tool() {
            None => Self::Verilator,
            Some(_) => Self::Text,
        }
    }
}

impl fmt::Display for DeviceKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl Serialize for DeviceKind {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// Writes a file that a tool then reads.
pub(crate) fn write_file(path: &std::path::Path, text: &str) -> Result<(), DeviceError> {
    std::fs::write(path, text).map_err(|source| DeviceError::File {
        action: "write",
        path: path.display().to_string(),
        source,
    })
}

/// A folder that goes away with the device.
pub(crate) fn scratch_folder() -> Result<tempfile::TempDir, DeviceError> {
    tempfile::tempdir().map_err(|source| DeviceError::File {
        action: "make a folder in",
        path: std::env::temp_dir().display().to_string(),
        source,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_device_is_found_by_its_name_and_an_unknown_one_is_refused_with_the_list() {
        for kind in DeviceKind::ALL {
            assert_eq!(DeviceKind::from_name(kind.name()), Ok(kind));
        }
        let message = DeviceKind::from_name("modelsim").unwrap_err().to_string();
        assert!(message.contains("`modelsim`;") && message.contains("icarus, verilator"));
        let message = DeviceKind::from_name("verilatr").unwrap_err().to_string();
        assert!(
            message.contains("`verilatr` (did you mean `verilator`?);"),
            "{message}"
        );
    }
}
