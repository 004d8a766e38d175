#![doc = include_str!("../README.md")]

mod driver;
mod frames;
mod model;
mod schedule;
mod transport;

pub use driver::{Driver, DriverError, Work};
pub use frames::{Frame, FramePlan, PhotonLeaf, Set, SetBatch, SetQuery};
pub use model::ModelTransport;
pub use schedule::{Owed, Schedule, Scheduler};
pub use transport::{Transport, TransportError};
