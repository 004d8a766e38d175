//! The golden model of the sequential machine.

mod cell;
mod machine;

pub use cell::{CellInputs, CellRules, CellState};
pub use machine::StepMachine;
