//! Removes blocks that never run. `always @(*)` waits for a change; a block whose inputs never change is
//! never run, and the signals that it assigns keep their initial values (IEEE 1364-2005, 9.7.5).
//!
//! A register without an initial value counts as a signal that changes. Before its first change, a block that
//! reads only this register shows unknown bits in a simulator; the evaluator shows the result of the block's
//! operators on unknown bits.

use super::flat::{Driver, Flat};
use super::graph::{Known, SignalId};

/// Removes the blocks that never run from the design.
pub fn leave_out_what_never_runs(flat: &mut Flat<'_>) {
    let changes = changing(flat);
    let units = std::mem::take(&mut flat.units);
    for unit in units.iter().filter(|unit| unit.waits) {
        let runs = unit.reads_memory || unit.reads.iter().any(|id| changes[id.0 as usize]);
        if runs {
            continue;
        }
        for &target in &unit.targets {
            let signal = flat.signal(target);
            let start = signal.initial.clone();
            let start = start.unwrap_or_else(|| Known::nothing(signal.width));
            let start = flat.graph.constant(start);
            flat.signal_mut(target).driver = Driver::Value(start);
        }
    }
    flat.units = units;
}

/// Marks the signals that inputs and registers reach. A constant never changes.
fn changing(flat: &Flat<'_>) -> Vec<bool> {
    let mut readers: Vec<Vec<usize>> = vec![Vec::new(); flat.signals.len()];
    for (index, unit) in flat.units.iter().enumerate() {
        for id in &unit.reads {
            readers[id.0 as usize].push(index);
        }
    }
    let mut changes = vec![false; flat.signals.len()];
    let mut fresh: Vec<SignalId> = Vec::new();
    for (index, signal) in flat.signals.iter().enumerate() {
        if matches!(signal.driver, Driver::Input | Driver::Register { .. }) {
            fresh.push(SignalId(index as u32));
        }
    }
    let memory_units = flat.units.iter().filter(|unit| unit.reads_memory);
    fresh.extend(memory_units.flat_map(|unit| &unit.targets));
    while let Some(id) = fresh.pop() {
        if std::mem::replace(&mut changes[id.0 as usize], true) {
            continue;
        }
        for &unit in &readers[id.0 as usize] {
            fresh.extend(&flat.units[unit].targets);
        }
    }
    changes
}
