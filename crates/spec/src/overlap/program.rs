//! The program of an overlapped machine: a kernel that runs as long as there are groups, and an epilogue.
//!
//! The kernel starts an iteration every `interval` clocks, before the earlier iterations are complete. There
//! is no prologue: the kernel also fills and empties the pipeline. Every op is done in every pass, on a group
//! or on nothing. A missing group has an absent power, so it adds nothing to a sum.

use super::graph::{Graph, ROTATED};
use super::schedule::{Schedule, SchedulerError, schedule};
use crate::cell::{OVERLAPPED, Op, ScheduledStep, Step, phase_clocks};
use crate::hypercube::{Axis, Role};

/// An op of the kernel. All quads do it alike.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct KernelOp {
    /// The clock of the pass in which the op starts.
    pub clock: u32,
    /// The number of passes from the one that takes the group to the one that does the op.
    pub stage: u32,
    /// The index of the op's group in the iteration.
    pub group: usize,
    /// The role of the cell that does the op.
    pub role: Role,
    /// The step that the cell does.
    pub step: Step,
}

/// The program of an overlapped machine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Program {
    /// Clocks of a pass of the kernel.
    pub interval: u32,
    /// Groups that an iteration takes.
    pub groups: usize,
    /// The ops of a pass, by clock, role and op.
    pub kernel: Vec<KernelOp>,
    /// The steps of the epilogue, which add the sums across the photon axes. All cells do them alike.
    pub epilogue: Vec<ScheduledStep>,
    /// Clocks from the one in which the last group is taken to the first of the epilogue.
    pub drain_clocks: u32,
}

impl Program {
    /// Makes the program of the machine whose roles rotate.
    ///
    /// # Errors
    /// The scheduler finds no schedule.
    pub fn rotated() -> Result<Self, SchedulerError> {
        let graph = Graph::new(ROTATED);
        let schedule = schedule(&graph)?;
        Ok(Self::new(&graph, &schedule))
    }

    /// Makes the program of a schedule.
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
                        step: part.step,
                    }
                })
            })
            .collect();
        kernel.sort_by_key(|op| (op.clock, op.role, op.step, op.group));
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

    /// The clock in which an op starts, counted from the first clock of its iteration.
    pub fn time(&self, op: &KernelOp) -> u32 {
        op.stage * self.interval + op.clock
    }

    /// The clock of a pass in which a group of the iteration is taken.
    pub fn take_clock(&self, group: usize) -> u32 {
        let is_take = |op: &&KernelOp| op.step.op == Op::LoadPower && op.group == group;
        self.kernel.iter().find(is_take).map_or(0, |op| op.clock)
    }

    /// Clocks from the one in which a group is taken to the first after the group's last accumulation.
    pub fn latency(&self, group: usize) -> u32 {
        let of_group = self.kernel.iter().filter(|op| op.group == group);
        let ends = of_group.map(|op| self.time(op) + OVERLAPPED.op(op.step.op).latency);
        ends.max().map_or(0, |end| end - self.take_clock(group))
    }

    /// The number of passes over which the ops of one iteration are spread.
    pub fn stages(&self) -> u32 {
        self.kernel.iter().map(|op| op.stage + 1).max().unwrap_or(0)
    }

    /// The number of clocks of the epilogue.
    pub fn epilogue_clocks(&self) -> u32 {
        phase_clocks(&self.epilogue)
    }

    /// Clocks from the one in which a query is taken to the first in which its result can be taken, for
    /// `groups` groups while no stream waits.
    pub fn latency_clocks(&self, groups: u64) -> u64 {
        let query = 1;
        let last = groups.saturating_sub(1);
        let each = self.groups as u64;
        let pass = u64::from(self.interval) * (last / each);
        let last_taken = pass + u64::from(self.take_clock((last % each) as usize));
        query + last_taken + u64::from(self.drain_clocks) + u64::from(self.epilogue_clocks())
    }

    /// Clocks that a query occupies the machine while no stream waits: the latency and the one clock in which
    /// the result is taken.
    pub fn occupied_clocks(&self, groups: u64) -> u64 {
        self.latency_clocks(groups) + 1
    }

    /// Clocks from one group to the next, on average.
    pub fn initiation_interval(&self) -> f64 {
        f64::from(self.interval) / self.groups as f64
    }
}

/// The steps that add the sums across these axes. Each axis takes two clocks: the sums are received, then
/// added.
fn cross(axes: &[Axis]) -> Vec<ScheduledStep> {
    let steps = axes
        .iter()
        .flat_map(|&axis| [Step::across(Op::Receive, axis), Step::new(Op::Accumulate)]);
    ScheduledStep::one_a_clock(&steps.collect::<Vec<_>>())
}
