//! The registers of an overlapped machine as signals.

use super::control::control_word_bits;
use super::program::Program;
use super::register::Register;
use crate::formats::{Widths, bits_for};
use crate::machine::Machine;
use crate::pins::{Pin, SignalPlace};

/// The control block's registers, in order: the address of the next control words; "a query is in the
/// machine"; "its last group is taken"; the clocks since then; "the result waits to be taken"; the current
/// control words, by role.
pub const CONTROL_REGISTERS: [&str; 9] = [
    "address", "occupied", "last", "drain", "done", "word_x", "word_y", "word_z", "word_d",
];

/// The width of the register that counts the clocks since the last group was taken.
pub fn drain_bits(program: &Program) -> u32 {
    bits_for(program.drain_clocks.into())
}

/// All registers of an overlapped machine, in the order of [`crate::Pins`].
pub(crate) fn pins(machine: &Machine, widths: &Widths) -> Vec<Pin> {
    let mut pins = control_pins(&machine.overlap_program().expect("its units overlap"));
    for node in 0..machine.hypercube().nodes() {
        pins.extend(Register::all().map(|register| Pin {
            name: format!("cell_{node}_{}", register.name()),
            width: register.width(widths),
            place: SignalPlace::OverlapCell { node, register },
        }));
    }
    pins
}

fn control_pins(program: &Program) -> Vec<Pin> {
    let address = bits_for(u128::from(program.end_address()));
    let word = control_word_bits();
    let widths = [
        address,
        1,
        1,
        drain_bits(program),
        1,
        word,
        word,
        word,
        word,
    ];
    let registers = CONTROL_REGISTERS.iter().zip(widths).enumerate();
    registers
        .map(|(index, (name, width))| Pin {
            name: format!("control_{name}"),
            width,
            place: SignalPlace::OverlapControl(index),
        })
        .collect()
}
