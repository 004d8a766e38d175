//! Checks comparisons, and the widths of the operands of one operator.

use super::agree::{Context, demand, is_exact, is_signed};
use super::node::{Node, Operator};
use super::rule::Rule;

/// Checks that a comparison gives the same result in Rust and Verilog. Verilog evaluates its operands at the
/// width of the wider one, whatever the context.
pub(super) fn agree_compare(left: &Node, operator: Operator, right: &Node) -> Result<(), Rule> {
    let unguarded =
        |side: &Node| matches!(side, Node::Binary(_, operator, _) if operator.is_bitwise());
    if unguarded(left) || unguarded(right) {
        return Err(Rule::BitwiseBesideCompare);
    }
    check_widths(left, right, false)?;
    if operator == Operator::Equal && (is_small(left, right) || is_small(right, left)) {
        return Ok(());
    }
    let signed = left.verilog_signed() && right.verilog_signed();
    if operator == Operator::Order && is_signed(left, right) && !signed {
        return Err(Rule::SignedAgainstUnsigned);
    }
    let width = left.verilog_width().max(right.verilog_width());
    for (side, other) in [(left, right), (right, left)] {
        let wanted = other.rust_type().width;
        check_signed_cast(side, wanted)?;
        let exact = is_exact(
            side,
            Context {
                width,
                signed,
                wanted,
            },
        )?;
        let rule = if is_signed(left, right) && !signed {
            Rule::SignedAgainstUnsigned
        } else {
            Rule::CompareOfExpression
        };
        demand(exact, side, rule)?;
    }
    Ok(())
}

/// Whether the operands are a signed signal and a number below its sign bit. Their equality does not depend
/// on the sign.
fn is_small(signal: &Node, number: &Node) -> bool {
    match (signal.bare(), number.bare()) {
        (Node::Leaf(leaf), Node::Int(int)) => leaf.signed && int.fits(leaf.width - 1),
        _ => false,
    }
}

/// Checks a signed cast. A cast to an unknown width is correct only if the context gives the width and does
/// not narrow.
pub(super) fn check_signed_cast(node: &Node, wanted: Option<usize>) -> Result<(), Rule> {
    let Node::Signed(inner) = node.bare() else {
        return Ok(());
    };
    let number = matches!(inner.bare(), Node::Int(_));
    if number || node.rust_type().width.is_some() {
        return Ok(());
    }
    match wanted {
        Some(wanted) if wanted >= inner.verilog_width() => Ok(()),
        _ if inner.has_product() => Err(Rule::CastOfProduct),
        _ => Err(Rule::NarrowingSignedCast),
    }
}

/// Checks that two operands of known width have one width, and that a literal fits it.
pub(super) fn check_widths(left: &Node, right: &Node, with_bool: bool) -> Result<(), Rule> {
    for (number, other) in [(left, right), (right, left)] {
        if let (Node::Int(int), Some(width)) = (number.bare(), other.rust_type().width)
            && int.literal
            && !int.fits(width)
        {
            return Err(Rule::LiteralTooWide);
        }
    }
    match (left.rust_type().width, right.rust_type().width) {
        (Some(one), Some(two)) if one != two && !with_bool => Err(Rule::WidthMismatch),
        _ => Ok(()),
    }
}
