//! The op table of a sequential machine's cell: what a cell can do in one clock.
//!
//! The three computing units are the paper's: `A+B`, `(A-B)^2`, and `if A>B, output 0`. A fourth unit, the
//! port, moves a word from the streams into the register file.

use std::fmt;

use super::control::{ControlFields, WorkSource};
use super::register::Register;
use crate::formats::Widths;

/// A unit of the cell; each does at most one op a clock.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Unit {
    /// The data port: loads from the query and group streams.
    Port,
    /// `(A-B)^2`.
    Square,
    /// `if A>B, output 0`.
    Gate,
    /// `A+B`.
    Add,
}

impl Unit {
    /// The paper's three computing units, over which utilisation is counted.
    pub const COMPUTING: [Self; 3] = [Self::Square, Self::Gate, Self::Add];

    /// The unit's name in listings, reports and the emitted Verilog.
    pub fn name(self) -> &'static str {
        match self {
            Self::Port => "port",
            Self::Square => "square",
            Self::Gate => "gate",
            Self::Add => "add",
        }
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// An op: what a cell does in one clock.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Op {
    /// No operation.
    Nop,
    /// Load the query: its coordinate and radius. Clears the sum.
    LoadQuery,
    /// Load the photon's coordinate.
    LoadPhoton,
    /// Load the photon's power; 0 where the group has no photon for this quad.
    LoadPower,
    /// Square the difference of the two coordinates.
    SquareDifference,
    /// Exchange-add: add the neighbour's work register on an axis to the cell's own.
    ExchangeAdd,
    /// Replace a distance by the photon's power, or by 0 where the photon is out of range.
    Gate,
    /// Add the work register to the sum of the query.
    Accumulate,
}

/// One row of the op table.
#[derive(Copy, Clone, Debug)]
pub struct OpRow {
    /// The op that the row describes.
    pub op: Op,
    /// The op's mnemonic in listings.
    pub mnemonic: &'static str,
    /// The unit that does the op; `None` for the nop.
    pub unit: Option<Unit>,
    /// The registers that the op reads.
    pub reads: &'static [Register],
    /// The registers that the op writes, at the clock edge that ends the step.
    pub writes: &'static [Register],
    /// Whether the op reads the link of a network axis. The step must then name the axis.
    pub uses_link: bool,
    /// Whether the op reads the query stream.
    pub reads_query: bool,
    /// Whether the op reads the group stream.
    pub reads_group: bool,
    /// The width in bits of the op's result, before it is stored.
    pub result_width: fn(&Widths) -> u32,
    /// The op's meaning as a formula over the registers' mnemonics; `n` is the neighbour's `v`.
    pub formula: &'static str,
    /// The control-word fields that make a cell do the op.
    pub(crate) control: ControlFields,
}

const IDLE: ControlFields = ControlFields::IDLE;

/// The op table, one row each, in the order of [`Op`].
pub const OPS: &[OpRow] = &[
    OpRow {
        op: Op::Nop,
        mnemonic: "nop",
        unit: None,
        reads: &[],
        writes: &[],
        uses_link: false,
        reads_query: false,
        reads_group: false,
        result_width: |_| 0,
        formula: "-",
        control: IDLE,
    },
    OpRow {
        op: Op::LoadQuery,
        mnemonic: "ldq",
        unit: Some(Unit::Port),
        reads: &[],
        writes: &[Register::Query, Register::RadiusSq, Register::Sum],
        uses_link: false,
        reads_query: true,
        reads_group: false,
        result_width: |w| w.coordinate,
        formula: "q := query coordinate; r := radius_sq; s := 0",
        control: ControlFields {
            write_query: true,
            ..IDLE
        },
    },
    OpRow {
        op: Op::LoadPhoton,
        mnemonic: "ldp",
        unit: Some(Unit::Port),
        reads: &[],
        writes: &[Register::Photon],
        uses_link: false,
        reads_query: false,
        reads_group: true,
        result_width: |w| w.photon,
        formula: "p := photon coordinate",
        control: ControlFields {
            write_photon: true,
            ..IDLE
        },
    },
    OpRow {
        op: Op::LoadPower,
        mnemonic: "ldw",
        unit: Some(Unit::Port),
        reads: &[],
        writes: &[Register::Power],
        uses_link: false,
        reads_query: false,
        reads_group: true,
        result_width: |w| w.power,
        formula: "w := present ? photon mantissa << exponent : 0",
        control: ControlFields {
            write_power: true,
            ..IDLE
        },
    },
    OpRow {
        op: Op::SquareDifference,
        mnemonic: "sqd",
        unit: Some(Unit::Square),
        reads: &[Register::Query, Register::Photon],
        writes: &[Register::Work],
        uses_link: false,
        reads_query: false,
        reads_group: false,
        result_width: |w| w.square,
        formula: "v := square(q - p)",
        control: ControlFields {
            write_work: true,
            work_source: WorkSource::Square,
            ..IDLE
        },
    },
    OpRow {
        op: Op::ExchangeAdd,
        mnemonic: "add",
        unit: Some(Unit::Add),
        reads: &[Register::Work],
        writes: &[Register::Work],
        uses_link: true,
        reads_query: false,
        reads_group: false,
        result_width: |w| w.work,
        formula: "v := v + n (mod 2^work)",
        control: ControlFields {
            write_work: true,
            work_source: WorkSource::Add,
            ..IDLE
        },
    },
    OpRow {
        op: Op::Gate,
        mnemonic: "gate",
        unit: Some(Unit::Gate),
        reads: &[Register::Work, Register::RadiusSq, Register::Power],
        writes: &[Register::Work],
        uses_link: false,
        reads_query: false,
        reads_group: false,
        result_width: |w| w.power,
        formula: "v := v > r ? 0 : w",
        control: ControlFields {
            write_work: true,
            work_source: WorkSource::Gate,
            ..IDLE
        },
    },
    OpRow {
        op: Op::Accumulate,
        mnemonic: "acc",
        unit: Some(Unit::Add),
        reads: &[Register::Work, Register::Sum],
        writes: &[Register::Sum],
        uses_link: false,
        reads_query: false,
        reads_group: false,
        result_width: |w| w.sum,
        formula: "s := s + v (mod 2^sum)",
        control: ControlFields {
            write_sum: true,
            add_sum: true,
            ..IDLE
        },
    },
];

impl Op {
    /// The op's row in [`OPS`].
    pub fn row(self) -> &'static OpRow {
        &OPS[self as usize]
    }

    /// Finds the op of that mnemonic.
    pub fn from_mnemonic(mnemonic: &str) -> Option<Self> {
        OPS.iter()
            .find(|row| row.mnemonic == mnemonic)
            .map(|row| row.op)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_stand_in_the_order_of_the_enum() {
        for (index, row) in OPS.iter().enumerate() {
            assert_eq!(row.op as usize, index);
            assert_eq!(Op::from_mnemonic(row.mnemonic), Some(row.op));
        }
    }

    #[test]
    fn every_unit_has_an_op() {
        for unit in Unit::COMPUTING.into_iter().chain([Unit::Port]) {
            assert!(OPS.iter().any(|row| row.unit == Some(unit)), "{unit}");
        }
    }
}
