//! Overlapped machines in rust-hdl, whose units work at the same time; see `photoncube_spec::overlap`.

mod add;
mod build;
mod cell;
mod control;
mod decoder;
mod digits;
mod pinned;
mod processor;

pub(crate) use build::{WIDTHS, build};
