//! The kinds of value that a register of a sequential machine holds, as the checker distinguishes them.

use std::fmt;

use crate::hypercube::Axis;

/// The content of a register.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Content {
    /// No value that may be read: never written, or left over from the iteration before.
    Stale,
    /// A word loaded from a stream.
    Loaded,
    /// Squares summed across these axes (bit set), by index bit.
    Distance(u32),
    /// Powers gated and summed across these axes (bit set), by index bit.
    Gated(u32),
    /// The sum of a query over this many groups.
    SumOf(u32),
}

impl fmt::Display for Content {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Stale => f.write_str("nothing of this iteration"),
            Self::Loaded => f.write_str("a loaded word"),
            Self::Distance(axes) => write!(f, "squares summed across {}", AxisSet(axes)),
            Self::Gated(axes) => write!(f, "gated powers summed across {}", AxisSet(axes)),
            Self::SumOf(groups) => write!(f, "the sum of {groups} groups"),
        }
    }
}

struct AxisSet(u32);

impl fmt::Display for AxisSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0 == 0 {
            return f.write_str("no axis");
        }
        let names: Vec<_> = (0..32)
            .filter(|bit| self.0 >> bit & 1 == 1)
            .filter_map(Axis::new)
            .map(Axis::name)
            .collect();
        f.write_str(&names.join(", "))
    }
}
