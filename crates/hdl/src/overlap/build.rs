//! The table of overlapped machines that are compiled in.

use photoncube_spec::{Machine, Squarer, Widths};

use super::cell::Cell;
use super::processor::Processor;
use crate::level::Level;
use crate::pinned::Pinned;

/// A description of the compiled widths, for messages.
pub(crate) const BUILT_IN: &str = "overlapped: 16 cells, 8-bit coordinates, 16-bit powers, \
                                   32-bit sums, squarers for LUTs; whole or by cell";

const WIDTHS: Widths = Widths {
    coordinate: 8,
    photon: 8,
    difference: 8,
    square: 16,
    radius_sq: 18,
    mantissa: 16,
    exponent: 0,
    power: 16,
    work: 18,
    sum: 32,
};

/// Builds the block of an overlapped machine at a level; `None` if its widths are not compiled in.
pub(crate) fn build(machine: &Machine, level: Level) -> Option<Box<dyn Pinned>> {
    let is_built_in = Widths::of(machine) == WIDTHS
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
