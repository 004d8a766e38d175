//! The golden model: what a machine computes, in plain integers.
//!
//! Two independent readings of the spec: [`StepMachine`] does what the hardware does, clock by
//! clock, register by register; [`gather`] is the sum over photons that all of it is for. A
//! property test holds them equal. No I/O, no HDL, and no arithmetic shared with the HDL.

mod cell;
mod gather;
mod machine;
mod range;

pub use cell::{CellInputs, CellState};
pub use gather::{GatherError, gather};
pub use machine::{ControlState, StepMachine};
pub use range::{Limits, RangeError};
