//! The registers of a sequential machine as signals.

use super::register::REGISTERS;
use crate::formats::Widths;
use crate::machine::Machine;
use crate::pins::{Pin, SignalPlace};

/// The control block's registers: `address` is the program counter, `last` is set while the group at work is
/// the query's last, `done` is set while the result waits to be taken.
pub const CONTROL_REGISTERS: [&str; 3] = ["address", "last", "done"];

/// All registers of a sequential machine, in the order of [`crate::Pins`].
pub(crate) fn pins(machine: &Machine, widths: &Widths) -> Vec<Pin> {
    let mut pins = control_pins(machine);
    pins.extend(cell_pins(machine, widths));
    pins
}

fn control_pins(machine: &Machine) -> Vec<Pin> {
    let program = machine
        .microprogram()
        .expect("a machine without engines has a program");
    CONTROL_REGISTERS
        .iter()
        .zip([program.address_bits(), 1, 1])
        .enumerate()
        .map(|(index, (name, width))| Pin {
            name: format!("control_{name}"),
            width,
            place: SignalPlace::Control(index),
        })
        .collect()
}

fn cell_pins(machine: &Machine, widths: &Widths) -> Vec<Pin> {
    let mut pins = Vec::new();
    for node in 0..machine.hypercube().nodes() {
        for row in REGISTERS {
            pins.push(Pin {
                name: format!("cell_{node}_{}", row.name),
                width: (row.width)(widths),
                place: SignalPlace::Cell {
                    node,
                    register: row.register,
                },
            });
        }
    }
    pins
}
