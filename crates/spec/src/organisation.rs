//! How a machine's work is laid out over its cells and clocks.

use crate::own_program::OwnProgram;
use crate::spatial::Spatial;

/// How a machine's work is laid out over its cells and clocks.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Organisation {
    /// The paper's: all cells do one instruction a clock, each one unit at a time.
    Sequential,
    /// The same with a program of one's own.
    Programmed(OwnProgram),
    /// All units at the same time, by a modulo schedule; see [`crate::overlap`].
    Overlapped,
    /// Every cell keeps its instruction, and data flows through registers.
    Spatial(Spatial),
}

/// Groups that a machine takes, in the steady state, in so many clocks.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Rate {
    /// Groups.
    pub groups: u32,
    /// Clocks in which they are taken.
    pub clocks: u32,
}

impl Rate {
    /// Clocks from one group to the next, the initiation interval.
    pub fn interval(self) -> f64 {
        f64::from(self.clocks) / f64::from(self.groups)
    }
}
