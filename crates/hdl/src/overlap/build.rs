//! The table of overlapped machines that are compiled in.

use photoncube_spec::{Machine, Squarer, Widths};

use super::cell::Cell;
use super::processor::Processor;
use crate::build::{bits, program_widths};
use crate::level::Level;
use crate::pinned::Pinned;

/// The compiled widths, see [`program_widths`].
pub(crate) const WIDTHS: [u32; 10] = [8, 8, 8, 16, 18, 16, 0, 16, 18, 32];

/// Builds the block of an overlapped machine at a level; `None` if its widths are not compiled in.
pub(crate) fn build(machine: &Machine, level: Level) -> Option<Box<dyn Pinned>> {
    let is_built_in = cfg!(all(feature = "named-machines", not(test)))
        && bits(program_widths(&Widths::of(machine))) == WIDTHS
        && machine.dimension == 4
        && machine.squarer == Squarer::Digits;
    if !is_built_in {
        return None;
    }
    match level {
        Level::Machine => Some(Box::new(Processor::<18, 16, 18, 32, 3, 4, 23>::new(
            machine,
        ))),
        Level::Cell => Some(Box::new(Cell::<18, 16, 18, 32, 23>::default())),
        Level::Network | Level::Unit(_) | Level::SquarePair | Level::Memory => None,
    }
}
