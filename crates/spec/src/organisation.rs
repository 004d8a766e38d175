//! The organisation of a machine: how its work is laid out over its cells and clocks.

use crate::leaf::Leaf;
use crate::sequential::OwnProgram;
use crate::spatial::Spatial;

/// How a machine's work is laid out over its cells and clocks.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Organisation {
    /// The paper's organisation: all cells do one instruction a clock, with one unit each.
    Sequential,
    /// The sequential organisation with a user's own program in place of the paper's.
    Programmed(OwnProgram),
    /// All units of a cell work at the same time, by a modulo schedule; see [`crate::overlap`].
    Overlapped,
    /// Every cell keeps its instruction, and data flows through registers; see [`Spatial`].
    Spatial(Spatial),
    /// A chain of engines behind a memory that skips the photons far from a batch; see [`Leaf`].
    Leaf(Leaf),
}

/// The rate at which a machine takes groups in the steady state: `groups` in every `clocks` clocks.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Rate {
    /// The number of groups that are taken.
    pub groups: u32,
    /// The number of clocks in which they are taken.
    pub clocks: u32,
}

impl Rate {
    /// The initiation interval: clocks from one group to the next, on average.
    pub fn interval(self) -> f64 {
        f64::from(self.clocks) / f64::from(self.groups)
    }
}
