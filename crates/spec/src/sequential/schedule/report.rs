//! The utilisation of a schedule.

use crate::cell::{OpRow, Register, SEQUENTIAL, UnitUse, unit_utilisation};
use crate::hypercube::Hypercube;
use crate::sequential::Microprogram;

/// The utilisation of a schedule.
///
/// `units` counts the paper's three computing units; `registers` counts a register as used in a
/// clock in which it is read or written. Then
/// `utilisation = (sum of busy unit clocks + sum of used register clocks) / (clocks x (units + registers))`.
/// The paper reports 62 % "over ALUs and registers" for its machine without giving its formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ScheduleReport {
    /// The number of clocks of an iteration.
    pub initiation_interval: u32,
    /// The number of photons that an iteration tests.
    pub photons: usize,
    /// The use of each computing unit.
    pub units: Vec<UnitUse>,
    /// Each register, with the number of clocks in which it is read or written.
    pub registers: Vec<(Register, u32)>,
}

impl ScheduleReport {
    /// Busy unit clocks over all unit clocks.
    pub fn unit_utilisation(&self) -> f64 {
        unit_utilisation(&self.units)
    }

    /// Used register clocks over all register clocks.
    pub fn register_utilisation(&self) -> f64 {
        self.ratio(self.used_registers(), self.registers.len())
    }

    /// Utilisation of units and registers together, by the formula above.
    pub fn utilisation(&self) -> f64 {
        let busy_units: u32 = self.units.iter().map(|unit| unit.busy_clocks).sum();
        self.ratio(
            busy_units + self.used_registers(),
            self.units.len() + self.registers.len(),
        )
    }

    fn used_registers(&self) -> u32 {
        self.registers.iter().map(|&(_, clocks)| clocks).sum()
    }

    fn ratio(&self, used: u32, resources: usize) -> f64 {
        f64::from(used) / (f64::from(self.initiation_interval) * resources as f64)
    }
}

/// Counts the use of units and registers over one iteration.
pub fn schedule_report(program: &Microprogram, cube: Hypercube) -> ScheduleReport {
    let rows: Vec<_> = program
        .iteration
        .iter()
        .map(|scheduled| SEQUENTIAL.op(scheduled.step.op))
        .collect();
    let count = |used: &dyn Fn(&OpRow) -> bool| rows.iter().filter(|row| used(row)).count() as u32;
    let interval = program.initiation_interval();
    let unit_use = |unit| {
        let busy_clocks = count(&|row| row.unit == Some(unit));
        UnitUse {
            unit,
            busy_clocks,
            clocks: interval,
            bound: busy_clocks,
        }
    };
    ScheduleReport {
        initiation_interval: interval,
        photons: cube.photons(),
        units: SEQUENTIAL
            .computing_units()
            .into_iter()
            .map(unit_use)
            .collect(),
        registers: SEQUENTIAL
            .registers
            .iter()
            .map(|register| {
                let r = register.register;
                let used = count(&|row| row.reads.contains(&r) || row.writes.contains(&r));
                (r, used)
            })
            .collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::Unit;

    #[test]
    fn utilisation_counts_units_and_registers() {
        let cube = Hypercube::new(4);
        let report = schedule_report(&Microprogram::all_reduce(cube), cube);
        let busy = |unit| {
            let found = report.units.iter().find(|found| found.unit == unit);
            found.map(|found| found.busy_clocks)
        };
        let units = [Unit::Square, Unit::Gate, Unit::Add];
        assert_eq!(units.map(busy), [1, 1, 5].map(Some));
        // q: sqd. r: gate. p: ldp, sqd. w: ldw, gate. v: sqd, four adds, gate, acc. s: acc.
        let used: Vec<_> = report.registers.iter().map(|&(_, clocks)| clocks).collect();
        assert_eq!(used, [1, 1, 2, 2, 7, 1]);
        let all = report.units.len() + report.registers.len();
        assert_eq!(report.utilisation(), 21.0 / (9.0 * all as f64));
    }
}
