//! The ops of a cell: what it can do, on which unit, from which registers into which.
//!
//! An op reads its operands in the clock in which it starts. It writes its result with the clock edge that ends
//! its last clock, so that the result can be read `latency` clocks after the start. Every unit can start an op
//! in every clock.

use super::register::{POWER_WORDS, Register};
use super::unit::Unit;
use crate::hypercube::Axis;

/// An op of a cell. [`crate::CellTables::ops`] says what it does in the cell of each organisation.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Op {
    /// No operation.
    Nop,
    /// Load the query: its coordinate and radius. Clears the sum.
    LoadQuery,
    /// Load the photon's coordinate.
    LoadPhoton,
    /// Load the photon's power; in an overlapped cell, into the first place of the queue.
    LoadPower,
    /// Move a power and its presence to that place of the queue, from the place before.
    MovePower(u8),
    /// Square the difference of the two coordinates.
    SquareDifference,
    /// Make the cell's own square an operand, and receive the other operand from the neighbour on an axis: on z
    /// its square, on w its sum of squares, on a photon axis its sum of the query.
    Receive,
    /// Compare the distance with the squared radius.
    Compare,
    /// Make a photon's power the next value, or 0 where the photon is out of range or absent.
    Gate,
    /// Add two operands: in a sequential cell its own work register and the neighbour's on an axis, which
    /// exchanges sums; in an overlapped cell the addend and the operand.
    Add,
    /// Add to the sum of the query.
    Accumulate,
    /// Keep a complete distance: the cell's own, or that of the neighbour on a role axis, which has just added
    /// it up.
    Keep,
    /// Keep the distance that the neighbour on w keeps.
    Relay,
}

impl Op {
    /// The op's mnemonic in listings, without place or axis.
    pub fn mnemonic(self) -> &'static str {
        match self {
            Self::Nop => "nop",
            Self::LoadQuery => "ldq",
            Self::LoadPhoton => "ldp",
            Self::LoadPower => "ldw",
            Self::MovePower(_) => "mvw",
            Self::SquareDifference => "sqd",
            Self::Receive => "get",
            Self::Compare => "cmp",
            Self::Gate => "gate",
            Self::Add => "add",
            Self::Accumulate => "acc",
            Self::Keep => "keep",
            Self::Relay => "rly",
        }
    }
}

/// A stream that an op reads.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Stream {
    /// The query stream.
    Query,
    /// The group stream.
    Group,
}

/// One row of an op table.
#[derive(Copy, Clone, Debug)]
pub struct OpRow {
    /// The op that the row describes.
    pub op: Op,
    /// The unit that does the op; `None` for an op that only moves a word, and for the nop.
    pub unit: Option<Unit>,
    /// Clocks from the op's start to the first clock in which its result can be read.
    pub latency: u32,
    /// The registers of its own cell that the op reads. On a unit they are its inputs, in the order of its pins.
    pub reads: &'static [Register],
    /// The register that the op reads across the step's axis, or in its own cell where the step has no axis;
    /// `None` for an op that uses no link.
    pub link: Option<fn(Option<Axis>) -> Register>,
    /// The registers that the op writes, at the clock edge that ends its last clock. A write of a queued power
    /// includes its presence; a write of an operand includes the addend, which follows the square in every
    /// clock.
    pub writes: &'static [Register],
    /// The stream that the op reads.
    pub stream: Option<Stream>,
    /// The op's meaning as a formula over the registers' mnemonics; `n` is the word on the link.
    pub formula: &'static str,
}

impl OpRow {
    const fn across(self, link: fn(Option<Axis>) -> Register) -> Self {
        Self {
            link: Some(link),
            ..self
        }
    }

    const fn of(self, stream: Stream) -> Self {
        Self {
            stream: Some(stream),
            ..self
        }
    }

    const fn in_clocks(self, latency: u32) -> Self {
        Self { latency, ..self }
    }

    /// Whether the op reads the query stream.
    pub fn reads_query(&self) -> bool {
        self.stream == Some(Stream::Query)
    }

    /// Whether the op reads the group stream.
    pub fn reads_group(&self) -> bool {
        self.stream == Some(Stream::Group)
    }
}

const fn row(
    op: Op,
    unit: Option<Unit>,
    reads: &'static [Register],
    writes: &'static [Register],
    formula: &'static str,
) -> OpRow {
    OpRow {
        op,
        unit,
        latency: 1,
        reads,
        link: None,
        writes,
        stream: None,
        formula,
    }
}

use Register::{
    Addend, Distance, InRange, Operand, Photon, Power, Query, RadiusSq, Square, Sum, Work,
};

/// The ops of a sequential cell. The three computing units are the paper's: `A+B`, `(A-B)^2`, and `if A>B,
/// output 0`. A fourth unit, the port, moves a word from the streams into the register file.
#[rustfmt::skip]
pub(super) const SEQUENTIAL: &[OpRow] = &[
    row(Op::Nop, None, &[], &[], "-"),
    row(Op::LoadQuery, Some(Unit::Port), &[], &[Query, RadiusSq, Sum],
        "q := query coordinate; r := radius_sq; s := 0").of(Stream::Query),
    row(Op::LoadPhoton, Some(Unit::Port), &[], &[Photon],
        "p := photon coordinate").of(Stream::Group),
    row(Op::LoadPower, Some(Unit::Port), &[], &[Power(0)],
        "w := present ? photon mantissa << exponent : 0").of(Stream::Group),
    row(Op::SquareDifference, Some(Unit::Square), &[Query, Photon], &[Work],
        "v := square(q - p)"),
    row(Op::Add, Some(Unit::Add), &[Work], &[Work],
        "v := v + n (mod 2^work)").across(|_| Work),
    row(Op::Gate, Some(Unit::Gate), &[Work, RadiusSq, Power(0)], &[Work],
        "v := v > r ? 0 : w"),
    row(Op::Accumulate, Some(Unit::Add), &[Work, Sum], &[Sum],
        "s := s + v (mod 2^sum)"),
];

/// The last place of the power queue, from which the gate takes the power.
const GATED: Register = Power(POWER_WORDS - 1);

/// The ops of an overlapped cell.
#[rustfmt::skip]
pub(super) const OVERLAPPED: &[OpRow] = &[
    row(Op::LoadPhoton, Some(Unit::PhotonPort), &[], &[Photon],
        "p := photon coordinate").of(Stream::Group),
    row(Op::LoadPower, Some(Unit::PowerPort), &[], &[Power(0)],
        "w0 := photon power; n0 := group taken and photon present").of(Stream::Group),
    row(Op::MovePower(1), None, &[Power(0)], &[Power(1)],
        "w(i) := w(i-1); n(i) := n(i-1)"),
    row(Op::SquareDifference, Some(Unit::Square), &[Query, Photon], &[Square],
        "m := |q - p|; dd, dl, dh := products of m's digits; v := dd + 32 dl + 128 dh = m^2").in_clocks(3),
    row(Op::Receive, None, &[Square], &[Operand],
        "c := v; b := n, which is v on z, a on w, s on x and y").across(sent_as_operand),
    row(Op::Compare, Some(Unit::Gate), &[Distance, RadiusSq], &[InRange],
        "f := t <= r"),
    row(Op::Gate, None, &[InRange, GATED], &[Operand],
        "b := f and n7 ? w7 : 0"),
    row(Op::Add, Some(Unit::Add), &[Addend, Operand], &[Work],
        "a := c + b (mod 2^work)"),
    row(Op::Accumulate, Some(Unit::Add), &[Sum, Operand], &[Sum],
        "s := s + b (mod 2^sum)"),
    row(Op::Keep, None, &[], &[Distance],
        "t := a, one's own or n").across(|_| Work),
    row(Op::Relay, None, &[], &[Distance],
        "t := n, which is t on w").across(|_| Distance),
];

/// The register that a cell sends on an axis for [`Op::Receive`].
fn sent_as_operand(axis: Option<Axis>) -> Register {
    match axis {
        Some(Axis::Z) => Square,
        Some(Axis::W) => Work,
        _ => Sum,
    }
}
