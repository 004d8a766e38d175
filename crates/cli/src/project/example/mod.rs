//! Example testbenches: how the ports of a machine or a core are driven, for an engineer who connects one.
//!
//! A testbench drives a few photons and queries over the pins, and compares the results with the sums of the golden model's
//! direct gather. The machines share a template, because their ports differ only in the fields of the words.

mod core;
mod machine;
mod set;
mod text;

pub(super) use self::core::core_example;
pub(super) use self::machine::machine_example;
pub use self::set::Set;
