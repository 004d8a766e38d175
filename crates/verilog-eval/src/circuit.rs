//! Lowers the flat design to two-state nodes: every observed signal, and every register and memory that it
//! depends on, as a function of the state before one clock.
//!
//! Each value has a second node for the bits that are unknown; see [`super::four_state`]. A register has a
//! second node where an unknown bit may reach it. The lowering first assumes that registers with a known
//! start are known always. Where an unknown bit reaches such a register, all that depends on it is lowered
//! again.

use std::collections::HashSet;

use super::bits::Bits;
use super::doubts::Doubts;
use super::flat::{Driver, Flat};
use super::four_state::{self, Pair};
use super::graph::{Known, MemoryId, SignalId, Value, ValueId};
use super::node::{Binary, NodeId, Nodes, Operation, Unary};
use super::{Refusal, refuse};

/// The function that one clock computes.
pub struct Circuit {
    pub nodes: Nodes,
    /// The leaf of each input, in the order of the question; `None` where nothing reads it.
    pub inputs: Vec<Option<NodeId>>,
    pub registers: Vec<Register>,
    pub memories: Vec<Memory>,
    /// The observed signals, in the order of the question.
    pub observed: Vec<Pair>,
}

pub struct Register {
    pub leaf: NodeId,
    pub next: NodeId,
    pub initial: Bits,
}

pub struct Memory {
    pub width: u32,
    pub words: Vec<Bits>,
    pub writes: Vec<Write>,
}

pub struct Write {
    pub enable: NodeId,
    pub address: NodeId,
    pub data: NodeId,
}

/// The signals that are to be observed, and the inputs.
pub struct Question<'q> {
    pub clock: Option<SignalId>,
    pub inputs: &'q [SignalId],
    pub observed: &'q [SignalId],
}

/// Lowers everything that the observed signals depend on.
pub fn circuit(flat: &Flat<'_>, question: &Question<'_>) -> Result<Circuit, Refusal> {
    let mut doubts = Doubts::default();
    loop {
        let mut lowering = Lowering::new(flat, question, &doubts);
        lowering.run()?;
        let more = lowering.doubts();
        if more.registers.len() == doubts.registers.len()
            && more.memories.len() == doubts.memories.len()
        {
            return Ok(lowering.finish());
        }
        doubts = more;
    }
}

/// The number of the clock's leaf. Inputs and registers are numbered from 0.
const CLOCK: u32 = u32::MAX;

pub struct Lowering<'l> {
    flat: &'l Flat<'l>,
    question: &'l Question<'l>,
    pub doubts: &'l Doubts,
    pub nodes: Nodes,
    values: Vec<Option<Pair>>,
    signals: Vec<Option<Pair>>,
    /// The places that are being lowered. A place that is reached again is part of a combinational loop.
    open: HashSet<Place>,
    leaves: u32,
    inputs: Vec<Option<NodeId>>,
    /// The registers that were reached, with their leaves.
    pub registers: Vec<(SignalId, Pair)>,
    /// The next values of the registers.
    pub next: Vec<Pair>,
    /// The memories that were reached, with the number of the values and the number of their unknown bits.
    pub memories: Vec<(MemoryId, u32, Option<u32>)>,
    pub writes: Vec<Vec<[Pair; 3]>>,
    planes: u32,
}

#[derive(Copy, Clone, PartialEq, Eq, Hash)]
enum Place {
    Value(ValueId),
    Signal(SignalId),
}

impl<'l> Lowering<'l> {
    fn new(flat: &'l Flat<'l>, question: &'l Question<'l>, doubts: &'l Doubts) -> Self {
        Self {
            flat,
            question,
            doubts,
            nodes: Nodes::default(),
            values: vec![None; flat.graph.len()],
            signals: vec![None; flat.signals.len()],
            open: HashSet::new(),
            leaves: 0,
            inputs: vec![None; question.inputs.len()],
            registers: Vec::new(),
            next: Vec::new(),
            memories: Vec::new(),
            writes: Vec::new(),
            planes: 0,
        }
    }

    /// Lowers everything. Each register or memory that is reached adds work.
    fn run(&mut self) -> Result<(), Refusal> {
        if let Some(clock) = self.question.clock {
            let leaf = self.nodes.leaf(1, CLOCK);
            self.signals[clock.0 as usize] = Some(four_state::known(&mut self.nodes, leaf));
        }
        for (index, &input) in self.question.inputs.iter().enumerate() {
            let leaf = self.leaf(self.flat.signal(input).width);
            self.inputs[index] = Some(leaf);
            self.signals[input.0 as usize] = Some(four_state::known(&mut self.nodes, leaf));
        }
        for &observed in self.question.observed {
            self.lower(Place::Signal(observed))?;
        }
        while self.next.len() < self.registers.len() || self.writes.len() < self.memories.len() {
            if let Some(&(id, _)) = self.registers.get(self.next.len()) {
                let next = self.next_of(id)?;
                self.next.push(next);
            } else if let Some(&(id, ..)) = self.memories.get(self.writes.len()) {
                let writes = self.writes_of(id)?;
                self.writes.push(writes);
            }
        }
        Ok(())
    }

    fn leaf(&mut self, width: u32) -> NodeId {
        self.leaves += 1;
        self.nodes.leaf(width, self.leaves - 1)
    }

    fn next_of(&mut self, id: SignalId) -> Result<Pair, Refusal> {
        let signal = self.flat.signal(id);
        let Driver::Register { clock, next, line } = signal.driver else {
            unreachable!("only registers are put into the list");
        };
        self.check_clock(clock, line)?;
        self.lower(Place::Value(next))
    }

    fn check_clock(&mut self, clock: SignalId, line: u32) -> Result<(), Refusal> {
        let pair = self.lower(Place::Signal(clock))?;
        match self.nodes.get(pair.value).operation {
            Operation::Leaf(CLOCK) => Ok(()),
            _ => {
                let path = self.flat.signal_path(clock);
                refuse(
                    line,
                    format!("the clock `{path}` is not that of the top module"),
                )
            }
        }
    }

    fn writes_of(&mut self, id: MemoryId) -> Result<Vec<[Pair; 3]>, Refusal> {
        let flat = self.flat;
        let memory = flat.memory(id);
        if let Some(clock) = memory.clock {
            self.check_clock(clock, flat.signal(clock).line)?;
        }
        let mut writes = Vec::new();
        for write in &memory.writes {
            let enable = self.lower(Place::Value(write.enable))?;
            let address = self.lower(Place::Value(write.address))?;
            let data = self.lower(Place::Value(write.data))?;
            writes.push([enable, address, data]);
        }
        Ok(writes)
    }

    /// Lowers a value and all values that it depends on. Does not recurse, because a chain may be long.
    fn lower(&mut self, root: Place) -> Result<Pair, Refusal> {
        let mut stack = vec![(root, false)];
        while let Some((place, operands_are_there)) = stack.pop() {
            if self.lowered(place).is_some() {
                continue;
            }
            if operands_are_there {
                let pair = match place {
                    Place::Value(id) => self.value(id),
                    Place::Signal(id) => self.signal(id),
                };
                self.open.remove(&place);
                match place {
                    Place::Value(id) => self.values[id.index()] = Some(pair),
                    Place::Signal(id) => self.signals[id.0 as usize] = Some(pair),
                }
                continue;
            }
            if !self.open.insert(place) {
                return Err(self.found_loop(&stack, place));
            }
            stack.push((place, true));
            stack.extend(
                self.operands(place)
                    .into_iter()
                    .map(|operand| (operand, false)),
            );
        }
        Ok(self.lowered(root).expect("it was lowered"))
    }

    fn lowered(&self, place: Place) -> Option<Pair> {
        match place {
            Place::Value(id) => self.values[id.index()],
            Place::Signal(id) => self.signals[id.0 as usize],
        }
    }

    fn operands(&self, place: Place) -> Vec<Place> {
        match place {
            Place::Value(id) => {
                let (_, value) = self.flat.graph.get(id);
                match *value {
                    Value::Signal(signal) => vec![Place::Signal(signal)],
                    _ => value.operands().map(Place::Value).collect(),
                }
            }
            Place::Signal(id) => match &self.flat.signal(id).driver {
                Driver::Value(value) => vec![Place::Value(*value)],
                Driver::Parts(parts) => parts.iter().map(|part| Place::Value(part.1)).collect(),
                Driver::None | Driver::Input | Driver::Register { .. } => Vec::new(),
            },
        }
    }

    fn found_loop(&self, stack: &[(Place, bool)], place: Place) -> Refusal {
        let from = stack.iter().position(|&(open, busy)| busy && open == place);
        let mut names = Vec::new();
        let mut line = 0;
        for &(open, busy) in &stack[from.unwrap_or(0)..] {
            if let (Place::Signal(id), true) = (open, busy) {
                names.push(format!("`{}`", self.flat.signal_path(id)));
                line = self.flat.signal(id).line;
            }
        }
        Refusal::new(
            line,
            format!("a loop without a register: {}", names.join(", ")),
        )
    }

    fn value(&mut self, id: ValueId) -> Pair {
        let there = |pair: Option<Pair>| pair.expect("operands are lowered first");
        let (width, value) = self.flat.graph.get(id);
        match *value {
            Value::Signal(signal) => there(self.signals[signal.0 as usize]),
            Value::Word(memory, address) => {
                let address = there(self.values[address.index()]);
                self.word(memory, address)
            }
            _ => {
                let operands = value.operands().map(|id| there(self.values[id.index()]));
                let operands: Vec<_> = operands.collect();
                four_state::operation(&mut self.nodes, width, value, &operands)
                    .expect("every other value is an operation")
            }
        }
    }

    fn signal(&mut self, id: SignalId) -> Pair {
        let flat = self.flat;
        let signal = flat.signal(id);
        match &signal.driver {
            Driver::Value(value) => self.values[value.index()].expect("drivers are lowered first"),
            Driver::Parts(parts) => self.parts(signal.width, parts),
            Driver::Register { .. } => self.register(id),
            Driver::None | Driver::Input => {
                let nothing = Known::nothing(signal.width);
                let known = signal.initial.as_ref().unwrap_or(&nothing);
                four_state::constant(&mut self.nodes, known)
            }
        }
    }

    /// Concatenates parts. Undriven bits are unknown.
    fn parts(&mut self, width: u32, parts: &[(u32, ValueId)]) -> Pair {
        let mut all = four_state::constant(&mut self.nodes, &Known::nothing(width));
        for &(low, value) in parts {
            let part = self.values[value.index()].expect("drivers are lowered first");
            all = Pair {
                value: self.put(all.value, low, part.value),
                unknown: self.put(all.unknown, low, part.unknown),
            };
        }
        all
    }

    fn put(&mut self, whole: NodeId, low: u32, part: NodeId) -> NodeId {
        let nodes = &mut self.nodes;
        let (width, high) = (nodes.width(whole), low + nodes.width(part));
        let mut joined = part;
        if high < width {
            let above = nodes.slice(whole, high, width - high);
            joined = nodes.concat(above, joined);
        }
        if low > 0 {
            let below = nodes.slice(whole, 0, low);
            joined = nodes.concat(joined, below);
        }
        joined
    }

    fn register(&mut self, id: SignalId) -> Pair {
        let signal = self.flat.signal(id);
        let value = self.leaf(signal.width);
        let known = signal
            .initial
            .as_ref()
            .is_some_and(|known| known.unknown.is_zero());
        let unknown = match known && !self.doubts.registers.contains(&id) {
            true => self.nodes.zero(signal.width),
            false => self.leaf(signal.width),
        };
        let pair = Pair { value, unknown };
        self.registers.push((id, pair));
        pair
    }

    /// Reads a word of a memory. It is unknown outside the memory and for an unknown address.
    fn word(&mut self, id: MemoryId, address: Pair) -> Pair {
        let flat = self.flat;
        let memory = flat.memory(id);
        let (values, unknowns) = self.planes_of(id);
        let nodes = &mut self.nodes;
        let inside = inside(nodes, address, memory.words.len());
        let nothing = nodes.not(inside);
        let nothing = nodes.spread(nothing, memory.width);
        let something = nodes.not(nothing);
        let value = nodes.word(memory.width, values, address.value);
        let unknown = match unknowns {
            Some(plane) => nodes.word(memory.width, plane, address.value),
            None => nodes.zero(memory.width),
        };
        Pair {
            value: nodes.and(value, something),
            unknown: nodes.or(unknown, nothing),
        }
    }

    fn planes_of(&mut self, id: MemoryId) -> (u32, Option<u32>) {
        if let Some(&(_, values, unknowns)) = self.memories.iter().find(|known| known.0 == id) {
            return (values, unknowns);
        }
        let mut plane = || {
            self.planes += 1;
            self.planes - 1
        };
        let values = plane();
        let words = &self.flat.memory(id).words;
        let known = words.iter().all(|word| word.unknown.is_zero());
        let unknowns = match known && !self.doubts.memories.contains(&id) {
            true => None,
            false => Some(plane()),
        };
        self.memories.push((id, values, unknowns));
        (values, unknowns)
    }

    fn finish(mut self) -> Circuit {
        let mut registers = Vec::new();
        for (&(id, leaf), next) in self.registers.iter().zip(&self.next) {
            let signal = self.flat.signal(id);
            let nothing = Known::nothing(signal.width);
            let initial = signal.initial.as_ref().unwrap_or(&nothing);
            registers.push(Register {
                leaf: leaf.value,
                next: next.value,
                initial: initial.value.clone(),
            });
            if !self.nodes.is_zero(leaf.unknown) {
                registers.push(Register {
                    leaf: leaf.unknown,
                    next: next.unknown,
                    initial: initial.unknown.clone(),
                });
            }
        }
        let mut memories = Vec::new();
        for (&(id, _, unknowns), writes) in self.memories.iter().zip(&self.writes) {
            let memory = self.flat.memory(id);
            let (mut values, mut unknown) = (Vec::new(), Vec::new());
            for [enable, address, data] in writes {
                let inside = inside(&mut self.nodes, *address, memory.words.len());
                let enable = self.nodes.and(enable.value, inside);
                let write = |data| Write {
                    enable,
                    address: address.value,
                    data,
                };
                values.push(write(data.value));
                unknown.push(write(data.unknown));
            }
            let plane = |writes, part: fn(&Known) -> &Bits| Memory {
                width: memory.width,
                words: memory.words.iter().map(|word| part(word).clone()).collect(),
                writes,
            };
            memories.push(plane(values, |word| &word.value));
            if unknowns.is_some() {
                memories.push(plane(unknown, |word| &word.unknown));
            }
        }
        let observed = self.question.observed.iter();
        let observed = observed.map(|id| self.signals[id.0 as usize].expect("it was lowered"));
        Circuit {
            observed: observed.collect(),
            inputs: self.inputs,
            registers,
            memories,
            nodes: self.nodes,
        }
    }
}

/// Whether an address is known and below the number of words.
fn inside(nodes: &mut Nodes, address: Pair, words: usize) -> NodeId {
    let width = nodes.width(address.value);
    let known = nodes.unary(Unary::Any, address.unknown);
    let known = nodes.not(known);
    if width < u64::BITS && words as u64 >= 1 << width {
        return known;
    }
    let words = nodes.number(width, words as u64);
    let below = nodes.binary(Binary::Less, address.value, words);
    nodes.and(known, below)
}

/// Whether anything reads the clock as a value.
pub fn reads_clock(circuit: &Circuit, reached: &[bool]) -> bool {
    (0..circuit.nodes.len()).any(|index| {
        reached[index] && matches!(circuit.nodes.at(index).operation, Operation::Leaf(CLOCK))
    })
}
