//! Evaluates expressions symbolically, with Verilog's widths and signs (IEEE 1364-2005, 5.4 and 5.5). The
//! operands of most operators are extended to the width of their context *before* the operator is applied.
//! They are extended by their sign only where all operands of the context are signed.

use std::collections::HashMap;

use super::bits::Bits;
use super::environment::{Environment, Mode, Slot};
use super::flat::{Entity, Flat};
use super::graph::{self, Known, MemoryId, SignalId, Value, ValueId};
use super::shape::{Part, is_arithmetic, is_shift};
use super::syntax::{Binary, Expression, ExpressionKind, Function, Line, Number, Select, Unary};
use super::{Refusal, refuse};

/// Evaluates the code of one instance.
pub struct Evaluator<'e, 'a> {
    pub flat: &'e mut Flat<'a>,
    pub instance: usize,
    pub environment: Environment,
    /// The local names of the functions that are being called, the innermost last.
    pub calls: Vec<HashMap<&'a str, SignalId>>,
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
            // `always @(*)` does not wait for signals that only a function reads.
            return refuse(line, format!("a function reads `{name}`, no input of it"));
        }
        Ok(found.clone())
    }

    /// The value of an expression that is assigned to a target of `width` bits.
    pub fn assigned(&mut self, e: &'a Expression, width: u32) -> Result<ValueId, Refusal> {
        let shape = self.shape(e)?;
        let value = self.context(e, width.max(shape.width), shape.signed)?;
        Ok(self.flat.graph.resize(value, width, shape.signed))
    }

    /// The value of an expression without a context.
    pub fn alone(&mut self, e: &'a Expression) -> Result<ValueId, Refusal> {
        let shape = self.shape(e)?;
        self.context(e, shape.width, shape.signed)
    }

    /// A truth value of one bit: whether any bit of the expression is 1.
    pub fn truth(&mut self, e: &'a Expression) -> Result<ValueId, Refusal> {
        let value = self.alone(e)?;
        Ok(self.flat.graph.unary(graph::Unary::Any, value))
    }

    /// The value of an expression at the width and the sign of its context.
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

    /// The value of an operand that has its own width, whatever the context.
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

    /// The value of a signal at this statement.
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

    /// The value of a function: its body is executed with the arguments in its inputs.
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
        // The variables of an earlier call are discarded.
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

    /// A variable before any assignment.
    pub fn unassigned(&mut self, id: SignalId) -> Slot {
        let width = self.flat.signal(id).width;
        Slot {
            value: self.flat.graph.constant(Known::nothing(width)),
            missing: Some(Bits::ones(width)),
        }
    }
}
