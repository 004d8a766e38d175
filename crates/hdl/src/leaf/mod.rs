//! The leaf machines in rust-hdl: a chain of engines behind a memory that skips the photons far from a batch.
//!
//! The control blocks (`fill`, `former`, `scan`, `player`, `tags`) and the arithmetic of boxes (`extent`, `gap`) are
//! kernels, whose widths are const generics. The two memories (`ram`, `words`) are written by hand. The blocks with parts
//! (`boxes`, `culler`, `machine`) only wire them. The chain is a spatial machine without a photon memory, unchanged.

mod boxes;
mod build;
mod culler;
mod extent;
mod fill;
mod former;
mod gap;
mod machine;
mod pinned;
mod player;
mod ram;
mod registers;
mod scan;
mod tags;
mod words;

pub use build::leaf;
pub(crate) use build::leaf_sizes;
use machine::LeafMachine;
