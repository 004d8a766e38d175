//! The control word of the sequential machine: one word for each step, which the control block stores and
//! broadcasts to all cells.
//!
//! The encoding is horizontal: each thing that a cell selects or writes has a field, so a cell needs no
//! decoder. [`encode`] is the only function that makes a control word.

use super::microprogram::Step;
use super::op::Op;

/// An encoded control word, fields from bit 0 in the order of [`FIELDS`].
pub type ControlWord = u32;

/// The unit whose result the work register stores.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum WorkSource {
    /// The result of `(A-B)^2`.
    Square = 0,
    /// The result of `A+B`.
    Add = 1,
    /// The result of `if A>B, output 0`.
    Gate = 2,
}

/// The control-word fields that an op sets in a cell. The step adds the axis.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct ControlFields {
    pub write_query: bool,
    pub write_photon: bool,
    pub write_power: bool,
    pub write_work: bool,
    pub write_sum: bool,
    pub work_source: WorkSource,
    pub add_sum: bool,
}

impl ControlFields {
    pub const IDLE: Self = Self {
        write_query: false,
        write_photon: false,
        write_power: false,
        write_work: false,
        write_sum: false,
        work_source: WorkSource::Square,
        add_sum: false,
    };
}

/// A field of the control word.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum Field {
    /// Store the query's coordinate and radius, clear the sum.
    WriteQuery,
    /// Store the photon's coordinate.
    WritePhoton,
    /// Store the photon's power.
    WritePower,
    /// Store into the work register.
    WriteWork,
    /// Store into the sum.
    WriteSum,
    /// The unit whose result the work register stores: a [`WorkSource`].
    WorkSource,
    /// The second operand of `A+B` is the sum; otherwise it is the link.
    AddSum,
    /// The step waits for, and takes, the query stream.
    TakesQuery,
    /// The step waits for the group stream.
    ReadsGroup,
    /// The step is the last to read the group, and consumes it.
    TakesGroup,
    /// The network axis of the link, one bit for each axis. With no bit set the link is 0, so that the second
    /// operand of `A+B` is an OR and needs no multiplexer.
    Axis,
}

/// One row of the field table.
#[derive(Copy, Clone, Debug)]
pub struct FieldRow {
    /// The field that the row describes.
    pub field: Field,
    /// The field's name in the emitted Verilog.
    pub name: &'static str,
    /// The field's width in bits, for a hypercube of the given dimension.
    pub width: fn(u32) -> u32,
}

/// The field table: the layout of the control word from bit 0 upwards, in the order of [`Field`].
pub const FIELDS: &[FieldRow] = &[
    FieldRow {
        field: Field::WriteQuery,
        name: "write_query",
        width: |_| 1,
    },
    FieldRow {
        field: Field::WritePhoton,
        name: "write_photon",
        width: |_| 1,
    },
    FieldRow {
        field: Field::WritePower,
        name: "write_power",
        width: |_| 1,
    },
    FieldRow {
        field: Field::WriteWork,
        name: "write_work",
        width: |_| 1,
    },
    FieldRow {
        field: Field::WriteSum,
        name: "write_sum",
        width: |_| 1,
    },
    FieldRow {
        field: Field::WorkSource,
        name: "work_source",
        width: |_| 2,
    },
    FieldRow {
        field: Field::AddSum,
        name: "add_sum",
        width: |_| 1,
    },
    FieldRow {
        field: Field::TakesQuery,
        name: "takes_query",
        width: |_| 1,
    },
    FieldRow {
        field: Field::ReadsGroup,
        name: "reads_group",
        width: |_| 1,
    },
    FieldRow {
        field: Field::TakesGroup,
        name: "takes_group",
        width: |_| 1,
    },
    FieldRow {
        field: Field::Axis,
        name: "axis",
        width: |dimension| dimension,
    },
];

impl Field {
    /// The field's row in [`FIELDS`].
    pub fn row(self) -> &'static FieldRow {
        &FIELDS[self as usize]
    }

    /// The field's lowest bit. The axis is the last field, so the place of every other field is independent
    /// of the dimension.
    pub fn lsb(self) -> u32 {
        FIELDS[..self as usize]
            .iter()
            .map(|row| (row.width)(0))
            .sum()
    }

    /// Extracts the field's value from a control word.
    pub fn of(self, word: ControlWord, dimension: u32) -> u32 {
        let mask = (1 << (self.row().width)(dimension)) - 1;
        (word >> self.lsb()) & mask
    }
}

/// The width in bits of the control word of a hypercube of that dimension.
pub fn control_word_bits(dimension: u32) -> u32 {
    Field::Axis.lsb() + (Field::Axis.row().width)(dimension)
}

/// Encodes the control word of a step. `takes_group` marks the last step of an iteration that reads the
/// group; [`crate::Microprogram::control_words`] finds that step.
pub fn encode(step: Step, takes_group: bool) -> ControlWord {
    let row = step.op.row();
    let control = row.control;
    let place = |field: Field, value: u32| value << field.lsb();
    let flag = |field: Field, value: bool| place(field, u32::from(value));
    flag(Field::WriteQuery, control.write_query)
        | flag(Field::WritePhoton, control.write_photon)
        | flag(Field::WritePower, control.write_power)
        | flag(Field::WriteWork, control.write_work)
        | flag(Field::WriteSum, control.write_sum)
        | place(Field::WorkSource, control.work_source as u32)
        | flag(Field::AddSum, control.add_sum)
        | flag(Field::TakesQuery, step.op == Op::LoadQuery)
        | flag(Field::ReadsGroup, row.reads_group)
        | flag(Field::TakesGroup, takes_group)
        | place(Field::Axis, step.axis.map_or(0, |axis| 1 << axis.bit()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hypercube::{Axis, Hypercube};
    use crate::sequential::OPS;

    #[test]
    fn rows_stand_in_the_order_of_the_enum_and_do_not_overlap() {
        for dimension in 4..=10 {
            let mut next = 0;
            for (index, row) in FIELDS.iter().enumerate() {
                assert_eq!(row.field as usize, index);
                assert_eq!(row.field.lsb(), next);
                next += (row.width)(dimension);
            }
            assert_eq!(control_word_bits(dimension), next);
        }
    }

    #[test]
    fn every_step_has_a_word_of_its_own_and_its_fields_are_read_back() {
        let cube = Hypercube::new(5);
        let mut words = Vec::new();
        for row in OPS {
            let axes: Vec<Option<Axis>> = if row.uses_link {
                cube.axes().map(Some).collect()
            } else {
                vec![None]
            };
            for axis in axes {
                let word = encode(Step { op: row.op, axis }, false);
                assert_eq!(
                    Field::Axis.of(word, 5),
                    axis.map_or(0, |axis| 1 << axis.bit()),
                    "{}",
                    row.mnemonic
                );
                assert_eq!(Field::ReadsGroup.of(word, 5) == 1, row.reads_group);
                words.push(word);
            }
        }
        let all = words.len();
        words.sort_unstable();
        words.dedup();
        assert_eq!(words.len(), all, "two steps share a control word");
    }

    #[test]
    fn a_word_writes_just_the_registers_of_its_op() {
        use crate::sequential::Register;
        let writers = [
            (Register::Query, vec![Field::WriteQuery]),
            (Register::RadiusSq, vec![Field::WriteQuery]),
            (Register::Photon, vec![Field::WritePhoton]),
            (Register::Power, vec![Field::WritePower]),
            (Register::Work, vec![Field::WriteWork]),
            (Register::Sum, vec![Field::WriteQuery, Field::WriteSum]),
        ];
        for row in OPS {
            let word = encode(
                Step {
                    op: row.op,
                    axis: None,
                },
                false,
            );
            for (register, fields) in &writers {
                let written = fields.iter().any(|field| field.of(word, 4) == 1);
                assert_eq!(
                    written,
                    row.writes.contains(register),
                    "{} {register:?}",
                    row.mnemonic
                );
            }
        }
    }
}
