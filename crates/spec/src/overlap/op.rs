//! The op table of an overlapped machine's cell: what it can do, on which unit, and with which latency.
//!
//! An op reads its operands in the clock in which it starts. It writes its result with the clock edge that
//! ends its last clock, so that the result can be read `latency` clocks after the start. Every unit can start
//! an op in every clock.

use std::fmt;

use super::register::{POWER_WORDS, Register};
use crate::hypercube::Axis;

/// A unit of the cell; each starts at most one op a clock.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Unit {
    /// `(A-B)^2`.
    Square,
    /// `if A>B, output 0`.
    Gate,
    /// `A+B`.
    Add,
    /// Reads a photon's coordinate from the group stream.
    PhotonPort,
    /// Reads a photon's power from the group stream.
    PowerPort,
}

impl Unit {
    /// All units, the paper's three first.
    pub const ALL: [Self; 5] = [
        Self::Square,
        Self::Gate,
        Self::Add,
        Self::PhotonPort,
        Self::PowerPort,
    ];

    /// The unit's name in listings and reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Square => "square",
            Self::Gate => "gate",
            Self::Add => "add",
            Self::PhotonPort => "photon port",
            Self::PowerPort => "power port",
        }
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// An op of an overlapped machine's cell.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Op {
    /// Load the photon's coordinate.
    LoadPhoton,
    /// Load the photon's power into the first place of the queue.
    LoadPower,
    /// Move a power and its presence to that place of the queue, from the place before.
    MovePower(u8),
    /// Square the difference of the two coordinates.
    SquareDifference,
    /// Make the cell's own square an operand, and receive the other operand from the neighbour on an axis: on
    /// z its square, on w its sum of squares, on a photon axis its sum of the query.
    Receive(Axis),
    /// Compare the distance with the squared radius.
    Compare,
    /// Make the power the operand, or 0 where the photon is out of range or absent: the second half of the
    /// gate.
    Gate,
    /// Add the two operands.
    Add,
    /// Add the operand to the sum of the query.
    Accumulate,
    /// Keep a complete distance: the cell's own, or that of the neighbour on a role axis, which has just
    /// added it up.
    Keep(Option<Axis>),
    /// Keep the distance that the neighbour on w keeps.
    Relay,
}

/// One row of the op table.
#[derive(Copy, Clone, Debug)]
pub struct OpRow {
    /// The op's mnemonic in listings, without place or axis.
    pub mnemonic: &'static str,
    /// The unit that does the op; `None` for an op that only moves a word.
    pub unit: Option<Unit>,
    /// Clocks from the op's start to the first clock in which its result can be read.
    pub latency: u32,
    /// The op's meaning as a formula over the registers' mnemonics; `n` is the word on the link.
    pub formula: &'static str,
}

/// A register that an op reads, in its own cell or in the neighbour on an axis.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Read {
    /// The register that is read.
    pub register: Register,
    /// The axis of the neighbour that holds the register; `None` for the op's own cell.
    pub across: Option<Axis>,
}

const LOAD_PHOTON: OpRow = OpRow {
    mnemonic: "ldp",
    unit: Some(Unit::PhotonPort),
    latency: 1,
    formula: "p := photon coordinate",
};
const LOAD_POWER: OpRow = OpRow {
    mnemonic: "ldw",
    unit: Some(Unit::PowerPort),
    latency: 1,
    formula: "w0 := photon power; n0 := group taken and photon present",
};
const MOVE_POWER: OpRow = OpRow {
    mnemonic: "mvw",
    unit: None,
    latency: 1,
    formula: "w(i) := w(i-1); n(i) := n(i-1)",
};
const SQUARE_DIFFERENCE: OpRow = OpRow {
    mnemonic: "sqd",
    unit: Some(Unit::Square),
    latency: 3,
    formula: "m := |q - p|; dd, dl, dh := products of m's digits; v := dd + 32 dl + 128 dh = m^2",
};
const RECEIVE: OpRow = OpRow {
    mnemonic: "get",
    unit: None,
    latency: 1,
    formula: "c := v; b := n, which is v on z, a on w, s on x and y",
};
const COMPARE: OpRow = OpRow {
    mnemonic: "cmp",
    unit: Some(Unit::Gate),
    latency: 1,
    formula: "f := t <= r",
};
const GATE: OpRow = OpRow {
    mnemonic: "gate",
    unit: None,
    latency: 1,
    formula: "b := f and n7 ? w7 : 0",
};
const ADD: OpRow = OpRow {
    mnemonic: "add",
    unit: Some(Unit::Add),
    latency: 1,
    formula: "a := c + b (mod 2^work)",
};
const ACCUMULATE: OpRow = OpRow {
    mnemonic: "acc",
    unit: Some(Unit::Add),
    latency: 1,
    formula: "s := s + b (mod 2^sum)",
};
const KEEP: OpRow = OpRow {
    mnemonic: "keep",
    unit: None,
    latency: 1,
    formula: "t := a, one's own or n",
};
const RELAY: OpRow = OpRow {
    mnemonic: "rly",
    unit: None,
    latency: 1,
    formula: "t := n, which is t on w",
};

/// The op table, one row for each kind.
pub const OPS: &[OpRow] = &[
    LOAD_PHOTON,
    LOAD_POWER,
    MOVE_POWER,
    SQUARE_DIFFERENCE,
    RECEIVE,
    COMPARE,
    GATE,
    ADD,
    ACCUMULATE,
    KEEP,
    RELAY,
];

impl Op {
    /// The op's row in [`OPS`].
    pub fn row(self) -> &'static OpRow {
        match self {
            Self::LoadPhoton => &LOAD_PHOTON,
            Self::LoadPower => &LOAD_POWER,
            Self::MovePower(_) => &MOVE_POWER,
            Self::SquareDifference => &SQUARE_DIFFERENCE,
            Self::Receive(_) => &RECEIVE,
            Self::Compare => &COMPARE,
            Self::Gate => &GATE,
            Self::Add => &ADD,
            Self::Accumulate => &ACCUMULATE,
            Self::Keep(_) => &KEEP,
            Self::Relay => &RELAY,
        }
    }

    /// The registers that the op reads.
    pub fn reads(self) -> Vec<Read> {
        let own = |register| Read {
            register,
            across: None,
        };
        let across = |register, axis| Read {
            register,
            across: Some(axis),
        };
        match self {
            Self::LoadPhoton | Self::LoadPower => vec![],
            Self::MovePower(place) => vec![own(Register::Power(place - 1))],
            Self::SquareDifference => vec![own(Register::Query), own(Register::Photon)],
            Self::Receive(axis) => vec![own(Register::Square), across(sent_as_operand(axis), axis)],
            Self::Compare => vec![own(Register::Distance), own(Register::RadiusSq)],
            Self::Gate => vec![
                own(Register::InRange),
                own(Register::Power(POWER_WORDS - 1)),
            ],
            Self::Add => vec![own(Register::Addend), own(Register::Operand)],
            Self::Accumulate => vec![own(Register::Sum), own(Register::Operand)],
            Self::Keep(axis) => vec![Read {
                register: Register::Work,
                across: axis,
            }],
            Self::Relay => vec![across(Register::Distance, Axis::W)],
        }
    }

    /// The register that the op writes. A write of a power includes its presence; a write of an operand
    /// includes the addend, which follows the square in every clock.
    pub fn write(self) -> Register {
        match self {
            Self::LoadPhoton => Register::Photon,
            Self::LoadPower => Register::Power(0),
            Self::MovePower(place) => Register::Power(place),
            Self::SquareDifference => Register::Square,
            Self::Receive(_) | Self::Gate => Register::Operand,
            Self::Compare => Register::InRange,
            Self::Add => Register::Work,
            Self::Accumulate => Register::Sum,
            Self::Keep(_) | Self::Relay => Register::Distance,
        }
    }

    /// The axis on which the op receives a word from its neighbour.
    pub fn axis(self) -> Option<Axis> {
        match self {
            Self::Receive(axis) => Some(axis),
            Self::Keep(axis) => axis,
            Self::Relay => Some(Axis::W),
            _ => None,
        }
    }
}

/// The register that a cell sends on an axis for [`Op::Receive`].
fn sent_as_operand(axis: Axis) -> Register {
    match axis {
        Axis::Z => Register::Square,
        Axis::W => Register::Work,
        _ => Register::Sum,
    }
}

impl fmt::Display for Op {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.row().mnemonic)?;
        match (self, self.axis()) {
            (Self::MovePower(place), _) => write!(f, " {place}"),
            (_, Some(axis)) => write!(f, " {axis}"),
            _ => Ok(()),
        }
    }
}
