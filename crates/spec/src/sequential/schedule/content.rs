//! The kinds of value that a register of a sequential machine holds, as the checker distinguishes them.

use std::collections::BTreeMap;
use std::fmt;

use crate::cell::{Op, Register, SEQUENTIAL, Step};
use crate::hypercube::{Axis, Hypercube};

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

/// The contents of a cell's registers. At first no register holds a value that may be read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Contents(BTreeMap<Register, Content>);

/// A register that a step reads and that does not hold what the step needs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unreadable {
    /// The register that is read.
    pub register: Register,
    /// The content that the step needs there.
    pub expected: String,
}

impl Contents {
    /// The content of a register.
    pub fn of(&self, register: Register) -> Content {
        self.0.get(&register).copied().unwrap_or(Content::Stale)
    }

    /// The contents after a step that all cells of the cube do.
    ///
    /// # Errors
    /// The first register that the step reads and that does not hold what a gather needs there.
    pub fn after(&self, step: Step, cube: Hypercube) -> Result<Self, Unreadable> {
        let row = SEQUENTIAL.op(step.op);
        let made = match step.op {
            Op::SquareDifference => {
                self.expect(Register::Query, Content::Loaded)?;
                self.expect(Register::Photon, Content::Loaded)?;
                Content::Distance(0)
            }
            Op::Add => self.exchanged(step, cube)?,
            Op::Gate => {
                let complete = axis_set(cube.role_axes());
                self.expect(Register::Work, Content::Distance(complete))?;
                self.expect(Register::RadiusSq, Content::Loaded)?;
                self.expect(Register::Power(0), Content::Loaded)?;
                Content::Gated(0)
            }
            Op::Accumulate => {
                let complete = axis_set(cube.photon_axes());
                self.expect(Register::Work, Content::Gated(complete))?;
                self.one_group_more()?
            }
            _ if row.stream.is_some() => Content::Loaded,
            // A gather needs no other op, and reads nothing that such an op writes.
            _ => Content::Stale,
        };
        let mut next = self.clone();
        next.0
            .extend(row.writes.iter().map(|&register| (register, made)));
        if row.reads_query() {
            next.0.insert(Register::Sum, Content::SumOf(0));
        }
        Ok(next)
    }

    /// Makes the registers unreadable whose values belong to one iteration.
    pub(super) fn forget_iteration(&mut self) {
        for register in [Register::Photon, Register::Power(0), Register::Work] {
            self.0.remove(&register);
        }
    }

    /// The sum after an exchange-add. The neighbour holds the same kind of value; the axis must not be in it
    /// already.
    fn exchanged(&self, step: Step, cube: Hypercube) -> Result<Content, Unreadable> {
        let role_axes = axis_set(cube.role_axes());
        let bit = step.axis.map_or(0, |axis| 1 << axis.bit());
        let of_roles = bit & role_axes != 0;
        match self.of(Register::Work) {
            Content::Distance(axes) if axes & bit == 0 && of_roles => {
                Ok(Content::Distance(axes | bit))
            }
            Content::Gated(axes) if axes & bit == 0 && bit & !role_axes != 0 => {
                Ok(Content::Gated(axes | bit))
            }
            _ => {
                let summed = if of_roles { "squares" } else { "gated powers" };
                let axis = step.axis.map_or("no axis", Axis::name);
                let expected = format!("{summed} not yet summed across {axis}");
                Err(Unreadable {
                    register: Register::Work,
                    expected,
                })
            }
        }
    }

    fn one_group_more(&self) -> Result<Content, Unreadable> {
        match self.of(Register::Sum) {
            Content::SumOf(groups) => Ok(Content::SumOf(groups + 1)),
            _ => Err(Unreadable {
                register: Register::Sum,
                expected: "a cleared sum".to_owned(),
            }),
        }
    }

    fn expect(&self, register: Register, expected: Content) -> Result<(), Unreadable> {
        if self.of(register) == expected {
            return Ok(());
        }
        Err(Unreadable {
            register,
            expected: expected.to_string(),
        })
    }
}

fn axis_set(axes: impl Iterator<Item = Axis>) -> u32 {
    axes.map(|axis| 1 << axis.bit()).sum()
}
