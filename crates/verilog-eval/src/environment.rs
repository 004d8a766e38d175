//! The assignments of a block so far, while it is executed symbolically from its first statement to its last.

use std::collections::{BTreeMap, HashSet};

use super::bits::Bits;
use super::graph::{SignalId, ValueId};

/// The kind of code that is executed.
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

/// A signal with the value that the block has assigned.
#[derive(Clone, Debug)]
pub struct Slot {
    pub value: ValueId,
    /// The bits that some path does not assign; `None` where all paths assign all bits.
    pub missing: Option<Bits>,
}

/// The assignments on the path to a statement. A branch is a layer above the assignments before it.
pub struct Environment {
    pub mode: Mode,
    layers: Vec<Layer>,
    /// The signals that the block assigns anywhere.
    pub targets: HashSet<SignalId>,
    /// The signals that the block reads from outside.
    pub reads: Vec<SignalId>,
    pub reads_memory: bool,
    /// The conditions that hold on the path, the innermost last.
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

    /// Ends a branch and returns its assignments.
    pub fn leave(&mut self) -> Layer {
        self.conditions.pop();
        self.layers.pop().expect("a branch was entered")
    }

    /// Ends the block and returns all of its assignments.
    pub fn take(&mut self) -> Layer {
        self.layers.pop().expect("a block has a layer")
    }
}
