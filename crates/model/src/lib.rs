//! The golden model: the results and the registers of a machine, in plain integers.
//!
//! The crate has two independent readings of the spec. A [`GoldenMachine`] models the hardware register by
//! register, in every clock ([`StepMachine`] runs programs, [`SpatialMachine`] is a pipeline, [`LeafMachine`] a pipeline
//! behind a memory); a [`CoreModel`] models several leaf machines behind standard ports. [`gather`] is
//! the sum over photons that a machine must return. A property test shows that both agree. [`Gather`]
//! computes this sum over blocks of stored records, in the numbers of any machine; [`PhotonPlanes`] computes
//! it fast in a photon format, bit for bit. The crate does no I/O, uses no HDL, and shares no
//! arithmetic with the HDL.
//!
//! ```
//! use photoncube_model::gather;
//! use photoncube_spec::{Photon, Query, find_machine};
//!
//! let query = Query { position: [100, 100, 100], radius_sq: 25 };
//! let photon = |x| Photon { position: [x, 100, 100], power: [300, 200, 100], exponent: 0 };
//! // 5 steps away is in range, 6 are not.
//! let sums = gather(find_machine("paper")?, &query, [photon(105), photon(106)])?;
//! assert_eq!((sums.count, sums.power), (1, [300, 200, 100]));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod core;
mod gather;
mod golden;
mod leaf;
mod overlap;
mod planes;
mod sequential;
mod spatial;

pub use crate::core::{CoreModel, SerialFrame, SerialModel};
pub use gather::{
    CountError, Gather, GatherError, Limits, PackError, RangeError, gather, pack, unpack,
};
pub use golden::{GoldenMachine, golden_machine};
pub use leaf::LeafMachine;
pub use overlap::{CellPorts, OverlapCell, OverlapMachine};
pub use planes::{
    Gathered, INDEX_BITS, INDEX_MASK, Instructions, LEAF, PhotonPlanes, PlacedQuery, Rows,
};
pub use sequential::{CellInputs, CellRules, CellState, StepMachine};
pub use spatial::{GoldenMemory, HeadStatus, SpatialMachine};
