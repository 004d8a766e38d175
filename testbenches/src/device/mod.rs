//! Devices: simulators that accept rows of inputs and return rows of signals.

mod activity;
mod board;
mod core;
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

pub(crate) use self::board::FAULT;
pub use self::board::{BoardSimulation, Symbol};
pub use self::core::CoreSimulation;
pub use icarus::Icarus;
pub use mutant::Mutant;
pub(crate) use netlist::{block_ram_names, netlist_text};
pub use netlist::{netlist, with_outputs_alone};
pub use simulation::RustHdl;
pub(crate) use simulation::{hdl_error, hdl_error_of};
pub use text::Text;
pub use verilator::Verilator;

/// A simulation that is compared with the golden model. It keeps its state between calls and starts in the
/// power-up state.
pub trait Device {
    /// The device's name in reports and on the command line.
    fn name(&self) -> &str;

    /// The tool behind the device, with its version.
    fn tool_version(&self) -> &str;

    /// The number of [`photoncube_spec::Pins::observed`] signals that the device shows; at least the outputs.
    fn visible(&self) -> usize;

    /// For each row of inputs: drives it, lets the design settle, samples all visible signals, and makes the
    /// rising clock edge. Appends one row of values for each row of inputs.
    ///
    /// # Errors
    /// The tool behind the device fails.
    fn replay(&mut self, inputs: &[u64], observed: &mut Observed) -> Result<(), DeviceError>;
}

impl<D: Device + ?Sized> Device for Box<D> {
    fn name(&self) -> &str {
        (**self).name()
    }

    fn tool_version(&self) -> &str {
        (**self).tool_version()
    }

    fn visible(&self) -> usize {
        (**self).visible()
    }

    fn replay(&mut self, inputs: &[u64], observed: &mut Observed) -> Result<(), DeviceError> {
        (**self).replay(inputs, observed)
    }
}

/// Rows of observed values.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Observed {
    /// The values, row after row; 0 where the value is unknown.
    pub values: Vec<u64>,
    /// The values with bits that are neither 0 nor 1, in order. Only 4-state devices have them.
    pub unknown: Vec<Unknown>,
}

/// A value with bits that are neither 0 nor 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unknown {
    /// The value's index in [`Observed::values`].
    pub index: usize,
    /// The value in hexadecimal with x and z, as the device writes it.
    pub text: String,
}

impl Observed {
    /// The value at an index.
    pub(crate) fn at(&self, index: usize) -> Actual {
        match self.unknown.iter().find(|unknown| unknown.index == index) {
            Some(unknown) => Actual::Unknown(unknown.text.clone()),
            None => Actual::Known(self.values[index]),
        }
    }

    /// Removes all rows but keeps the allocated memory.
    pub fn clear(&mut self) {
        self.values.clear();
        self.unknown.clear();
    }
}

/// The reason why a device cannot run.
#[derive(Debug, Error)]
pub enum DeviceError {
    /// A tool is missing or fails.
    #[error(transparent)]
    Tool(#[from] ToolError),
    /// The HDL generator has no such machine, or its checks fail.
    #[error("the HDL of machine `{machine}` cannot be made")]
    Hdl {
        /// The name of the machine.
        machine: &'static str,
        /// The error of the HDL generator.
        source: Box<dyn std::error::Error + Send + Sync>,
    },
    /// The emitted Verilog is outside the subset that the device `text` evaluates.
    #[error(transparent)]
    Refused(#[from] verilog_eval::Refusal),
    /// A file cannot be written or read.
    #[error("cannot {action} {path}")]
    File {
        /// The action that failed.
        action: &'static str,
        /// The path of the file or folder.
        path: String,
        /// The error of the operating system.
        source: std::io::Error,
    },
    /// A running simulation ended, or its answer was not understood.
    #[error("the simulation in {device} broke off: {message}")]
    BrokeOff {
        /// The name of the device.
        device: String,
        /// The last output of the device, or the error in its answer.
        message: String,
    },
    /// A text that a planted fault replaces does not occur once in its module.
    #[error(
        "a planted fault replaces `{find}` in module `{module}`, which was found {times} times, expected once; correct \
         the fault's row"
    )]
    NotPlanted {
        /// The name of the module.
        module: String,
        /// The text.
        find: String,
        /// The number of times that it was found.
        times: usize,
    },
}

impl From<fpga_flow::FlowError> for DeviceError {
    fn from(error: fpga_flow::FlowError) -> Self {
        match error {
            fpga_flow::FlowError::Tool(error) => Self::Tool(error.into()),
            other => Self::BrokeOff {
                device: "yosys".to_owned(),
                message: other.to_string(),
            },
        }
    }
}

impl From<fpga_flow::ToolError> for DeviceError {
    fn from(error: fpga_flow::ToolError) -> Self {
        Self::Tool(error.into())
    }
}

impl From<MissingTool> for DeviceError {
    fn from(missing: MissingTool) -> Self {
        Self::Tool(missing.into())
    }
}

/// The devices that a machine can be verified in.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum DeviceKind {
    /// rust-hdl's own simulation. It verifies the Rust source and not the Verilog.
    RustHdl,
    /// The emitted Verilog in the testbench's own evaluator, which needs no external tool.
    Text,
    /// The emitted Verilog in Icarus, 4-state.
    Icarus,
    /// The emitted Verilog in Verilator, 2-state and fast.
    Verilator,
    /// The emitted Verilog, synthesised to gates by Yosys, in Icarus. The registers have lost their names, so
    /// only the output pins are compared.
    Netlist,
}

/// No device has that name.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("there is no device `{found}`{meant}; the devices are {expected}")]
pub struct UnknownDevice {
    /// The name that was given.
    pub found: String,
    /// A hint with the nearest name, made by [`did_you_mean`]; empty where none is near.
    pub meant: String,
    /// The names of all devices.
    pub expected: String,
}

impl DeviceKind {
    /// All devices, in the order of the enum.
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

    /// Finds the device of that name.
    ///
    /// # Errors
    /// No device has that name; the error lists all names.
    pub fn from_name(name: &str) -> Result<Self, UnknownDevice> {
        let found = Self::ALL.into_iter().find(|kind| kind.name() == name);
        found.ok_or_else(|| UnknownDevice {
            found: name.to_owned(),
            meant: did_you_mean(name, Self::ALL.map(Self::name)),
            expected: Self::ALL.map(Self::name).join(", "),
        })
    }

    /// The external tools that the device needs.
    pub fn tools(self) -> &'static [Tool] {
        match self {
            Self::RustHdl | Self::Text => &[],
            Self::Icarus => &[Tool::Iverilog, Tool::Vvp],
            Self::Verilator => &[Tool::Verilator, Tool::Make, Tool::Gxx],
            Self::Netlist => &[Tool::Yosys, Tool::Iverilog, Tool::Vvp],
        }
    }

    /// The first of the device's tools that is missing.
    pub fn missing_tool(self) -> Option<MissingTool> {
        self.tools().iter().find_map(|tool| tool.find().err())
    }

    /// Opens the device with a machine, or a part of one.
    ///
    /// # Errors
    /// A tool is missing or fails, or the machine's HDL cannot be made.
    pub fn open(self, machine: &Machine, level: Level) -> Result<Box<dyn Device>, DeviceError> {
        if self == Self::RustHdl {
            return Ok(Box::new(RustHdl::new(machine, level)?));
        }
        self.open_emitted(&emit(machine, level).map_err(hdl_error(machine))?)
    }

    /// Opens the device with an emitted text, if its tools are installed.
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

    /// Opens the device with a unit on its own.
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

    /// Opens the device with an emitted text, without a check for its tools.
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

    /// The fastest device for the emitted text on this computer: Verilator, or the testbench's own evaluator
    /// where Verilator is missing.
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

/// Writes a file for a tool to read.
pub(crate) fn write_file(path: &std::path::Path, text: &str) -> Result<(), DeviceError> {
    std::fs::write(path, text).map_err(|source| DeviceError::File {
        action: "write",
        path: path.display().to_string(),
        source,
    })
}

/// Makes a temporary folder that is deleted with the device.
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
