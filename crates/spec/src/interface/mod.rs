//! What an integrator must know of a machine: its ports, their protocol, its limits.
//!
//! The headers of the emitted Verilog, `docs/ports.md` and `photoncube list MACHINE` say what is written here.

mod facts;
mod ports;
mod protocol;

use crate::machine::Machine;

pub use facts::Fact;
pub use ports::{Direction, Port};

/// A machine as it is seen from outside.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interface {
    /// The ports of the top module, grouped by stream; the clock is the first.
    pub ports: Vec<Port>,
    /// How the streams move, a rule a line.
    pub protocol: Vec<String>,
    /// Formats, limits and clocks.
    pub facts: Vec<Fact>,
}

impl Interface {
    /// That of a machine.
    pub fn of(machine: &Machine) -> Self {
        Self {
            ports: ports::ports(machine),
            protocol: protocol::protocol(machine),
            facts: facts::facts(machine),
        }
    }
}
