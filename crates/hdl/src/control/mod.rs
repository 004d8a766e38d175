//! The control block: sequencer, control store and the decoder of its words.

mod decoder;
mod sequencer;
mod store;

pub(crate) use sequencer::Control;
pub(crate) use store::ControlStore;
