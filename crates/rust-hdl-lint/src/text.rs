//! Prints statements for a reader, in a form close to the emitted Verilog, with loop variables unresolved.

use rust_hdl::prelude::ast::{VerilogExpression as Expression, VerilogOp, VerilogOpUnary};

use super::name::readable;

/// Prints an expression.
pub(super) fn expression(node: &Expression) -> String {
    match node {
        Expression::Signal(path) => readable(path),
        Expression::Literal(literal) => literal.to_string(),
        Expression::Cast(inner, width) => format!("bit_cast<{width}>({})", expression(inner)),
        Expression::Signed(inner) => format!("$signed({})", expression(inner)),
        Expression::Unsigned(inner) => format!("$unsigned({})", expression(inner)),
        Expression::Paren(inner) => format!("({})", expression(inner)),
        Expression::Binary(left, operator, right) => {
            format!(
                "{} {} {}",
                expression(left),
                binary(operator),
                expression(right)
            )
        }
        Expression::Unary(operator, inner) => format!("{}{}", unary(operator), expression(inner)),
        Expression::Index(base, index) => format!("{}[{}]", expression(base), expression(index)),
        Expression::Slice(base, width, offset) => {
            format!("{}[{}+:{width}]", expression(base), expression(offset))
        }
        Expression::IndexReplace(base, index, bit) => format!(
            "replace_bit({}, {}, {})",
            expression(base),
            expression(index),
            expression(bit)
        ),
    }
}

fn binary(operator: &VerilogOp) -> &'static str {
    match operator {
        VerilogOp::Add => "+",
        VerilogOp::Sub => "-",
        VerilogOp::Mul => "*",
        VerilogOp::LogicalAnd => "&&",
        VerilogOp::LogicalOr => "||",
        VerilogOp::BitXor => "^",
        VerilogOp::BitAnd => "&",
        VerilogOp::BitOr => "|",
        VerilogOp::Shl => "<<",
        VerilogOp::Shr => ">>",
        VerilogOp::Eq => "==",
        VerilogOp::Lt => "<",
        VerilogOp::Le => "<=",
        VerilogOp::Ne => "!=",
        VerilogOp::Ge => ">=",
        VerilogOp::Gt => ">",
    }
}

fn unary(operator: &VerilogOpUnary) -> &'static str {
    match operator {
        VerilogOpUnary::Not => "~",
        VerilogOpUnary::Neg => "-",
        VerilogOpUnary::All => "&",
        VerilogOpUnary::Any => "|",
        VerilogOpUnary::Xor => "^",
    }
}
