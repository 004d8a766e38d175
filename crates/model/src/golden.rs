//! The step-exact golden models behind one interface.

use photoncube_spec::{Inputs, Machine, Organisation, Outputs};

use crate::machine::StepMachine;
use crate::overlap::OverlapMachine;
use crate::spatial::SpatialMachine;

/// A machine with its state, all registers, every clock; starts as after power-up, all 0.
pub trait GoldenMachine: Send {
    /// The output pins in this clock, with these inputs on the input pins.
    fn outputs(&self, inputs: &Inputs) -> Outputs;

    /// Appends the output pins with these inputs, and all registers, to a row, in the order of
    /// [`photoncube_spec::Pins::observed`].
    fn observe(&self, inputs: &Inputs, row: &mut Vec<u64>);

    /// One rising clock edge with these inputs. Inputs must fit the machine's widths; a lane that
    /// is not there is 0.
    fn clock(&mut self, inputs: &Inputs);

    /// Whether the clock with these inputs is one that the machine's program counts, rather than
    /// one spent waiting for a stream.
    fn works(&self, inputs: &Inputs) -> bool;
}

/// The golden model of a machine, in its power-up state.
///
/// # Panics
/// Where a spatial machine is not legal, see [`photoncube_spec::Spatial::check`].
pub fn golden_machine(machine: &Machine) -> Box<dyn GoldenMachine> {
    match &machine.organisation {
        Organisation::Sequential | Organisation::Programmed(_) => {
            Box::new(StepMachine::new(machine))
        }
        Organisation::Overlapped => Box::new(OverlapMachine::new(machine)),
        Organisation::Spatial(_) => Box::new(SpatialMachine::new(machine)),
    }
}
