//! Compiles a circuit to a flat program. Nodes are sorted in levels, and in each level all nodes of one kind
//! form one batch. A clock is thus a few hundred tight loops over 64-bit words, with one dispatch for each
//! loop.
//!
//! A value of up to 64 bits takes one word; a wider value takes several. The bits of a word above the value's
//! width are 0. [`super::run`] runs the program.

use std::collections::HashMap;

use super::bits::{top_mask, words_of};
use super::circuit::Circuit;
use super::node::{Binary, NodeId, Nodes, Operation, Unary};

/// A circuit, ready to run.
pub struct Program {
    /// The words of all values at power-up. Those of registers are contiguous.
    pub state: Vec<u64>,
    pub batches: Vec<Batch>,
    pub steps: Vec<Step>,
    pub wide: Vec<Wide>,
    pub memories: Vec<Memory>,
    /// The word of each input; `None` where nothing reads it.
    pub inputs: Vec<Option<u32>>,
    /// The index of the first register word.
    pub first_register: usize,
    /// For each register word, the index of the word with its next value.
    pub next: Vec<u32>,
    pub observed: Vec<Observed>,
}

/// An observed signal: the place of its value and, where it may be unknown, the place of its mask of unknown
/// bits.
#[derive(Copy, Clone, Debug)]
pub struct Observed {
    pub value: u32,
    pub unknown: Option<u32>,
    pub width: u32,
}

/// Consecutive steps of one kind.
pub struct Batch {
    pub code: Code,
    pub first: usize,
    pub end: usize,
}

#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Code {
    Unary(Unary),
    Binary(Binary),
    Select,
    /// Concatenation of `a` above `b`, which has `c` bits.
    Concat,
    /// The bits of `a` from bit `c` on.
    Slice,
    /// The bits from bit `c` on of the two words `a` and `b`.
    SliceOfTwo,
    /// Sign extension from `c` bits.
    SignExtend,
    /// The word at address `a` of memory `b`.
    Word,
    /// The wide step with the index `a`.
    Wide,
}

/// A step on single words.
#[derive(Copy, Clone, Debug, Default)]
pub struct Step {
    pub to: u32,
    pub a: u32,
    pub b: u32,
    pub c: u32,
    pub mask: u64,
}

/// A step on values of several words.
pub struct Wide {
    pub to: Place,
    pub operation: Operation,
    pub operands: Vec<Place>,
}

/// A value: its first word and its width.
#[derive(Copy, Clone, Debug)]
pub struct Place {
    pub word: u32,
    pub width: u32,
}

pub struct Memory {
    pub words: Vec<u64>,
    /// The number of words of one entry.
    pub size: usize,
    pub writes: Vec<Write>,
}

pub struct Write {
    pub enable: u32,
    pub address: u32,
    pub data: u32,
}

/// Whether a value of that width fits one word.
pub fn is_narrow(width: u32) -> bool {
    width <= u64::BITS
}

impl Program {
    pub fn new(circuit: &Circuit) -> Self {
        let nodes = &circuit.nodes;
        let reached = reached(circuit);
        let mut compiler = Compiler {
            nodes,
            places: HashMap::new(),
            state: Vec::new(),
            wide: Vec::new(),
        };
        let inputs = circuit.inputs.iter();
        let inputs = inputs.map(|leaf| leaf.map(|leaf| compiler.put(leaf, &[])));
        let inputs = inputs.collect();
        let first_register = compiler.state.len();
        for register in &circuit.registers {
            compiler.put(register.leaf, register.initial.words());
        }
        let (mut steps, mut batches) = (Vec::new(), Vec::<Batch>::new());
        for (code, id) in order(nodes, &reached) {
            let (first, end) = (steps.len(), steps.len() + 1);
            match batches.last_mut() {
                Some(batch) if batch.code == code => batch.end = end,
                _ => batches.push(Batch { code, first, end }),
            }
            steps.push(compiler.step(code, id));
        }
        let mut next = Vec::new();
        for register in &circuit.registers {
            let first = compiler.place(register.next).word;
            let words = words_of(nodes.width(register.next)) as u32;
            next.extend(first..first + words);
        }
        let observed = circuit.observed.iter().map(|pair| Observed {
            value: compiler.place(pair.value).word,
            unknown: match nodes.is_zero(pair.unknown) {
                true => None,
                false => Some(compiler.place(pair.unknown).word),
            },
            width: nodes.width(pair.value),
        });
        let observed = observed.collect();
        let memories = circuit.memories.iter().map(|memory| Memory {
            words: memory
                .words
                .iter()
                .flat_map(|word| word.words().to_vec())
                .collect(),
            size: words_of(memory.width),
            writes: memory
                .writes
                .iter()
                .map(|write| Write {
                    enable: compiler.place(write.enable).word,
                    address: compiler.place(write.address).word,
                    data: compiler.place(write.data).word,
                })
                .collect(),
        });
        Self {
            memories: memories.collect(),
            state: compiler.state,
            wide: compiler.wide,
            batches,
            steps,
            inputs,
            first_register,
            next,
            observed,
        }
    }
}

/// Marks the nodes that an observed signal, a register or a memory depends on.
pub fn reached(circuit: &Circuit) -> Vec<bool> {
    let mut roots = Vec::new();
    roots.extend(
        circuit
            .observed
            .iter()
            .flat_map(|pair| [pair.value, pair.unknown]),
    );
    roots.extend(circuit.registers.iter().map(|register| register.next));
    let writes = circuit.memories.iter().flat_map(|memory| &memory.writes);
    roots.extend(writes.flat_map(|write| [write.enable, write.address, write.data]));
    let mut reached = vec![false; circuit.nodes.len()];
    for root in roots {
        reached[root.index()] = true;
    }
    // Operands come before the nodes that read them.
    for index in (0..reached.len()).rev() {
        if reached[index] {
            for operand in circuit.nodes.at(index).operation.operands() {
                reached[operand.index()] = true;
            }
        }
    }
    reached
}

/// The nodes that need a step, in an order in which operands come first and nodes of one kind are contiguous.
fn order(nodes: &Nodes, reached: &[bool]) -> Vec<(Code, NodeId)> {
    let mut levels = vec![0u32; nodes.len()];
    let mut order = Vec::new();
    for index in (0..nodes.len()).filter(|&index| reached[index]) {
        let id = nodes.id(index);
        let operands = nodes.get(id).operation.operands();
        let above = operands
            .map(|operand| levels[operand.index()])
            .max()
            .unwrap_or(0);
        match code(nodes, id) {
            None => levels[index] = above,
            Some(code) => {
                levels[index] = above + 1;
                order.push((above, code, id));
            }
        }
    }
    order.sort_unstable();
    order.into_iter().map(|(_, code, id)| (code, id)).collect()
}

/// The kind of step of a node; `None` where the node needs no step.
fn code(nodes: &Nodes, id: NodeId) -> Option<Code> {
    let node = nodes.get(id);
    let narrow = |id: NodeId| is_narrow(nodes.width(id));
    let all_narrow = is_narrow(node.width) && node.operation.operands().all(narrow);
    Some(match &node.operation {
        Operation::Constant(_) | Operation::Leaf(_) => return None,
        Operation::ZeroExtend(_) if all_narrow => return None,
        Operation::Slice(..) if is_narrow(node.width) && !all_narrow => Code::SliceOfTwo,
        _ if !all_narrow => Code::Wide,
        Operation::Unary(unary, _) => Code::Unary(*unary),
        Operation::Binary(binary, ..) => Code::Binary(*binary),
        Operation::Select(..) => Code::Select,
        Operation::Concat(..) => Code::Concat,
        Operation::Slice(..) => Code::Slice,
        Operation::SignExtend(_) => Code::SignExtend,
        Operation::Word(..) => Code::Word,
        Operation::ZeroExtend(_) => Code::Wide,
    })
}

struct Compiler<'c> {
    nodes: &'c Nodes,
    places: HashMap<NodeId, u32>,
    state: Vec<u64>,
    wide: Vec<Wide>,
}

impl Compiler<'_> {
    /// Allocates the words of a value, with initial contents where these matter.
    fn put(&mut self, id: NodeId, words: &[u64]) -> u32 {
        let first = self.state.len();
        let size = words_of(self.nodes.width(id));
        self.state.extend_from_slice(words);
        self.state.resize(first + size, 0);
        let first = u32::try_from(first).expect("fewer words than 2^32");
        self.places.insert(id, first);
        first
    }

    /// The place of a value. A constant is allocated when it is first used.
    fn place(&mut self, id: NodeId) -> Place {
        let node = self.nodes.get(id);
        let width = node.width;
        if let Some(&word) = self.places.get(&id) {
            return Place { word, width };
        }
        let word = match &node.operation {
            Operation::Constant(bits) => self.put(id, bits.words()),
            // In one word, zero extension changes nothing.
            Operation::ZeroExtend(inner) if is_narrow(width) => self.place(*inner).word,
            _ => self.put(id, &[]),
        };
        Place { word, width }
    }

    fn step(&mut self, code: Code, id: NodeId) -> Step {
        let node = self.nodes.get(id);
        let operands = node.operation.operands().map(|operand| self.place(operand));
        let operands: Vec<_> = operands.collect();
        let to = self.place(id);
        let word = |index: usize| operands.get(index).map_or(0, |place| place.word);
        let mut step = Step {
            to: to.word,
            a: word(0),
            b: word(1),
            c: word(2),
            mask: top_mask(node.width.min(u64::BITS)),
        };
        match (&node.operation, code) {
            (_, Code::Wide) => {
                step.a = self.wide.len() as u32;
                self.wide.push(Wide {
                    to,
                    operation: node.operation.clone(),
                    operands,
                });
            }
            (Operation::Unary(Unary::All, _), _) => step.mask = top_mask(operands[0].width),
            (Operation::Binary(Binary::LessSigned | Binary::ArithmeticShiftRight, ..), _)
            | (Operation::SignExtend(_), _) => step.c = u64::BITS - operands[0].width,
            (Operation::Concat(..), _) => step.c = operands[1].width,
            (Operation::Slice(_, low), Code::SliceOfTwo) => {
                let last = step.a + words_of(operands[0].width) as u32 - 1;
                step.a += low / u64::BITS;
                step.b = (step.a + 1).min(last);
                step.c = low % u64::BITS;
            }
            (Operation::Slice(_, low), _) => step.c = *low,
            (Operation::Word(memory, _), _) => step.b = *memory,
            _ => {}
        }
        step
    }
}
