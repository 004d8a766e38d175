//! The design without its hierarchy: signals, memories and what drives them, by numbers.

use std::collections::HashMap;

use super::bits::Bits;
use super::four_state::{self, Pair};
use super::graph::{Graph, Known, MemoryId, SignalId, Value, ValueId};
use super::node::Nodes;
use super::syntax::{Function, Line};
use super::{Refusal, refuse};

#[derive(Default)]
pub struct Flat<'a> {
    pub graph: Graph,
    pub instances: Vec<Instance<'a>>,
    pub signals: Vec<Signal<'a>>,
    pub memories: Vec<Memory<'a>>,
    pub units: Vec<Unit>,
    /// Where constants are folded.
    scratch: Nodes,
}

/// A module's instance; the first is the top.
pub struct Instance<'a> {
    pub parent: Option<usize>,
    pub name: &'a str,
    pub names: HashMap<&'a str, Entity<'a>>,
    pub children: HashMap<&'a str, usize>,
}

/// What a name stands for.
#[derive(Clone)]
pub enum Entity<'a> {
    Signal(SignalId),
    Memory(MemoryId),
    Constant { known: Known, signed: bool },
    Function(&'a Function, HashMap<&'a str, SignalId>),
}

pub struct Signal<'a> {
    pub instance: usize,
    pub name: &'a str,
    pub width: u32,
    pub signed: bool,
    /// `reg` or `integer`: what blocks may assign.
    pub variable: bool,
    /// A function's, which lives in a call.
    pub local: bool,
    pub line: Line,
    pub driver: Driver,
    /// What a variable starts with.
    pub initial: Option<Known>,
}

pub enum Driver {
    None,
    /// A pin of the top.
    Input,
    Value(ValueId),
    /// Parts that are driven apart: lowest bit, value.
    Parts(Vec<(u32, ValueId)>),
    Register {
        clock: SignalId,
        next: ValueId,
        line: Line,
    },
}

pub struct Memory<'a> {
    pub name: &'a str,
    pub width: u32,
    /// What each word starts with.
    pub words: Vec<Known>,
    pub clock: Option<SignalId>,
    /// In their order.
    pub writes: Vec<Write>,
}

pub struct Write {
    pub enable: ValueId,
    pub address: ValueId,
    pub data: ValueId,
}

/// A block or an assignment without a clock: what it reads and what it drives.
pub struct Unit {
    pub reads: Vec<SignalId>,
    pub reads_memory: bool,
    pub targets: Vec<SignalId>,
    /// `always @(*)`, which waits for something to change.
    pub waits: bool,
}

impl<'a> Flat<'a> {
    pub fn signal(&self, id: SignalId) -> &Signal<'a> {
        &self.signals[id.0 as usize]
    }

    pub fn signal_mut(&mut self, id: SignalId) -> &mut Signal<'a> {
        &mut self.signals[id.0 as usize]
    }

    pub fn memory(&self, id: MemoryId) -> &Memory<'a> {
        &self.memories[id.0 as usize]
    }

    pub fn memory_mut(&mut self, id: MemoryId) -> &mut Memory<'a> {
        &mut self.memories[id.0 as usize]
    }

    pub fn add_signal(&mut self, signal: Signal<'a>) -> SignalId {
        let id = u32::try_from(self.signals.len()).expect("fewer signals than 2^32");
        self.signals.push(signal);
        SignalId(id)
    }

    pub fn add_memory(&mut self, memory: Memory<'a>) -> MemoryId {
        let id = u32::try_from(self.memories.len()).expect("fewer memories than 2^32");
        self.memories.push(memory);
        MemoryId(id)
    }

    /// The value that a signal has.
    pub fn read(&mut self, id: SignalId) -> ValueId {
        let width = self.signal(id).width;
        self.graph.add(width, Value::Signal(id))
    }

    /// The hierarchical name, without the top.
    pub fn path(&self, instance: usize, name: &str) -> String {
        let mut path = name.to_owned();
        let mut at = &self.instances[instance];
        while let Some(parent) = at.parent {
            path = format!("{}.{path}", at.name);
            at = &self.instances[parent];
        }
        path
    }

    /// A signal's hierarchical name.
    pub fn signal_path(&self, id: SignalId) -> String {
        let signal = self.signal(id);
        self.path(signal.instance, signal.name)
    }

    /// The signal of a hierarchical name.
    pub fn find(&self, path: &str) -> Option<SignalId> {
        match self.entity(path)? {
            Entity::Signal(id) => Some(*id),
            _ => None,
        }
    }

    /// Lets every word of the memory of that hierarchical name start as zero.
    pub fn fill_with_zeros(&mut self, path: &str) -> Result<(), Refusal> {
        let Some(&Entity::Memory(id)) = self.entity(path) else {
            return refuse(1, format!("there is no memory `{path}`"));
        };
        let memory = self.memory_mut(id);
        let zero = Known::new(Bits::zero(memory.width));
        memory.words.fill(zero);
        Ok(())
    }

    fn entity(&self, path: &str) -> Option<&Entity<'a>> {
        let mut at = self.instances.first()?;
        let (instances, name) = path.rsplit_once('.').unwrap_or(("", path));
        for instance in instances.split('.').filter(|name| !name.is_empty()) {
            at = &self.instances[*at.children.get(instance)?];
        }
        at.names.get(name)
    }

    /// Drives a signal, or a part of it, without a clock.
    pub fn drive(
        &mut self,
        id: SignalId,
        low: u32,
        value: ValueId,
        line: Line,
    ) -> Result<(), Refusal> {
        let width = self.graph.width(value);
        let graph = &self.graph;
        let signal = &mut self.signals[id.0 as usize];
        let whole = low == 0 && width == signal.width;
        let overlaps = |&(other, part): &(u32, ValueId)| {
            low < other + graph.width(part) && other < low + width
        };
        match &mut signal.driver {
            driver @ Driver::None if whole => *driver = Driver::Value(value),
            driver @ Driver::None => *driver = Driver::Parts(vec![(low, value)]),
            Driver::Parts(parts) if !parts.iter().any(overlaps) => parts.push((low, value)),
            _ => {
                return refuse(line, format!("`{}` is driven twice", signal.name));
            }
        }
        Ok(())
    }

    /// A value that depends on no signal.
    pub fn fold(&mut self, id: ValueId) -> Option<Known> {
        let pair = self.fold_pair(id)?;
        let bits = |node| self.scratch.constant(node).cloned();
        Some(Known {
            value: bits(pair.value)?,
            unknown: bits(pair.unknown)?,
        })
    }

    fn fold_pair(&mut self, id: ValueId) -> Option<Pair> {
        let (width, value) = self.graph.get(id);
        let value = value.clone();
        if matches!(value, Value::Signal(_) | Value::Word(..)) {
            return None;
        }
        let mut operands = Vec::new();
        for operand in value.operands() {
            operands.push(self.fold_pair(operand)?);
        }
        four_state::operation(&mut self.scratch, width, &value, &operands)
    }

    /// A number that depends on no signal and has no unknown bit.
    pub fn fold_number(&mut self, id: ValueId) -> Option<Bits> {
        let known = self.fold(id)?;
        known.unknown.is_zero().then_some(known.value)
    }
}
