//! A user's own microprogram in a form small enough to be a part of a machine.

use super::microprogram::Microprogram;
use crate::cell::{Op, Step};

/// The most steps of a user's own program: the reach of a 5-bit program counter, which has one bit more than
/// the named machines have.
pub const MOST_OWN_STEPS: usize = 32;

/// The program of a machine that does not run the paper's all-reduce: one step for each clock.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct OwnProgram {
    steps: [Step; MOST_OWN_STEPS],
    query_clocks: usize,
    clocks: usize,
}

impl OwnProgram {
    /// Packs a program; `None` where it is longer than [`MOST_OWN_STEPS`] clocks.
    pub fn new(program: &Microprogram) -> Option<Self> {
        let mut steps = [Step::new(Op::Nop); MOST_OWN_STEPS];
        let all = program.steps();
        steps.get_mut(..all.len())?.copy_from_slice(&all);
        Some(Self {
            steps,
            query_clocks: program.query_clocks() as usize,
            clocks: all.len(),
        })
    }

    /// Unpacks the program. Each clock without a step gets a nop.
    pub fn microprogram(&self) -> Microprogram {
        let (query, iteration) = self.steps[..self.clocks].split_at(self.query_clocks);
        Microprogram::of_phases(query, iteration)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hypercube::Hypercube;

    #[test]
    fn a_program_comes_back_as_it_was_unless_it_is_too_long() {
        let program = Microprogram::all_reduce(Hypercube::new(5));
        let own = OwnProgram::new(&program).unwrap();
        assert_eq!(own.microprogram(), program);
        let mut long = program;
        long.query[0].clock = MOST_OWN_STEPS as u32 - 10;
        assert_eq!(long.steps().len(), MOST_OWN_STEPS + 1);
        assert_eq!(OwnProgram::new(&long), None);
    }
}
