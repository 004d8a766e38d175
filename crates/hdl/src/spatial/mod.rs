//! The spatial machines in rust-hdl: every cell keeps its instruction, and data flows through registers.
//!
//! A machine is its head and a chain of engines. In an engine, cell (photon g, role X, Y or Z) is half of a
//! `SquarePair`, and cell (g, D) is a `Lane`. The four roles process powers in a `ChannelSum` for each
//! channel and one for the count. Blocks that contain others only wire them (`wiring`); arithmetic is in
//! small blocks of its own (`arithmetic`, `digits`, `lookup`). A `Stage` is a register or a wire, as the
//! machine's set of pipeline registers states.

mod admission;
pub(crate) mod arithmetic;
mod copy;
mod delay;
mod digits;
mod engine;
mod flags;
mod head;
mod hidden;
pub(crate) mod lane;
mod lookup;
mod machine;
mod memory;
mod pinned;
mod presence;
mod queue;
pub(crate) mod registers;
pub(crate) mod square;
pub(crate) mod stage;
mod sums;
pub(crate) mod wiring;

pub(crate) use lookup::square_word;
pub(crate) use machine::SpatialMachine;
pub(crate) use memory::PhotonMemory;
pub(crate) use square::SquarePair;
