//! The plain gather, photon by photon, in the numbers of a machine: of stored records in blocks, and of the
//! words on a machine's pins.

mod direct;
mod error;
mod pack;
mod range;

pub use direct::{Gather, gather};
pub use error::{CountError, GatherError, PackError, RangeError};
pub use pack::{pack, unpack};
pub use range::Limits;
