//! The kinds of value that a register of an overlapped machine holds, as the checker distinguishes them.

use std::collections::BTreeSet;
use std::fmt;

use crate::hypercube::Axis;

/// The content of a register. Groups count from 0 in their query, and missing groups count too.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Content {
    /// A value that no op may read.
    Stale,
    /// A zero, or a power that is marked as absent.
    Nothing,
    /// A word of the query.
    Query,
    /// A photon's coordinate x, y or z.
    Coordinate(usize, u32),
    /// The sum of these squares (bit set: x, y, z) of a group.
    Squares(u32, u32),
    /// Whether a group's photon is in range.
    InRange(u32),
    /// A photon's power.
    Power(u32),
    /// A photon's power in range, 0 out of it.
    Gated(u32),
    /// The sum of these groups' powers.
    Sum(BTreeSet<u32>, AxisSet),
    /// A neighbour's sum, received on an axis.
    SumAcross(Axis, BTreeSet<u32>, AxisSet),
}

/// The photon axes over which a sum was added (bit set), by index bit.
pub type AxisSet = u32;

/// The bits of all three squares.
pub(super) const ALL_SQUARES: u32 = 0b111;

impl fmt::Display for Content {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Stale => f.write_str("nothing that may be read"),
            Self::Nothing => f.write_str("nothing"),
            Self::Query => f.write_str("the query"),
            Self::Coordinate(index, group) => {
                write!(f, "{} of group {group}", ["x", "y", "z"][*index])
            }
            Self::Squares(set, group) => {
                let names = [(1, "x^2"), (2, "y^2"), (4, "z^2")];
                let names = names.iter().filter(|(bit, _)| set & bit != 0);
                let names: Vec<_> = names.map(|(_, name)| *name).collect();
                write!(f, "{} of group {group}", names.join(" + "))
            }
            Self::InRange(group) => write!(f, "the comparison of group {group}"),
            Self::Power(group) => write!(f, "the power of group {group}"),
            Self::Gated(group) => write!(f, "the gated power of group {group}"),
            Self::Sum(groups, axes) => write!(f, "{}", sum(groups, *axes)),
            Self::SumAcross(axis, groups, axes) => {
                write!(f, "{} from across {axis}", sum(groups, *axes))
            }
        }
    }
}

fn sum(groups: &BTreeSet<u32>, axes: AxisSet) -> String {
    let groups: Vec<_> = groups.iter().map(u32::to_string).collect();
    let crossed: Vec<_> = (0..32)
        .filter(|bit| axes >> bit & 1 == 1)
        .filter_map(Axis::new)
        .map(Axis::name)
        .collect();
    let crossed = match crossed.is_empty() {
        true => String::new(),
        false => format!(" summed across {}", crossed.join(", ")),
    };
    format!("the sum of the groups {{{}}}{crossed}", groups.join(", "))
}
