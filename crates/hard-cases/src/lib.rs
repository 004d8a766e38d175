#![doc = include_str!("../README.md")]

mod boundary;
mod case;
mod exact;
mod grid;
mod invariance;
mod lattice;
mod many;
mod naive;
mod places;
mod powers;
mod refusals;
mod room;
mod run;
mod setting;
mod wrap;

pub use case::{Bound, Contrast, HardCase, HardCaseError, Outcome};
pub use grid::Grid;
pub use run::{HardCaseReport, hard_case_formats, run_hard_case};
pub use setting::Setting;

/// Every hard case.
pub const HARD_CASES: &[HardCase] = &[
    boundary::TIES_F32,
    boundary::TIES_F64,
    boundary::HALF_STEPS,
    wrap::OWN_WIDTH,
    wrap::TRUNCATED,
    wrap::SQUARES_32,
    wrap::DIFFERENCES_16,
    many::QUARTER_MILLION,
    many::MILLION,
    many::FULLEST,
    many::PERMUTED,
    lattice::BIAS,
    lattice::CAUSTIC,
    lattice::JUST_OUTSIDE,
    places::EXACTLY_ONE,
    places::CORNERS,
    places::RADIUS_IS_EDGE,
    places::RADIUS_OVER_SCENE,
    powers::NONE,
    powers::ONE,
    powers::ONE_BLOCK,
    powers::ACROSS_BLOCKS,
    powers::ROUNDING,
    invariance::MOVED,
    invariance::SCALED,
    invariance::BRIGHTER,
    refusals::VALUES,
    refusals::COUNTS,
    refusals::PHOTONS,
];
