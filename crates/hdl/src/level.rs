//! The levels: the parts of a machine that can be built, simulated and emitted on their own.

use photoncube_spec::{Machine, Organisation};

/// A level: the whole machine, or one part of it on its own.
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
    /// A spatial machine's squares of the differences of two photons on one axis, with their pipeline
    /// registers.
    SquarePair,
    /// A spatial machine's photon memory, with its registers. The signals from the head are pins.
    Memory,
}

impl Level {
    /// The levels of a machine; the first is the whole machine.
    pub fn of(machine: &Machine) -> &'static [Self] {
        match machine.organisation {
            Organisation::Sequential | Organisation::Programmed(_) => &[
                Self::Machine,
                Self::Cell,
                Self::Network,
                Self::Add,
                Self::Square,
                Self::Gate,
            ],
            Organisation::Overlapped => &[Self::Machine, Self::Cell],
            Organisation::Spatial(_) if machine.has_memory() => {
                &[Self::Machine, Self::SquarePair, Self::Memory]
            }
            Organisation::Spatial(_) => &[Self::Machine, Self::SquarePair],
        }
    }

    /// Whether the block has a clock pin.
    pub fn is_clocked(self) -> bool {
        matches!(
            self,
            Self::Machine | Self::Cell | Self::SquarePair | Self::Memory
        )
    }

    /// The level's name. For a part it is the name of its module in the emitted Verilog.
    pub fn name(self) -> &'static str {
        match self {
            Self::Machine => "machine",
            Self::Cell => "cell",
            Self::Network => "network",
            Self::Add => "add_unit",
            Self::Square => "square_unit",
            Self::Gate => "gate_unit",
            Self::SquarePair => "square_pair",
            Self::Memory => "memory",
        }
    }
}
