//! The register file of a sequential machine's cell.

use crate::formats::Widths;

/// A register of a cell.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Register {
    /// The query point's coordinate of this role. In a D cell: the coordinate at zero distance from a photon
    /// at 0; that is 0, or 1 for quarter-step formats.
    Query,
    /// The squared search radius.
    RadiusSq,
    /// The photon's coordinate of this role; 0 in a D cell.
    Photon,
    /// The photon's power in this role's channel.
    Power,
    /// The running value: a square, then a distance, then a gated power. The links carry this register.
    Work,
    /// The sum of the query so far.
    Sum,
}

/// One row of the register table.
#[derive(Copy, Clone, Debug)]
pub struct RegisterRow {
    /// The register that the row describes.
    pub register: Register,
    /// The register's one-letter name in listings and formulas.
    pub mnemonic: &'static str,
    /// The register's name in the emitted Verilog.
    pub name: &'static str,
    /// The register's width in bits.
    pub width: fn(&Widths) -> u32,
}

/// The register table, one row each, in the order of [`Register`].
pub const REGISTERS: &[RegisterRow] = &[
    RegisterRow {
        register: Register::Query,
        mnemonic: "q",
        name: "query",
        width: |w| w.coordinate,
    },
    RegisterRow {
        register: Register::RadiusSq,
        mnemonic: "r",
        name: "radius_sq",
        width: |w| w.radius_sq,
    },
    RegisterRow {
        register: Register::Photon,
        mnemonic: "p",
        name: "photon",
        width: |w| w.photon,
    },
    RegisterRow {
        register: Register::Power,
        mnemonic: "w",
        name: "power",
        width: |w| w.power,
    },
    RegisterRow {
        register: Register::Work,
        mnemonic: "v",
        name: "work",
        width: |w| w.work,
    },
    RegisterRow {
        register: Register::Sum,
        mnemonic: "s",
        name: "sum",
        width: |w| w.sum,
    },
];

impl Register {
    /// The register's row in [`REGISTERS`].
    pub fn row(self) -> &'static RegisterRow {
        &REGISTERS[self as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_stand_in_the_order_of_the_enum() {
        for (index, row) in REGISTERS.iter().enumerate() {
            assert_eq!(row.register as usize, index);
        }
    }
}
