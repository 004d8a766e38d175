//! The utilisation of an overlapped program.

use super::bound::{resource_bound, unit_bound};
use super::graph::{Graph, ROTATED};
use super::program::Program;
use crate::cell::{OVERLAPPED, UnitUse, unit_utilisation};

/// The utilisation of a program's kernel. The ports are not counted among the units, because their use is
/// limited by the group stream.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProgramReport {
    /// The number of clocks of a pass.
    pub interval: u32,
    /// The number of groups of a pass.
    pub groups: usize,
    /// The fewest clocks of a pass that the resources allow.
    pub resource_bound: u32,
    /// Clocks from a group's first op to its last, the longest of all groups.
    pub latency_clocks: u32,
    /// The use of the paper's three units.
    pub units: Vec<UnitUse>,
}

impl ProgramReport {
    /// Busy unit clocks over all unit clocks.
    pub fn unit_utilisation(&self) -> f64 {
        unit_utilisation(&self.units)
    }

    /// The unit that sets the resource bound, with its use.
    pub fn binding_unit(&self) -> Option<&UnitUse> {
        self.units.iter().max_by_key(|unit| unit.bound)
    }
}

/// Counts the use of the units over one pass of the kernel.
pub fn program_report(program: &Program) -> ProgramReport {
    let graph = Graph::new(ROTATED);
    let cells = 4;
    let unit_use = |unit| {
        let starts = program.kernel.iter();
        let starts = starts.filter(|op| OVERLAPPED.op(op.step.op).unit == Some(unit));
        UnitUse {
            unit,
            busy_clocks: starts.count() as u32,
            clocks: cells * program.interval,
            bound: unit_bound(&graph, unit),
        }
    };
    let units = OVERLAPPED.computing_units().into_iter();
    ProgramReport {
        interval: program.interval,
        groups: program.groups,
        resource_bound: resource_bound(&graph),
        latency_clocks: program.drain_clocks,
        units: units.map(unit_use).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::Unit;

    #[test]
    fn the_adders_bind_and_work_in_every_clock() {
        let report = program_report(&Program::rotated().unwrap());
        assert_eq!((report.interval, report.resource_bound), (3, 3));
        let binding = report.binding_unit().unwrap();
        assert_eq!(binding.unit, Unit::Add);
        assert_eq!(binding.utilisation(), 1.0);
        let busy: Vec<_> = report.units.iter().map(|unit| unit.busy_clocks).collect();
        assert_eq!(busy, [6, 8, 12], "square, gate, add of 12 each");
    }
}
