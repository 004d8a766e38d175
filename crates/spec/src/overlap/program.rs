//! The program: the kernel that runs as long as there are groups, and the epilogue that follows.
//!
//! The kernel starts an iteration every `interval` clocks, before the earlier ones are done, and
//! it is all there is: it also fills and empties itself. Every op is done in every pass, on a group
//! or on nothing; only the power that a group brings, and that is absent where there is none, leaves
//! a trace in a sum.

use super::graph::{Graph, ROTATED};
use super::op::Op;
use super::schedule::{Schedule, SchedulerError, schedule};
use crate::hypercube::{Axis, Role};

/// An op of the kernel, the same in every quad.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct KernelOp {
    /// The clock of the pass in which it starts.
    pub clock: u32,
    /// How many passes after its group's it does so.
    pub stage: u32,
    /// Its group in the iteration.
    pub group: usize,
    /// The cell.
    pub role: Role,
    /// What it does.
    pub op: Op,
}

/// An op of the epilogue, the same in every cell.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct EpilogueOp {
    /// The clock, counted from the epilogue's first.
    pub clock: u32,
    /// What is done.
    pub op: Op,
}

/// A program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Program {
    /// Clocks of a pass of the kernel.
    pub interval: u32,
    /// Groups that an iteration takes.
    pub groups: usize,
    /// The ops of a pass, by clock, role and op.
    pub kernel: Vec<KernelOp>,
    /// Crosses the sums over the photon axes.
    pub epilogue: Vec<EpilogueOp>,
    /// Clocks from that in which the last group is taken to the epilogue's first.
    pub drain_clocks: u32,
}

impl Program {
    /// The program of the machine with rotated roles.
    ///
    /// # Errors
    /// The scheduler finds none.
    pub fn rotated() -> Result<Self, SchedulerError> {
        let graph = Graph::new(ROTATED);
        let schedule = schedule(&graph)?;
        Ok(Self::new(&graph, &schedule))
    }

    /// The program of a schedule.
    pub fn new(graph: &Graph, schedule: &Schedule) -> Self {
        let interval = schedule.interval;
        let bundles = graph.bundles.iter().zip(&schedule.starts);
        let mut kernel: Vec<_> = bundles
            .flat_map(|(bundle, &start)| {
                bundle.parts.iter().map(move |part| {
                    let clock = start + part.offset;
                    KernelOp {
                        clock: clock % interval,
                        stage: clock / interval,
                        group: bundle.group,
                        role: part.role,
                        op: part.op,
                    }
                })
            })
            .collect();
        kernel.sort_by_key(|op| (op.clock, op.role, op.op, op.group));
        let mut program = Self {
            interval,
            groups: graph.groups,
            kernel,
            epilogue: cross(&[Axis::X, Axis::Y]),
            drain_clocks: 0,
        };
        let drain = |group| program.latency(group);
        program.drain_clocks = (0..program.groups).map(drain).max().unwrap_or(0);
        program
    }

    /// The clock in which an op starts, counted from the first of its iteration.
    pub fn time(&self, op: &KernelOp) -> u32 {
        op.stage * self.interval + op.clock
    }

    /// The clock of a pass in which a group of the iteration is taken.
    pub fn take_clock(&self, group: usize) -> u32 {
        let is_take = |op: &&KernelOp| op.op == Op::LoadPower && op.group == group;
        self.kernel.iter().find(is_take).map_or(0, |op| op.clock)
    }

    /// Clocks from that in which a group is taken to the first after its last accumulation.
    pub fn latency(&self, group: usize) -> u32 {
        let of_group = self.kernel.iter().filter(|op| op.group == group);
        let ends = of_group.map(|op| self.time(op) + op.op.row().latency);
        ends.max().map_or(0, |end| end - self.take_clock(group))
    }

    /// Passes in which ops of one iteration stand.
    pub fn stages(&self) -> u32 {
        self.kernel.iter().map(|op| op.stage + 1).max().unwrap_or(0)
    }

    /// Clocks of the epilogue.
    pub fn epilogue_clocks(&self) -> u32 {
        let ends = self.epilogue.iter().map(|op| op.clock + 1);
        ends.max().unwrap_or(0)
    }

    /// Clocks from that in which a query is taken to the first in which its result can be, with
    /// `groups` groups and no waiting.
    pub fn latency_clocks(&self, groups: u64) -> u64 {
        let query = 1;
        let last = groups.saturating_sub(1);
        let each = self.groups as u64;
        let pass = u64::from(self.interval) * (last / each);
        let last_taken = pass + u64::from(self.take_clock((last % each) as usize));
        query + last_taken + u64::from(self.drain_clocks) + u64::from(self.epilogue_clocks())
    }

    /// Clocks that a query occupies the machine with no waiting: its latency and the one clock in
    /// which the result is taken.
    pub fn occupied_clocks(&self, groups: u64) -> u64 {
        self.latency_clocks(groups) + 1
    }

    /// Clocks from one group to the next, on average.
    pub fn initiation_interval(&self) -> f64 {
        f64::from(self.interval) / self.groups as f64
    }
}

/// Each axis takes two clocks: the sums are received, then added.
fn cross(axes: &[Axis]) -> Vec<EpilogueOp> {
    let ops = axes
        .iter()
        .flat_map(|&axis| [Op::Receive(axis), Op::Accumulate]);
    (0..)
        .zip(ops)
        .map(|(clock, op)| EpilogueOp { clock, op })
        .collect()
}
