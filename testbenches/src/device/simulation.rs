//! Runs machines in rust-hdl's own simulation.

use photoncube_hdl::{Level, Simulator, Unit, level_pins, unit_pins};
use photoncube_spec::Machine;

use super::{Device, DeviceError, Observed};

/// A machine, or a part of one, in rust-hdl's simulation.
pub struct RustHdl {
    simulator: Simulator,
    columns: usize,
    visible: usize,
}

impl RustHdl {
    /// Opens a machine, or a part of it, in its power-up state.
    ///
    /// # Errors
    /// The machine's widths are not built in.
    pub fn new(machine: &Machine, level: Level) -> Result<Self, DeviceError> {
        let pins = level_pins(machine, level).map_err(hdl_error(machine))?;
        Ok(Self {
            simulator: Simulator::new(machine, level).map_err(hdl_error(machine))?,
            columns: pins.inputs.len(),
            visible: pins.observed.len(),
        })
    }

    /// Opens a unit on its own, with operands of `bits` bits.
    ///
    /// # Errors
    /// The unit is not built at that width.
    pub fn of_unit(unit: Unit, bits: u32) -> Result<Self, DeviceError> {
        let pins = unit_pins(unit, bits).map_err(hdl_error_of(unit.name()))?;
        Ok(Self {
            simulator: Simulator::of_unit(unit, bits).map_err(hdl_error_of(unit.name()))?,
            columns: pins.inputs.len(),
            visible: pins.observed.len(),
        })
    }
}

impl Device for RustHdl {
    fn name(&self) -> &str {
        "rust-hdl"
    }

    fn tool_version(&self) -> &str {
        "rust-hdl 0.46.0"
    }

    fn visible(&self) -> usize {
        self.visible
    }

    fn replay(&mut self, inputs: &[u64], observed: &mut Observed) -> Result<(), DeviceError> {
        for row in inputs.chunks_exact(self.columns) {
            let clock = self.simulator.clock(row, &mut observed.values);
            clock.map_err(|error| DeviceError::BrokeOff {
                device: "rust-hdl".to_owned(),
                message: error.to_string(),
            })?;
        }
        Ok(())
    }
}

/// Converts an error of the HDL generator, and adds the machine's name.
pub(crate) fn hdl_error<E>(machine: &Machine) -> impl Fn(E) -> DeviceError
where
    E: std::error::Error + Send + Sync + 'static,
{
    hdl_error_of(machine.name)
}

/// Converts an error of the HDL generator, and adds the name of a machine or a unit.
pub(crate) fn hdl_error_of<E>(machine: &'static str) -> impl Fn(E) -> DeviceError
where
    E: std::error::Error + Send + Sync + 'static,
{
    move |source| DeviceError::Hdl {
        machine,
        source: Box::new(source),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use photoncube_spec::MACHINES;

    #[test]
    fn the_version_is_the_one_that_the_workspace_pins() {
        let device = RustHdl::new(&MACHINES[0], Level::Machine).unwrap();
        let version = device.tool_version().replace(' ', " = \"=");
        assert!(include_str!("../../../Cargo.toml").contains(&version));
    }
}
