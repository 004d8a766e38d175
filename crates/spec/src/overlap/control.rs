//! The control words of an overlapped machine: one for each role and clock.
//!
//! The words of the kernel's clocks come first, then those of the epilogue. Past the end, the word is 0 and
//! does nothing. A word has a field for each thing that a cell selects or writes in that clock. A write that
//! an op does later than in its first clock is in the control word of that later clock.

use super::program::Program;
use crate::cell::{ControlWord, Field, OVERLAPPED, Register, Step};
use crate::formats::bits_for;
use crate::hypercube::{Axis, Hypercube, Role};

/// The dimension of an overlapped machine's network, whose axes its cells know by name.
const DIMENSION: u32 = Hypercube::MIN_DIMENSION;

/// The width of the control word in bits.
pub fn control_word_bits() -> u32 {
    OVERLAPPED.word_bits(DIMENSION)
}

/// The width of the register that counts the clocks since the last group was taken.
pub fn drain_bits(program: &Program) -> u32 {
    bits_for(program.drain_clocks.into())
}

impl Program {
    /// The address of the epilogue's first word. The kernel's first word has address 0.
    pub fn epilogue_address(&self) -> u32 {
        self.interval
    }

    /// The number of control words, which is the first address past the end.
    pub fn end_address(&self) -> u32 {
        self.epilogue_address() + self.epilogue_clocks()
    }

    /// The control words of a role, by address.
    pub fn control_words(&self, role: Role) -> Vec<ControlWord> {
        let mut words = vec![0; self.end_address() as usize];
        for op in &self.kernel {
            let written = op.clock + OVERLAPPED.op(op.step.op).latency - 1;
            words[(written % self.interval) as usize] |= asked_of(op.step, op.role, role);
        }
        for op in &self.epilogue {
            words[(self.epilogue_address() + op.clock) as usize] |= asked_of(op.step, role, role);
        }
        words
    }

    /// The widths of the control block's registers, in the order of [`OVERLAPPED`].
    pub(crate) fn control_widths(&self) -> [u32; 9] {
        let address = bits_for(self.end_address().into());
        let word = control_word_bits();
        [address, 1, 1, drain_bits(self), 1, word, word, word, word]
    }
}

/// The control-word fields that a step of the cell `doer` sets in the cell `role`, in the clock in which the
/// step writes. Fields are set in the doer itself and in the neighbour that sends it a word.
pub fn asked_of(step: Step, doer: Role, role: Role) -> ControlWord {
    let mut word = 0;
    if doer == role {
        word |= OVERLAPPED.own_fields(step, DIMENSION);
    }
    let (Some(axis), Some(link)) = (step.axis, OVERLAPPED.op(step.op).link) else {
        return word;
    };
    let sent = match (axis, link(step.axis)) {
        (Axis::Z, Register::Work) => Some(Field::SendWork),
        (Axis::W, Register::Distance) => Some(Field::SendDistance),
        _ => None,
    };
    if let Some(field) = sent.filter(|_| doer.across(axis) == role) {
        word |= 1 << OVERLAPPED.lsb(field, DIMENSION);
    }
    word
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::{Op, POWER_WORDS};

    #[test]
    fn ops_that_write_or_choose_something_else_have_fields_of_their_own() {
        let mut ops = vec![
            Step::across(Op::Keep, Axis::Z),
            Step::across(Op::Keep, Axis::W),
        ];
        let alone = [
            Op::LoadPhoton,
            Op::LoadPower,
            Op::SquareDifference,
            Op::Gate,
            Op::Add,
            Op::Accumulate,
            Op::Keep,
        ];
        ops.extend(alone.map(Step::new));
        ops.extend((1..POWER_WORDS).map(|place| Step::new(Op::MovePower(place))));
        let axes = [Axis::X, Axis::Y, Axis::Z, Axis::W];
        ops.extend(axes.map(|axis| Step::across(Op::Receive, axis)));
        let own = |&step| OVERLAPPED.own_fields(step, DIMENSION);
        let mut words: Vec<_> = ops.iter().map(own).collect();
        assert!(!words.contains(&0));
        words.sort_unstable();
        words.dedup();
        assert_eq!(words.len(), ops.len());
        // The two roles that receive on w differ in the word that the neighbour sends.
        let sent = |op| asked_of(Step::across(op, Axis::W), Role::X, Role::Z);
        assert_ne!(sent(Op::Keep), sent(Op::Relay));
    }

    #[test]
    fn all_roles_take_a_group_in_the_same_clocks() {
        let program = Program::rotated().unwrap();
        let takes = |role| -> Vec<_> {
            let words = program.control_words(role);
            words
                .iter()
                .map(|&word| OVERLAPPED.field(Field::WritePower, word, DIMENSION))
                .collect()
        };
        for role in Role::ALL {
            assert_eq!(takes(role), takes(Role::X));
        }
        assert_eq!(takes(Role::X).iter().sum::<u32>(), program.groups as u32);
    }
}
