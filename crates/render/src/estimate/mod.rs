//! The radiance estimate: its f64 reference, in all its forms, and the gathers of the engines.
//!
//! [`Neighbourhood`] is the photons around a query: those that face its way, with their squared distances,
//! found by brute force or by a walk over the map's blocks. The estimates of irradiance E = sum(power K(d/r))
//! norm / r^2 are made from it, for a [`Kernel`] and a radius. The radius is either given (the paper's eq. 2)
//! or that of the k-th nearest photon (its eq. 1).
//!
//! The machine has one op on distances, `d^2 <= radius_sq`. Two modules derive all other forms from it:
//! [`smallest_radius_sq`] finds the k-th photon by bisection on the count, and a [`Ladder`] mixes rectangles
//! of several radii to a smooth kernel.
//!
//! An [`Estimator`] is one of these forms, and makes it by any engine (`estimates.rs`). The file `gather.rs`
//! gathers one query, and `batch.rs` many queries at once.

mod batch;
mod bisection;
mod estimates;
mod estimator;
mod gather;
mod integers;
mod kernel;
mod ladder;
mod neighbourhood;
mod sectors;

pub use bisection::{Bisection, smallest_radius_sq};
pub(crate) use estimates::halved;
pub use estimator::{Estimator, MIN_K, UnfitEstimator, UnknownEstimator};
pub(crate) use gather::{Estimate, Refusal, disc_area, estimate_f64};
pub use kernel::Kernel;
pub use ladder::{Ladder, LadderError, MAX_RUNGS, Rung};
pub use neighbourhood::{EstimatorError, KernelEstimate, Near, Neighbourhood};
pub(crate) use sectors::{SECTORS, Sectors, sectors};
