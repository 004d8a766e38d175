//! Runs machines in rust-hdl's own simulation.

use std::io::{Read, Write};

use photoncube_hdl::{Level, Simulator, Unit, generator, level_pins, unit_pins};
use photoncube_spec::Machine;
use tempfile::TempDir;

use super::process::Process;
use super::{Device, DeviceError, Observed, scratch_folder};

/// The device's name.
const NAME: &str = "rust-hdl";

/// Clocks in a frame of a custom machine's simulation.
const FRAME_CLOCKS: usize = 512;

/// A machine, or a part of one, in rust-hdl's simulation.
pub struct RustHdl {
    runs: Runs,
    columns: usize,
    visible: usize,
}

/// Where the simulation runs.
enum Runs {
    /// In this process: the widths are compiled in.
    Here(Simulator),
    /// In the generator of a custom machine, whose standard error is in the folder.
    Generator(
        Process,
        #[expect(dead_code, reason = "the folder lives as long as the process")] TempDir,
    ),
}

impl RustHdl {
    /// Opens a machine, or a part of it, in its power-up state.
    ///
    /// # Errors
    /// The machine's widths are not built in.
    pub fn new(machine: &Machine, level: Level) -> Result<Self, DeviceError> {
        let pins = level_pins(machine, level).map_err(hdl_error(machine))?;
        let runs = match Simulator::new(machine, level) {
            Ok(simulator) => Runs::Here(simulator),
            Err(_) => {
                let simulation = generator::simulation(machine, level);
                let folder = scratch_folder()?;
                let process = Process::start(
                    NAME,
                    &mut simulation.map_err(hdl_error(machine))?,
                    folder.path(),
                )?;
                Runs::Generator(process, folder)
            }
        };
        Ok(Self {
            runs,
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
            runs: Runs::Here(Simulator::of_unit(unit, bits).map_err(hdl_error_of(unit.name()))?),
            columns: pins.inputs.len(),
            visible: pins.observed.len(),
        })
    }
}

impl Device for RustHdl {
    fn name(&self) -> &str {
        NAME
    }

    fn tool_version(&self) -> &str {
        "rust-hdl 0.46.0"
    }

    fn visible(&self) -> usize {
        self.visible
    }

    fn replay(&mut self, inputs: &[u64], observed: &mut Observed) -> Result<(), DeviceError> {
        let (columns, visible) = (self.columns, self.visible);
        match &mut self.runs {
            Runs::Here(simulator) => {
                for row in inputs.chunks_exact(columns) {
                    let clock = simulator.clock(row, &mut observed.values);
                    clock.map_err(|error| DeviceError::BrokeOff {
                        device: NAME.to_owned(),
                        message: error.to_string(),
                    })?;
                }
                Ok(())
            }
            Runs::Generator(process, _) => process.converse(
                |stdin| {
                    for rows in inputs.chunks(FRAME_CLOCKS * columns) {
                        let clocks = u32::try_from(rows.len() / columns).expect("a frame is short");
                        stdin.write_all(&clocks.to_le_bytes())?;
                        let bytes: Vec<_> =
                            rows.iter().flat_map(|value| value.to_le_bytes()).collect();
                        stdin.write_all(&bytes)?;
                    }
                    Ok(())
                },
                |stdout| {
                    let mut bytes = vec![0; 8 * visible];
                    for _ in 0..inputs.len() / columns {
                        stdout.read_exact(&mut bytes)?;
                        let (values, _) = bytes.as_chunks::<8>();
                        let values = values.iter().map(|value| u64::from_le_bytes(*value));
                        observed.values.extend(values);
                    }
                    Ok(())
                },
            ),
        }
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
