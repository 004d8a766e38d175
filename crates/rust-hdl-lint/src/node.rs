//! Expressions with resolved names, and with the width and sign that each language gives them.

/// An expression as printed, with loop variables replaced and slices checked.
#[derive(Clone, Debug)]
pub(super) enum Node {
    Leaf(Leaf),
    Int(Int),
    /// `bit_cast`, printed as a mask: `((e) & 12'hfff)`.
    Cast(Box<Node>, usize),
    /// `signed_cast` and `signed_bit_cast`, both printed as `$signed(e)`.
    Signed(Box<Node>),
    /// `unsigned_cast`, printed as `$unsigned(e)`.
    Unsigned(Box<Node>),
    Paren(Box<Node>),
    Not(Box<Node>),
    Neg(Box<Node>),
    /// A reduction; the flag is `true` for `&`.
    Reduce(bool, Box<Node>),
    /// `replace_bit`: the word and the new bit.
    Replace(Box<Node>, Box<Node>),
    Binary(Box<Node>, Operator, Box<Node>),
}

/// A signal, a constant, or a slice of one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leaf {
    /// The width in Rust.
    pub(super) width: usize,
    /// The width in Verilog; wider than in Rust for the Constant of an enum.
    pub(super) declared: usize,
    /// Whether the Rust type is `Signed`.
    pub(super) signed: bool,
    /// Whether Verilog treats it as signed; a slice is never signed.
    pub(super) declared_signed: bool,
}

/// A number. In Rust it takes the width of the other operand.
#[derive(Clone, Copy, Debug)]
pub(super) struct Int {
    pub(super) value: Option<u128>,
    /// The width in Verilog, in bits.
    pub(super) bits: usize,
    /// Whether it was written as a literal, which Rust requires to fit.
    pub(super) literal: bool,
}

impl Int {
    /// A loop variable or an enum variant, which is printed as a plain decimal number.
    pub(super) fn plain(value: u128) -> Self {
        Int {
            value: Some(value),
            bits: 32,
            literal: false,
        }
    }

    pub(super) fn fits(&self, width: usize) -> bool {
        self.value
            .is_some_and(|value| (128 - value.leading_zeros()) as usize <= width)
    }
}

/// A binary operator, classed by its effect on widths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Operator {
    Add,
    Sub,
    Mul,
    And,
    Or,
    Xor,
    Shl,
    Shr,
    Equal,
    Order,
    Logic,
}

impl Operator {
    pub(super) fn is_bitwise(self) -> bool {
        matches!(self, Operator::And | Operator::Or | Operator::Xor)
    }

    pub(super) fn is_compare(self) -> bool {
        matches!(self, Operator::Equal | Operator::Order)
    }
}

/// A Rust type. The width is unknown for numbers and for `signed_bit_cast`, which take the width of the other
/// operand.
#[derive(Clone, Copy, Debug)]
pub(super) struct Type {
    pub(super) width: Option<usize>,
    pub(super) signed: bool,
}

impl Type {
    fn new(width: Option<usize>, signed: bool) -> Self {
        Type { width, signed }
    }

    fn or(self, other: Type) -> Type {
        Type::new(self.width.or(other.width), self.signed || other.signed)
    }
}

/// The width in bits of `Bits<16> * Bits<16>`, the only product that rust-hdl has.
pub(super) const PRODUCT_WIDTH: usize = 32;
/// The width in bits of the product's factors.
pub(super) const FACTOR_WIDTH: usize = 16;
/// The width in bits of `literal << Bits`.
const LITERAL_WIDTH: usize = 64;

impl Node {
    /// The expression without outer parentheses.
    pub(super) fn bare(&self) -> &Node {
        match self {
            Node::Paren(inner) => inner.bare(),
            other => other,
        }
    }

    /// The type that Rust gives the expression.
    pub(super) fn rust_type(&self) -> Type {
        match self {
            Node::Leaf(leaf) => Type::new(Some(leaf.width), leaf.signed),
            Node::Int(_) => Type::new(None, false),
            Node::Cast(_, width) => Type::new(Some(*width), false),
            Node::Signed(inner) => {
                let inner = inner.rust_type();
                Type::new(inner.width.filter(|_| !inner.signed), true)
            }
            Node::Unsigned(inner) => Type::new(inner.rust_type().width, false),
            Node::Paren(inner) | Node::Not(inner) | Node::Replace(inner, _) => inner.rust_type(),
            Node::Neg(inner) => Type::new(inner.rust_type().width, true),
            Node::Reduce(..) => Type::new(Some(1), false),
            Node::Binary(left, operator, right) => {
                binary_type(left.rust_type(), *operator, right.rust_type())
            }
        }
    }

    /// The self-determined width in Verilog (1364-2001, table 5-22).
    pub(super) fn verilog_width(&self) -> usize {
        match self {
            Node::Leaf(leaf) => leaf.declared,
            Node::Int(int) => int.bits,
            Node::Cast(inner, width) => inner.verilog_width().max(*width),
            Node::Signed(inner)
            | Node::Unsigned(inner)
            | Node::Paren(inner)
            | Node::Not(inner)
            | Node::Neg(inner) => inner.verilog_width(),
            Node::Reduce(..) => 1,
            // `(a & ~(1 << (i)) | ((b) << (i)))`: the 1 is a 32-bit number.
            Node::Replace(base, bit) => base.verilog_width().max(bit.verilog_width()).max(32),
            Node::Binary(left, operator, right) => match operator {
                Operator::Equal | Operator::Order | Operator::Logic => 1,
                Operator::Shl | Operator::Shr => left.verilog_width(),
                _ => left.verilog_width().max(right.verilog_width()),
            },
        }
    }

    /// Whether Verilog treats the expression, on its own, as signed (1364-2001, 5.5.1).
    pub(super) fn verilog_signed(&self) -> bool {
        match self {
            Node::Leaf(leaf) => leaf.declared_signed,
            Node::Int(int) => !int.literal,
            Node::Signed(_) => true,
            Node::Paren(inner) | Node::Not(inner) | Node::Neg(inner) => inner.verilog_signed(),
            Node::Cast(..) | Node::Unsigned(_) | Node::Reduce(..) | Node::Replace(..) => false,
            Node::Binary(left, operator, right) => match operator {
                Operator::Equal | Operator::Order | Operator::Logic => false,
                Operator::Shl | Operator::Shr => left.verilog_signed(),
                _ => left.verilog_signed() && right.verilog_signed(),
            },
        }
    }

    /// Whether the value depends on a product.
    pub(super) fn has_product(&self) -> bool {
        match self {
            Node::Leaf(_) | Node::Int(_) | Node::Reduce(..) => false,
            Node::Cast(inner, _)
            | Node::Signed(inner)
            | Node::Unsigned(inner)
            | Node::Paren(inner)
            | Node::Not(inner)
            | Node::Neg(inner)
            | Node::Replace(inner, _) => inner.has_product(),
            Node::Binary(_, Operator::Mul, _) => true,
            Node::Binary(left, _, right) => left.has_product() || right.has_product(),
        }
    }
}

fn binary_type(left: Type, operator: Operator, right: Type) -> Type {
    match operator {
        Operator::Mul => Type::new(Some(PRODUCT_WIDTH), left.signed || right.signed),
        Operator::Equal | Operator::Order | Operator::Logic => Type::new(Some(1), false),
        Operator::Shl | Operator::Shr => left.or(Type::new(Some(LITERAL_WIDTH), false)),
        _ => left.or(right),
    }
}
