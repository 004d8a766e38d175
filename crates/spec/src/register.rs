//! The register file of a cell.

use crate::format::Widths;

/// A register of a cell.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Register {
    /// The query point's coordinate of this role; in a D cell what is at distance 0 from a photon
    /// at 0: 0, on quarter steps 1.
    Query,
    /// The squared search radius.
    RadiusSq,
    /// The photon's coordinate of this role; 0 in a D cell.
    Photon,
    /// The photon's power in this role's channel.
    Power,
    /// The running value: a square, a distance, then a gated power; what the links carry.
    Work,
    /// The sum of the query so far.
    Sum,
}

/// One row of the register table.
#[derive(Copy, Clone, Debug)]
pub struct RegisterRow {
    /// The register.
    pub register: Register,
    /// Its one-letter name in listings and formulas.
    pub mnemonic: &'static str,
    /// Its name in the emitted Verilog.
    pub name: &'static str,
    /// Its width in bits.
    pub width: fn(&Widths) -> u32,
}

/// The register file, one row each, in the order of [`Register`].
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
    /// The register's row.
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
