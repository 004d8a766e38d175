//! The flattened design: signals, memories and their drivers, by number.

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
    /// The nodes in which constants are folded.
    scratch: Nodes,
}

/// An instance of a module; the first instance is the top.
pub struct Instance<'a> {
    pub parent: Option<usize>,
    pub name: &'a str,
    pub names: HashMap<&'a str, Entity<'a>>,
    pub children: HashMap<&'a str, usize>,
}

/// The object that a name denotes.
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
    /// A `reg` or `integer`, which blocks may assign.
    pub variable: bool,
    /// A variable of a function, which exists only in a call.
    pub local: bool,
    pub line: Line,
    pub driver: Driver,
    /// The initial value of a variable.
    pub initial: Option<Known>,
}

pub enum Driver {
    None,
    /// An input pin of the top module.
    Input,
    Value(ValueId),
    /// Parts with separate drivers: the lowest bit and the value of each.
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
    /// The initial value of each word.
    pub words: Vec<Known>,
    pub clock: Option<SignalId>,
    /// The writes in the order of the text.
    pub writes: Vec<Write>,
}

pub struct Write {
    pub enable: ValueId,
    pub address: ValueId,
    pub data: ValueId,
}

/// A block or an assignment without a clock, with the signals that it reads and drives.
pub struct Unit {
    pub reads: Vec<SignalId>,
    pub reads_memory: bool,
    pub targets: Vec<SignalId>,
    /// An `always @(*)`, which runs only when a signal changes.
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

    /// The value of a signal.
    pub fn read(&mut self, id: SignalId) -> ValueId {
        let width = self.signal(id).width;
        self.graph.add(width, Value::Signal(id))
    }

    /// The hierarchical name, without the name of the top.
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

    /// Finds the signal of a hierarchical name.
    pub fn find(&self, path: &str) -> Option<SignalId> {
        match self.entity(path)? {
            Entity::Signal(id) => Some(*id),
            _ => None,
        }
    }

    /// Sets the initial value of every word of a memory, named by its hierarchical name, to zero.
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

    /// Folds a value that depends on no signal; `None` for others.
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

    /// Folds a value that depends on no signal and has no unknown bit; `None` for others.
    pub fn fold_number(&mut self, id: ValueId) -> Option<Bits> {
        let known = self.fold(id)?;
        known.unknown.is_zero().then_some(known.value)
    }
}
