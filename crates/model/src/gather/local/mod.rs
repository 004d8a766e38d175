//! The gather of a photon format, by the rules of [`photoncube_spec::PhotonFormat`], in integers.

mod gather;
mod limits;
mod pack;

pub use gather::LocalGather;
pub use limits::LocalLimits;
pub use pack::{pack, unpack};
