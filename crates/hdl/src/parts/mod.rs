//! Blocks that the sequential and the overlapped machines both contain.

mod decoder;
mod difference;
mod store;

pub(crate) use decoder::{assignments, decoder};
pub(crate) use difference::Difference;
pub(crate) use store::ControlStore;
