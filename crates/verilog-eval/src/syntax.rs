//! The syntax tree of the Verilog subset, as [`super::read`] makes it. Each construct has its line.

/// A line of the text, from 1.
pub type Line = u32;

/// A module.
pub struct Module {
    pub name: String,
    /// The names between the parentheses, in order.
    pub ports: Vec<String>,
    pub items: Vec<Item>,
    pub line: Line,
}

/// A construct inside a module.
pub enum Item {
    Declaration(Declaration),
    Parameter(Parameter),
    Assign(Assignment),
    Always(Always),
    Initial(Statement),
    Function(Function),
    Instance(Instance),
}

/// A port, a net, a variable, or a memory.
pub struct Declaration {
    pub name: String,
    pub direction: Option<Direction>,
    pub kind: Kind,
    pub signed: bool,
    /// The range `[high:low]`; `None` for one bit.
    pub range: Option<Range>,
    /// The range `[first:last]` of a memory's addresses.
    pub words: Option<Range>,
    /// The continuous driver of a net, or the initial value of a variable.
    pub value: Option<Expression>,
    pub line: Line,
}

#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Direction {
    Input,
    Output,
}

#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    Wire,
    Reg,
    Integer,
}

/// The two bounds of a range, as written.
pub struct Range {
    pub left: Expression,
    pub right: Expression,
}

/// A parameter, which an instance may set, or a local parameter.
pub struct Parameter {
    pub name: String,
    pub local: bool,
    pub signed: bool,
    pub range: Option<Range>,
    pub value: Expression,
    pub line: Line,
}

/// `always @(*)` or `always @(posedge clock)`.
pub struct Always {
    /// The clock; `None` where the block is combinational.
    pub clock: Option<String>,
    pub body: Statement,
    pub line: Line,
}

/// A function. Its inputs come first in `variables`, in order.
pub struct Function {
    pub name: String,
    pub signed: bool,
    pub range: Option<Range>,
    pub inputs: usize,
    pub variables: Vec<Declaration>,
    pub body: Statement,
    pub line: Line,
}

/// An instance of a module.
pub struct Instance {
    pub module: String,
    pub name: String,
    pub parameters: Vec<(String, Expression)>,
    /// The connection of each port; `None` for a port that is left open.
    pub connections: Vec<(String, Option<Expression>)>,
    pub line: Line,
}

/// `target = value` or `target <= value`.
pub struct Assignment {
    pub target: Expression,
    pub value: Expression,
    pub line: Line,
}

pub enum Statement {
    Block(Vec<Statement>),
    Blocking(Assignment),
    Nonblocking(Assignment),
    If {
        condition: Expression,
        then: Box<Statement>,
        otherwise: Option<Box<Statement>>,
    },
    Case {
        selector: Expression,
        items: Vec<(Vec<Expression>, Statement)>,
        default: Option<Box<Statement>>,
    },
    For(Box<For>),
    Nothing,
}

/// `for (first; condition; next) body`.
pub struct For {
    pub first: Assignment,
    pub condition: Expression,
    pub next: Assignment,
    pub body: Statement,
    pub line: Line,
}

pub struct Expression {
    pub kind: ExpressionKind,
    pub line: Line,
}

pub enum ExpressionKind {
    Number(Number),
    /// A signal, a parameter, or a part of a signal or a memory.
    Name(String, Vec<Select>),
    Unary(Unary, Box<Expression>),
    Binary(Binary, Box<Expression>, Box<Expression>),
    Conditional(Box<[Expression; 3]>),
    Concatenation(Vec<Expression>),
    Replication(Box<Expression>, Vec<Expression>),
    Call(String, Vec<Expression>),
    /// `$signed` or `$unsigned`.
    Cast {
        signed: bool,
        value: Box<Expression>,
    },
}

/// A number as written.
pub struct Number {
    /// The width in bits; `None` for a number without a size, which has 32 bits.
    pub width: Option<u32>,
    pub signed: bool,
    /// The value, truncated to the width, with the lowest word first.
    pub words: Vec<u64>,
}

pub enum Select {
    /// `[i]`
    One(Expression),
    /// `[high:low]`
    Range(Range),
    /// `[base +: width]`
    Up(Expression, Expression),
}

#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Unary {
    Plus,
    Minus,
    Not,
    LogicalNot,
    All,
    Any,
    Parity,
    NotAll,
    NotAny,
    NotParity,
}

#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Binary {
    Add,
    Subtract,
    Multiply,
    And,
    Or,
    Xor,
    Xnor,
    LogicalAnd,
    LogicalOr,
    Equal,
    NotEqual,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    ShiftLeft,
    ShiftRight,
    ArithmeticShiftRight,
}

impl Binary {
    /// The operator of a symbol, with its precedence; the higher binds tighter (IEEE 1364-2005, table 5-4).
    pub fn of(symbol: &str) -> Option<(Self, u32)> {
        Some(match symbol {
            "*" => (Self::Multiply, 10),
            "+" => (Self::Add, 9),
            "-" => (Self::Subtract, 9),
            "<<" | "<<<" => (Self::ShiftLeft, 8),
            ">>" => (Self::ShiftRight, 8),
            ">>>" => (Self::ArithmeticShiftRight, 8),
            "<" => (Self::Less, 7),
            "<=" => (Self::LessOrEqual, 7),
            ">" => (Self::Greater, 7),
            ">=" => (Self::GreaterOrEqual, 7),
            "==" => (Self::Equal, 6),
            "!=" => (Self::NotEqual, 6),
            "&" => (Self::And, 5),
            "^" => (Self::Xor, 4),
            "^~" | "~^" => (Self::Xnor, 4),
            "|" => (Self::Or, 3),
            "&&" => (Self::LogicalAnd, 2),
            "||" => (Self::LogicalOr, 1),
            _ => return None,
        })
    }
}

impl Unary {
    /// The operator of a symbol.
    pub fn of(symbol: &str) -> Option<Self> {
        Some(match symbol {
            "+" => Self::Plus,
            "-" => Self::Minus,
            "~" => Self::Not,
            "!" => Self::LogicalNot,
            "&" => Self::All,
            "|" => Self::Any,
            "^" => Self::Parity,
            "~&" => Self::NotAll,
            "~|" => Self::NotAny,
            "~^" | "^~" => Self::NotParity,
            _ => return None,
        })
    }
}
