//! What a block has assigned so far, while it is followed from its first statement to its last.

use std::collections::{BTreeMap, HashSet};

use super::bits::Bits;
use super::graph::{SignalId, ValueId};

/// What kind of code is followed.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Mode {
    /// A continuous assignment, or a constant.
    Continuous,
    /// `always @(*)`.
    Combinational,
    /// `always @(posedge clock)`.
    Clocked,
    Initial,
}

/// A signal as the block has assigned it.
#[derive(Clone, Debug)]
pub struct Slot {
    pub value: ValueId,
    /// The bits that are not assigned on every way; none where all are.
    pub missing: Option<Bits>,
}

/// What is assigned on the way to a statement; a branch lies above what was before it.
pub struct Environment {
    pub mode: Mode,
    layers: Vec<Layer>,
    /// What the block assigns anywhere.
    pub targets: HashSet<SignalId>,
    /// What it reads from outside.
    pub reads: Vec<SignalId>,
    pub reads_memory: bool,
    /// What holds on the way, innermost last.
    pub conditions: Vec<ValueId>,
}

pub type Layer = BTreeMap<SignalId, Slot>;

impl Environment {
    pub fn new(mode: Mode) -> Self {
        Self {
            mode,
            layers: vec![Layer::new()],
            targets: HashSet::new(),
            reads: Vec::new(),
            reads_memory: false,
            conditions: Vec::new(),
        }
    }

    pub fn get(&self, signal: SignalId) -> Option<&Slot> {
        let mut layers = self.layers.iter().rev();
        layers.find_map(|layer| layer.get(&signal))
    }

    pub fn set(&mut self, signal: SignalId, slot: Slot) {
        let top = self.layers.last_mut().expect("a block has a layer");
        top.insert(signal, slot);
    }

    pub fn enter(&mut self, condition: ValueId) {
        self.layers.push(Layer::new());
        self.conditions.push(condition);
    }

    /// What the branch assigned.
    pub fn leave(&mut self) -> Layer {
        self.conditions.pop();
        self.layers.pop().expect("a branch was entered")
    }

    /// What the whole block assigned.
    pub fn take(&mut self) -> Layer {
        self.layers.pop().expect("a block has a layer")
    }
}
