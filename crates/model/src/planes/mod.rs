//! The fast gather: the sums of [`crate::Gather`], bit for bit, many photons at a time.
//!
//! - [`PhotonPlanes`] stores photons in planes of bytes: all x of a leaf, all y, all z, then the mantissas. A
//!   *leaf* is up to [`LEAF`] neighbouring photons of one run (one block, one surface) and one exponent, with
//!   a bounding box.
//! - [`Surroundings`] lists the leaves that the queries of one block share, so that the lookup is done once
//!   for all of them.
//! - The kernel lays out a tray of leaves for all queries of the block, and tests each query against the tray
//!   with its sums in registers. A leaf whose box the query's sphere cannot touch is skipped before any work
//!   on its photons; the paper names this as future work. Leaves on a wall along two axes compute the
//!   distance on the third axis once.
//! - The operations on all photons of a leaf are written twice: in AVX2, and in plain loops over arrays for
//!   every other processor. The implementation is selected at run time.
//!
//! Integer sums do not depend on the order, so leaves may be in any order.

#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx2_positions;
mod frame;
mod gather;
mod kernel;
mod lanes;
mod leaf;
mod portable;
mod store;
mod surroundings;
mod tray;

pub use gather::{Gathered, Instructions};
pub use leaf::LEAF;
pub use store::PhotonPlanes;
pub use surroundings::Surroundings;
