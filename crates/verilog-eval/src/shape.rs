//! Computes the self-determined widths of expressions, the bits of selections, and constants.

use super::bits::Bits;
use super::expression::Evaluator;
use super::flat::Entity;
use super::graph::ValueId;
use super::syntax::{Binary, Expression, ExpressionKind, Line, Range, Select, Unary};
use super::{Refusal, refuse};

/// The self-determined width of an expression, and whether it is signed.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Shape {
    pub width: u32,
    pub signed: bool,
}

const BIT: Shape = Shape {
    width: 1,
    signed: false,
};

/// The widest value in bits. The limit keeps a hostile text from using all memory.
pub const WIDEST: u32 = 1 << 16;

/// A part of a signal or a memory word.
pub enum Part {
    Whole,
    /// A constant lowest bit, which may be outside, and a width.
    Fixed(u32, u32),
    /// A computed lowest bit, and a width.
    At(ValueId, u32),
}

impl<'a> Evaluator<'_, 'a> {
    /// The value of an expression that depends on no signal.
    pub fn constant(&mut self, e: &'a Expression) -> Result<Bits, Refusal> {
        let value = self.alone(e)?;
        match self.flat.fold_number(value) {
            Some(bits) => Ok(bits),
            None => refuse(e.line, "expected a constant".to_owned()),
        }
    }

    /// The value of a constant expression that fits 32 bits and is not negative.
    pub fn small(&mut self, e: &'a Expression) -> Result<u32, Refusal> {
        let signed = self.shape(e)?.signed;
        let bits = self.constant(e)?;
        let negative = signed && bits.bit(bits.width() - 1);
        let number = bits.to_u64().and_then(|value| u32::try_from(value).ok());
        match number {
            Some(number) if !negative => Ok(number),
            _ => refuse(e.line, "expected a number from 0 to 2^32 - 1".to_owned()),
        }
    }

    /// The width of a vector, whose lowest bit must be bit 0.
    pub fn width(&mut self, range: Option<&'a Range>, line: Line) -> Result<u32, Refusal> {
        let Some(range) = range else {
            return Ok(1);
        };
        let (high, low) = (self.small(&range.left)?, self.small(&range.right)?);
        match high.checked_add(1) {
            Some(width) if low == 0 && width <= WIDEST => Ok(width),
            _ => {
                let found = format!("the range [{high}:{low}]; expected [N:0], N < {WIDEST}");
                refuse(line, found)
            }
        }
    }

    pub fn shape(&mut self, e: &'a Expression) -> Result<Shape, Refusal> {
        let shape = match &e.kind {
            ExpressionKind::Number(number) => Shape {
                width: number.width.unwrap_or(32),
                signed: number.signed,
            },
            ExpressionKind::Name(name, selects) => self.shape_of_name(name, selects, e.line)?,
            ExpressionKind::Unary(Unary::Plus | Unary::Minus | Unary::Not, a) => self.shape(a)?,
            ExpressionKind::Unary(..) => BIT,
            ExpressionKind::Binary(operator, a, b) => match operator {
                Binary::ShiftLeft | Binary::ShiftRight | Binary::ArithmeticShiftRight => {
                    self.shape(a)?
                }
                operator if is_arithmetic(*operator) => self.common(a, b)?,
                _ => BIT,
            },
            ExpressionKind::Conditional(operands) => self.common(&operands[1], &operands[2])?,
            ExpressionKind::Concatenation(parts) => self.joined(parts)?,
            ExpressionKind::Replication(count, parts) => {
                let one = self.joined(parts)?.width;
                let count = self.small(count)?;
                let width = one.checked_mul(count).filter(|&width| width > 0);
                let Some(width) = width else {
                    return refuse(e.line, format!("{count} times {one} bits"));
                };
                Shape { width, ..BIT }
            }
            ExpressionKind::Call(name, _) => match self.entity(name, e.line)? {
                Entity::Function(_, variables) => {
                    let result = self.flat.signal(variables[name.as_str()]);
                    Shape {
                        width: result.width,
                        signed: result.signed,
                    }
                }
                _ => return refuse(e.line, format!("`{name}` is called and is no function")),
            },
            ExpressionKind::Cast { signed, value } => Shape {
                signed: *signed,
                ..self.shape(value)?
            },
        };
        match shape.width <= WIDEST {
            true => Ok(shape),
            false => refuse(
                e.line,
                format!("{} bits; expected {WIDEST} at most", shape.width),
            ),
        }
    }

    /// The wider of two shapes, signed where both are.
    pub fn common(&mut self, a: &'a Expression, b: &'a Expression) -> Result<Shape, Refusal> {
        let (a, b) = (self.shape(a)?, self.shape(b)?);
        Ok(Shape {
            width: a.width.max(b.width),
            signed: a.signed && b.signed,
        })
    }

    pub fn joined(&mut self, parts: &'a [Expression]) -> Result<Shape, Refusal> {
        let mut width = 0u32;
        for part in parts {
            if matches!(&part.kind, ExpressionKind::Number(number) if number.width.is_none()) {
                let found = "a number without a width in a concatenation";
                return refuse(part.line, found.to_owned());
            }
            width = width.saturating_add(self.shape(part)?.width);
        }
        Ok(Shape { width, ..BIT })
    }

    fn shape_of_name(
        &mut self,
        name: &str,
        selects: &'a [Select],
        line: Line,
    ) -> Result<Shape, Refusal> {
        let (whole, selects) = match self.entity(name, line)? {
            Entity::Signal(id) => {
                let signal = self.flat.signal(id);
                let (width, signed) = (signal.width, signal.signed);
                (Shape { width, signed }, selects)
            }
            Entity::Constant { known, signed } => {
                let width = known.value.width();
                (Shape { width, signed }, selects)
            }
            Entity::Memory(id) => {
                let width = self.flat.memory(id).width;
                let Some((Select::One(_), rest)) = selects.split_first() else {
                    return refuse(line, format!("the whole memory `{name}`; expected a word"));
                };
                (Shape { width, ..BIT }, rest)
            }
            Entity::Function(..) => {
                return refuse(line, format!("the function `{name}` is read as a signal"));
            }
        };
        Ok(match self.part(selects, line)? {
            Part::Whole => whole,
            Part::Fixed(_, width) | Part::At(_, width) => Shape { width, ..BIT },
        })
    }

    /// The bits that a list of selects denotes.
    pub fn part(&mut self, selects: &'a [Select], line: Line) -> Result<Part, Refusal> {
        let select = match selects {
            [] => return Ok(Part::Whole),
            [select] => select,
            _ => return refuse(line, "a selection of a selection".to_owned()),
        };
        match select {
            Select::One(index) => self.part_at(index, 1),
            Select::Up(base, width) => {
                let width = self.small(width)?;
                match width {
                    1..=WIDEST => self.part_at(base, width),
                    _ => refuse(line, format!("a part of {width} bits")),
                }
            }
            Select::Range(range) => {
                let (high, low) = (self.small(&range.left)?, self.small(&range.right)?);
                if high < low || high - low >= WIDEST {
                    return refuse(line, format!("the range [{high}:{low}]"));
                }
                Ok(Part::Fixed(low, high - low + 1))
            }
        }
    }

    fn part_at(&mut self, index: &'a Expression, width: u32) -> Result<Part, Refusal> {
        let signed = self.shape(index)?.signed;
        let at = self.alone(index)?;
        if let Some(low) = self.flat.fold_number(at) {
            let negative = signed && low.bit(low.width() - 1);
            let low = low.to_u64().and_then(|low| u32::try_from(low).ok());
            return match low {
                Some(low) if !negative && low < u32::MAX - WIDEST => Ok(Part::Fixed(low, width)),
                _ => refuse(index.line, "an index far outside".to_owned()),
            };
        }
        match signed {
            true => refuse(index.line, "a signed index".to_owned()),
            false => Ok(Part::At(at, width)),
        }
    }
}

/// Whether both operands of the operator take the width of the context.
pub fn is_arithmetic(operator: Binary) -> bool {
    matches!(
        operator,
        Binary::Add
            | Binary::Subtract
            | Binary::Multiply
            | Binary::And
            | Binary::Or
            | Binary::Xor
            | Binary::Xnor
    )
}

/// Whether only the first operand of the operator takes the width of the context.
pub fn is_shift(operator: Binary) -> bool {
    matches!(
        operator,
        Binary::ShiftLeft | Binary::ShiftRight | Binary::ArithmeticShiftRight
    )
}
