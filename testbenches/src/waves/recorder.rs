//! A device whose signals are recorded.

use photoncube_model::{GoldenMachine, golden_machine};
use photoncube_spec::{Machine, Pins};

use super::{Row, Steps, Waves};
use crate::compare::Actual;
use crate::device::{Device, DeviceError, Observed};

/// A device that records its signals, beside those of a golden model that receives the inputs of the device.
pub struct Recorder<D> {
    device: D,
    machine: Machine,
    model: Option<Box<dyn GoldenMachine>>,
    /// The number of first clocks in which the registers may differ from the golden model.
    unknown_clocks: u64,
    waves: Waves,
}

impl<D: Device> Recorder<D> {
    /// Records a machine in a device that has not run yet. At most `clocks` clocks are kept, and at least one.
    pub fn new(machine: &Machine, device: D, clocks: usize) -> Self {
        let mut recorder = Self::of_part(machine, Pins::of(machine), device, clocks);
        recorder.model = Some(golden_machine(machine));
        recorder.waves.has_model = true;
        recorder.waves.steps = Steps::of(machine);
        recorder
    }

    /// Records a part of a machine that has these pins and no golden model.
    pub(crate) fn of_part(machine: &Machine, pins: Pins, device: D, clocks: usize) -> Self {
        let waves = Waves::new(machine, pins, device.visible(), device.name(), clocks);
        Self {
            device,
            machine: *machine,
            model: None,
            unknown_clocks: 0,
            waves,
        }
    }

    /// Does not look for differences in the first clocks, for a device whose registers have other values at
    /// power-up.
    pub(crate) fn unknown_for(mut self, clocks: u64) -> Self {
        self.unknown_clocks = clocks;
        self
    }

    /// What was recorded.
    pub fn into_waves(self) -> Waves {
        self.waves
    }

    /// The golden model's signals in this clock. Applies the clock's rising edge to the model.
    fn modelled(&mut self, inputs: &[u64]) -> Vec<u64> {
        let mut row = Vec::new();
        if let Some(model) = &mut self.model {
            let inputs = Pins::inputs_of(&self.machine, inputs);
            model.observe(&inputs, &mut row);
            model.clock(&inputs);
        }
        row
    }

    /// Records a clock.
    fn record(&mut self, inputs: &[u64], device: Vec<Actual>) {
        let model = self.modelled(inputs);
        let pairs = model.iter().zip(&device).enumerate();
        let differs = pairs.filter(|(_, (model, device))| Actual::Known(**model) != **device);
        let mut differing: Vec<_> = differs.map(|(column, _)| column).collect();
        if self.waves.seen < self.unknown_clocks {
            differing.clear();
        }
        self.waves.push(Row {
            inputs: inputs.to_vec(),
            device,
            model,
            differing,
        });
    }
}

impl<D: Device> Device for Recorder<D> {
    fn name(&self) -> &str {
        self.device.name()
    }

    fn tool_version(&self) -> &str {
        self.device.tool_version()
    }

    fn visible(&self) -> usize {
        self.device.visible()
    }

    fn replay(&mut self, inputs: &[u64], observed: &mut Observed) -> Result<(), DeviceError> {
        let (columns, visible) = (self.waves.pins.inputs.len(), self.visible());
        let mut first = observed.values.len();
        self.device.replay(inputs, observed)?;
        for inputs in inputs.chunks_exact(columns) {
            // A device that broke off has fewer rows.
            if self.waves.is_complete() || first + visible > observed.values.len() {
                break;
            }
            let row = (first..first + visible).map(|index| observed.at(index));
            self.record(inputs, row.collect());
            first += visible;
        }
        Ok(())
    }
}
