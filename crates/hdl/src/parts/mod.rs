//! Parts that machines of several organisations contain.

mod decoder;
mod difference;
mod group_word;
mod store;

pub(crate) use decoder::{assignments, decoder};
pub(crate) use difference::Difference;
pub(crate) use group_word::{Field, GroupPins, group_fields};
pub(crate) use store::ControlStore;
