//! The machines as rust-hdl blocks, and the only code that makes Verilog from them.
//!
//! Only this crate and `rust-hdl-lint` name rust-hdl. rust-hdl simulates Rust code and prints Verilog, and the two may
//! differ. A block is therefore trusted only after its *emitted* Verilog has been simulated. [`emit`] also returns the
//! path of every register in the emitted text, so that a simulation can observe it.
//!
//! ```
//! use photoncube_hdl::{Level, emit};
//! use photoncube_spec::find_machine;
//!
//! let design = emit(find_machine("paper")?, Level::Machine)?;
//! assert_eq!(design.top, "photoncube_paper");
//! assert!(design.text.contains("module photoncube_paper("));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

// Without the named machines the tables have no rows.
#![cfg_attr(
    any(test, not(feature = "named-machines")),
    allow(unused_variables, unused_mut, dead_code)
)]

mod board;
mod build;
pub mod cache;
mod core;
mod defaults;
mod emit;
pub mod generator;
mod leaf;
mod level;
mod overlap;
mod parts;
mod pinned;
mod registers;
mod sequential;
mod simulator;
mod spatial;
mod unit;

pub use crate::board::{OnLine, Ulx3s, Ulx3sError, Ulx3sFiles, core_on_line};
pub use crate::core::{EmittedCore, core_instances, core_rows, core_within, emit_core};
pub use build::{NotBuiltIn, most_steps};
pub use emit::{
    BlockRam, EmitError, Emitted, Linted, emit, emit_unit, generate_command, interface_text,
    lint_control, lint_machine, ports_text,
};
pub use level::Level;
pub use simulator::{NotSettled, Simulator, level_pins};
pub use unit::{Unit, has_unit, unit_pins};
