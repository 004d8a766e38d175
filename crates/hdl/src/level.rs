//! The parts of a machine that can be built, simulated and emitted on their own.

/// A block of the machine: the whole, or a part for itself.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// The whole machine.
    Machine,
    /// One cell, with its control fields as pins.
    Cell,
    /// The hypercube network.
    Network,
    /// The unit `A+B`.
    Add,
    /// The unit `(A-B)^2`.
    Square,
    /// The unit `if A>B, output 0`.
    Gate,
}

impl Level {
    /// All levels, the whole first.
    pub const ALL: [Self; 6] = [
        Self::Machine,
        Self::Cell,
        Self::Network,
        Self::Add,
        Self::Square,
        Self::Gate,
    ];

    /// The level's name; the parts' are their modules' in the emitted Verilog.
    pub fn name(self) -> &'static str {
        match self {
            Self::Machine => "machine",
            Self::Cell => "cell",
            Self::Network => "network",
            Self::Add => "add_unit",
            Self::Square => "square_unit",
            Self::Gate => "gate_unit",
        }
    }
}
