//! The registers of control block and cells as signals.

use super::CellTables;
use crate::formats::Widths;
use crate::machine::Machine;
use crate::pins::{Pin, SignalPlace};

/// All registers of a machine whose cells have these tables, in the order of [`crate::Pins`].
/// `control_widths` has the widths of [`CellTables::control_registers`].
pub(crate) fn pins(machine: &Machine, tables: &CellTables, control_widths: &[u32]) -> Vec<Pin> {
    let widths = Widths::of(machine);
    let control = tables.control_registers.iter().zip(control_widths);
    let mut pins: Vec<_> = control
        .enumerate()
        .map(|(index, (name, &width))| Pin {
            name: format!("control_{name}"),
            width,
            place: SignalPlace::Control(index),
        })
        .collect();
    for node in 0..machine.hypercube().nodes() {
        pins.extend(tables.registers.iter().map(|row| Pin {
            name: format!("cell_{node}_{}", row.name),
            width: (row.width)(&widths),
            place: SignalPlace::Cell {
                node,
                register: row.register,
            },
        }));
    }
    pins
}
