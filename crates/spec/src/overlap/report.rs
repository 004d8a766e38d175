//! The utilisation of a program.

use super::bound::{UnitBound, resource_bound, unit_bounds};
use super::graph::{Graph, ROTATED};
use super::op::Unit;
use super::program::Program;

/// How much of the kernel's time a unit works.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct UnitUse {
    /// The unit.
    pub unit: Unit,
    /// Ops that it starts in one pass, in the four cells of a quad together.
    pub busy_clocks: u32,
    /// Clocks of a pass, in four cells.
    pub clocks: u32,
    /// Clocks below which no pass can be, because of this unit.
    pub bound: u32,
}

impl UnitUse {
    /// Busy clocks over all clocks.
    pub fn utilisation(&self) -> f64 {
        f64::from(self.busy_clocks) / f64::from(self.clocks)
    }
}

/// The utilisation of a program in its kernel. The ports are not among the units: the group stream
/// gives them a word only so often.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProgramReport {
    /// Clocks of a pass.
    pub interval: u32,
    /// Groups of a pass.
    pub groups: usize,
    /// Clocks of a pass that the resources allow.
    pub resource_bound: u32,
    /// Clocks from a group's first to its last, the longest of all groups.
    pub latency_clocks: u32,
    /// The paper's three units.
    pub units: Vec<UnitUse>,
}

impl ProgramReport {
    /// Busy unit clocks over all unit clocks.
    pub fn unit_utilisation(&self) -> f64 {
        let sum = |count: fn(&UnitUse) -> u32| self.units.iter().map(count).sum::<u32>();
        f64::from(sum(|unit| unit.busy_clocks)) / f64::from(sum(|unit| unit.clocks))
    }

    /// The unit that sets the bound, with its use.
    pub fn binding_unit(&self) -> Option<&UnitUse> {
        self.units.iter().max_by_key(|unit| unit.bound)
    }
}

/// Counts the use of the units over a pass of the kernel.
pub fn program_report(program: &Program) -> ProgramReport {
    let graph = Graph::new(ROTATED);
    let cells = 4;
    let units = unit_bounds(&graph).into_iter().take(3);
    ProgramReport {
        interval: program.interval,
        groups: program.groups,
        resource_bound: resource_bound(&graph),
        latency_clocks: program.drain_clocks,
        units: units
            .map(|UnitBound { unit, clocks, .. }| {
                let starts = program.kernel.iter();
                let starts = starts.filter(|op| op.op.row().unit == Some(unit));
                UnitUse {
                    unit,
                    busy_clocks: starts.count() as u32,
                    clocks: cells * program.interval,
                    bound: clocks,
                }
            })
            .collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
