//! The plain gathers, photon by photon: of a machine's numbers, and of the records of a photon format.

mod direct;
mod local;
mod range;

pub use direct::{GatherError, gather};
pub use local::{
    CountError, LocalError, LocalGather, LocalLimits, PackError, ValueError, pack, unpack,
};
pub use range::{Limits, RangeError};
