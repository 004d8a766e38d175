//! The golden model: the results and the registers of a machine, in plain integers.
//!
//! The crate has two independent readings of the spec. A [`GoldenMachine`] models the hardware register by
//! register, in every clock ([`StepMachine`] runs programs, [`SpatialMachine`] is a pipeline). [`gather`] is
//! the sum over photons that a machine must return. A property test shows that both agree. [`LocalGather`]
//! computes this sum over blocks of stored records in a photon format, with the format's radius;
//! [`PhotonPlanes`] computes it fast, bit for bit. The crate does no I/O, uses no HDL, and shares no
//! arithmetic with the HDL.

mod cell;
mod gather;
mod golden;
mod local;
mod machine;
mod overlap;
mod overlap_cell;
mod planes;
mod range;
mod spatial;

pub use cell::{CellInputs, CellRules, CellState};
pub use gather::{GatherError, gather};
pub use golden::{GoldenMachine, golden_machine};
pub use local::{
    CountError, LocalError, LocalGather, LocalLimits, PackError, ValueError, pack, unpack,
};
pub use machine::StepMachine;
pub use overlap::OverlapMachine;
pub use overlap_cell::{CellPorts, OverlapCell};
pub use planes::{Gathered, Instructions, LEAF, PhotonPlanes, Surroundings};
pub use range::{Limits, RangeError};
pub use spatial::{GoldenMemory, HeadStatus, SpatialMachine};
