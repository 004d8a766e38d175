//! Flattens the hierarchy. Every name of every instance gets a number, and every block and every port becomes
//! a driver of signals.

use std::collections::HashMap;

use super::environment::{Environment, Layer, Mode};
use super::expression::Evaluator;
use super::flat::{Driver, Entity, Flat, Instance, Memory, Signal, Unit};
use super::graph::{Known, SignalId, ValueId};
use super::statement::{assigned_names, is_variable};
use super::syntax::{
    Always, Declaration, Direction, Expression, Function, Item, Kind, Line, Module, Statement,
};
use super::{Refusal, refuse};

/// The largest depth of nested instances.
const DEEPEST: usize = 64;

/// Flattens the design below its top module.
pub fn elaborate<'a>(modules: &'a [Module], top: &str) -> Result<Flat<'a>, Refusal> {
    let mut named = HashMap::new();
    for module in modules {
        if named.insert(module.name.as_str(), module).is_some() {
            return refuse(module.line, format!("module `{}` twice", module.name));
        }
    }
    let Some(&module) = named.get(top) else {
        return refuse(1, format!("no module `{top}`"));
    };
    let mut elaboration = Elaboration {
        modules: named,
        flat: Flat::default(),
    };
    elaboration.instance(module, None, HashMap::new(), 0)?;
    for name in &module.ports {
        let port = elaboration.port(0, module, name)?;
        if port.1 == Direction::Input {
            elaboration.flat.signal_mut(port.0).driver = Driver::Input;
        }
    }
    Ok(elaboration.flat)
}

pub struct Elaboration<'a> {
    pub modules: HashMap<&'a str, &'a Module>,
    pub flat: Flat<'a>,
}

/// The parameters that an instance sets, with their values and signs.
pub type Parameters<'a> = HashMap<&'a str, (Known, bool)>;

impl<'a> Elaboration<'a> {
    pub fn instance(
        &mut self,
        module: &'a Module,
        place: Option<(usize, &'a str)>,
        parameters: Parameters<'a>,
        depth: usize,
    ) -> Result<usize, Refusal> {
        if depth > DEEPEST {
            let found = format!("`{}` is in itself, or {DEEPEST} deep", module.name);
            return refuse(module.line, found);
        }
        let id = self.flat.instances.len();
        self.flat.instances.push(Instance {
            parent: place.map(|(parent, _)| parent),
            name: place.map_or("", |(_, name)| name),
            names: HashMap::new(),
            children: HashMap::new(),
        });
        self.parameters(id, module, parameters)?;
        for item in &module.items {
            match item {
                Item::Declaration(declaration) => self.declaration(id, declaration)?,
                Item::Function(function) => self.function(id, function)?,
                _ => {}
            }
        }
        for item in &module.items {
            match item {
                Item::Declaration(declaration) => self.start(id, declaration)?,
                Item::Assign(assignment) => {
                    self.assign(id, &assignment.target, &assignment.value, assignment.line)?;
                }
                Item::Always(always) => self.always(id, always)?,
                Item::Initial(body) => self.initial(id, body)?,
                Item::Instance(instance) => self.child(id, instance, depth)?,
                Item::Parameter(_) | Item::Function(_) => {}
            }
        }
        Ok(id)
    }

    pub fn evaluator(&mut self, instance: usize, mode: Mode) -> Evaluator<'_, 'a> {
        Evaluator::new(&mut self.flat, instance, mode)
    }

    fn declare(
        &mut self,
        instance: usize,
        name: &'a str,
        entity: Entity<'a>,
        line: Line,
    ) -> Result<(), Refusal> {
        let names = &mut self.flat.instances[instance].names;
        match names.insert(name, entity) {
            None => Ok(()),
            Some(_) => refuse(line, format!("`{name}` is declared twice")),
        }
    }

    fn parameters(
        &mut self,
        instance: usize,
        module: &'a Module,
        mut given: Parameters<'a>,
    ) -> Result<(), Refusal> {
        for item in &module.items {
            let Item::Parameter(parameter) = item else {
                continue;
            };
            let from_outside = match parameter.local {
                true => None,
                false => given.remove(parameter.name.as_str()),
            };
            let mut evaluator = self.evaluator(instance, Mode::Continuous);
            let (known, mut signed) = match from_outside {
                Some(given) => given,
                None => {
                    let signed = evaluator.shape(&parameter.value)?.signed;
                    (Known::new(evaluator.constant(&parameter.value)?), signed)
                }
            };
            let mut value = known.value;
            if parameter.range.is_some() {
                let width = evaluator.width(parameter.range.as_ref(), parameter.line)?;
                value = match signed {
                    true => value.sign_extend(width.max(value.width())).slice(0, width),
                    false => value.zero_extend(width),
                };
                signed = parameter.signed;
            }
            let known = Known::new(value);
            let entity = Entity::Constant { known, signed };
            self.declare(instance, &parameter.name, entity, parameter.line)?;
        }
        match given.keys().next() {
            None => Ok(()),
            Some(name) => refuse(module.line, format!("no parameter `{name}` to be set")),
        }
    }

    fn declaration(&mut self, instance: usize, d: &'a Declaration) -> Result<(), Refusal> {
        let width = self.declared_width(instance, d)?;
        if let Some(words) = &d.words {
            let mut evaluator = self.evaluator(instance, Mode::Continuous);
            let bounds = [
                evaluator.small(&words.left)?,
                evaluator.small(&words.right)?,
            ];
            let (first, last) = (bounds[0].min(bounds[1]), bounds[0].max(bounds[1]));
            if first != 0 || last >= 1 << 24 || d.kind != Kind::Reg || d.direction.is_some() {
                let found = format!(
                    "the memory `{}`; expected a `reg` of words from 0 on",
                    d.name
                );
                return refuse(d.line, found);
            }
            let memory = self.flat.add_memory(Memory {
                name: &d.name,
                width,
                words: vec![Known::nothing(width); last as usize + 1],
                clock: None,
                writes: Vec::new(),
            });
            return self.declare(instance, &d.name, Entity::Memory(memory), d.line);
        }
        let id = self.signal(instance, d, width, false);
        self.declare(instance, &d.name, Entity::Signal(id), d.line)
    }

    fn declared_width(&mut self, instance: usize, d: &'a Declaration) -> Result<u32, Refusal> {
        match d.kind {
            Kind::Integer => Ok(32),
            _ => self
                .evaluator(instance, Mode::Continuous)
                .width(d.range.as_ref(), d.line),
        }
    }

    fn signal(&mut self, instance: usize, d: &'a Declaration, width: u32, local: bool) -> SignalId {
        self.flat.add_signal(Signal {
            instance,
            name: &d.name,
            width,
            signed: d.signed || d.kind == Kind::Integer,
            variable: is_variable(d.kind) || local,
            local,
            line: d.line,
            driver: Driver::None,
            initial: None,
        })
    }

    fn function(&mut self, instance: usize, function: &'a Function) -> Result<(), Refusal> {
        let mut variables = HashMap::new();
        for variable in &function.variables {
            if variable.words.is_some() || variable.value.is_some() {
                return refuse(variable.line, format!("`{}` in a function", variable.name));
            }
            let width = self.declared_width(instance, variable)?;
            let id = self.signal(instance, variable, width, true);
            if variables.insert(variable.name.as_str(), id).is_some() {
                let found = format!("`{}` is declared twice", variable.name);
                return refuse(variable.line, found);
            }
        }
        let width = self
            .evaluator(instance, Mode::Continuous)
            .width(function.range.as_ref(), function.line)?;
        let result = self.flat.add_signal(Signal {
            instance,
            name: &function.name,
            width,
            signed: function.signed,
            variable: true,
            local: true,
            line: function.line,
            driver: Driver::None,
            initial: None,
        });
        if variables.insert(function.name.as_str(), result).is_some() {
            let found = format!("`{}` is declared twice", function.name);
            return refuse(function.line, found);
        }
        let entity = Entity::Function(function, variables);
        self.declare(instance, &function.name, entity, function.line)
    }

    /// Applies the value in a declaration: a continuous driver of a net, or the initial value of a variable.
    fn start(&mut self, instance: usize, d: &'a Declaration) -> Result<(), Refusal> {
        let Some(value) = &d.value else {
            return Ok(());
        };
        let id = self.own(instance, &d.name, d.line)?;
        let width = self.flat.signal(id).width;
        if !is_variable(d.kind) {
            return self.drive_whole(id, instance, value, d.line);
        }
        let mut evaluator = self.evaluator(instance, Mode::Continuous);
        let value = evaluator.assigned(value, width)?;
        match self.flat.fold(value) {
            Some(known) => {
                self.flat.signal_mut(id).initial = Some(known);
                Ok(())
            }
            None => refuse(d.line, format!("`{}` starts with no constant", d.name)),
        }
    }

    pub fn own(&self, instance: usize, name: &str, line: Line) -> Result<SignalId, Refusal> {
        match self.flat.instances[instance].names.get(name) {
            Some(Entity::Signal(id)) => Ok(*id),
            _ => refuse(line, format!("`{name}` is no signal")),
        }
    }

    /// Drives a signal with an expression of an instance.
    pub fn drive_whole(
        &mut self,
        id: SignalId,
        instance: usize,
        value: &'a Expression,
        line: Line,
    ) -> Result<(), Refusal> {
        let width = self.flat.signal(id).width;
        let mut evaluator = self.evaluator(instance, Mode::Continuous);
        let value = evaluator.assigned(value, width)?;
        let environment = evaluator.environment;
        self.flat.drive(id, 0, value, line)?;
        self.unit(environment, vec![id], false);
        Ok(())
    }

    pub fn unit(&mut self, environment: Environment, targets: Vec<SignalId>, waits: bool) {
        let mut reads = environment.reads;
        reads.sort_unstable();
        reads.dedup();
        self.flat.units.push(Unit {
            reads,
            reads_memory: environment.reads_memory,
            targets,
            waits,
        });
    }

    /// Applies an `assign`, or the driver of an output.
    fn assign(
        &mut self,
        instance: usize,
        target: &'a Expression,
        value: &'a Expression,
        line: Line,
    ) -> Result<(), Refusal> {
        let mut evaluator = self.evaluator(instance, Mode::Continuous);
        let parts = evaluator.net_targets(target)?;
        let width = parts.iter().map(|part| part.2).sum();
        let value = evaluator.assigned(value, width)?;
        let environment = evaluator.environment;
        self.drive_parts(&parts, value, line)?;
        self.unit(
            environment,
            parts.iter().map(|part| part.0).collect(),
            false,
        );
        Ok(())
    }

    pub fn drive_parts(
        &mut self,
        parts: &[(SignalId, u32, u32)],
        value: ValueId,
        line: Line,
    ) -> Result<(), Refusal> {
        let mut left = self.flat.graph.width(value);
        for &(id, low, width) in parts {
            left -= width;
            let part = self.flat.graph.slice(value, left, width);
            self.flat.drive(id, low, part, line)?;
        }
        Ok(())
    }

    fn always(&mut self, instance: usize, always: &'a Always) -> Result<(), Refusal> {
        let mode = match always.clock {
            Some(_) => Mode::Clocked,
            None => Mode::Combinational,
        };
        let mut names = Vec::new();
        assigned_names(&always.body, &mut names);
        let mut targets = Vec::new();
        let mut memories = Vec::new();
        for &(name, line) in &names {
            match self.flat.instances[instance].names.get(name) {
                Some(Entity::Signal(id)) => targets.push(*id),
                Some(Entity::Memory(id)) => memories.push(*id),
                _ => return refuse(line, format!("`{name}` is no signal")),
            }
        }
        let mut evaluator = self.evaluator(instance, mode);
        evaluator.environment.targets.extend(targets);
        evaluator.statement(&always.body)?;
        let mut environment = evaluator.environment;
        let layer = environment.take();
        let Some(clock) = &always.clock else {
            return self.settle(environment, layer, always.line);
        };
        let clock = self.own(instance, clock, always.line)?;
        memories.sort_unstable_by_key(|id| id.0);
        memories.dedup();
        for id in memories {
            let memory = self.flat.memory_mut(id);
            if memory.clock.is_some_and(|other| other != clock) {
                let found = format!("`{}` is written with two clocks", memory.name);
                return refuse(always.line, found);
            }
            memory.clock = Some(clock);
        }
        for (id, slot) in layer {
            let signal = self.flat.signal_mut(id);
            if signal.local {
                continue;
            }
            if !matches!(signal.driver, Driver::None) {
                let found = format!("`{}` is driven twice", signal.name);
                return refuse(always.line, found);
            }
            signal.driver = Driver::Register {
                clock,
                next: slot.value,
                line: always.line,
            };
        }
        Ok(())
    }

    /// Drives the signals that a block without a clock assigns.
    fn settle(
        &mut self,
        environment: Environment,
        layer: Layer,
        line: Line,
    ) -> Result<(), Refusal> {
        let mut targets = Vec::new();
        for (id, slot) in layer {
            let signal = self.flat.signal(id);
            if signal.local {
                continue;
            }
            if slot.missing.is_some() {
                let found = format!(
                    "`{}` is not assigned on every way through the block: a latch",
                    signal.name
                );
                return refuse(line, found);
            }
            self.flat.drive(id, 0, slot.value, line)?;
            targets.push(id);
        }
        self.unit(environment, targets, true);
        Ok(())
    }

    fn initial(&mut self, instance: usize, body: &'a Statement) -> Result<(), Refusal> {
        let mut evaluator = self.evaluator(instance, Mode::Initial);
        evaluator.statement(body)?;
        let layer = evaluator.environment.take();
        for (id, slot) in layer {
            let known = match slot.missing {
                None => self.flat.fold(slot.value),
                Some(_) => None,
            };
            let signal = self.flat.signal_mut(id);
            if signal.local {
                continue;
            }
            let Some(known) = known else {
                let found = format!("an initial block leaves `{}` no constant", signal.name);
                return refuse(signal.line, found);
            };
            signal.initial = Some(known);
        }
        Ok(())
    }
}
