#![doc = include_str!("../README.md")]
//!
//! # The modules
//!
//! [`devices`] has the families of FPGAs as tables. [`area`](area()) and [`place`](place()) measure; [`bitstream`](bitstream()) makes the
//! file that a board is loaded with; [`netlist`] and [`path`] read what Yosys and nextpnr write; [`prove`](prove()) proves the passes
//! over a netlist. [`asic`] measures a design in standard cells.

mod area;
pub mod asic;
mod bitstream;
mod design;
pub mod devices;
mod error;
mod figure;
mod flow;
mod models;
pub mod netlist;
pub mod path;
mod place;
mod program;
mod prove;
mod tools;
mod utilisation;
pub mod wrapper;
mod yosys;

pub use area::area;
pub use bitstream::{PackStep, Packed, Pinned, ReachedClock, bitstream, packer};
pub use design::Design;
pub use devices::{Device, FAMILIES, FLOWS, Family};
pub use error::{FlowError, Result, ToolError};
pub use figure::{CellCounts, Figure, Figures};
pub use flow::Flow;
pub use models::Models;
pub use netlist::{Netlist, Stage};
pub use path::{Binding, CriticalPath, EndpointGroup, Endpoints};
pub use place::{Mapped, Placed, Placer, Routed, Router, Target, Try, map, place};
pub use program::Program;
pub use prove::{PassProof, prove};
pub use tools::Tools;
pub use utilisation::Resource;
pub use yosys::{SCRIPT, Yosys};
