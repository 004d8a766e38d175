//! A device whose signals are recorded.

use std::collections::VecDeque;

use photoncube_model::{GoldenMachine, golden_machine};
use photoncube_spec::{Machine, Pins};

use super::{Row, Steps, Waves};
use crate::compare::Actual;
use crate::device::{Device, DeviceError, Observed};

/// A device that records its signals, beside those of a golden model.
pub struct Recorder<D> {
    device: D,
    model: Model,
    /// The number of first clocks in which the registers may differ from the golden model.
    unknown_clocks: u64,
    waves: Waves,
}

/// Where the golden model's signals come from.
enum Model {
    /// There is none.
    None,
    /// A machine that receives the inputs of the device.
    Machine(Box<Machine>, Box<dyn GoldenMachine>),
    /// They are given before the device runs.
    Given(VecDeque<u64>),
}

impl<D: Device> Recorder<D> {
    /// Records a machine in a device that has not run yet. At most `clocks` clocks are kept, and at least one.
    pub fn new(machine: &Machine, device: D, clocks: usize) -> Self {
        let mut recorder = Self::of_part(machine.name, Pins::of(machine), device, clocks);
        recorder.model = Model::Machine(Box::new(*machine), golden_machine(machine));
        recorder.waves.has_model = true;
        recorder.waves.steps = Steps::of(machine);
        recorder
    }

    /// Records something whose golden model's signals are given by [`Self::expect`].
    pub(crate) fn of_given(subject: &str, pins: Pins, device: D, clocks: usize) -> Self {
        let mut recorder = Self::of_part(subject, pins, device, clocks);
        recorder.model = Model::Given(VecDeque::new());
        recorder.waves.has_model = true;
        recorder
    }

    /// Adds the golden model's signals of the clocks that the device replays next.
    pub(crate) fn expect(&mut self, rows: &[u64]) {
        if let Model::Given(expected) = &mut self.model {
            expected.extend(rows);
        }
    }

    /// Records something that has these pins and no golden model.
    pub(crate) fn of_part(subject: &str, pins: Pins, device: D, clocks: usize) -> Self {
        let waves = Waves::new(subject, pins, device.visible(), device.name(), clocks);
        Self {
            device,
            model: Model::None,
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
        match &mut self.model {
            Model::None => {}
            Model::Machine(machine, model) => {
                let inputs = Pins::inputs_of(machine, inputs);
                model.observe(&inputs, &mut row);
                model.clock(&inputs);
            }
            Model::Given(expected) => {
                let columns = self.waves.pins.observed.len().min(expected.len());
                row.extend(expected.drain(..columns));
            }
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
