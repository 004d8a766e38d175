//! The cell of a machine that runs a program: its ops, registers and control fields, each a table of rows.
//!
//! The sequential and the overlapped machine have one word for each kind of row. [`SEQUENTIAL`] and
//! [`OVERLAPPED`] say which rows the cell of each has; listings, control words, checkers, HDL and testbenches
//! read these rows.

mod control;
mod error;
mod op;
mod pins;
mod register;
mod step;
mod unit;

pub use control::{ControlWord, Field, FieldRow};
pub use error::{Place, ScheduleError};
pub use op::{Op, OpRow, Stream};
pub(crate) use pins::pins;
pub use register::{POWER_WORDS, Register, RegisterRow};
pub(crate) use step::phase_clocks;
pub use step::{Read, ScheduledStep, Step};
pub use unit::{Unit, UnitUse, unit_utilisation};

use std::mem::discriminant;

/// The cell of a machine that runs a program, as tables.
#[derive(Copy, Clone, Debug)]
pub struct CellTables {
    /// The ops that the cell can do.
    pub ops: &'static [OpRow],
    /// The cell's registers, in the order in which they are observed.
    pub registers: &'static [RegisterRow],
    /// The fields of the control word, from bit 0 upwards.
    pub fields: &'static [FieldRow],
    /// The names of the control block's registers, in the order in which they are observed.
    pub control_registers: &'static [&'static str],
}

/// The cell of a sequential machine. Its control block has `address`, the program counter; `last`, set while
/// the group at work is the query's last; and `done`, set while the result waits to be taken.
pub static SEQUENTIAL: CellTables = CellTables {
    ops: op::SEQUENTIAL,
    registers: register::SEQUENTIAL,
    fields: control::SEQUENTIAL,
    control_registers: &["address", "last", "done"],
};

/// The cell of an overlapped machine. Its control block has the address of the next control words; "a query is
/// in the machine"; "its last group is taken"; the clocks since then; "the result waits to be taken"; and the
/// current control words, by role.
pub static OVERLAPPED: CellTables = CellTables {
    ops: op::OVERLAPPED,
    registers: register::OVERLAPPED,
    fields: control::OVERLAPPED,
    control_registers: &[
        "address", "occupied", "last", "drain", "done", "word_x", "word_y", "word_z", "word_d",
    ],
};

impl CellTables {
    /// The row of an op.
    ///
    /// # Panics
    /// Where the cell has no such op.
    pub fn op(&self, op: Op) -> &'static OpRow {
        let mut rows = self.ops.iter();
        let row = rows.find(|row| discriminant(&row.op) == discriminant(&op));
        row.unwrap_or_else(|| panic!("the cell has no op {op:?}"))
    }

    /// Finds the op of that mnemonic.
    pub fn op_named(&self, mnemonic: &str) -> Option<Op> {
        let mut ops = self.ops.iter().map(|row| row.op);
        ops.find(|op| op.mnemonic() == mnemonic)
    }

    /// The row of a register.
    ///
    /// # Panics
    /// Where the cell has no such register.
    pub fn register(&self, register: Register) -> &'static RegisterRow {
        let mut rows = self.registers.iter();
        let row = rows.find(|row| row.register == register);
        row.unwrap_or_else(|| panic!("the cell has no register {register:?}"))
    }

    /// The units that the cell's ops use, in the order of [`Unit`].
    pub fn units(&self) -> Vec<Unit> {
        let mut units: Vec<_> = self.ops.iter().filter_map(|row| row.unit).collect();
        units.sort_unstable();
        units.dedup();
        units
    }

    /// The paper's computing units, over which utilisation is counted: the cell's units but for the ports.
    pub fn computing_units(&self) -> Vec<Unit> {
        let mut units = self.units();
        units.retain(|unit| !unit.is_port());
        units
    }

    /// The op by which a unit is tested on its own: an op of the unit that reads registers of its own cell
    /// alone. The unit's inputs are what the op reads, in order, and its output is what the op writes.
    pub fn op_of_unit(&self, unit: Unit) -> Option<&'static OpRow> {
        let mut rows = self.ops.iter();
        rows.find(|row| row.unit == Some(unit) && row.link.is_none() && !row.reads.is_empty())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_op_and_register_stands_in_its_table_once() {
        for tables in [&SEQUENTIAL, &OVERLAPPED] {
            for (index, row) in tables.ops.iter().enumerate() {
                assert!(std::ptr::eq(tables.op(row.op), &tables.ops[index]));
                assert_eq!(tables.op_named(row.op.mnemonic()), Some(row.op));
            }
            for (index, row) in tables.registers.iter().enumerate() {
                let found = tables.register(row.register);
                assert!(std::ptr::eq(found, &tables.registers[index]));
            }
        }
    }

    #[test]
    fn ops_read_and_write_registers_of_their_cell() {
        for tables in [&SEQUENTIAL, &OVERLAPPED] {
            for row in tables.ops {
                for &register in row.reads.iter().chain(row.writes) {
                    let name = tables.register(register).name;
                    assert!(!name.is_empty(), "{:?} {register:?}", row.op);
                }
            }
        }
    }

    #[test]
    fn every_computing_unit_can_be_tested_on_its_own() {
        for unit in SEQUENTIAL.computing_units() {
            assert!(SEQUENTIAL.op_of_unit(unit).is_some(), "{unit}");
        }
    }
}
