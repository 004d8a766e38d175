//! Blocks that the sequential and the overlapped machines both contain.

mod difference;
mod store;

pub(crate) use difference::Difference;
pub(crate) use store::ControlStore;
