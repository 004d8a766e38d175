//! The four-state expressions of a text: Verilog's operators with settled widths, over numbered signals.
//! [`super::lower`] turns them into two-state nodes.

use super::bits::Bits;

#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub struct ValueId(u32);

#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SignalId(pub u32);

#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub struct MemoryId(pub u32);

impl ValueId {
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A constant whose bits may be unknown. Unknown bits are 0 in the value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Known {
    pub value: Bits,
    pub unknown: Bits,
}

impl Known {
    pub fn new(value: Bits) -> Self {
        let unknown = Bits::zero(value.width());
        Self { value, unknown }
    }

    pub fn nothing(width: u32) -> Self {
        Self {
            value: Bits::zero(width),
            unknown: Bits::ones(width),
        }
    }
}

/// An operation of Verilog. The operands of a binary operation have its width, except comparisons, whose two
/// operands share a width, and shifts, whose amount has any width.
#[derive(Clone, Debug)]
pub enum Value {
    Constant(Known),
    Signal(SignalId),
    Word(MemoryId, ValueId),
    Unary(Unary, ValueId),
    Binary(Binary, ValueId, ValueId),
    /// `?:`. Where the condition, one bit, is unknown, the bits in which the two values differ are unknown.
    Conditional(ValueId, ValueId, ValueId),
    /// `if`. An unknown condition counts as 0.
    If(ValueId, ValueId, ValueId),
    Concat(ValueId, ValueId),
    Slice(ValueId, u32),
    /// Bits from a computed place on; unknown outside the number.
    SliceAt(ValueId, ValueId),
    /// The first value with the third inserted at a computed place. A place outside the value inserts
    /// nothing.
    Insert(ValueId, ValueId, ValueId),
    ZeroExtend(ValueId),
    SignExtend(ValueId),
}

#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Unary {
    Not,
    Negate,
    All,
    Any,
    Parity,
}

#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Binary {
    And,
    Or,
    Xor,
    Add,
    Subtract,
    Multiply,
    Equal,
    /// `===`, the comparison of `case`.
    Same,
    Less,
    LessSigned,
    ShiftLeft,
    ShiftRight,
    ArithmeticShiftRight,
}

/// All values, each after its operands.
#[derive(Default)]
pub struct Graph {
    values: Vec<(u32, Value)>,
}

impl Graph {
    pub fn add(&mut self, width: u32, value: Value) -> ValueId {
        let id = ValueId(u32::try_from(self.values.len()).expect("fewer values than 2^32"));
        self.values.push((width, value));
        id
    }

    pub fn get(&self, id: ValueId) -> (u32, &Value) {
        let (width, value) = &self.values[id.index()];
        (*width, value)
    }

    pub fn width(&self, id: ValueId) -> u32 {
        self.values[id.index()].0
    }

    pub fn len(&self) -> usize {
        self.values.len()
    }

    pub fn constant(&mut self, known: Known) -> ValueId {
        self.add(known.value.width(), Value::Constant(known))
    }

    pub fn unary(&mut self, operation: Unary, a: ValueId) -> ValueId {
        let width = match operation {
            Unary::Not | Unary::Negate => self.width(a),
            Unary::All | Unary::Any | Unary::Parity => 1,
        };
        self.add(width, Value::Unary(operation, a))
    }

    pub fn binary(&mut self, operation: Binary, a: ValueId, b: ValueId) -> ValueId {
        let width = match operation {
            Binary::Equal | Binary::Same | Binary::Less | Binary::LessSigned => 1,
            _ => self.width(a),
        };
        self.add(width, Value::Binary(operation, a, b))
    }

    pub fn concat(&mut self, high: ValueId, low: ValueId) -> ValueId {
        let width = self.width(high) + self.width(low);
        self.add(width, Value::Concat(high, low))
    }

    pub fn slice(&mut self, a: ValueId, low: u32, width: u32) -> ValueId {
        match low == 0 && width == self.width(a) {
            true => a,
            false => self.add(width, Value::Slice(a, low)),
        }
    }

    /// A value at another width: truncated, or extended by 0 or by its sign.
    pub fn resize(&mut self, a: ValueId, width: u32, signed: bool) -> ValueId {
        match (width.cmp(&self.width(a)), signed) {
            (std::cmp::Ordering::Equal, _) => a,
            (std::cmp::Ordering::Less, _) => self.add(width, Value::Slice(a, 0)),
            (std::cmp::Ordering::Greater, true) => self.add(width, Value::SignExtend(a)),
            (std::cmp::Ordering::Greater, false) => self.add(width, Value::ZeroExtend(a)),
        }
    }
}

impl Value {
    /// The values that the operation reads, without signals and memories.
    pub fn operands(&self) -> impl Iterator<Item = ValueId> + use<> {
        let operands = match *self {
            Self::Constant(_) | Self::Signal(_) => [None; 3],
            Self::Word(_, a)
            | Self::Unary(_, a)
            | Self::Slice(a, _)
            | Self::ZeroExtend(a)
            | Self::SignExtend(a) => [Some(a), None, None],
            Self::Binary(_, a, b) | Self::Concat(a, b) | Self::SliceAt(a, b) => {
                [Some(a), Some(b), None]
            }
            Self::Conditional(a, b, c) | Self::If(a, b, c) | Self::Insert(a, b, c) => {
                [Some(a), Some(b), Some(c)]
            }
        };
        operands.into_iter().flatten()
    }
}
