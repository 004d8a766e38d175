//! Measures area and clock of the emitted machines, with one pinned version of Yosys and nextpnr.

pub mod asic;
pub mod clock;
pub mod figures;
#[cfg(test)]
mod fine;
pub mod layout;
pub mod measurements;
pub mod placed;
pub mod plan;
pub mod tables;
pub mod writer;

use std::path::Path;

use anyhow::{Result, anyhow, bail};
use fpga_flow::{Device, Family, Flow, FlowError, ToolError, Tools, devices::ecp5};
use photoncube_hdl::{Level, core_within, emit, emit_core};
use photoncube_spec::{Core, Machine, Squarer};
use photoncube_testbench::pinned_tools;

/// The device of the committed figures.
pub const DEFAULT_DEVICE: &str = "LFE5U-85F";

/// The speed grades of the committed figures: the slowest, whose clocks `list` shows, and the fastest.
pub const DEFAULT_GRADES: [u32; 2] = [6, 8];

/// The target clock in MHz, higher than any machine reaches, so that no path counts as fast enough.
pub const TARGET_MHZ: u32 = 400;

/// The command that installs the tools.
pub const INSTALL: &str = "photoncube setup --synthesis";

/// Finds Yosys, and the nextpnr of a family, in a folder, or else where `photoncube setup --synthesis` has
/// installed them.
///
/// # Errors
/// A tool is missing; the error names the command that installs it.
pub fn tools(folder: Option<&Path>, places_in: Option<&Family>) -> Result<Tools> {
    let installed = pinned_tools();
    let Some(folder) = folder.or(installed) else {
        bail!(
            "the pinned Yosys and nextpnr are not installed, and those of the system are not used; `{INSTALL}` installs them, --tools names \
             a folder that has them"
        );
    };
    Tools::find(Some(folder), places_in).map_err(|error| match error {
        FlowError::Tool(ToolError::Missing { .. }) => anyhow!("{error}; `{INSTALL}` installs it"),
        error => error.into(),
    })
}

/// The flow in which a machine is placed: with DSP blocks only where its squarer is made for them. In other
/// machines the synthesiser finds products elsewhere, and the measurement would be of its choice.
pub fn flow_to_place(machine: &Machine, device: &Device) -> &'static Flow {
    let others = machine.spatial().map_or(&[][..], |spatial| spatial.others);
    let others = others.iter().map(|(kind, _)| kind.squarer);
    let mut squarers = others.chain([machine.squarer]);
    device.flow(squarers.any(|kind| kind == Squarer::Product))
}

/// A machine that is measured, with its emitted Verilog.
pub struct Subject {
    /// The name of the machine or core that is measured.
    pub name: String,
    /// The machine, or that of each chain of the core.
    pub machine: &'static Machine,
    /// Its Verilog, with the overrides of some modules for an ECP5.
    pub design: fpga_flow::Design,
    /// The digest of both texts, see [`Emitted::ecp5_sha256`](photoncube_hdl::Emitted::ecp5_sha256).
    pub verilog_sha256: String,
}

/// Whether `verilog_sha256`, recorded for the machine `name`, is that of other Verilog than the subject's of this name.
pub fn is_stale(subjects: &[Subject], name: &str, verilog_sha256: &str) -> bool {
    let subject = subjects.iter().find(|subject| subject.name == name);
    subject.is_some_and(|subject| subject.verilog_sha256 != verilog_sha256)
}

impl Subject {
    /// Emits the machine.
    pub fn of(machine: &'static Machine) -> Result<Self> {
        let emitted = emit(machine, Level::Machine)?;
        let overrides = emitted.ecp5_text.iter();
        let overrides = overrides.map(|text| (ecp5::FAMILY.name, text.clone()));
        Ok(Self {
            name: machine.name.to_owned(),
            machine,
            verilog_sha256: emitted.ecp5_sha256(),
            design: fpga_flow::Design {
                overrides: overrides.collect(),
                top: emitted.top,
                verilog: emitted.text,
            },
        })
    }

    /// Emits the core.
    pub fn of_core(core: &Core) -> Result<Self> {
        let emitted = emit_core(core)?;
        let overrides = emitted.machine.ecp5_text.iter();
        let overrides = overrides.map(|text| (ecp5::FAMILY.name, text.clone()));
        // Place and route take the clock by the name that every machine's has.
        let top = format!("{}_with_clock", emitted.top);
        let around = core_within(&top, "clock", core, &emitted);
        Ok(Self {
            name: core.name(),
            machine: core.machine,
            verilog_sha256: emitted.ecp5_sha256(),
            design: fpga_flow::Design {
                overrides: overrides.collect(),
                top,
                verilog: emitted.text + &around,
            },
        })
    }
}

#[cfg(test)]
mod tests {
    use photoncube_spec::find_machine;

    use super::*;

    #[test]
    fn dsp_blocks_are_for_squarers_that_are_products() {
        let device = Device::find(DEFAULT_DEVICE).unwrap();
        let flow = |machine| flow_to_place(find_machine(machine).unwrap(), device).name;
        assert_eq!(flow("paper"), "ecp5-nodsp");
        assert_eq!(flow("paper-dsp"), "ecp5");
    }
}
