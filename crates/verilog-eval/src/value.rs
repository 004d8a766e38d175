//! The value of an observed signal.

use std::fmt;

/// A value of up to 64 bits, each 0, 1 or unknown. It is displayed as Verilog's `%h` writes it: `x` for a digit of
/// unknown bits, `X` for a digit with some.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Value {
    /// The bits; those that are unknown have no meaning here.
    pub bits: u64,
    /// A one for each bit that is unknown.
    pub unknown: u64,
    /// How many bits there are.
    pub width: u32,
}

impl Value {
    /// The bits, if none is unknown.
    #[must_use]
    pub fn known(self) -> Option<u64> {
        (self.unknown == 0).then_some(self.bits)
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for index in (0..self.width.div_ceil(4)).rev() {
            let of_digit = |word: u64| word >> (4 * index) & 0xf;
            let there = 0xf >> (4 * (index + 1)).saturating_sub(self.width);
            match of_digit(self.unknown) {
                0 => write!(f, "{:x}", of_digit(self.bits))?,
                all if all == there => f.write_str("x")?,
                _ => f.write_str("X")?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_written_as_verilog_does() {
        let text = |bits, unknown, width| {
            let value = Value {
                bits,
                unknown,
                width,
            };
            value.to_string()
        };
        assert_eq!(text(0xab, 0, 8), "ab");
        assert_eq!(text(0x0b, 0, 9), "00b");
        assert_eq!(text(0xa0, 0x0f, 8), "ax");
        assert_eq!(text(0xa0, 0x01, 8), "aX");
        // The upper digit has two bits, both unknown.
        assert_eq!(text(0x0, 0x30, 6), "x0");
    }
}
