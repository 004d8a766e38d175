//! The control block of a sequential machine: sequencer, control store and decoder.

mod decoder;
mod sequencer;
mod store;

pub(crate) use sequencer::Control;
pub(crate) use store::ControlStore;
