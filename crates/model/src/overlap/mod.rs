//! The golden model of the overlapped machine.

mod cell;
mod machine;

pub use cell::{CellPorts, OverlapCell};
pub use machine::OverlapMachine;
