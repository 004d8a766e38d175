//! The step-exact model of the spatial machines: what it sums, when, and after a reset.

mod driver;
mod machines;
mod memory;
mod pace;
mod reset;
mod rows;
mod sums;
mod words;
