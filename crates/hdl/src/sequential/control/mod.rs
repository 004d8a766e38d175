//! The control block of a sequential machine: sequencer and decoder, around the control store of `parts`.

mod decoder;
mod sequencer;

pub(crate) use sequencer::Control;
