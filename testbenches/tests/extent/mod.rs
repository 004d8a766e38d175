//! How much of each machine's proof the tests do.

use photoncube_spec::Machine;

/// How much of a machine's proof is done here; `photoncube verify` goes on for as long as one likes.
#[derive(Copy, Clone, PartialEq, Eq)]
pub enum Extent {
    /// One machine of each organisation, and a chain: in all devices, most in the fastest, which takes long to build.
    Full,
    /// Others of as many cells or a few times that: they differ in numbers and sizes. In Verilator they are compared by
    /// `photoncube verify --campaign`.
    Brief,
    /// Chains whose devices have many times the signals: that they are put together right, as their
    /// engines are those of shorter chains.
    Chain,
    /// Chains that take minutes in any Verilog simulator: in rust-hdl and the evaluator of the
    /// emitted text alone.
    LongChain,
}

impl Extent {
    /// That of a machine.
    pub fn of(machine: &Machine) -> Self {
        match machine.name {
            "paper" | "overlap" | "stream" | "tile-6" => Self::Full,
            _ if machine.queries_at_once() > 8 => Self::LongChain,
            _ if machine.queries_at_once() > 4 => Self::Chain,
            _ => Self::Brief,
        }
    }
}
