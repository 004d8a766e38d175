//! Executes blocks symbolically. Each block is executed once, from its first statement to its last, and
//! yields one expression for each signal that it assigns.

use super::bits::Bits;
use super::environment::{Layer, Mode, Slot};
use super::expression::Evaluator;
use super::flat::{Entity, Write};
use super::graph::{self, Known, MemoryId, SignalId, Value, ValueId};
use super::shape::Part;
use super::syntax::{Assignment, Expression, ExpressionKind, For, Kind, Line, Select, Statement};
use super::{Refusal, refuse};

/// The most turns of a `for` in an initial block.
const TURNS: u32 = 1 << 20;

/// The target of an assignment.
enum Target {
    Signal(SignalId, Part),
    Word(MemoryId, ValueId),
}

impl<'a> Evaluator<'_, 'a> {
    pub fn statement(&mut self, statement: &'a Statement) -> Result<(), Refusal> {
        match statement {
            Statement::Nothing => Ok(()),
            Statement::Block(statements) => statements
                .iter()
                .try_for_each(|inner| self.statement(inner)),
            Statement::Blocking(assignment) => {
                if self.environment.mode == Mode::Clocked && self.calls.is_empty() {
                    return refuse(assignment.line, "`=` in a block with a clock".to_owned());
                }
                self.assign(assignment)
            }
            Statement::Nonblocking(assignment) => {
                if self.environment.mode != Mode::Clocked || !self.calls.is_empty() {
                    return refuse(assignment.line, "`<=` without a clock".to_owned());
                }
                self.assign(assignment)
            }
            Statement::If {
                condition,
                then,
                otherwise,
            } => {
                let condition = self.truth(condition)?;
                let then = self.branch(condition, then)?;
                let opposite = self.opposite(condition);
                let otherwise = match otherwise {
                    Some(otherwise) => self.branch(opposite, otherwise)?,
                    None => Layer::new(),
                };
                self.merge(condition, then, otherwise);
                Ok(())
            }
            Statement::Case {
                selector,
                items,
                default,
            } => self.case(selector, items, default.as_deref()),
            Statement::For(repeated) => self.repeat(repeated),
        }
    }

    /// Executes a loop of an initial block, turn by turn.
    fn repeat(&mut self, repeated: &'a For) -> Result<(), Refusal> {
        if self.environment.mode != Mode::Initial {
            return refuse(repeated.line, "`for` outside an initial block".to_owned());
        }
        self.assign(&repeated.first)?;
        for _ in 0..TURNS {
            if self.constant(&repeated.condition)?.is_zero() {
                return Ok(());
            }
            self.statement(&repeated.body)?;
            self.assign(&repeated.next)?;
        }
        let found = format!("`for` of more than {TURNS} turns");
        refuse(repeated.line, found)
    }

    /// The assignments of a statement under a condition.
    fn branch(&mut self, condition: ValueId, statement: &'a Statement) -> Result<Layer, Refusal> {
        self.environment.enter(condition);
        let followed = self.statement(statement);
        let layer = self.environment.leave();
        followed.map(|()| layer)
    }

    /// The condition of the `else` branch, which is also taken where the `if` condition is unknown.
    fn opposite(&mut self, condition: ValueId) -> ValueId {
        let graph = &mut self.flat.graph;
        let [no, yes] = [0, 1].map(|bit| graph.constant(Known::new(Bits::of(1, bit))));
        graph.add(1, Value::If(condition, no, yes))
    }

    /// Merges the assignments of both branches.
    fn merge(&mut self, condition: ValueId, then: Layer, otherwise: Layer) {
        let mut signals: Vec<_> = then.keys().chain(otherwise.keys()).copied().collect();
        signals.sort_unstable();
        signals.dedup();
        for id in signals {
            let (then, otherwise) = match (then.get(&id), otherwise.get(&id)) {
                (Some(then), Some(otherwise)) => (then.clone(), otherwise.clone()),
                (Some(then), None) => (then.clone(), self.current(id)),
                (None, Some(otherwise)) => (self.current(id), otherwise.clone()),
                (None, None) => continue,
            };
            let width = self.flat.signal(id).width;
            let value = Value::If(condition, then.value, otherwise.value);
            let value = self.flat.graph.add(width, value);
            let missing = match (then.missing, otherwise.missing) {
                (Some(a), Some(b)) => Some(a.or(&b)),
                (a, b) => a.or(b),
            };
            self.environment.set(id, Slot { value, missing });
        }
    }

    /// The value of a target before the statement.
    fn current(&mut self, id: SignalId) -> Slot {
        if let Some(slot) = self.environment.get(id) {
            return slot.clone();
        }
        if self.environment.mode == Mode::Clocked && !self.flat.signal(id).local {
            let (value, missing) = (self.flat.read(id), None);
            return Slot { value, missing };
        }
        self.unassigned(id)
    }

    /// Executes a `case`: the first item whose value equals the selector, bit for bit, is taken.
    fn case(
        &mut self,
        selector: &'a Expression,
        items: &'a [(Vec<Expression>, Statement)],
        default: Option<&'a Statement>,
    ) -> Result<(), Refusal> {
        let mut shape = self.shape(selector)?;
        for label in items.iter().flat_map(|(labels, _)| labels) {
            let other = self.shape(label)?;
            shape.width = shape.width.max(other.width);
            shape.signed &= other.signed;
        }
        let chosen = self.context(selector, shape.width, shape.signed)?;
        let mut branches = Vec::new();
        for (labels, statement) in items {
            let mut condition = None;
            for label in labels {
                let label = self.context(label, shape.width, shape.signed)?;
                let graph = &mut self.flat.graph;
                let same = graph.binary(graph::Binary::Same, chosen, label);
                condition = Some(match condition {
                    None => same,
                    Some(other) => graph.binary(graph::Binary::Or, other, same),
                });
            }
            let Some(condition) = condition else {
                return refuse(selector.line, "a case item without a value".to_owned());
            };
            let layer = self.branch(condition, statement)?;
            branches.push((condition, layer));
            // The later items are reached only where this one is not taken.
            let opposite = self.opposite(condition);
            self.environment.conditions.push(opposite);
        }
        let mut below = match default {
            Some(statement) => {
                let holds = self.holds();
                self.branch(holds, statement)?
            }
            None => Layer::new(),
        };
        let conditions = &mut self.environment.conditions;
        conditions.truncate(conditions.len() - branches.len());
        for (condition, layer) in branches.into_iter().rev() {
            below = self.merged(condition, layer, below);
        }
        for (id, slot) in below {
            self.environment.set(id, slot);
        }
        Ok(())
    }

    /// The constant 1.
    fn holds(&mut self) -> ValueId {
        self.flat.graph.constant(Known::new(Bits::of(1, 1)))
    }

    /// Merges the assignments of both branches, as [`Self::merge`] does, into a new layer.
    fn merged(&mut self, condition: ValueId, then: Layer, otherwise: Layer) -> Layer {
        let holds = self.holds();
        self.environment.enter(holds);
        self.merge(condition, then, otherwise);
        self.environment.leave()
    }

    fn assign(&mut self, assignment: &'a Assignment) -> Result<(), Refusal> {
        let mut targets = Vec::new();
        let width = self.targets(&assignment.target, &mut targets)?;
        let mut value = self.assigned(&assignment.value, width)?;
        if self.environment.mode == Mode::Initial {
            // Folds the value, so that expressions do not grow with a loop's turns.
            if let Some(known) = self.flat.fold(value) {
                value = self.flat.graph.constant(known);
            }
        }
        let mut left = width;
        for (target, width) in targets {
            left -= width;
            let part = self.flat.graph.slice(value, left, width);
            self.store(target, part, assignment.line)?;
        }
        Ok(())
    }

    /// The targets of an assignment, the highest first, with their widths; and the total width.
    fn targets(
        &mut self,
        e: &'a Expression,
        targets: &mut Vec<(Target, u32)>,
    ) -> Result<u32, Refusal> {
        match &e.kind {
            ExpressionKind::Name(name, selects) => {
                let (target, width) = self.target(name, selects, e.line)?;
                targets.push((target, width));
                Ok(width)
            }
            ExpressionKind::Concatenation(parts) => {
                let mut width = 0;
                for part in parts {
                    width += self.targets(part, targets)?;
                }
                Ok(width)
            }
            _ => refuse(e.line, "an assignment to no signal".to_owned()),
        }
    }

    /// The nets of a continuous assignment, the highest first, with the lowest bit and the width of each.
    pub fn net_targets(&mut self, e: &'a Expression) -> Result<Vec<(SignalId, u32, u32)>, Refusal> {
        let mut targets = Vec::new();
        self.targets(e, &mut targets)?;
        let mut nets = Vec::new();
        for (target, width) in targets {
            let (id, low) = match target {
                Target::Signal(id, Part::Whole) => (id, 0),
                Target::Signal(id, Part::Fixed(low, _)) => (id, low),
                _ => return refuse(e.line, "a net that depends on a signal".to_owned()),
            };
            let signal = self.flat.signal(id);
            if signal.variable {
                let found = format!("`{}` is a `reg` and is driven as a net", signal.name);
                return refuse(e.line, found);
            }
            nets.push((id, low, width));
        }
        Ok(nets)
    }

    fn target(
        &mut self,
        name: &str,
        selects: &'a [Select],
        line: Line,
    ) -> Result<(Target, u32), Refusal> {
        match self.entity(name, line)? {
            Entity::Signal(id) => {
                let whole = self.flat.signal(id).width;
                let part = self.part(selects, line)?;
                let width = match part {
                    Part::Whole => whole,
                    Part::Fixed(_, width) | Part::At(_, width) => width,
                };
                if let Part::Fixed(low, width) = part
                    && low + width > whole
                {
                    return refuse(line, format!("a part outside `{name}` is assigned"));
                }
                Ok((Target::Signal(id, part), width))
            }
            Entity::Memory(id) => {
                let [Select::One(address)] = selects else {
                    let found = format!("`{name}` is assigned; expected a word of that memory");
                    return refuse(line, found);
                };
                let at = self.alone(address)?;
                if self.shape(address)?.signed && self.flat.fold_number(at).is_none() {
                    return refuse(line, "a signed address".to_owned());
                }
                Ok((Target::Word(id, at), self.flat.memory(id).width))
            }
            _ => refuse(line, format!("`{name}` is assigned and is no signal")),
        }
    }

    fn store(&mut self, target: Target, value: ValueId, line: Line) -> Result<(), Refusal> {
        let (id, part) = match target {
            Target::Word(memory, address) => return self.store_word(memory, address, value, line),
            Target::Signal(id, part) => (id, part),
        };
        let signal = self.flat.signal(id);
        if !signal.variable {
            let found = format!("a block assigns `{}`, which is no `reg`", signal.name);
            return refuse(line, found);
        }
        let width = signal.width;
        let slot = match part {
            Part::Whole => Slot {
                value,
                missing: None,
            },
            Part::Fixed(low, part) => {
                let old = self.current(id);
                let value = self.put(old.value, low, value);
                let missing = old.missing.and_then(|missing| {
                    let hole = Bits::ones(part).zero_extend(width);
                    let hole = hole.shift_left(&Bits::of(32, u64::from(low)));
                    let missing = missing.and(&hole.not());
                    (!missing.is_zero()).then_some(missing)
                });
                Slot { value, missing }
            }
            Part::At(at, _) => {
                let old = self.current(id);
                let value = Value::Insert(old.value, at, value);
                Slot {
                    value: self.flat.graph.add(width, value),
                    missing: old.missing,
                }
            }
        };
        self.environment.set(id, slot);
        Ok(())
    }

    /// A value with some of its bits replaced.
    fn put(&mut self, old: ValueId, low: u32, part: ValueId) -> ValueId {
        let graph = &mut self.flat.graph;
        let (width, high) = (graph.width(old), low + graph.width(part));
        let mut value = part;
        if high < width {
            let above = graph.slice(old, high, width - high);
            value = graph.concat(above, value);
        }
        if low > 0 {
            let below = graph.slice(old, 0, low);
            value = graph.concat(value, below);
        }
        value
    }

    fn store_word(
        &mut self,
        id: MemoryId,
        address: ValueId,
        data: ValueId,
        line: Line,
    ) -> Result<(), Refusal> {
        match self.environment.mode {
            Mode::Clocked => {
                let mut enable = self.holds();
                for &condition in &self.environment.conditions {
                    enable = self
                        .flat
                        .graph
                        .binary(graph::Binary::And, enable, condition);
                }
                self.flat.memory_mut(id).writes.push(Write {
                    enable,
                    address,
                    data,
                });
                Ok(())
            }
            Mode::Initial if self.environment.conditions.is_empty() => {
                let place = self
                    .flat
                    .fold_number(address)
                    .and_then(|bits| bits.to_u64());
                let word = self.flat.fold(data);
                let memory = self.flat.memory_mut(id);
                let place = place.and_then(|place| memory.words.get_mut(place as usize));
                let (Some(place), Some(word)) = (place, word) else {
                    let found = format!("a word of `{}` outside it, or unknown", memory.name);
                    return refuse(line, found);
                };
                *place = word;
                Ok(())
            }
            _ => {
                let name = self.flat.memory(id).name;
                refuse(
                    line,
                    format!("a word of `{name}` is assigned without a clock"),
                )
            }
        }
    }
}

/// Collects the names that a statement assigns, with their lines.
pub fn assigned_names<'a>(statement: &'a Statement, names: &mut Vec<(&'a str, Line)>) {
    match statement {
        Statement::Nothing => {}
        Statement::Block(inner) => inner.iter().for_each(|inner| assigned_names(inner, names)),
        Statement::Blocking(assignment) | Statement::Nonblocking(assignment) => {
            target_names(&assignment.target, names);
        }
        Statement::If {
            then, otherwise, ..
        } => {
            assigned_names(then, names);
            if let Some(otherwise) = otherwise {
                assigned_names(otherwise, names);
            }
        }
        Statement::Case { items, default, .. } => {
            items
                .iter()
                .for_each(|(_, inner)| assigned_names(inner, names));
            if let Some(default) = default {
                assigned_names(default, names);
            }
        }
        Statement::For(repeated) => {
            target_names(&repeated.first.target, names);
            target_names(&repeated.next.target, names);
            assigned_names(&repeated.body, names);
        }
    }
}

pub fn target_names<'a>(e: &'a Expression, names: &mut Vec<(&'a str, Line)>) {
    match &e.kind {
        ExpressionKind::Name(name, _) => names.push((name, e.line)),
        ExpressionKind::Concatenation(parts) => {
            parts.iter().for_each(|part| target_names(part, names));
        }
        _ => {}
    }
}

/// Whether a declaration is of a variable.
pub fn is_variable(kind: Kind) -> bool {
    kind != Kind::Wire
}
