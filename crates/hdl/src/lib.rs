//! The machines in rust-hdl, and the one place that emits Verilog.
