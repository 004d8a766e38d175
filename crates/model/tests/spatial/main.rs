//! Tests of the step-exact model of the spatial machines: its sums, its timing, and its behaviour after a
//! reset.

mod driver;
mod machines;
mod memory;
mod pace;
mod reset;
mod rows;
mod sums;
mod words;
