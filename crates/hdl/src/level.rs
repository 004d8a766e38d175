//! The levels: the parts of a machine that can be built, simulated and emitted on their own.

use photoncube_spec::{Machine, Organisation, SEQUENTIAL, Unit};

/// A level: the whole machine, or one part of it on its own.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// The whole machine.
    Machine,
    /// One cell, with its control fields as pins.
    Cell,
    /// The hypercube network.
    Network,
    /// A computing unit of a sequential cell.
    Unit(Unit),
    /// A spatial machine's squares of the differences of two photons on one axis, with their pipeline
    /// registers.
    SquarePair,
    /// A spatial machine's photon memory, with its registers. The signals from the head are pins.
    Memory,
}

impl Level {
    /// The levels of a machine; the first is the whole machine.
    pub fn of(machine: &Machine) -> Vec<Self> {
        match machine.organisation {
            Organisation::Sequential | Organisation::Programmed(_) => {
                let units = SEQUENTIAL.computing_units().into_iter().map(Self::Unit);
                let larger = [Self::Machine, Self::Cell, Self::Network];
                larger.into_iter().chain(units).collect()
            }
            Organisation::Overlapped => vec![Self::Machine, Self::Cell],
            Organisation::Spatial(_) if machine.has_memory() => {
                vec![Self::Machine, Self::SquarePair, Self::Memory]
            }
            Organisation::Spatial(_) => vec![Self::Machine, Self::SquarePair],
            Organisation::Leaf(_) => vec![Self::Machine],
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
            Self::Unit(unit) => unit.module(),
            Self::SquarePair => "square_pair",
            Self::Memory => "memory",
        }
    }
}
