//! The sequential machines in rust-hdl: all cells execute one op per clock; see `photoncube_spec::SEQUENTIAL`.

mod cell;
mod control;
mod network;
mod pinned;
mod ports;
mod processor;
mod units;

pub(crate) use cell::Cell;
pub(crate) use network::Network;
pub(crate) use processor::Processor;
pub(crate) use units::build_unit;
