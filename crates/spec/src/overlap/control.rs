//! The control words of an overlapped machine: one for each role and clock.
//!
//! The words of the kernel's clocks come first, then those of the epilogue. Past the end, the word is 0 and
//! does nothing. A word has a field for each thing that a cell selects or writes in that clock. A write that
//! an op does later than in its first clock is in the control word of that later clock.

use super::op::Op;
use super::program::Program;
use super::register::POWER_WORDS;
use crate::hypercube::{Axis, Role};

/// An encoded control word, fields from bit 0 in the order of [`FIELDS`].
pub type ControlWord = u32;

/// A field of the control word.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum Field {
    /// Store the photon's coordinate.
    WritePhoton,
    /// Store the photon's power. All roles store it in the same clocks, in which a group is taken.
    WritePower,
    /// Move powers in the queue; bit i moves the power from place i to place i + 1.
    MovePower,
    /// Store the square that leaves the square unit.
    WriteSquare,
    /// Store the sum of the operands.
    WriteWork,
    /// Store the new sum of the query.
    WriteSum,
    /// Store a distance.
    WriteDistance,
    /// The source of the distance: 0 the cell's own, 1 the word on z, 2 the word on w.
    DistanceSource,
    /// The axis whose word is the next operand, one bit for each axis. Where neither an axis nor the gate is
    /// selected, the operand is 0.
    Axis,
    /// The gate's power is the next operand.
    Gate,
    /// The adder's first operand is the sum; otherwise the addend.
    AddSum,
    /// The word sent on z is the sum of squares; otherwise the square.
    SendWork,
    /// The word sent on w is the distance; otherwise the sum of squares.
    SendDistance,
}

/// One row of the field table.
#[derive(Copy, Clone, Debug)]
pub struct FieldRow {
    /// The field that the row describes.
    pub field: Field,
    /// The field's name in the emitted Verilog.
    pub name: &'static str,
    /// The field's width in bits.
    pub width: u32,
}

const fn row(field: Field, name: &'static str, width: u32) -> FieldRow {
    FieldRow { field, name, width }
}

/// The field table: the layout of the control word from bit 0 upwards, in the order of [`Field`].
pub const FIELDS: &[FieldRow] = &[
    row(Field::WritePhoton, "write_photon", 1),
    row(Field::WritePower, "write_power", 1),
    row(Field::MovePower, "move_power", POWER_WORDS as u32 - 1),
    row(Field::WriteSquare, "write_square", 1),
    row(Field::WriteWork, "write_work", 1),
    row(Field::WriteSum, "write_sum", 1),
    row(Field::WriteDistance, "write_distance", 1),
    row(Field::DistanceSource, "distance_source", 2),
    row(Field::Axis, "axis", 4),
    row(Field::Gate, "gate", 1),
    row(Field::AddSum, "add_sum", 1),
    row(Field::SendWork, "send_work", 1),
    row(Field::SendDistance, "send_distance", 1),
];

impl Field {
    /// The field's row in [`FIELDS`].
    pub fn row(self) -> &'static FieldRow {
        &FIELDS[self as usize]
    }

    /// The field's lowest bit.
    pub fn lsb(self) -> u32 {
        FIELDS[..self as usize].iter().map(|row| row.width).sum()
    }

    /// Extracts the field's value from a control word.
    pub fn of(self, word: ControlWord) -> u32 {
        (word >> self.lsb()) & ((1 << self.row().width) - 1)
    }

    fn put(self, value: u32) -> ControlWord {
        value << self.lsb()
    }
}

/// The width of the control word in bits.
pub fn control_word_bits() -> u32 {
    FIELDS.iter().map(|row| row.width).sum()
}

impl Program {
    /// The address of the epilogue's first word. The kernel's first word has address 0.
    pub fn epilogue_address(&self) -> u32 {
        self.interval
    }

    /// The number of control words, which is the first address past the end.
    pub fn end_address(&self) -> u32 {
        self.epilogue_address() + self.epilogue_clocks()
    }

    /// The control words of a role, by address.
    pub fn control_words(&self, role: Role) -> Vec<ControlWord> {
        let mut words = vec![0; self.end_address() as usize];
        for op in &self.kernel {
            let written = op.clock + op.op.row().latency - 1;
            words[(written % self.interval) as usize] |= asked_of(op.op, op.role, role);
        }
        for op in &self.epilogue {
            words[(self.epilogue_address() + op.clock) as usize] |= asked_of(op.op, role, role);
        }
        words
    }
}

/// The control-word fields that an op of the cell `doer` sets in the cell `role`, in the clock in which the
/// op writes. Fields are set in the doer itself and in the neighbour that sends it a word.
pub fn asked_of(op: Op, doer: Role, role: Role) -> ControlWord {
    let mut word = 0;
    if doer == role {
        word |= own_fields(op);
    }
    if op.axis().is_some_and(|axis| doer.across(axis) == role) {
        word |= match op {
            Op::Keep(Some(Axis::Z)) => Field::SendWork.put(1),
            Op::Relay => Field::SendDistance.put(1),
            _ => 0,
        };
    }
    word
}

fn own_fields(op: Op) -> ControlWord {
    let keep = |source| Field::WriteDistance.put(1) | Field::DistanceSource.put(source);
    match op {
        Op::LoadPhoton => Field::WritePhoton.put(1),
        Op::LoadPower => Field::WritePower.put(1),
        Op::MovePower(place) => Field::MovePower.put(1 << (place - 1)),
        Op::SquareDifference => Field::WriteSquare.put(1),
        Op::Receive(axis) => Field::Axis.put(1 << axis.bit()),
        Op::Compare => 0,
        Op::Gate => Field::Gate.put(1),
        Op::Add => Field::WriteWork.put(1),
        Op::Accumulate => Field::WriteSum.put(1) | Field::AddSum.put(1),
        Op::Keep(None) => keep(0),
        Op::Keep(Some(Axis::Z)) => keep(1),
        Op::Keep(Some(_)) | Op::Relay => keep(2),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_stand_in_the_order_of_the_enum_and_fit_a_word() {
        let mut next = 0;
        for (index, row) in FIELDS.iter().enumerate() {
            assert_eq!(row.field as usize, index);
            assert_eq!(row.field.lsb(), next);
            next += row.width;
        }
        assert_eq!(control_word_bits(), next);
        assert!(next <= ControlWord::BITS);
    }

    #[test]
    fn ops_that_write_or_choose_something_else_have_fields_of_their_own() {
        let mut ops = vec![
            Op::LoadPhoton,
            Op::LoadPower,
            Op::SquareDifference,
            Op::Gate,
            Op::Add,
            Op::Accumulate,
            Op::Keep(None),
            Op::Keep(Some(Axis::Z)),
            Op::Keep(Some(Axis::W)),
        ];
        ops.extend((1..POWER_WORDS).map(Op::MovePower));
        ops.extend([Axis::X, Axis::Y, Axis::Z, Axis::W].map(Op::Receive));
        let mut words: Vec<_> = ops.iter().map(|&op| own_fields(op)).collect();
        assert!(!words.contains(&0));
        words.sort_unstable();
        words.dedup();
        assert_eq!(words.len(), ops.len());
        // The two roles that receive on w differ in the word that the neighbour sends.
        let sent = |op| asked_of(op, Role::X, Role::Z);
        assert_ne!(sent(Op::Keep(Some(Axis::W))), sent(Op::Relay));
    }

    #[test]
    fn all_roles_take_a_group_in_the_same_clocks() {
        let program = Program::rotated().unwrap();
        let takes = |role| -> Vec<_> {
            let words = program.control_words(role);
            words
                .iter()
                .map(|&word| Field::WritePower.of(word))
                .collect()
        };
        for role in Role::ALL {
            assert_eq!(takes(role), takes(Role::X));
        }
        assert_eq!(takes(Role::X).iter().sum::<u32>(), program.groups as u32);
    }
}
