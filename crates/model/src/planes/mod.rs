//! The fast gather: the sums of [`crate::LocalGather`], bit for bit, many photons at a time.
//!
//! - [`PhotonPlanes`] keeps photons in planes of bytes: all x of a leaf, all y, all z, then the
//!   mantissas. A *leaf* is up to [`LEAF`] photons of one run (one block, one surface) and one exponent,
//!   near each other, with a box around them.
//! - [`Surroundings`] lists the leaves that the queries of one block share, so that what is looked up is
//!   looked up once for all of them.
//! - The kernel lays out a tray of leaves for all queries of the block, and each query meets them with its
//!   sums in registers. A leaf whose box a query's sphere cannot touch is skipped before any work on its
//!   photons, which the paper names as future work. Leaves on a wall along two axes share their distance
//!   on the third.
//! - What is done with all photons of a leaf at a time is written twice: in AVX2, and in plain loops
//!   over arrays for every other processor. Which of them runs is found out at run time.
//!
//! Sums of integers do not depend on the order, so leaves may be in any.

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
