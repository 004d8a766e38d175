//! Verifies the netlist that is placed against the golden model.

use std::path::Path;

use anyhow::{Context, Result};
use fpga_flow::devices::ecp5;
use fpga_flow::{
    Device as Fpga, Mapped, Models, Netlist, PassProof, Stage, Target, Tools, map, prove,
};
use photoncube_hdl::{Level, emit};
use photoncube_testbench::{
    Device, DeviceKind, Icarus, Verdict, VerifyError, VerifyOptions, Verilator, verify_device,
    with_outputs_alone,
};
use tempfile::TempDir;

use super::{DEFAULT_DEVICE, Subject, flow_to_place};
use crate::project::ABC9_TARGET_PS;

/// The simulators that can run the models of the cells.
pub const SIMULATORS: [DeviceKind; 2] = [DeviceKind::Verilator, DeviceKind::Icarus];

/// A machine with the netlists of its placement.
pub struct Placed<'a> {
    tools: &'a Tools,
    folder: TempDir,
    subject: &'a Subject,
    mapped: Mapped,
    models: Models,
}

impl<'a> Placed<'a> {
    /// Maps a machine as `synth` does.
    ///
    /// # Errors
    /// Yosys fails, or refuses the machine.
    pub fn map(tools: &'a Tools, subject: &'a Subject) -> Result<Self> {
        let folder = tempfile::tempdir().context("cannot make a scratch folder")?;
        subject.design.write(folder.path())?;
        let device = Fpga::find(DEFAULT_DEVICE)?;
        let target = Target {
            device,
            flow: flow_to_place(subject.machine, device),
            abc9_target_ps: ABC9_TARGET_PS,
        };
        let yosys = tools.yosys();
        Ok(Self {
            mapped: map(yosys, folder.path(), &subject.design, &target)
                .with_context(|| format!("machine {} in its wrapper", subject.machine.name))?,
            models: ecp5::models(yosys, folder.path())?,
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
        Ok(placed.netlist.sha256()?)
    }

    /// Yosys's version.
    ///
    /// # Errors
    /// Yosys prints no version.
    pub fn yosys_version(&self) -> Result<String> {
        Ok(self.tools.yosys().version()?)
    }

    fn folder(&self) -> &Path {
        self.folder.path()
    }

    /// Proves that the changes of each pass preserve the function.
    ///
    /// # Errors
    /// A pass has done more than change cells, or Yosys fails.
    pub fn prove(&self) -> Result<Vec<PassProof>> {
        let (yosys, stages) = (self.tools.yosys(), &self.mapped.stages);
        Ok(prove(yosys, self.folder(), &self.models, stages)?)
    }

    /// The Verilog of the machine in a netlist, with the models of its cells.
    ///
    /// # Errors
    /// A cell has no model, or the machine's surroundings are not its wrapper.
    pub fn text(&self, netlist: &Netlist) -> Result<String> {
        self.models.check(netlist)?;
        let top = &self.subject.design.top;
        Ok(ecp5::unwrapped(netlist, top, &self.mapped.ports)? + self.models.verilog())
    }

    /// Verifies the machine in a netlist in a simulator. Its output pins are compared in every clock.
    ///
    /// # Errors
    /// The netlist cannot be simulated. The inner error is the first difference from the golden model, or a
    /// failure of the simulator.
    pub fn verify(
        &self,
        netlist: &Netlist,
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
            _ => Verilator::new(&design).map(|device| Box::new(device) as Box<dyn Device>),
        };
        Ok(opened
            .map_err(VerifyError::from)
            .and_then(|mut device| verify_device(machine, device.as_mut(), options, progress)))
    }
}

#[cfg(test)]
mod tests;
