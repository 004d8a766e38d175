//! The machines in rust-hdl, and the one place that makes Verilog of them.
//!
//! This crate and `rust-hdl-lint` alone name rust-hdl. rust-hdl simulates one text and prints another, so
//! a block is trusted only when its *emitted* Verilog has been simulated; [`emit`] therefore also
//! says where in that text every register is.

mod build;
mod cell;
mod control;
mod emit;
mod level;
mod network;
mod overlap;
mod pinned;
mod ports;
mod processor;
mod simulator;
mod spatial;
mod unit;
mod units;

pub use build::{NotBuiltIn, most_steps};
pub use emit::{
    BlockRam, EmitError, Emitted, Linted, emit, emit_unit, interface_text, lint_control,
    lint_machine,
};
pub use level::Level;
pub use simulator::{NotSettled, Simulator, level_pins};
pub use unit::{Unit, has_unit, unit_pins};
