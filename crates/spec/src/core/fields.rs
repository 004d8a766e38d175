//! The fields of registers.

/// A field of a register.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct CoreField {
    /// Its name.
    pub name: &'static str,
    /// Its lowest bit.
    pub low: u32,
    /// Its bits.
    pub width: u32,
    /// A description.
    pub about: &'static str,
}

impl CoreField {
    /// A field of one bit.
    pub const fn bit(low: u32, name: &'static str, about: &'static str) -> Self {
        Self {
            name,
            low,
            width: 1,
            about,
        }
    }
}
