//! The plain gathers, photon by photon: of a machine's numbers, and of the records of a photon format.

mod direct;
mod error;
mod local;
mod range;

pub use direct::gather;
pub use error::{CountError, GatherError, PackError, RangeError};
pub use local::{LocalGather, LocalLimits, pack, unpack};
pub use range::Limits;
