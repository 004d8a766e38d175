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
mod gathers;
mod machine;
mod pinned;
mod player;
mod ram;
mod registers;
mod scan;
mod tags;
mod words;

use photoncube_spec::Leaf;

/// Bits of a facing, of a set of facings, and of a tag.
const FACING: usize = Leaf::FACING_BITS as usize;
const FACINGS: usize = Leaf::FACINGS as usize;
const TAG: usize = Leaf::TAG_BITS as usize;
/// Bits of the groups of a pair that are played.
const MASK: usize = Leaf::PAIR * Leaf::GROUPS;

pub use build::leaf;
pub(crate) use build::leaf_sizes;
use machine::LeafMachine;
