//! The step-exact golden models behind one interface.

use photoncube_spec::{Inputs, Machine, Organisation, Outputs};

use crate::leaf::LeafMachine;
use crate::overlap::OverlapMachine;
use crate::sequential::StepMachine;
use crate::spatial::SpatialMachine;

/// A step-exact model with the state of all registers. It starts in the power-up state, in which all
/// registers are 0.
pub trait GoldenMachine: Send {
    /// The values of the output pins in this clock, for these inputs.
    fn outputs(&self, inputs: &Inputs) -> Outputs;

    /// Appends the output pins for these inputs, and all registers, to a row in the order of
    /// [`photoncube_spec::Pins::observed`].
    fn observe(&self, inputs: &Inputs, row: &mut Vec<u64>);

    /// Applies one rising clock edge with these inputs. The inputs must fit the machine's widths, and a lane
    /// without a photon must be 0.
    fn clock(&mut self, inputs: &Inputs);

    /// Whether the machine's program counts this clock as work. A clock spent waiting for a stream does not
    /// count.
    fn works(&self, inputs: &Inputs) -> bool;
}

/// Makes the golden model of a machine, in its power-up state.
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
        Organisation::Leaf(_) => Box::new(LeafMachine::new(machine)),
    }
}
