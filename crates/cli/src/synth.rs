//! Measures area and clock of the emitted machines, with one pinned version of Yosys and nextpnr.

pub mod area;
pub mod cells;
pub mod clock;
pub mod figures;
pub mod flow;
mod models;
pub mod netlist;
pub mod path;
pub mod place;
pub mod placed;
pub mod plan;
pub mod prove;
pub mod tables;
pub mod tools;
mod transistors;
mod wrapper;
pub mod writer;

use std::fs;
use std::path::Path;

use anyhow::Result;
use clap::ValueEnum;
use photoncube_hdl::{Level, emit};
use photoncube_spec::Machine;

use flow::Flow;

/// An enum's value as it is written on the command line.
fn option_name(value: impl ValueEnum) -> String {
    let value = value.to_possible_value();
    value.map_or_else(String::new, |value| value.get_name().to_owned())
}

/// A machine that is measured, with its emitted Verilog.
pub struct Subject {
    /// The machine that is measured.
    pub machine: &'static Machine,
    /// The name of its top module.
    pub top: String,
    /// The Verilog text of all modules.
    pub verilog: String,
    /// The overrides of some modules for an ECP5; `None` if there are none.
    pub ecp5_verilog: Option<String>,
    /// The digest of both texts, see [`Emitted::ecp5_sha256`](photoncube_hdl::Emitted::ecp5_sha256).
    pub verilog_sha256: String,
}

impl Subject {
    /// Emits the machine.
    pub fn of(machine: &'static Machine) -> Result<Self> {
        let emitted = emit(machine, Level::Machine)?;
        Ok(Self {
            machine,
            verilog_sha256: emitted.ecp5_sha256(),
            top: emitted.top,
            verilog: emitted.text,
            ecp5_verilog: emitted.ecp5_text,
        })
    }

    /// The Yosys commands that read the machine for a flow, from the folder of its files.
    pub fn read(&self, flow: Flow) -> String {
        let top = &self.top;
        let is_ecp5 = matches!(flow, Flow::Ecp5 | Flow::Ecp5Nodsp);
        match &self.ecp5_verilog {
            Some(_) if is_ecp5 => {
                format!("read_verilog {top}.v; read_verilog -overwrite {top}_ecp5.v")
            }
            _ => format!("read_verilog {top}.v"),
        }
    }

    /// Writes the texts into a folder.
    pub fn write(&self, folder: &Path) -> std::io::Result<()> {
        let top = &self.top;
        fs::write(folder.join(format!("{top}.v")), &self.verilog)?;
        match &self.ecp5_verilog {
            Some(text) => fs::write(folder.join(format!("{top}_ecp5.v")), text),
            None => Ok(()),
        }
    }
}
