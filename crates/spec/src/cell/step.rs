//! A step: an op with the network axis that it uses.

use std::fmt;

use super::CellTables;
use super::op::Op;
use super::register::Register;
use crate::hypercube::Axis;

/// An op with the network axis that it uses, if it uses one.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Step {
    /// The op of the step.
    pub op: Op,
    /// The axis of the link; `Some` only where [`crate::OpRow::link`] is.
    pub axis: Option<Axis>,
}

impl Step {
    /// A step that uses no link.
    pub const fn new(op: Op) -> Self {
        Self { op, axis: None }
    }

    /// A step that receives a word on an axis.
    pub const fn across(op: Op, axis: Axis) -> Self {
        Self {
            op,
            axis: Some(axis),
        }
    }

    /// A sequential machine's step that adds the neighbour's work register on an axis.
    pub const fn exchange_add(axis: Axis) -> Self {
        Self::across(Op::Add, axis)
    }
}

impl fmt::Display for Step {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.op.mnemonic())?;
        match (self.op, self.axis) {
            (Op::MovePower(place), _) => write!(f, " {place}"),
            (_, Some(axis)) => write!(f, " {axis}"),
            _ => Ok(()),
        }
    }
}

/// A step with the clock in which every cell does it.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct ScheduledStep {
    /// The clock, counted from 0 in its phase.
    pub clock: u32,
    /// The step that all cells do in that clock.
    pub step: Step,
}

impl ScheduledStep {
    /// Steps in successive clocks, from clock 0 on.
    pub(crate) fn one_a_clock(steps: &[Step]) -> Vec<Self> {
        let steps = (0..).zip(steps);
        steps.map(|(clock, &step)| Self { clock, step }).collect()
    }
}

/// The clocks of a phase, up to its last step.
pub(crate) fn phase_clocks(phase: &[ScheduledStep]) -> u32 {
    phase.iter().map(|s| s.clock + 1).max().unwrap_or(0)
}

/// A register that a step reads, in its own cell or in the neighbour on an axis.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Read {
    /// The register that is read.
    pub register: Register,
    /// The axis of the neighbour that holds the register; `None` for the step's own cell.
    pub across: Option<Axis>,
}

impl CellTables {
    /// The registers that a step reads; that of the link comes last.
    pub fn reads(&self, step: Step) -> Vec<Read> {
        let row = self.op(step.op);
        let own = row.reads.iter().map(|&register| Read {
            register: register.at(step.op),
            across: None,
        });
        let link = row.link.map(|link| Read {
            register: link(step.axis),
            across: step.axis,
        });
        own.chain(link).collect()
    }

    /// The registers that a step writes.
    pub fn writes(&self, step: Step) -> impl Iterator<Item = Register> {
        let writes = self.op(step.op).writes.iter();
        writes.map(move |register| register.at(step.op))
    }
}
