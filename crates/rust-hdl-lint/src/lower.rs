//! Lowers rust-hdl's tree to [`Node`]: resolves names, folds constants, checks slices.

use rust_hdl::prelude::ast::{VerilogExpression, VerilogLiteral, VerilogOp, VerilogOpUnary};

use super::design::{Literal, Module, Role, Symbol};
use super::finding::Fault;
use super::name::{self, Loops};
use super::node::{Int, Leaf, Node, Operator};
use super::rule::Rule;

/// A module, with the loops around the current statement.
pub(super) struct Frame<'a> {
    pub(super) module: &'a Module,
    pub(super) loops: Loops,
    /// Whether the block has read a signal that can change without it.
    pub(super) reads_outside: bool,
}

impl Frame<'_> {
    /// The symbol of a path, or the error in the path.
    pub(super) fn symbol(&self, raw: &str) -> Result<&Symbol, Fault> {
        let name = name::printed(raw, &self.loops)?;
        self.module.symbols.get(&name).ok_or_else(|| {
            let constant = !name.contains('$') && !name.contains(|c: char| c.is_lowercase());
            let rule = if constant {
                Rule::UndeclaredConstant
            } else {
                Rule::StaleName
            };
            Fault::about(rule, name)
        })
    }

    pub(super) fn lower(&mut self, expression: &VerilogExpression) -> Result<Node, Fault> {
        Ok(match expression {
            VerilogExpression::Signal(path) => self.signal(path)?,
            VerilogExpression::Literal(literal) => number(literal),
            VerilogExpression::Cast(inner, to) => Node::Cast(self.boxed(inner)?, *to),
            VerilogExpression::Signed(inner) => Node::Signed(self.boxed(inner)?),
            VerilogExpression::Unsigned(inner) => Node::Unsigned(self.boxed(inner)?),
            VerilogExpression::Paren(inner) => Node::Paren(self.boxed(inner)?),
            VerilogExpression::Binary(left, operator, right) => {
                let (left, right) = (self.boxed(left)?, self.boxed(right)?);
                binary(left, operator_of(operator), right)
            }
            VerilogExpression::Unary(operator, inner) => unary(operator, self.boxed(inner)?),
            VerilogExpression::Index(base, index) => self.slice(base, 1, index, Past::Panics)?,
            VerilogExpression::Slice(base, width, offset) => {
                self.slice(base, *width, offset, Past::ReadsZero)?
            }
            VerilogExpression::IndexReplace(base, index, bit) => self.replace(base, index, bit)?,
        })
    }

    fn boxed(&mut self, expression: &VerilogExpression) -> Result<Box<Node>, Fault> {
        self.lower(expression).map(Box::new)
    }

    fn signal(&mut self, path: &str) -> Result<Node, Fault> {
        if let Some(value) = name::loop_value(&self.loops, path) {
            return Ok(Node::Int(Int::plain(value as u128)));
        }
        let found = self
            .symbol(path)
            .map(|symbol| (symbol.role, node_of(symbol)));
        // An unknown name may be a signal from outside, so it counts as one.
        self.reads_outside |= !matches!(found, Ok((role, _)) if role != Role::Outside);
        found.map(|(_, node)| node)
    }

    fn slice(
        &mut self,
        base: &VerilogExpression,
        width: usize,
        offset: &VerilogExpression,
        past: Past,
    ) -> Result<Node, Fault> {
        self.lower(base)?;
        let VerilogExpression::Signal(path) = base else {
            return Err(match base {
                VerilogExpression::Slice(..) | VerilogExpression::Index(..) => Rule::SliceOfSlice,
                _ => Rule::SliceOfExpression,
            }
            .into());
        };
        let first = self.index(offset)?;
        let symbol = self.symbol(path)?;
        if symbol.declared < 2 || first.past_end(width, past) > symbol.width {
            let found = format!("[{first}+:{width}] of {} bits", symbol.width);
            return Err(Fault::about(Rule::SliceOutOfRange, found));
        }
        // `get_bit` of a Signed is a bool, `get_bits` a Signed; a struct has no signed fields.
        let signed = symbol.is_signed() && past == Past::ReadsZero;
        Ok(Node::Leaf(Leaf {
            width,
            declared: width,
            signed,
            declared_signed: false,
        }))
    }

    fn replace(
        &mut self,
        base: &VerilogExpression,
        index: &VerilogExpression,
        bit: &VerilogExpression,
    ) -> Result<Node, Fault> {
        let (base, bit) = (self.boxed(base)?, self.boxed(bit)?);
        let index = self.index(index)?;
        match base.rust_type().width {
            Some(width) if index.past_end(1, Past::Panics) > width => {
                let found = format!("[{index}] of {width} bits");
                Err(Fault::about(Rule::SliceOutOfRange, found))
            }
            _ => Ok(Node::Replace(base, bit)),
        }
    }

    /// An index of bits: a known number or a signal.
    fn index(&mut self, expression: &VerilogExpression) -> Result<Index, Fault> {
        if let VerilogExpression::Signal(path) = expression {
            let known = self.symbol(path).ok().and_then(|symbol| symbol.value);
            if let Some(value) = known.and_then(|value| value.try_into().ok()) {
                return Ok(Index::At(value));
            }
        }
        match self.lower(expression)?.bare() {
            Node::Int(int) => match int.value.and_then(|value| value.try_into().ok()) {
                Some(value) => Ok(Index::At(value)),
                None => Err(Rule::SliceOutOfRange.into()),
            },
            Node::Leaf(leaf) if !leaf.signed => Ok(Index::Below(leaf.width)),
            _ => Err(Rule::IndexExpression.into()),
        }
    }
}

/// The behaviour of Rust for a variable index past the end.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Past {
    /// Rust panics, so that a simulation shows the error.
    Panics,
    /// Rust reads 0.
    ReadsZero,
}

/// The position of a slice.
enum Index {
    At(usize),
    /// A signal of that many bits.
    Below(usize),
}

impl Index {
    /// The first bit that is certainly not read, as far as the lint needs it.
    fn past_end(&self, width: usize, past: Past) -> usize {
        match (self, past) {
            (Index::At(first), _) => first.saturating_add(width),
            (Index::Below(bits), Past::ReadsZero) => {
                let largest = 1usize
                    .checked_shl(*bits as u32)
                    .map_or(usize::MAX, |end| end - 1);
                largest.saturating_add(width)
            }
            (Index::Below(_), Past::Panics) => 0,
        }
    }
}

impl std::fmt::Display for Index {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Index::At(first) => write!(f, "{first}"),
            Index::Below(bits) => write!(f, "({bits} bits)"),
        }
    }
}

fn node_of(symbol: &Symbol) -> Node {
    match (symbol.role, symbol.value) {
        (Role::Variant, Some(value)) => Node::Int(Int::plain(value)),
        _ => Node::Leaf(Leaf {
            width: symbol.width,
            declared: symbol.declared,
            signed: symbol.is_signed(),
            declared_signed: symbol.is_signed(),
        }),
    }
}

fn number(literal: &VerilogLiteral) -> Node {
    let Literal { bits, value } = Literal::of(literal);
    Node::Int(Int {
        value,
        bits,
        literal: true,
    })
}

fn unary(operator: &VerilogOpUnary, inner: Box<Node>) -> Node {
    match operator {
        VerilogOpUnary::Not => Node::Not(inner),
        VerilogOpUnary::Neg => Node::Neg(inner),
        VerilogOpUnary::All => Node::Reduce(true, inner),
        VerilogOpUnary::Any | VerilogOpUnary::Xor => Node::Reduce(false, inner),
    }
}

/// Folds arithmetic on loop variables, which is 32 bits wide in Verilog and does not wrap.
fn binary(left: Box<Node>, operator: Operator, right: Box<Node>) -> Node {
    let known = |node: &Node| match node.bare() {
        Node::Int(int) => int.value,
        _ => None,
    };
    let folded = known(&left)
        .zip(known(&right))
        .and_then(|(a, b)| match operator {
            Operator::Add => a.checked_add(b),
            Operator::Sub => a.checked_sub(b),
            Operator::Mul => a.checked_mul(b),
            _ => None,
        });
    match folded.filter(|value| *value <= u32::MAX.into()) {
        Some(value) => Node::Int(Int::plain(value)),
        None => Node::Binary(left, operator, right),
    }
}

fn operator_of(operator: &VerilogOp) -> Operator {
    match operator {
        VerilogOp::Add => Operator::Add,
        VerilogOp::Sub => Operator::Sub,
        VerilogOp::Mul => Operator::Mul,
        VerilogOp::BitAnd => Operator::And,
        VerilogOp::BitOr => Operator::Or,
        VerilogOp::BitXor => Operator::Xor,
        VerilogOp::Shl => Operator::Shl,
        VerilogOp::Shr => Operator::Shr,
        VerilogOp::Eq | VerilogOp::Ne => Operator::Equal,
        VerilogOp::Lt | VerilogOp::Le | VerilogOp::Ge | VerilogOp::Gt => Operator::Order,
        VerilogOp::LogicalAnd | VerilogOp::LogicalOr => Operator::Logic,
    }
}
