#![doc = include_str!("../README.md")]

mod chain;
mod cull;
mod cut;
mod driver;
mod exchanges;
mod forecast;
mod found;
mod frames;
mod model;
mod order;
mod schedule;
mod serial;
mod shares;
mod timetable;
mod transport;

pub use driver::{Driver, DriverError, Work};
pub use forecast::Forecast;
pub use frames::{Frame, FramePlan, PhotonLeaf, Set, SetBatch, SetQuery};
pub use model::ModelTransport;
pub use schedule::{Owed, Schedule, Scheduler};
pub use serial::{SerialError, SerialTransport};
pub use transport::{Transport, TransportError};
