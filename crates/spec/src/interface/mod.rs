//! The interface of a machine for an integrator: its ports, their protocol, its limits.
//!
//! The headers of the emitted Verilog, `docs/ports.md`, the datasheets and `photoncube list MACHINE` print this
//! interface.

mod facts;
mod limitations;
mod ports;
mod protocol;

use crate::machine::Machine;

pub use facts::Fact;
pub use limitations::Limitation;
pub use ports::{Direction, Port};

/// The interface of a machine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interface {
    /// The ports of the top module, grouped by stream; the clock is the first.
    pub ports: Vec<Port>,
    /// The rules of the streams' handshakes, one rule a line.
    pub protocol: Vec<String>,
    /// Formats, limits and clocks.
    pub facts: Vec<Fact>,
    /// What a user must design around.
    pub limitations: Vec<Limitation>,
}

impl Interface {
    /// Describes the interface of a machine.
    pub fn of(machine: &Machine) -> Self {
        Self {
            ports: ports::ports(machine),
            protocol: protocol::protocol(machine),
            facts: facts::facts(machine),
            limitations: limitations::limitations(machine),
        }
    }
}
