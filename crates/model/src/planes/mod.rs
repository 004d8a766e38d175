//! The fast gather: the sums of [`crate::Gather`], bit for bit, many photons at a time.
//!
//! - [`PhotonPlanes`] stores photons in planes of bytes: all x of a leaf, all y, all z, their blocks, then the
//!   mantissas. A *leaf* is up to [`LEAF`] neighbouring photons of one run (one cube of blocks, one surface) and
//!   one exponent, with a bounding box.
//! - A *window* is consecutive queries in one cube, in a part of it or in one block, by the number of leaves
//!   around them. They share the lookup of these leaves.
//! - The kernel lays out the leaves around a cube, and tests each query of a window against trays of them, with
//!   its sums in registers. A leaf whose box the query's sphere cannot touch is skipped before any work
//!   on its photons; the paper names this as future work. Leaves on a wall along two axes compute the
//!   distance on the third axis once.
//! - The operations on all photons of a leaf are written four times: in AVX-512, in AVX2, in NEON, and in plain
//!   loops over arrays for every other processor. The implementation is selected at run time.
//!
//! Integer sums do not depend on the order, so leaves may be in any order.

mod around;
#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx2_positions;
#[cfg(target_arch = "x86_64")]
mod avx512;
#[cfg(target_arch = "x86_64")]
mod avx512_positions;
mod cube;
mod frame;
mod gather;
mod kernel;
mod lanes;
mod leaf;
#[cfg(all(target_arch = "aarch64", target_endian = "little"))]
mod neon;
#[cfg(all(target_arch = "aarch64", target_endian = "little"))]
mod neon_positions;
mod photon_planes;
mod portable;
mod rows;
mod store;
mod tray;
mod windows;

pub use gather::{Gathered, Instructions, PlacedQuery};
pub use leaf::LEAF;
pub use photon_planes::PhotonPlanes;
pub use rows::{INDEX_BITS, INDEX_MASK, Rows};
