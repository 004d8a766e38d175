//! The golden model: what a machine computes, in plain integers.
//!
//! Two independent readings of the spec: a [`GoldenMachine`] does what the hardware does, clock by
//! clock, register by register ([`StepMachine`] runs programs, [`SpatialMachine`] is a pipeline);
//! [`gather`] is the sum over photons that all of it is for. A property test holds them equal.
//! [`LocalGather`] is the same sum over blocks of stored records in a photon format, with its
//! radius; [`PhotonPlanes`] makes it fast, bit for bit. No I/O, no HDL, and no arithmetic shared with the HDL.

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
