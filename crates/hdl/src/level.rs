//! The parts of a machine that can be built, simulated and emitted on their own.

use photoncube_spec::{Machine, Organisation};

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
    /// A spatial machine's squares of two photons' distances on one axis, with their registers.
    SquarePair,
    /// A spatial machine's photon memory, with its registers; what the head says are pins.
    Memory,
}

impl Level {
    /// The levels of a machine, the whole first.
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

    /// Whether the block has a clock.
    pub fn is_clocked(self) -> bool {
        matches!(
            self,
            Self::Machine | Self::Cell | Self::SquarePair | Self::Memory
        )
    }

    /// The level's name; the parts' are their modules' in the emitted Verilog.
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
