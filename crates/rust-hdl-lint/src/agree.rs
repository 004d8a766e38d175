//! Computes how many low bits of an expression are equal in Rust and in Verilog.
//!
//! In `+ - * & | ^ ~ <<` information moves upwards only: if the operands agree in their low `k` bits, so does
//! the result. All other operators (`>>`, comparisons, reductions, the upper bits of a cast) need operands
//! that agree in every bit at the width at which Verilog evaluates them.

use super::compare::{agree_compare, check_signed_cast, check_widths};
use super::node::{FACTOR_WIDTH, Leaf, Node, Operator, PRODUCT_WIDTH};
use super::rule::Rule;

/// The context of an expression in Verilog.
#[derive(Clone, Copy)]
pub(super) struct Context {
    /// The width at which Verilog evaluates the expression.
    pub(super) width: usize,
    /// Whether Verilog evaluates the expression as signed, which requires that every operand of the whole
    /// expression is signed.
    pub(super) signed: bool,
    /// The width in Rust, for an expression that does not know its own width.
    pub(super) wanted: Option<usize>,
}

impl Context {
    /// The context of an expression that nothing around it widens.
    pub(super) fn alone(node: &Node) -> Self {
        Context {
            width: node.verilog_width(),
            signed: node.verilog_signed(),
            wanted: None,
        }
    }

    fn wanting(self, wanted: Option<usize>) -> Self {
        Context { wanted, ..self }
    }

    /// The number of bits that an operator of this Rust width computes correctly: all bits, if nothing widens
    /// it.
    fn cap(self, width: Option<usize>) -> usize {
        width.or(self.wanted).unwrap_or(self.width).min(self.width)
    }
}

/// The number of low bits in which the Verilog value agrees with the Rust value, after the Rust value is
/// extended to the context's width by the sign of its type.
pub(super) fn agree(node: &Node, context: Context) -> Result<usize, Rule> {
    let width = context.width;
    match node {
        Node::Leaf(leaf) => Ok(agree_leaf(leaf, context)),
        Node::Int(_) => Ok(width),
        Node::Paren(inner) => agree(inner, context),
        Node::Cast(inner, to) => agree_cast(inner, *to, context),
        Node::Signed(inner) => agree_signed(inner, context),
        Node::Unsigned(inner) => agree_unsigned(inner, context),
        Node::Not(inner) => Ok(agree(inner, context)?.min(context.cap(inner.rust_type().width))),
        Node::Neg(inner) if matches!(inner.bare(), Node::Int(_)) => Ok(width),
        Node::Neg(inner) => Ok(agree(inner, context)?.min(context.cap(inner.rust_type().width))),
        Node::Reduce(all, inner) => agree_reduce(*all, inner).map(|()| width),
        Node::Replace(base, bit) => agree_replace(base, bit, context),
        Node::Binary(left, operator, right) => agree_binary(left, *operator, right, context),
    }
}

fn agree_leaf(leaf: &Leaf, context: Context) -> usize {
    let extended_by_sign = leaf.declared_signed && context.signed;
    if leaf.signed && !extended_by_sign {
        leaf.width.min(context.width)
    } else {
        context.width
    }
}

/// Whether every bit agrees, and no bit of the Rust value is lost.
pub(super) fn is_exact(node: &Node, context: Context) -> Result<bool, Rule> {
    let whole = node
        .rust_type()
        .width
        .or(context.wanted)
        .is_none_or(|own| own <= context.width);
    Ok(agree(node, context)? == context.width && whole)
}

/// Whether every bit of an argument agrees that Verilog evaluates at the argument's own width.
fn is_exact_alone(node: &Node) -> Result<bool, Rule> {
    is_exact(node, Context::alone(node))
}

/// Returns an error unless `holds`. A failure caused by a product is reported under the rule for products.
pub(super) fn demand(holds: bool, node: &Node, rule: Rule) -> Result<(), Rule> {
    match (holds, node.has_product()) {
        (true, _) => Ok(()),
        (false, true) => Err(Rule::ProductInContext),
        (false, false) => Err(rule),
    }
}

fn agree_cast(inner: &Node, to: usize, context: Context) -> Result<usize, Rule> {
    if let Node::Int(int) = inner.bare() {
        return if int.fits(to) {
            Ok(context.width)
        } else {
            Err(Rule::LiteralTooWide)
        };
    }
    let inside = Context {
        signed: false,
        ..context
    }
    .wanting(None);
    let masked =
        agree(inner, inside)? >= to && inner.rust_type().width.is_some_and(|own| own >= to);
    demand(
        masked || is_exact(inner, inside)?,
        inner,
        Rule::CastOfExpression,
    )?;
    Ok(context.width)
}

fn agree_signed(inner: &Node, context: Context) -> Result<usize, Rule> {
    let alone = inner.verilog_width();
    if let Node::Int(int) = inner.bare() {
        if !int.fits(alone - 1) {
            return Err(Rule::LiteralTooWide);
        }
    } else if !is_exact_alone(inner)? && inner.has_product() {
        return Err(Rule::CastOfProduct);
    }
    // The sign bit is at the top only if the argument is as wide in Verilog as in Rust.
    let low = agree(inner, Context::alone(inner))?;
    let own = inner.rust_type().width.unwrap_or(alone);
    let whole = low == alone && own == alone;
    Ok(if whole && context.signed {
        context.width
    } else {
        low.min(own).min(context.width)
    })
}

fn agree_unsigned(inner: &Node, context: Context) -> Result<usize, Rule> {
    demand(is_exact_alone(inner)?, inner, Rule::CastOfExpression)?;
    match inner.rust_type().width {
        Some(_) => Ok(context.width),
        // A signed cast to an unknown width, which Verilog then extends with zeros.
        None => Ok(inner.verilog_width().min(context.width)),
    }
}

fn agree_reduce(all: bool, inner: &Node) -> Result<(), Rule> {
    let filled = !all || inner.rust_type().width == Some(inner.verilog_width());
    demand(
        is_exact_alone(inner)? && filled,
        inner,
        Rule::ReductionOfExpression,
    )
}

fn agree_replace(base: &Node, bit: &Node, context: Context) -> Result<usize, Rule> {
    demand(is_exact(bit, context)?, bit, Rule::CastOfExpression)?;
    Ok(agree(base, context)?.min(if is_exact(base, context)? {
        context.width
    } else {
        context.cap(base.rust_type().width)
    }))
}

fn agree_binary(
    left: &Node,
    operator: Operator,
    right: &Node,
    context: Context,
) -> Result<usize, Rule> {
    match operator {
        Operator::Mul => agree_product(left, right, context),
        Operator::Shl | Operator::Shr => agree_shift(left, operator, right, context),
        Operator::Equal | Operator::Order => {
            agree_compare(left, operator, right).map(|()| context.width)
        }
        Operator::Logic => {
            for side in [left, right] {
                demand(is_exact_alone(side)?, side, Rule::CompareOfExpression)?;
            }
            Ok(context.width)
        }
        _ => agree_ring(left, operator, right, context),
    }
}

/// Agreement of the operators `+ - & | ^`.
fn agree_ring(
    left: &Node,
    operator: Operator,
    right: &Node,
    context: Context,
) -> Result<usize, Rule> {
    let widths = (left.rust_type().width, right.rust_type().width);
    check_widths(
        left,
        right,
        operator == Operator::Add && widths.1 == Some(1),
    )?;
    let own = widths.0.or(widths.1).or(context.wanted);
    let inside = context.wanting(own);
    let (low_left, low_right) = (agree(left, inside)?, agree(right, inside)?);
    let low = low_left.min(low_right);
    if low < context.cap(own) && !context.signed && is_signed(left, right) {
        return Err(Rule::SignedAgainstUnsigned);
    }
    if !operator.is_bitwise() {
        return Ok(low.min(context.cap(own)));
    }
    // Where one side of `&` is exact, the zeros above it mask the upper bits of the other side.
    let hidden = operator == Operator::And
        && !is_signed(left, right)
        && low_left.max(low_right) == context.width
        && own.is_some_and(|own| low >= own);
    Ok(if hidden { context.width } else { low })
}

pub(super) fn is_signed(left: &Node, right: &Node) -> bool {
    left.rust_type().signed || right.rust_type().signed
}

fn agree_product(left: &Node, right: &Node, context: Context) -> Result<usize, Rule> {
    let inside = context.wanting(Some(FACTOR_WIDTH));
    for factor in [left, right] {
        check_signed_cast(factor, Some(FACTOR_WIDTH))?;
        if is_exact(factor, inside)? {
            continue;
        }
        let plain = matches!(factor.bare(), Node::Leaf(_) | Node::Signed(_));
        return Err(match (plain, factor.has_product()) {
            (true, _) => Rule::SignedAgainstUnsigned,
            (false, true) => Rule::ProductInContext,
            (false, false) => Rule::FactorExpression,
        });
    }
    Ok(if context.width < PRODUCT_WIDTH {
        context.width
    } else if is_signed(left, right) && !context.signed {
        PRODUCT_WIDTH
    } else {
        context.width
    })
}

fn agree_shift(
    left: &Node,
    operator: Operator,
    right: &Node,
    context: Context,
) -> Result<usize, Rule> {
    demand(is_exact_alone(right)?, right, Rule::ShiftOfExpression)?;
    if operator == Operator::Shl {
        return Ok(agree(left, context)?.min(context.cap(left.rust_type().width)));
    }
    demand(is_exact(left, context)?, left, Rule::ShiftOfExpression)?;
    Ok(context.width)
}

/// Checks `target = value`, where the target has `width` bits.
pub(super) fn check_assignment(width: usize, value: &Node) -> Result<(), Rule> {
    match (value.bare(), value.rust_type().width) {
        (Node::Int(int), _) if int.literal && !int.fits(width) => return Err(Rule::LiteralTooWide),
        (_, Some(own)) if own != width => return Err(Rule::WidthMismatch),
        _ => {}
    }
    let context = Context {
        width: width.max(value.verilog_width()),
        signed: value.verilog_signed(),
        wanted: Some(width),
    };
    match agree(value, context)? >= width {
        true => Ok(()),
        false if value.rust_type().signed => Err(Rule::SignedAgainstUnsigned),
        false if matches!(value.bare(), Node::Unsigned(_)) => Err(Rule::SignedAgainstUnsigned),
        false => Err(Rule::CastOfExpression),
    }
}

/// Checks an expression that is not assigned: a condition, or the selector of a `case`.
pub(super) fn check_alone(node: &Node) -> Result<(), Rule> {
    demand(is_exact_alone(node)?, node, Rule::CompareOfExpression)
}
