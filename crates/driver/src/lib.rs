#![doc = include_str!("../README.md")]

mod driver;
mod frames;
mod model;
mod transport;

pub use driver::{Driver, DriverError, Work};
pub use frames::{Frame, FramePlan, FrameWords};
pub use model::ModelTransport;
pub use transport::{Transport, TransportError};
