//! Finds the registers and memories that may hold unknown bits although they start known.

use std::collections::HashSet;

use super::circuit::Lowering;
use super::four_state::Pair;
use super::graph::{MemoryId, SignalId};
use super::node::Operation;

/// Registers and memories that may hold unknown bits, whatever their start.
#[derive(Clone, Default)]
pub struct Doubts {
    pub registers: HashSet<SignalId>,
    pub memories: HashSet<MemoryId>,
}

impl Lowering<'_> {
    /// The doubts, with those that this lowering adds: registers that were assumed known and receive an
    /// unknown value, and all registers that depend on them.
    pub fn doubts(&self) -> Doubts {
        let mut doubts = self.doubts.clone();
        let unknown = |pair: &Pair| !self.nodes.is_zero(pair.unknown);
        for (&(id, leaf), next) in self.registers.iter().zip(&self.next) {
            if unknown(next) && !unknown(&leaf) {
                doubts.registers.insert(id);
            }
        }
        for (&(id, _, unknowns), writes) in self.memories.iter().zip(&self.writes) {
            if unknowns.is_none() && writes.iter().any(|[_, _, data]| unknown(data)) {
                doubts.memories.insert(id);
            }
        }
        if doubts.registers.len() > self.doubts.registers.len()
            || doubts.memories.len() > self.doubts.memories.len()
        {
            while self.spread_doubts(&mut doubts) {}
        }
        doubts
    }

    /// Adds the registers that read something in doubt. Returns whether any was added.
    fn spread_doubts(&self, doubts: &mut Doubts) -> bool {
        let mut doubtful = vec![false; self.nodes.len()];
        for (id, leaf) in &self.registers {
            doubtful[leaf.value.index()] = doubts.registers.contains(id);
        }
        let planes: HashSet<u32> = self
            .memories
            .iter()
            .filter(|(id, ..)| doubts.memories.contains(id))
            .map(|&(_, values, _)| values)
            .collect();
        for index in 0..self.nodes.len() {
            let operation = &self.nodes.at(index).operation;
            let from_memory =
                matches!(operation, Operation::Word(plane, _) if planes.contains(plane));
            if from_memory
                || operation
                    .operands()
                    .any(|operand| doubtful[operand.index()])
            {
                doubtful[index] = true;
            }
        }
        let mut more = false;
        for (&(id, _), next) in self.registers.iter().zip(&self.next) {
            more |= doubtful[next.value.index()] && doubts.registers.insert(id);
        }
        for (&(id, ..), writes) in self.memories.iter().zip(&self.writes) {
            let reached = |pairs: &[Pair; 3]| pairs.iter().any(|p| doubtful[p.value.index()]);
            more |= writes.iter().any(reached) && doubts.memories.insert(id);
        }
        more
    }
}
