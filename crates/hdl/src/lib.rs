//! The machines in rust-hdl, and the one place that makes Verilog of them.
//!
//! This is the only crate that names rust-hdl. rust-hdl simulates one text and prints another, so
//! a block is trusted only when its *emitted* Verilog has been simulated; [`emit`] therefore also
//! says where in that text every register is.

mod build;
mod cell;
mod control;
mod level;
mod network;
mod pinned;
mod ports;
mod processor;
mod simulator;
mod units;

pub use build::NotBuiltIn;
pub use level::Level;
pub use simulator::{NotSettled, Simulator, level_pins};
#[test]
fn dump() {
    use rust_hdl::prelude::*;
    let m = photoncube_spec::find_machine("paper").unwrap();
    let b = build::build(m, Level::Machine).unwrap();
    println!("{:?}", rust_hdl::prelude::check_all(b.as_ref()));
    let mut d = ModuleDefines::default();
    b.accept("top", &mut d);
    std::fs::write("/tmp/raw.v", d.defines()).unwrap();
}
