//! The two-state function of a clock: nodes of exact width over inputs, registers and memories. Equal nodes
//! are shared, and constants are folded when a node is made.

use std::collections::HashMap;

use super::bits::Bits;

/// A node.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(u32);

impl NodeId {
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    Constant(Bits),
    /// An input of the clock's function: a pin or a register, by its number.
    Leaf(u32),
    /// A word of a memory, by the memory's number. The address must be inside the memory.
    Word(u32, NodeId),
    Unary(Unary, NodeId),
    Binary(Binary, NodeId, NodeId),
    /// The second node where the first, one bit, is 1; else the third.
    Select(NodeId, NodeId, NodeId),
    /// The concatenation with the first node above the second.
    Concat(NodeId, NodeId),
    /// The bits from this one on.
    Slice(NodeId, u32),
    ZeroExtend(NodeId),
    SignExtend(NodeId),
}

#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Unary {
    Not,
    Negate,
    /// This reduction and the two below have a result of one bit.
    All,
    Any,
    Parity,
}

#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Binary {
    And,
    Or,
    Xor,
    Add,
    Subtract,
    Multiply,
    /// This comparison and the two below have a result of one bit.
    Equal,
    Less,
    LessSigned,
    /// The amount of this shift and of the two below is unsigned and of any width.
    ShiftLeft,
    ShiftRight,
    ArithmeticShiftRight,
}

/// A node with its width.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Node {
    pub width: u32,
    pub operation: Operation,
}

/// All nodes, each after its operands.
#[derive(Default)]
pub struct Nodes {
    nodes: Vec<Node>,
    known: HashMap<Node, NodeId>,
}

impl Nodes {
    pub fn get(&self, id: NodeId) -> &Node {
        &self.nodes[id.index()]
    }

    /// The node of that number.
    pub fn at(&self, index: usize) -> &Node {
        &self.nodes[index]
    }

    pub fn id(&self, index: usize) -> NodeId {
        NodeId(u32::try_from(index).expect("fewer nodes than 2^32"))
    }

    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    pub fn width(&self, id: NodeId) -> u32 {
        self.get(id).width
    }

    /// The node's value, where it is constant.
    pub fn constant(&self, id: NodeId) -> Option<&Bits> {
        match &self.get(id).operation {
            Operation::Constant(bits) => Some(bits),
            _ => None,
        }
    }

    pub fn is_zero(&self, id: NodeId) -> bool {
        self.constant(id).is_some_and(Bits::is_zero)
    }

    fn is_ones(&self, id: NodeId) -> bool {
        self.constant(id).is_some_and(Bits::is_ones)
    }

    fn add(&mut self, width: u32, operation: Operation) -> NodeId {
        let node = Node { width, operation };
        if let Some(&known) = self.known.get(&node) {
            return known;
        }
        let id = NodeId(u32::try_from(self.nodes.len()).expect("fewer nodes than 2^32"));
        self.nodes.push(node.clone());
        self.known.insert(node, id);
        id
    }

    pub fn bits(&mut self, bits: Bits) -> NodeId {
        self.add(bits.width(), Operation::Constant(bits))
    }

    pub fn number(&mut self, width: u32, value: u64) -> NodeId {
        self.bits(Bits::of(width, value))
    }

    pub fn zero(&mut self, width: u32) -> NodeId {
        self.bits(Bits::zero(width))
    }

    pub fn leaf(&mut self, width: u32, number: u32) -> NodeId {
        self.add(width, Operation::Leaf(number))
    }

    pub fn word(&mut self, width: u32, memory: u32, address: NodeId) -> NodeId {
        self.add(width, Operation::Word(memory, address))
    }

    pub fn unary(&mut self, operation: Unary, a: NodeId) -> NodeId {
        let width = match operation {
            Unary::Not | Unary::Negate => self.width(a),
            Unary::All | Unary::Any | Unary::Parity => 1,
        };
        if let Some(a) = self.constant(a) {
            let folded = unary(operation, a);
            return self.bits(folded);
        }
        match (operation, &self.get(a).operation) {
            (Unary::Not, &Operation::Unary(Unary::Not, inner)) => inner,
            (Unary::All | Unary::Any | Unary::Parity, _) if self.width(a) == 1 => a,
            (Unary::Any, &Operation::ZeroExtend(inner)) => self.unary(Unary::Any, inner),
            (Unary::Any, &Operation::Concat(high, low)) if self.is_zero(high) => {
                self.unary(Unary::Any, low)
            }
            _ => self.add(width, Operation::Unary(operation, a)),
        }
    }

    pub fn not(&mut self, a: NodeId) -> NodeId {
        self.unary(Unary::Not, a)
    }

    pub fn binary(&mut self, operation: Binary, a: NodeId, b: NodeId) -> NodeId {
        let width = match operation {
            Binary::Equal | Binary::Less | Binary::LessSigned => 1,
            _ => self.width(a),
        };
        if let (Some(a), Some(b)) = (self.constant(a), self.constant(b)) {
            let folded = binary(operation, a, b);
            return self.bits(folded);
        }
        if let Some(simpler) = self.simpler(operation, a, b) {
            return simpler;
        }
        let commutes = matches!(
            operation,
            Binary::And | Binary::Or | Binary::Xor | Binary::Add | Binary::Multiply | Binary::Equal
        );
        let (a, b) = match commutes && b < a {
            true => (b, a),
            false => (a, b),
        };
        self.add(width, Operation::Binary(operation, a, b))
    }

    /// The simpler form of an operation where one operand is all zeros or ones, or both operands are equal.
    fn simpler(&mut self, operation: Binary, a: NodeId, b: NodeId) -> Option<NodeId> {
        let width = self.width(a);
        match operation {
            Binary::And if self.is_zero(a) || self.is_ones(b) => Some(a),
            Binary::And if self.is_zero(b) || self.is_ones(a) => Some(b),
            Binary::Or if self.is_zero(b) || self.is_ones(a) => Some(a),
            Binary::Or if self.is_zero(a) || self.is_ones(b) => Some(b),
            Binary::And | Binary::Or if a == b => Some(a),
            Binary::Xor | Binary::Subtract if a == b => Some(self.zero(width)),
            Binary::Xor if self.is_ones(a) => Some(self.not(b)),
            Binary::Xor if self.is_ones(b) => Some(self.not(a)),
            Binary::Xor | Binary::Add if self.is_zero(a) => Some(b),
            Binary::Xor | Binary::Add | Binary::Subtract if self.is_zero(b) => Some(a),
            Binary::Multiply if self.is_zero(a) => Some(a),
            Binary::Multiply if self.is_zero(b) => Some(b),
            Binary::Equal if a == b => Some(self.number(1, 1)),
            Binary::Equal if width == 1 && self.is_ones(b) => Some(a),
            Binary::Equal if width == 1 && self.is_ones(a) => Some(b),
            Binary::Equal if width == 1 && self.is_zero(b) => Some(self.not(a)),
            Binary::Equal if width == 1 && self.is_zero(a) => Some(self.not(b)),
            Binary::Less | Binary::LessSigned if a == b => Some(self.zero(1)),
            Binary::Less if self.is_zero(b) => Some(self.zero(1)),
            Binary::ShiftLeft | Binary::ShiftRight => self.constant_shift(operation, a, b),
            Binary::ArithmeticShiftRight if self.is_zero(b) => Some(a),
            _ => None,
        }
    }

    /// A shift by a constant becomes wiring.
    fn constant_shift(&mut self, operation: Binary, a: NodeId, by: NodeId) -> Option<NodeId> {
        let width = self.width(a);
        let by = self.constant(by)?.to_u64().unwrap_or(u64::MAX);
        if by == 0 {
            return Some(a);
        }
        if by >= u64::from(width) {
            return Some(self.zero(width));
        }
        let by = by as u32;
        Some(match operation {
            Binary::ShiftLeft => {
                let kept = self.slice(a, 0, width - by);
                let low = self.zero(by);
                self.concat(kept, low)
            }
            _ => {
                let kept = self.slice(a, by, width - by);
                self.zero_extend(kept, width)
            }
        })
    }

    pub fn and(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.binary(Binary::And, a, b)
    }

    pub fn or(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.binary(Binary::Or, a, b)
    }

    pub fn select(&mut self, condition: NodeId, then: NodeId, otherwise: NodeId) -> NodeId {
        let width = self.width(then);
        if then == otherwise || self.is_ones(condition) {
            return then;
        }
        if self.is_zero(condition) {
            return otherwise;
        }
        if let Operation::Unary(Unary::Not, inner) = self.get(condition).operation {
            return self.select(inner, otherwise, then);
        }
        if width == 1 {
            if self.is_ones(then) {
                return self.or(condition, otherwise);
            }
            if self.is_zero(otherwise) {
                return self.and(condition, then);
            }
            if self.is_zero(then) {
                let not = self.not(condition);
                return self.and(not, otherwise);
            }
            if self.is_ones(otherwise) {
                let not = self.not(condition);
                return self.or(not, then);
            }
        }
        self.add(width, Operation::Select(condition, then, otherwise))
    }

    pub fn concat(&mut self, high: NodeId, low: NodeId) -> NodeId {
        let width = self.width(high) + self.width(low);
        if let (Some(high), Some(low)) = (self.constant(high), self.constant(low)) {
            let folded = high.concat(low);
            return self.bits(folded);
        }
        if self.is_zero(high) {
            return self.zero_extend(low, width);
        }
        // Adjacent slices of one number become one slice.
        if let (&Operation::Slice(a, from_a), &Operation::Slice(b, from_b)) =
            (&self.get(high).operation, &self.get(low).operation)
            && a == b
            && from_a == from_b + self.width(low)
        {
            return self.slice(a, from_b, width);
        }
        self.add(width, Operation::Concat(high, low))
    }

    pub fn slice(&mut self, a: NodeId, low: u32, width: u32) -> NodeId {
        if low == 0 && width == self.width(a) {
            return a;
        }
        if let Some(a) = self.constant(a) {
            let folded = a.slice(low, width);
            return self.bits(folded);
        }
        match self.get(a).operation {
            Operation::Slice(inner, below) => self.slice(inner, low + below, width),
            Operation::Concat(high, lower) => {
                let border = self.width(lower);
                if low >= border {
                    self.slice(high, low - border, width)
                } else if low + width <= border {
                    self.slice(lower, low, width)
                } else {
                    let part = self.slice(lower, low, border - low);
                    let above = self.slice(high, 0, low + width - border);
                    self.concat(above, part)
                }
            }
            Operation::ZeroExtend(inner) => {
                let border = self.width(inner);
                if low >= border {
                    self.zero(width)
                } else if low + width <= border {
                    self.slice(inner, low, width)
                } else {
                    let part = self.slice(inner, low, border - low);
                    self.zero_extend(part, width)
                }
            }
            Operation::SignExtend(inner) if low + width <= self.width(inner) => {
                self.slice(inner, low, width)
            }
            _ => self.add(width, Operation::Slice(a, low)),
        }
    }

    pub fn zero_extend(&mut self, a: NodeId, width: u32) -> NodeId {
        if width == self.width(a) {
            return a;
        }
        if let Some(a) = self.constant(a) {
            let folded = a.zero_extend(width);
            return self.bits(folded);
        }
        match self.get(a).operation {
            Operation::ZeroExtend(inner) => self.zero_extend(inner, width),
            _ => self.add(width, Operation::ZeroExtend(a)),
        }
    }

    pub fn sign_extend(&mut self, a: NodeId, width: u32) -> NodeId {
        if width == self.width(a) {
            return a;
        }
        if let Some(a) = self.constant(a) {
            let folded = a.sign_extend(width);
            return self.bits(folded);
        }
        self.add(width, Operation::SignExtend(a))
    }

    /// A bit repeated at every place.
    pub fn spread(&mut self, bit: NodeId, width: u32) -> NodeId {
        self.sign_extend(bit, width)
    }
}

impl Operation {
    /// The nodes that the operation reads.
    pub fn operands(&self) -> impl Iterator<Item = NodeId> + use<> {
        let operands = match *self {
            Self::Constant(_) | Self::Leaf(_) => [None; 3],
            Self::Word(_, a)
            | Self::Unary(_, a)
            | Self::Slice(a, _)
            | Self::ZeroExtend(a)
            | Self::SignExtend(a) => [Some(a), None, None],
            Self::Binary(_, a, b) | Self::Concat(a, b) => [Some(a), Some(b), None],
            Self::Select(a, b, c) => [Some(a), Some(b), Some(c)],
        };
        operands.into_iter().flatten()
    }
}

pub fn unary(operation: Unary, a: &Bits) -> Bits {
    let bit = |value| Bits::of(1, u64::from(value));
    match operation {
        Unary::Not => a.not(),
        Unary::Negate => a.negate(),
        Unary::All => bit(a.is_ones()),
        Unary::Any => bit(!a.is_zero()),
        Unary::Parity => bit(a.parity()),
    }
}

pub fn binary(operation: Binary, a: &Bits, b: &Bits) -> Bits {
    let bit = |value| Bits::of(1, u64::from(value));
    match operation {
        Binary::And => a.and(b),
        Binary::Or => a.or(b),
        Binary::Xor => a.xor(b),
        Binary::Add => a.add(b),
        Binary::Subtract => a.subtract(b),
        Binary::Multiply => a.multiply(b),
        Binary::Equal => bit(a == b),
        Binary::Less => bit(a.less(b)),
        Binary::LessSigned => bit(a.less_signed(b)),
        Binary::ShiftLeft => a.shift_left(b),
        Binary::ShiftRight => a.shift_right(b),
        Binary::ArithmeticShiftRight => a.arithmetic_shift_right(b),
    }
}
