//! The golden model with a planted fault, which tests that the comparison detects faults.

use photoncube_model::{GoldenMachine, golden_machine};
use photoncube_spec::{Inputs, Machine, Pins};

use super::{Device, DeviceError, Observed};

/// A fault at the inputs: from the clock and the inputs, it changes what the model receives.
type InputFault = Box<dyn Fn(u64, &mut Inputs)>;
/// A fault at the outputs: from the clock and the row of signals, it changes what is observed.
type RowFault = Box<dyn Fn(u64, &mut [u64])>;

/// A golden model with a fault at its inputs and a fault at its outputs.
pub struct Mutant {
    model: Box<dyn GoldenMachine>,
    machine: Machine,
    columns: usize,
    visible: usize,
    clock: u64,
    input_fault: InputFault,
    row_fault: RowFault,
}

impl Mutant {
    /// The golden model without a fault.
    pub fn sound(machine: &Machine) -> Self {
        let pins = Pins::of(machine);
        Self {
            model: golden_machine(machine),
            machine: *machine,
            columns: pins.inputs.len(),
            visible: pins.observed.len(),
            clock: 0,
            input_fault: Box::new(|_, _| {}),
            row_fault: Box::new(|_, _| {}),
        }
    }

    /// Adds a fault at the inputs.
    pub fn with_input_fault(mut self, fault: impl Fn(u64, &mut Inputs) + 'static) -> Self {
        self.input_fault = Box::new(fault);
        self
    }

    /// Adds a fault at the outputs.
    pub fn with_row_fault(mut self, fault: impl Fn(u64, &mut [u64]) + 'static) -> Self {
        self.row_fault = Box::new(fault);
        self
    }

    /// Limits the visible signals to the first `visible`.
    pub fn showing(mut self, visible: usize) -> Self {
        self.visible = visible;
        self
    }
}

impl Device for Mutant {
    fn name(&self) -> &str {
        "mutant"
    }

    fn tool_version(&self) -> &str {
        "golden model"
    }

    fn visible(&self) -> usize {
        self.visible
    }

    fn replay(&mut self, inputs: &[u64], observed: &mut Observed) -> Result<(), DeviceError> {
        for row in inputs.chunks_exact(self.columns) {
            let mut inputs = Pins::inputs_of(&self.machine, row);
            (self.input_fault)(self.clock, &mut inputs);
            let first = observed.values.len();
            self.model.observe(&inputs, &mut observed.values);
            (self.row_fault)(self.clock, &mut observed.values[first..]);
            observed.values.truncate(first + self.visible);
            self.model.clock(&inputs);
            self.clock += 1;
        }
        Ok(())
    }
}
