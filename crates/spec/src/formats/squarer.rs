//! The implementations of the square.

/// The implementation of the squarer of `(A-B)^2`. All implementations give the same square.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum Squarer {
    /// From base-16 digits: tables of 4-bit squares and 4x4-bit products, for LUTs.
    Digits,
    /// As one product `m * m`, for a DSP block.
    Product,
    /// As a table of squares, for a block RAM. Only spatial machines have this squarer.
    Table,
}

impl Squarer {
    /// The squarer's name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Digits => "digits",
            Self::Product => "product",
            Self::Table => "table",
        }
    }
}
