//! Expressions, with Verilog's widths and signs (IEEE 1364-2005, 5.4 and 5.5): the operands of most
//! operators are extended to the width of what stands around them *before* the operator works, by
//! their sign only where everything around is signed.

use std::collections::HashMap;

use super::bits::Bits;
use super::environment::{Environment, Mode, Slot};
use super::flat::{Entity, Flat};
use super::graph::{self, Known, MemoryId, SignalId, Value, ValueId};
use super::syntax::{
    Binary, Expression, ExpressionKind, Function, Line, Number, Range, Select, Unary,
};
use super::{Refusal, refuse};

/// An expression's own width, and whether it is signed.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Shape {
    pub width: u32,
    pub signed: bool,
}

const BIT: Shape = Shape {
    width: 1,
    signed: false,
};

/// No value is wider: a limit that keeps a hostile text from taking all memory.
pub const WIDEST: u32 = 1 << 16;

/// Follows the code of one instance.
pub struct Evaluator<'e, 'a> {
    pub flat: &'e mut Flat<'a>,
    pub instance: usize,
    pub environment: Environment,
    /// The names of the functions that are being called, innermost last.
    pub calls: Vec<HashMap<&'a str, SignalId>>,
}

/// A part of a signal or a memory word.
pub enum Part {
    Whole,
    /// Lowest bit, which may lie outside, and width.
    Fixed(u32, u32),
    /// Computed lowest bit, and width.
    At(ValueId, u32),
}

impl<'e, 'a> Evaluator<'e, 'a> {
    pub fn new(flat: &'e mut Flat<'a>, instance: usize, mode: Mode) -> Self {
        Self {
            flat,
            instance,
            environment: Environment::new(mode),
            calls: Vec::new(),
        }
    }

    pub fn entity(&self, name: &str, line: Line) -> Result<Entity<'a>, Refusal> {
        if let Some(locals) = self.calls.last()
            && let Some(&id) = locals.get(name)
        {
            return Ok(Entity::Signal(id));
        }
        let found = self.flat.instances[self.instance].names.get(name);
        let Some(found) = found else {
            return refuse(line, format!("`{name}` is not declared"));
        };
        let outside = matches!(found, Entity::Signal(_) | Entity::Memory(_));
        if outside && !self.calls.is_empty() {
            // `always @(*)` does not wait for what only a function reads.
            return refuse(line, format!("a function reads `{name}`, no input of it"));
        }
        Ok(found.clone())
    }

    /// The value of an expression that is assigned to something of that width.
    pub fn assigned(&mut self, e: &'a Expression, width: u32) -> Result<ValueId, Refusal> {
        let shape = self.shape(e)?;
        let value = self.context(e, width.max(shape.width), shape.signed)?;
        Ok(self.flat.graph.resize(value, width, shape.signed))
    }

    /// The value of an expression that stands alone.
    pub fn alone(&mut self, e: &'a Expression) -> Result<ValueId, Refusal> {
        let shape = self.shape(e)?;
        self.context(e, shape.width, shape.signed)
    }

    /// One bit: whether any bit is 1.
    pub fn truth(&mut self, e: &'a Expression) -> Result<ValueId, Refusal> {
        let value = self.alone(e)?;
        Ok(self.flat.graph.unary(graph::Unary::Any, value))
    }

    /// A number that no signal has a part in.
    pub fn constant(&mut self, e: &'a Expression) -> Result<Bits, Refusal> {
        let value = self.alone(e)?;
        match self.flat.fold_number(value) {
            Some(bits) => Ok(bits),
            None => refuse(e.line, "expected a constant".to_owned()),
        }
    }

    /// A small constant that is not negative.
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

    /// A vector's width; its lowest bit has to be bit 0.
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

    /// The wider of two, signed where both are.
    fn common(&mut self, a: &'a Expression, b: &'a Expression) -> Result<Shape, Refusal> {
        let (a, b) = (self.shape(a)?, self.shape(b)?);
        Ok(Shape {
            width: a.width.max(b.width),
            signed: a.signed && b.signed,
        })
    }

    fn joined(&mut self, parts: &'a [Expression]) -> Result<Shape, Refusal> {
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

    /// The bits that the selects name.
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

    /// The value of an expression at the width, and of the sign, of what stands around it.
    pub fn context(
        &mut self,
        e: &'a Expression,
        width: u32,
        signed: bool,
    ) -> Result<ValueId, Refusal> {
        match &e.kind {
            ExpressionKind::Unary(Unary::Plus, a) => self.context(a, width, signed),
            ExpressionKind::Unary(operator @ (Unary::Minus | Unary::Not), a) => {
                let a = self.context(a, width, signed)?;
                Ok(self.flat.graph.unary(
                    match operator {
                        Unary::Minus => graph::Unary::Negate,
                        _ => graph::Unary::Not,
                    },
                    a,
                ))
            }
            ExpressionKind::Binary(operator, a, b) if is_arithmetic(*operator) => {
                let a = self.context(a, width, signed)?;
                let b = self.context(b, width, signed)?;
                Ok(self.arithmetic(*operator, a, b))
            }
            ExpressionKind::Binary(operator, a, b) if is_shift(*operator) => {
                let a = self.context(a, width, signed)?;
                let by = self.alone(b)?;
                let operator = match operator {
                    Binary::ShiftLeft => graph::Binary::ShiftLeft,
                    Binary::ArithmeticShiftRight if signed => graph::Binary::ArithmeticShiftRight,
                    _ => graph::Binary::ShiftRight,
                };
                Ok(self.flat.graph.binary(operator, a, by))
            }
            ExpressionKind::Conditional(operands) => {
                let condition = self.truth(&operands[0])?;
                let then = self.context(&operands[1], width, signed)?;
                let otherwise = self.context(&operands[2], width, signed)?;
                let value = Value::Conditional(condition, then, otherwise);
                Ok(self.flat.graph.add(width, value))
            }
            _ => {
                let value = self.operand(e)?;
                Ok(self.flat.graph.resize(value, width, signed))
            }
        }
    }

    fn arithmetic(&mut self, operator: Binary, a: ValueId, b: ValueId) -> ValueId {
        let graph = &mut self.flat.graph;
        let operation = match operator {
            Binary::Add => graph::Binary::Add,
            Binary::Subtract => graph::Binary::Subtract,
            Binary::Multiply => graph::Binary::Multiply,
            Binary::And => graph::Binary::And,
            Binary::Or => graph::Binary::Or,
            _ => graph::Binary::Xor,
        };
        let value = graph.binary(operation, a, b);
        match operator {
            Binary::Xnor => graph.unary(graph::Unary::Not, value),
            _ => value,
        }
    }

    /// What has its own width, whatever stands around it.
    fn operand(&mut self, e: &'a Expression) -> Result<ValueId, Refusal> {
        match &e.kind {
            ExpressionKind::Number(number) => Ok(self.number(number)),
            ExpressionKind::Name(name, selects) => self.name(name, selects, e.line),
            ExpressionKind::Unary(operator, a) => self.reduction(*operator, a),
            ExpressionKind::Binary(operator, a, b) => match operator {
                Binary::LogicalAnd | Binary::LogicalOr => {
                    let (a, b) = (self.truth(a)?, self.truth(b)?);
                    let operation = match operator {
                        Binary::LogicalAnd => graph::Binary::And,
                        _ => graph::Binary::Or,
                    };
                    Ok(self.flat.graph.binary(operation, a, b))
                }
                _ => self.comparison(*operator, a, b),
            },
            ExpressionKind::Concatenation(parts) => self.join(parts, e.line),
            ExpressionKind::Replication(count, parts) => {
                let count = self.small(count)?;
                let one = self.join(parts, e.line)?;
                let mut all = one;
                for _ in 1..count {
                    all = self.flat.graph.concat(all, one);
                }
                Ok(all)
            }
            ExpressionKind::Call(name, arguments) => self.call(name, arguments, e.line),
            ExpressionKind::Cast { value, .. } => self.alone(value),
            ExpressionKind::Conditional(_) => self.alone(e),
        }
    }

    fn number(&mut self, number: &Number) -> ValueId {
        let bits = Bits::cut(number.width.unwrap_or(32), number.words.clone());
        self.flat.graph.constant(Known::new(bits))
    }

    fn reduction(&mut self, operator: Unary, a: &'a Expression) -> Result<ValueId, Refusal> {
        let a = self.alone(a)?;
        let graph = &mut self.flat.graph;
        let (operation, inverted) = match operator {
            Unary::All => (graph::Unary::All, false),
            Unary::NotAll => (graph::Unary::All, true),
            Unary::Any => (graph::Unary::Any, false),
            Unary::Parity => (graph::Unary::Parity, false),
            Unary::NotParity => (graph::Unary::Parity, true),
            _ => (graph::Unary::Any, true),
        };
        let value = graph.unary(operation, a);
        Ok(match inverted {
            true => graph.unary(graph::Unary::Not, value),
            false => value,
        })
    }

    fn comparison(
        &mut self,
        operator: Binary,
        a: &'a Expression,
        b: &'a Expression,
    ) -> Result<ValueId, Refusal> {
        let shape = self.common(a, b)?;
        let a = self.context(a, shape.width, shape.signed)?;
        let b = self.context(b, shape.width, shape.signed)?;
        let less = match shape.signed {
            true => graph::Binary::LessSigned,
            false => graph::Binary::Less,
        };
        let (operation, a, b, inverted) = match operator {
            Binary::Equal => (graph::Binary::Equal, a, b, false),
            Binary::NotEqual => (graph::Binary::Equal, a, b, true),
            Binary::Less => (less, a, b, false),
            Binary::GreaterOrEqual => (less, a, b, true),
            Binary::Greater => (less, b, a, false),
            _ => (less, b, a, true),
        };
        let graph = &mut self.flat.graph;
        let value = graph.binary(operation, a, b);
        Ok(match inverted {
            true => graph.unary(graph::Unary::Not, value),
            false => value,
        })
    }

    fn join(&mut self, parts: &'a [Expression], line: Line) -> Result<ValueId, Refusal> {
        let mut joined = None;
        for part in parts {
            let part = self.alone(part)?;
            joined = Some(match joined {
                None => part,
                Some(high) => self.flat.graph.concat(high, part),
            });
        }
        joined.ok_or_else(|| Refusal::new(line, "an empty concatenation".to_owned()))
    }

    fn name(&mut self, name: &str, selects: &'a [Select], line: Line) -> Result<ValueId, Refusal> {
        let (whole, selects) = match self.entity(name, line)? {
            Entity::Signal(id) => (self.read(id, line)?, selects),
            Entity::Constant { known, .. } => (self.flat.graph.constant(known), selects),
            Entity::Memory(id) => {
                let Some((Select::One(address), rest)) = selects.split_first() else {
                    return refuse(line, format!("the whole memory `{name}`; expected a word"));
                };
                (self.word(id, address)?, rest)
            }
            Entity::Function(..) => {
                return refuse(line, format!("the function `{name}` is read as a signal"));
            }
        };
        Ok(match self.part(selects, line)? {
            Part::Whole => whole,
            Part::Fixed(low, width) => self.flat.graph.slice(whole, low, width),
            Part::At(at, width) => self.flat.graph.add(width, Value::SliceAt(whole, at)),
        })
    }

    fn word(&mut self, id: MemoryId, address: &'a Expression) -> Result<ValueId, Refusal> {
        let at = self.alone(address)?;
        if self.shape(address)?.signed && self.flat.fold_number(at).is_none() {
            return refuse(address.line, "a signed address".to_owned());
        }
        self.environment.reads_memory = true;
        let width = self.flat.memory(id).width;
        Ok(self.flat.graph.add(width, Value::Word(id, at)))
    }

    /// A signal as it is at this statement.
    pub fn read(&mut self, id: SignalId, line: Line) -> Result<ValueId, Refusal> {
        let signal = self.flat.signal(id);
        let follows = signal.local || self.environment.mode != Mode::Clocked;
        if follows {
            match self.environment.get(id) {
                Some(Slot {
                    value,
                    missing: None,
                }) => return Ok(*value),
                None if !signal.local && !self.environment.targets.contains(&id) => {}
                _ => {
                    let found = format!("`{}` is read before it is assigned", signal.name);
                    return refuse(line, found);
                }
            }
        }
        if self.environment.mode == Mode::Initial {
            let found = format!("an initial block reads `{}`", signal.name);
            return refuse(line, found);
        }
        self.environment.reads.push(id);
        Ok(self.flat.read(id))
    }

    /// A function's value: its body is followed with the arguments in its inputs.
    fn call(
        &mut self,
        name: &str,
        arguments: &'a [Expression],
        line: Line,
    ) -> Result<ValueId, Refusal> {
        let Entity::Function(function, variables) = self.entity(name, line)? else {
            return refuse(line, format!("`{name}` is called and is no function"));
        };
        if self.calls.len() > 16 {
            return refuse(line, format!("calls 16 deep at `{name}`"));
        }
        self.arguments(function, &variables, arguments, line)?;
        let result = variables[name];
        self.calls.push(variables);
        let followed = self.statement(&function.body);
        self.calls.pop();
        followed?;
        self.read(result, line)
    }

    fn arguments(
        &mut self,
        function: &'a Function,
        variables: &HashMap<&'a str, SignalId>,
        arguments: &'a [Expression],
        line: Line,
    ) -> Result<(), Refusal> {
        if arguments.len() != function.inputs {
            let (name, inputs, given) = (&function.name, function.inputs, arguments.len());
            let found = format!("`{name}` has {inputs} inputs and is given {given}");
            return refuse(line, found);
        }
        let mut values = Vec::new();
        for (variable, argument) in function.variables.iter().zip(arguments) {
            let width = self.flat.signal(variables[variable.name.as_str()]).width;
            values.push(self.assigned(argument, width)?);
        }
        // What an earlier call left is gone.
        for &id in variables.values() {
            let slot = self.unassigned(id);
            self.environment.set(id, slot);
        }
        for (variable, value) in function.variables.iter().zip(values) {
            let missing = None;
            let id = variables[variable.name.as_str()];
            self.environment.set(id, Slot { value, missing });
        }
        Ok(())
    }

    /// A variable before any statement.
    pub fn unassigned(&mut self, id: SignalId) -> Slot {
        let width = self.flat.signal(id).width;
        Slot {
            value: self.flat.graph.constant(Known::nothing(width)),
            missing: Some(Bits::ones(width)),
        }
    }
}

fn is_arithmetic(operator: Binary) -> bool {
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

fn is_shift(operator: Binary) -> bool {
    matches!(
        operator,
        Binary::ShiftLeft | Binary::ShiftRight | Binary::ArithmeticShiftRight
    )
}
