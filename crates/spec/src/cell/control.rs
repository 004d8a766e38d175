//! The control word of a cell: the fields that say what the cell selects and writes in a clock.
//!
//! The encoding is horizontal: each thing that a cell selects or writes has a field, so a cell needs no
//! decoder. A field's value follows from the step and from what the step's op reads and writes.

use super::op::{Op, OpRow};
use super::register::{POWER_WORDS, Register};
use super::step::Step;
use super::{CellTables, SEQUENTIAL as CELL};
use crate::hypercube::Axis;

/// An encoded control word, fields from bit 0 in the order of [`CellTables::fields`].
pub type ControlWord = u32;

/// A field of the control word.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum Field {
    /// Store the query's coordinate and radius, clear the sum.
    WriteQuery,
    /// Store the photon's coordinate.
    WritePhoton,
    /// Store the photon's power. In an overlapped machine all roles store it in the same clocks, in which a group
    /// is taken.
    WritePower,
    /// Move powers in the queue; bit i moves the power from place i to place i + 1.
    MovePower,
    /// Store the square that leaves the square unit.
    WriteSquare,
    /// Store into the work register.
    WriteWork,
    /// Store into the sum.
    WriteSum,
    /// Store a distance.
    WriteDistance,
    /// The unit whose result a sequential cell's work register stores; see [`CellTables::work_source`].
    WorkSource,
    /// The source of the distance: 0 the cell's own, 1 the word on z, 2 the word on w.
    DistanceSource,
    /// The adder adds to the sum. Otherwise the sum is replaced by the link in a sequential cell, by the addend
    /// in an overlapped one.
    AddSum,
    /// The step waits for, and takes, the query stream.
    TakesQuery,
    /// The step waits for the group stream.
    ReadsGroup,
    /// The step is the last to read the group, and consumes it.
    TakesGroup,
    /// The axis whose word is received, one bit for each axis. With no bit set the word is 0, so that the
    /// selection of an operand is an OR and needs no multiplexer.
    Axis,
    /// The gate's power is the next operand.
    Gate,
    /// The word sent on z is the sum of squares; otherwise the square.
    SendWork,
    /// The word sent on w is the distance; otherwise the sum of squares.
    SendDistance,
}

/// One row of a field table.
#[derive(Copy, Clone, Debug)]
pub struct FieldRow {
    /// The field that the row describes.
    pub field: Field,
    /// The field's name in the emitted Verilog.
    pub name: &'static str,
    /// The field's width in bits, for a hypercube of the given dimension.
    pub width: fn(u32) -> u32,
    /// The value that a step gives the field in its own cell. The program adds the fields that depend on other
    /// steps or cells.
    pub(super) value: fn(Step, &OpRow) -> u32,
}

const fn flag(field: Field, name: &'static str, value: fn(Step, &OpRow) -> u32) -> FieldRow {
    FieldRow {
        field,
        name,
        width: |_| 1,
        value,
    }
}

fn writes(row: &OpRow, register: Register) -> u32 {
    u32::from(row.writes.contains(&register))
}

fn axis_bit(step: Step) -> u32 {
    step.axis.map_or(0, |axis| 1 << axis.bit())
}

/// The axis stands last, so that the place of every other field is independent of the dimension.
pub(super) const SEQUENTIAL: &[FieldRow] = &[
    flag(Field::WriteQuery, "write_query", |_, row| {
        writes(row, Register::Query)
    }),
    flag(Field::WritePhoton, "write_photon", |_, row| {
        writes(row, Register::Photon)
    }),
    flag(Field::WritePower, "write_power", |_, row| {
        writes(row, Register::Power(0))
    }),
    flag(Field::WriteWork, "write_work", |_, row| {
        writes(row, Register::Work)
    }),
    // The query's load clears the sum, and stores no sum.
    flag(Field::WriteSum, "write_sum", |_, row| {
        writes(row, Register::Sum) & !writes(row, Register::Query)
    }),
    FieldRow {
        field: Field::WorkSource,
        name: "work_source",
        width: |_| 2,
        value: |_, row| CELL.work_source(row).unwrap_or(0),
    },
    flag(Field::AddSum, "add_sum", |_, row| {
        u32::from(row.reads.contains(&Register::Sum))
    }),
    flag(Field::TakesQuery, "takes_query", |_, row| {
        u32::from(row.reads_query())
    }),
    flag(Field::ReadsGroup, "reads_group", |_, row| {
        u32::from(row.reads_group())
    }),
    flag(Field::TakesGroup, "takes_group", |_, _| 0),
    FieldRow {
        field: Field::Axis,
        name: "axis",
        width: |dimension| dimension,
        value: |step, _| axis_bit(step),
    },
];

pub(super) const OVERLAPPED: &[FieldRow] = &[
    flag(Field::WritePhoton, "write_photon", |_, row| {
        writes(row, Register::Photon)
    }),
    flag(Field::WritePower, "write_power", |_, row| {
        writes(row, Register::Power(0))
    }),
    FieldRow {
        field: Field::MovePower,
        name: "move_power",
        width: |_| u32::from(POWER_WORDS) - 1,
        value: |step, _| match step.op {
            Op::MovePower(place) => 1 << (place - 1),
            _ => 0,
        },
    },
    flag(Field::WriteSquare, "write_square", |_, row| {
        writes(row, Register::Square)
    }),
    flag(Field::WriteWork, "write_work", |_, row| {
        writes(row, Register::Work)
    }),
    flag(Field::WriteSum, "write_sum", |_, row| {
        writes(row, Register::Sum)
    }),
    flag(Field::WriteDistance, "write_distance", |_, row| {
        writes(row, Register::Distance)
    }),
    FieldRow {
        field: Field::DistanceSource,
        name: "distance_source",
        width: |_| 2,
        value: |step, row| match step.axis {
            None => 0,
            Some(_) if writes(row, Register::Distance) == 0 => 0,
            Some(Axis::Z) => 1,
            Some(_) => 2,
        },
    },
    FieldRow {
        field: Field::Axis,
        name: "axis",
        width: |dimension| dimension,
        value: |step, row| writes(row, Register::Operand) * axis_bit(step),
    },
    flag(Field::Gate, "gate", |step, _| {
        u32::from(step.op == Op::Gate)
    }),
    flag(Field::AddSum, "add_sum", |_, row| {
        u32::from(row.reads.contains(&Register::Sum))
    }),
    flag(Field::SendWork, "send_work", |_, _| 0),
    flag(Field::SendDistance, "send_distance", |_, _| 0),
];

impl CellTables {
    /// The lowest bit of a field in the control word of a hypercube of that dimension.
    ///
    /// # Panics
    /// Where the cell has no such field.
    pub fn lsb(&self, field: Field, dimension: u32) -> u32 {
        let place = self.fields.iter().position(|row| row.field == field);
        let place = place.unwrap_or_else(|| panic!("the control word has no field {field:?}"));
        width(&self.fields[..place], dimension)
    }

    /// The value of a field in a control word.
    ///
    /// # Panics
    /// Where the cell has no such field.
    pub fn field(&self, field: Field, word: ControlWord, dimension: u32) -> u32 {
        let mut rows = self.fields.iter();
        let lsb = self.lsb(field, dimension);
        let bits = rows
            .find(|row| row.field == field)
            .map(|row| (row.width)(dimension));
        (word >> lsb) & ((1 << bits.unwrap_or(0)) - 1)
    }

    /// The width in bits of the control word of a hypercube of that dimension.
    pub fn word_bits(&self, dimension: u32) -> u32 {
        width(self.fields, dimension)
    }

    /// The fields that a step sets in its own cell.
    pub(crate) fn own_fields(&self, step: Step, dimension: u32) -> ControlWord {
        let row = self.op(step.op);
        let fields = self.fields.iter();
        let place = |field: &FieldRow| (field.value)(step, row) << self.lsb(field.field, dimension);
        fields.map(place).fold(0, |word, field| word | field)
    }

    /// The number of the unit whose result the work register stores, by which [`Field::WorkSource`] selects it:
    /// the units that write the work register, in the order of the op table. `None` for an op that does not
    /// write the work register.
    pub fn work_source(&self, row: &OpRow) -> Option<u32> {
        let mut sources = Vec::new();
        for row in self
            .ops
            .iter()
            .filter(|row| writes(row, Register::Work) == 1)
        {
            if !sources.contains(&row.unit) {
                sources.push(row.unit);
            }
        }
        let place = sources.iter().position(|unit| *unit == row.unit);
        place
            .filter(|_| writes(row, Register::Work) == 1)
            .map(|place| place as u32)
    }
}

fn width(fields: &[FieldRow], dimension: u32) -> u32 {
    fields.iter().map(|row| (row.width)(dimension)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::OVERLAPPED;

    #[test]
    fn fields_do_not_overlap_and_fit_a_word() {
        for (tables, dimensions) in [(&CELL, 4..=10), (&OVERLAPPED, 4..=4)] {
            for dimension in dimensions {
                let mut next = 0;
                for row in tables.fields {
                    assert_eq!(tables.lsb(row.field, dimension), next);
                    let bits = (row.width)(dimension);
                    let ones = ((1 << bits) - 1) << next;
                    assert_eq!(tables.field(row.field, ones, dimension), (1 << bits) - 1);
                    next += bits;
                }
                assert_eq!(tables.word_bits(dimension), next);
                assert!(next <= ControlWord::BITS);
            }
        }
    }

    #[test]
    fn every_source_of_the_work_register_has_a_number() {
        let sources: Vec<_> = CELL
            .ops
            .iter()
            .filter_map(|row| CELL.work_source(row))
            .collect();
        let most = sources.iter().max().copied().unwrap_or(0);
        assert!((0..=most).all(|source| sources.contains(&source)));
        assert!(most < 1 << 2, "the field has two bits");
    }
}
