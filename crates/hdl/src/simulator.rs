//! Runs rust-hdl's own simulation: one settling loop for each clock level.

use photoncube_spec::{Machine, Pins};
use thiserror::Error;

use crate::build::{NotBuiltIn, build};
use crate::generator::{self, GeneratorError};
use crate::level::Level;
use crate::pinned::{Pinned, pins};
use crate::unit::{Unit, build_unit};

/// Passes of the settling loop after which a design counts as unstable. Legal designs need about 12.
const MAX_PASSES: usize = 100;

/// The error of a simulation that does not settle: the design has a combinational loop.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Error)]
#[error("the design did not settle in {MAX_PASSES} passes: look for a combinational loop")]
pub struct NotSettled;

/// A rust-hdl simulation of a block. It starts in the power-up state.
pub struct Simulator {
    block: Box<dyn Pinned>,
}

impl Simulator {
    /// Builds the block of a machine at a level.
    ///
    /// # Errors
    /// The machine's widths are not built in.
    pub fn new(machine: &Machine, level: Level) -> Result<Self, NotBuiltIn> {
        Ok(Self {
            block: build(machine, level)?,
        })
    }

    /// Simulates a block whose signals are claimed.
    pub(crate) fn of_block(block: Box<dyn Pinned>) -> Self {
        Self { block }
    }

    /// Builds a unit on its own, with operands of `bits` bits.
    ///
    /// # Errors
    /// The unit is not built at that width.
    pub fn of_unit(unit: Unit, bits: u32) -> Result<Self, NotBuiltIn> {
        Ok(Self {
            block: build_unit(unit, bits)?,
        })
    }

    /// Simulates one clock. Drives the inputs with the falling edge, appends the observed values in the order
    /// of [`level_pins`], and makes the rising edge. A block without a clock only settles.
    ///
    /// # Errors
    /// The design does not settle.
    pub fn clock(&mut self, inputs: &[u64], observed: &mut Vec<u64>) -> Result<(), NotSettled> {
        self.block.drive(inputs);
        self.block.set_clock(false);
        self.settle()?;
        self.block.sample(observed);
        self.block.set_clock(true);
        self.settle()
    }

    fn settle(&mut self) -> Result<(), NotSettled> {
        let settled = (0..MAX_PASSES).any(|_| self.block.settle());
        settled.then_some(()).ok_or(NotSettled)
    }
}

/// Lists the pins and registers of a block, in the order of its rows.
///
/// # Errors
/// The machine is neither built in nor has a generator.
pub fn level_pins(machine: &Machine, level: Level) -> Result<Pins, GeneratorError> {
    if level == Level::Machine {
        return Ok(Pins::of(machine));
    }
    match build(machine, level) {
        Ok(block) => Ok(pins(block.as_ref(), machine, level)),
        Err(_) => Ok(generator::emit(machine, level)?.pins),
    }
}
