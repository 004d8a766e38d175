//! Decides how much of each machine's verification the tests run.

use photoncube_spec::Machine;

/// The extent of a machine's verification in the tests. `photoncube verify` runs for any length.
#[derive(Copy, Clone, PartialEq, Eq)]
pub enum Extent {
    /// One machine of each organisation, and a chain: all devices, and most iterations in the fastest device,
    /// which takes long to build.
    Full,
    /// Other machines of up to a few times as many cells, which differ in numbers and sizes.
    /// `photoncube verify campaign` compares them in Verilator.
    Brief,
    /// Chains with many times the signals. The tests check that they are assembled correctly; their engines
    /// are those of shorter chains.
    Chain,
    /// Chains that take minutes to build in any Verilog simulator. They run only in the evaluator of the
    /// emitted text; `photoncube verify` runs them in rust-hdl.
    LongChain,
}

impl Extent {
    /// The extent of a machine.
    pub fn of(machine: &Machine) -> Self {
        match machine.name {
            "paper" | "overlap" | "stream" | "tile-6" => Self::Full,
            _ if machine.queries_at_once() > 8 => Self::LongChain,
            _ if machine.queries_at_once() > 4 => Self::Chain,
            _ => Self::Brief,
        }
    }
}
