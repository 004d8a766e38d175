//! Three-address code: the forms that a statement may have.

use super::node::{Node, Operator};

/// Whether the node is a signal, a number, a slice, or a cast of one of these.
pub(super) fn is_operand(node: &Node) -> bool {
    match node {
        Node::Leaf(_) | Node::Int(_) => true,
        Node::Cast(inner, _) | Node::Signed(inner) | Node::Unsigned(inner) | Node::Paren(inner) => {
            is_operand(inner)
        }
        Node::Neg(inner) => matches!(inner.bare(), Node::Int(_)),
        _ => false,
    }
}

/// Whether the node is one operator over operands, or one of the two forms that may have more operators:
/// logic of single bits, and a concatenation.
pub(super) fn is_three_address(node: &Node) -> bool {
    is_single(node.bare()) || is_flag(node) || is_concatenation(node)
}

fn is_single(node: &Node) -> bool {
    match node {
        Node::Not(inner) | Node::Neg(inner) | Node::Reduce(_, inner) => is_operand(inner),
        Node::Replace(base, bit) => is_operand(base) && is_operand(bit),
        Node::Binary(left, _, right) => is_operand(left) && is_operand(right),
        other => is_operand(other),
    }
}

/// `!a & (b == c)`: every operator gives one bit, and comparisons and reductions have operands.
fn is_flag(node: &Node) -> bool {
    match node {
        Node::Paren(inner) | Node::Not(inner) => is_flag(inner),
        Node::Reduce(..) => is_single(node),
        Node::Binary(_, operator, _) if operator.is_compare() => is_single(node),
        Node::Binary(left, operator, right)
            if operator.is_bitwise() || *operator == Operator::Logic =>
        {
            is_flag(left) && is_flag(right)
        }
        other => is_operand(other) && matches!(other.rust_type().width, Some(1) | None),
    }
}

/// `(bit_cast::<24, 12>(a) << 12) | bit_cast::<24, 12>(b)`, of any number of parts.
fn is_concatenation(node: &Node) -> bool {
    match node.bare() {
        Node::Binary(left, Operator::Or, right) => {
            is_concatenation(left) && is_concatenation(right)
        }
        Node::Binary(left, Operator::Shl | Operator::Shr, right) => {
            is_operand(left) && is_operand(right)
        }
        other => is_operand(other),
    }
}
