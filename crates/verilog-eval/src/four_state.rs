//! Verilog's operators on values that may be unknown, as pairs of two-state nodes: the value, and a mask of
//! its unknown bits. Where no bit is unknown the mask is the constant 0 and everything that depends on it is
//! folded. Thus an initialised design runs without extra cost.
//!
//! Bitwise operators, selections and concatenations are precise, bit by bit. For all other operators, one
//! unknown bit makes the whole result unknown (IEEE 1364-2005, 5.1), as in Icarus.

use super::graph::{Binary, Known, Unary, Value};
use super::node::{self, NodeId, Nodes};

/// A value with the mask of its unknown bits. Unknown bits are 0 in the value.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Pair {
    pub value: NodeId,
    pub unknown: NodeId,
}

pub fn known(nodes: &mut Nodes, value: NodeId) -> Pair {
    let unknown = nodes.zero(nodes.width(value));
    Pair { value, unknown }
}

pub fn constant(nodes: &mut Nodes, known: &Known) -> Pair {
    Pair {
        value: nodes.bits(known.value.clone()),
        unknown: nodes.bits(known.unknown.clone()),
    }
}

/// Applies an operation to operands that are lowered already; `None` for a value that is not an operation.
pub fn operation(nodes: &mut Nodes, width: u32, value: &Value, operands: &[Pair]) -> Option<Pair> {
    Some(match (value, operands) {
        (Value::Constant(known), _) => constant(nodes, known),
        (Value::Unary(operation, _), &[a]) => unary(nodes, *operation, a),
        (Value::Binary(operation, ..), &[a, b]) => binary(nodes, *operation, a, b),
        (Value::Conditional(..), &[c, a, b]) => conditional(nodes, c, a, b),
        (Value::If(..), &[c, a, b]) => Pair {
            value: nodes.select(c.value, a.value, b.value),
            unknown: nodes.select(c.value, a.unknown, b.unknown),
        },
        (Value::Concat(..), &[a, b]) => Pair {
            value: nodes.concat(a.value, b.value),
            unknown: nodes.concat(a.unknown, b.unknown),
        },
        (Value::Slice(_, low), &[a]) => slice(nodes, a, *low, width),
        (Value::SliceAt(..), &[a, at]) => slice_at(nodes, a, at, width),
        (Value::Insert(..), &[a, at, part]) => insert(nodes, a, at, part),
        (Value::ZeroExtend(_), &[a]) => Pair {
            value: nodes.zero_extend(a.value, width),
            unknown: nodes.zero_extend(a.unknown, width),
        },
        (Value::SignExtend(_), &[a]) => Pair {
            value: nodes.sign_extend(a.value, width),
            unknown: nodes.sign_extend(a.unknown, width),
        },
        _ => return None,
    })
}

fn any(nodes: &mut Nodes, a: NodeId) -> NodeId {
    nodes.unary(node::Unary::Any, a)
}

fn all(nodes: &mut Nodes, a: NodeId) -> NodeId {
    nodes.unary(node::Unary::All, a)
}

/// `a & ~b`.
fn and_not(nodes: &mut Nodes, a: NodeId, b: NodeId) -> NodeId {
    let not = nodes.not(b);
    nodes.and(a, not)
}

/// A value that is unknown as a whole where `unknown`, one bit, is 1.
fn all_or_nothing(nodes: &mut Nodes, value: NodeId, unknown: NodeId) -> Pair {
    let unknown = nodes.spread(unknown, nodes.width(value));
    let value = and_not(nodes, value, unknown);
    Pair { value, unknown }
}

fn unary(nodes: &mut Nodes, operation: Unary, a: Pair) -> Pair {
    match operation {
        Unary::Not => {
            let either = nodes.or(a.value, a.unknown);
            Pair {
                value: nodes.not(either),
                unknown: a.unknown,
            }
        }
        Unary::Negate => {
            let value = nodes.unary(node::Unary::Negate, a.value);
            let unknown = any(nodes, a.unknown);
            all_or_nothing(nodes, value, unknown)
        }
        Unary::All => {
            let value = all(nodes, a.value);
            let either = nodes.or(a.value, a.unknown);
            let may_be = all(nodes, either);
            let unknown = any(nodes, a.unknown);
            let unknown = nodes.and(unknown, may_be);
            Pair { value, unknown }
        }
        Unary::Any => {
            let value = any(nodes, a.value);
            let unknown = any(nodes, a.unknown);
            let unknown = and_not(nodes, unknown, value);
            Pair { value, unknown }
        }
        Unary::Parity => {
            let value = nodes.unary(node::Unary::Parity, a.value);
            let unknown = any(nodes, a.unknown);
            all_or_nothing(nodes, value, unknown)
        }
    }
}

fn binary(nodes: &mut Nodes, operation: Binary, a: Pair, b: Pair) -> Pair {
    let two_state = match operation {
        Binary::And => return and(nodes, a, b),
        Binary::Or => {
            let value = nodes.or(a.value, b.value);
            let unknown = nodes.or(a.unknown, b.unknown);
            let unknown = and_not(nodes, unknown, value);
            return Pair { value, unknown };
        }
        Binary::Xor => {
            let value = nodes.binary(node::Binary::Xor, a.value, b.value);
            let unknown = nodes.or(a.unknown, b.unknown);
            let value = and_not(nodes, value, unknown);
            return Pair { value, unknown };
        }
        Binary::Equal => return equal(nodes, a, b),
        Binary::Same => {
            let values = nodes.binary(node::Binary::Equal, a.value, b.value);
            let unknowns = nodes.binary(node::Binary::Equal, a.unknown, b.unknown);
            let value = nodes.and(values, unknowns);
            return known(nodes, value);
        }
        Binary::ShiftLeft | Binary::ShiftRight | Binary::ArithmeticShiftRight => {
            return shift(nodes, operation, a, b);
        }
        Binary::Add => node::Binary::Add,
        Binary::Subtract => node::Binary::Subtract,
        Binary::Multiply => node::Binary::Multiply,
        Binary::Less => node::Binary::Less,
        Binary::LessSigned => node::Binary::LessSigned,
    };
    let value = nodes.binary(two_state, a.value, b.value);
    let unknown = nodes.or(a.unknown, b.unknown);
    let unknown = any(nodes, unknown);
    all_or_nothing(nodes, value, unknown)
}

/// AND: a bit is unknown where one operand is unknown and neither is a known 0.
fn and(nodes: &mut Nodes, a: Pair, b: Pair) -> Pair {
    let value = nodes.and(a.value, b.value);
    let may_be_a = nodes.or(a.value, a.unknown);
    let may_be_b = nodes.or(b.value, b.unknown);
    let may_be = nodes.and(may_be_a, may_be_b);
    let unknown = nodes.or(a.unknown, b.unknown);
    let unknown = nodes.and(unknown, may_be);
    Pair { value, unknown }
}

/// Equality: two bits that are known and differ decide, whatever bits are unknown.
fn equal(nodes: &mut Nodes, a: Pair, b: Pair) -> Pair {
    let unknown = nodes.or(a.unknown, b.unknown);
    if nodes.is_zero(unknown) {
        let value = nodes.binary(node::Binary::Equal, a.value, b.value);
        return known(nodes, value);
    }
    let differ = nodes.binary(node::Binary::Xor, a.value, b.value);
    let differ = and_not(nodes, differ, unknown);
    let differ = any(nodes, differ);
    let unknown = any(nodes, unknown);
    let either = nodes.or(differ, unknown);
    Pair {
        value: nodes.not(either),
        unknown: and_not(nodes, unknown, differ),
    }
}

fn shift(nodes: &mut Nodes, operation: Binary, a: Pair, by: Pair) -> Pair {
    let operation = match operation {
        Binary::ShiftLeft => node::Binary::ShiftLeft,
        Binary::ShiftRight => node::Binary::ShiftRight,
        _ => node::Binary::ArithmeticShiftRight,
    };
    let value = nodes.binary(operation, a.value, by.value);
    let unknown = nodes.binary(operation, a.unknown, by.value);
    let nothing = any(nodes, by.unknown);
    let nothing = nodes.spread(nothing, nodes.width(value));
    Pair {
        value: and_not(nodes, value, nothing),
        unknown: nodes.or(unknown, nothing),
    }
}

fn conditional(nodes: &mut Nodes, c: Pair, a: Pair, b: Pair) -> Pair {
    let value = nodes.select(c.value, a.value, b.value);
    let unknown = nodes.select(c.value, a.unknown, b.unknown);
    if nodes.is_zero(c.unknown) {
        return Pair { value, unknown };
    }
    let differ = nodes.binary(node::Binary::Xor, a.value, b.value);
    let unknowns = nodes.or(a.unknown, b.unknown);
    let open = nodes.or(differ, unknowns);
    let both = nodes.and(a.value, b.value);
    Pair {
        value: nodes.select(c.unknown, both, value),
        unknown: nodes.select(c.unknown, open, unknown),
    }
}

/// A slice. Bits above the number are unknown.
fn slice(nodes: &mut Nodes, a: Pair, low: u32, width: u32) -> Pair {
    let there = nodes.width(a.value).saturating_sub(low).min(width);
    if there == 0 {
        return constant(nodes, &Known::nothing(width));
    }
    let value = nodes.slice(a.value, low, there);
    let unknown = nodes.slice(a.unknown, low, there);
    if there == width {
        return Pair { value, unknown };
    }
    let above = nodes.bits(super::bits::Bits::ones(width - there));
    Pair {
        value: nodes.zero_extend(value, width),
        unknown: nodes.concat(above, unknown),
    }
}

/// A slice at a computed place: the known bits, shifted down. Bits above the number are unknown.
fn slice_at(nodes: &mut Nodes, a: Pair, at: Pair, width: u32) -> Pair {
    let size = nodes.width(a.value).max(width);
    let known = nodes.not(a.unknown);
    let mut part = |whole| {
        let whole = nodes.zero_extend(whole, size);
        let shifted = nodes.binary(node::Binary::ShiftRight, whole, at.value);
        nodes.slice(shifted, 0, width)
    };
    let (value, known) = (part(a.value), part(known));
    let known = match always_inside(nodes, a, at, width) && nodes.is_zero(a.unknown) {
        true => nodes.bits(super::bits::Bits::ones(width)),
        false => known,
    };
    let nothing = any(nodes, at.unknown);
    let nothing = nodes.spread(nothing, width);
    let known = and_not(nodes, known, nothing);
    Pair {
        value: and_not(nodes, value, nothing),
        unknown: nodes.not(known),
    }
}

/// Whether every place that the index can have is inside the number.
fn always_inside(nodes: &Nodes, a: Pair, at: Pair, width: u32) -> bool {
    let mut bits = nodes.width(at.value);
    if let &node::Operation::ZeroExtend(inner) = &nodes.get(at.value).operation {
        bits = nodes.width(inner);
    }
    let last = 1u64.checked_shl(bits).map(|places| places - 1);
    let end = last.and_then(|last| last.checked_add(u64::from(width)));
    end.is_some_and(|end| end <= u64::from(nodes.width(a.value)))
}

/// Inserts a part at a computed place. An unknown place inserts nothing.
fn insert(nodes: &mut Nodes, a: Pair, at: Pair, part: Pair) -> Pair {
    let width = nodes.width(a.value);
    let size = width.max(nodes.width(part.value));
    let mut shifted = |part| {
        let whole = nodes.zero_extend(part, size);
        let placed = nodes.binary(node::Binary::ShiftLeft, whole, at.value);
        nodes.slice(placed, 0, width)
    };
    let (value, unknown) = (shifted(part.value), shifted(part.unknown));
    let hole = super::bits::Bits::ones(nodes.width(part.value));
    let hole = nodes.bits(hole);
    let hole = nodes.zero_extend(hole, size);
    let hole = nodes.binary(node::Binary::ShiftLeft, hole, at.value);
    let hole = nodes.slice(hole, 0, width);
    let nowhere = any(nodes, at.unknown);
    let nowhere = nodes.spread(nowhere, width);
    let hole = and_not(nodes, hole, nowhere);
    let mut put = |old, new| {
        let kept = and_not(nodes, old, hole);
        let new = nodes.and(new, hole);
        nodes.or(kept, new)
    };
    Pair {
        value: put(a.value, value),
        unknown: put(a.unknown, unknown),
    }
}
