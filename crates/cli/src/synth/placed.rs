//! Verifies the netlist that is placed against the golden model.

use std::path::Path;

use anyhow::{Context, Result};
use photoncube_hdl::{Level, emit};
use photoncube_testbench::{
    Device, DeviceKind, Icarus, Verdict, VerifyError, VerifyOptions, Verilator, verify_device,
    with_outputs_alone,
};
use tempfile::TempDir;

use super::models::{check_parameters, models};
use super::netlist::{self, Stage};
use super::place::{self, Mapped};
use super::prove::{PassProof, prove};
use super::tools::Tools;
use super::{Subject, netlist::unwrapped};

/// The simulators that can run the models of the cells.
pub const SIMULATORS: [DeviceKind; 2] = [DeviceKind::Verilator, DeviceKind::Icarus];

/// A machine with the netlists of its placement.
pub struct Placed<'a> {
    tools: &'a Tools,
    folder: TempDir,
    subject: &'a Subject,
    mapped: Mapped,
    models: String,
}

impl<'a> Placed<'a> {
    /// Maps a machine as `synth` does.
    ///
    /// # Errors
    /// Yosys fails, or refuses the machine.
    pub fn map(tools: &'a Tools, subject: &'a Subject) -> Result<Self> {
        let folder = tempfile::tempdir().context("cannot make a scratch folder")?;
        subject.write(folder.path())?;
        Ok(Self {
            mapped: place::map(tools, folder.path(), subject)?,
            models: models(tools, folder.path())?,
            tools,
            folder,
            subject,
        })
    }

    /// The netlist as Yosys maps it and after each pass.
    pub fn stages(&self) -> &[Stage] {
        &self.mapped.stages
    }

    /// The digest of the netlist that is placed.
    ///
    /// # Errors
    /// The netlist is not legal.
    pub fn netlist_sha256(&self) -> Result<String> {
        let placed = self.mapped.stages.last().context("there is a netlist")?;
        netlist::sha256(&placed.netlist)
    }

    /// Yosys's version.
    ///
    /// # Errors
    /// Yosys prints no version.
    pub fn yosys_version(&self) -> Result<String> {
        self.tools.yosys_version(self.folder())
    }

    fn folder(&self) -> &Path {
        self.folder.path()
    }

    /// Proves that the changes of each pass preserve the function.
    ///
    /// # Errors
    /// A pass has done more than change cells, or Yosys fails.
    pub fn prove(&self) -> Result<Vec<PassProof>> {
        prove(self.tools, self.folder(), &self.models, &self.mapped.stages)
    }

    /// The Verilog of the machine in a netlist, with the models of its cells.
    ///
    /// # Errors
    /// A cell has no model, or the machine's surroundings are not its wrapper.
    pub fn text(&self, netlist: &serde_json::Value) -> Result<String> {
        let machine = unwrapped(netlist, &self.subject.top, &self.mapped.ports)?;
        if let Some(cells) = netlist::top(netlist)?["cells"].as_object() {
            check_parameters(&self.models, cells)?;
        }
        Ok(machine + &self.models)
    }

    /// Verifies the machine in a netlist in a simulator. Its output pins are compared in every clock.
    ///
    /// # Errors
    /// The netlist cannot be simulated. The inner error is the first difference from the golden model, or a
    /// failure of the simulator.
    pub fn verify(
        &self,
        netlist: &serde_json::Value,
        simulator: DeviceKind,
        options: &VerifyOptions<'_>,
        progress: &dyn Fn(u64),
    ) -> Result<Result<Verdict, VerifyError>> {
        let machine = self.subject.machine;
        let design = emit(machine, Level::Machine)?;
        let design = with_outputs_alone(&design, self.text(netlist)?);
        let opened = match simulator {
            DeviceKind::Icarus => {
                Icarus::new(&design).map(|device| Box::new(device) as Box<dyn Device>)
            }
            _ => Verilator::of_netlist(&design).map(|device| Box::new(device) as Box<dyn Device>),
        };
        Ok(opened
            .map_err(VerifyError::from)
            .and_then(|mut device| verify_device(machine, device.as_mut(), options, progress)))
    }
}

#[cfg(test)]
mod tests;
