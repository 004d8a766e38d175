//! Runs a compiled program, clock by clock.

use super::bits::Bits;
use super::node::{self, Binary, Operation, Unary};
use super::program::{Code, Memory, Place, Program, Step, Wide};

/// A program with its state.
pub struct Running {
    program: Program,
    state: Vec<u64>,
    /// The next values of the registers.
    fresh: Vec<u64>,
}

impl Running {
    /// A program in its power-up state.
    pub fn new(mut program: Program) -> Self {
        Self {
            state: std::mem::take(&mut program.state),
            fresh: vec![0; program.next.len()],
            program,
        }
    }

    pub fn program(&self) -> &Program {
        &self.program
    }

    pub fn word(&self, place: u32) -> u64 {
        self.state[place as usize]
    }

    /// Drives the inputs and evaluates all values.
    pub fn settle(&mut self, inputs: &[u64]) {
        let program = &self.program;
        for (place, &value) in program.inputs.iter().zip(inputs) {
            if let Some(place) = place {
                self.state[*place as usize] = value;
            }
        }
        for batch in &program.batches {
            let steps = &program.steps[batch.first..batch.end];
            batch_of(program, &mut self.state, batch.code, steps);
        }
    }

    /// Applies the rising clock edge.
    pub fn clock(&mut self) {
        let program = &mut self.program;
        for (fresh, &from) in self.fresh.iter_mut().zip(&program.next) {
            *fresh = self.state[from as usize];
        }
        for memory in &mut program.memories {
            write(memory, &self.state);
        }
        let first = program.first_register;
        self.state[first..first + self.fresh.len()].copy_from_slice(&self.fresh);
    }
}

/// Applies the writes of a memory, in the order of the text.
fn write(memory: &mut Memory, state: &[u64]) {
    let size = memory.size;
    for write in &memory.writes {
        if state[write.enable as usize] == 0 {
            continue;
        }
        let first = state[write.address as usize] as usize * size;
        let data = &state[write.data as usize..][..size];
        memory.words[first..first + size].copy_from_slice(data);
    }
}

fn batch_of(program: &Program, state: &mut [u64], code: Code, steps: &[Step]) {
    match code {
        Code::Unary(operation) => unary(state, operation, steps),
        Code::Binary(operation) => binary(state, operation, steps),
        Code::Select => {
            for step in steps {
                let [a, b, c] = [step.a, step.b, step.c].map(|place| state[place as usize]);
                state[step.to as usize] = if a != 0 { b } else { c };
            }
        }
        Code::Concat => two(state, steps, |a, b, step| a << step.c | b),
        Code::Slice => one(state, steps, |a, step| a >> step.c & step.mask),
        Code::SliceOfTwo => two(state, steps, |a, b, step| {
            // The shift is done in two steps, because Rust does not shift a 64-bit word by 64.
            (a >> step.c | b << 1 << (63 - step.c)) & step.mask
        }),
        Code::SignExtend => one(state, steps, |a, step| extended(a, step.c) & step.mask),
        Code::Word => {
            for step in steps {
                let memory = &program.memories[step.b as usize].words;
                let address = state[step.a as usize] as usize;
                state[step.to as usize] = memory.get(address).copied().unwrap_or(0);
            }
        }
        Code::Wide => {
            for step in steps {
                wide(program, state, &program.wide[step.a as usize]);
            }
        }
    }
}

fn one(state: &mut [u64], steps: &[Step], operation: impl Fn(u64, &Step) -> u64) {
    for step in steps {
        state[step.to as usize] = operation(state[step.a as usize], step);
    }
}

fn two(state: &mut [u64], steps: &[Step], operation: impl Fn(u64, u64, &Step) -> u64) {
    for step in steps {
        let (a, b) = (state[step.a as usize], state[step.b as usize]);
        state[step.to as usize] = operation(a, b, step);
    }
}

fn unary(state: &mut [u64], operation: Unary, steps: &[Step]) {
    match operation {
        Unary::Not => one(state, steps, |a, step| !a & step.mask),
        Unary::Negate => one(state, steps, |a, step| a.wrapping_neg() & step.mask),
        Unary::All => one(state, steps, |a, step| u64::from(a == step.mask)),
        Unary::Any => one(state, steps, |a, _| u64::from(a != 0)),
        Unary::Parity => one(state, steps, |a, _| u64::from(a.count_ones() % 2)),
    }
}

fn binary(state: &mut [u64], operation: Binary, steps: &[Step]) {
    match operation {
        Binary::And => two(state, steps, |a, b, _| a & b),
        Binary::Or => two(state, steps, |a, b, _| a | b),
        Binary::Xor => two(state, steps, |a, b, _| a ^ b),
        Binary::Add => two(state, steps, |a, b, step| a.wrapping_add(b) & step.mask),
        Binary::Subtract => two(state, steps, |a, b, step| a.wrapping_sub(b) & step.mask),
        Binary::Multiply => two(state, steps, |a, b, step| a.wrapping_mul(b) & step.mask),
        Binary::Equal => two(state, steps, |a, b, _| u64::from(a == b)),
        Binary::Less => two(state, steps, |a, b, _| u64::from(a < b)),
        Binary::LessSigned => two(state, steps, |a, b, step| {
            u64::from(((a << step.c) as i64) < ((b << step.c) as i64))
        }),
        Binary::ShiftLeft => two(state, steps, |a, b, step| match b {
            0..64 => a << b & step.mask,
            _ => 0,
        }),
        Binary::ShiftRight => two(state, steps, |a, b, _| match b {
            0..64 => a >> b,
            _ => 0,
        }),
        Binary::ArithmeticShiftRight => two(state, steps, |a, b, step| {
            (extended(a, step.c) as i64 >> b.min(63)) as u64 & step.mask
        }),
    }
}

/// Sign-extends a number that has `less` bits fewer than a word.
fn extended(a: u64, less: u32) -> u64 {
    ((a << less) as i64 >> less) as u64
}

/// Runs a step on values of several words, with [`Bits`].
fn wide(program: &Program, state: &mut [u64], step: &Wide) {
    let value = |place: &Place| {
        let words = &state[place.word as usize..];
        let size = super::bits::words_of(place.width);
        Bits::cut(place.width, words[..size].to_vec())
    };
    let width = step.to.width;
    let operands: Vec<_> = step.operands.iter().map(value).collect();
    let result = match (&step.operation, operands.as_slice()) {
        (Operation::Unary(operation, _), [a]) => node::unary(*operation, a),
        (Operation::Binary(operation, ..), [a, b]) => node::binary(*operation, a, b),
        (Operation::Select(..), [c, a, b]) => if c.is_zero() { b } else { a }.clone(),
        (Operation::Concat(..), [a, b]) => a.concat(b),
        (Operation::Slice(_, low), [a]) => a.slice(*low, width),
        (Operation::ZeroExtend(_), [a]) => a.zero_extend(width),
        (Operation::SignExtend(_), [a]) => a.sign_extend(width),
        (Operation::Word(memory, _), [address]) => {
            let memory = &program.memories[*memory as usize];
            let first = address.to_u64().unwrap_or(u64::MAX) as usize;
            let first = first.saturating_mul(memory.size);
            let end = first.saturating_add(memory.size);
            Bits::cut(
                width,
                memory.words.get(first..end).unwrap_or_default().to_vec(),
            )
        }
        _ => unreachable!("constants and leaves take no step, and operands are counted"),
    };
    state[step.to.word as usize..][..result.words().len()].copy_from_slice(result.words());
}

#[cfg(test)]
mod tests {
    use super::super::circuit::Circuit;
    use super::super::four_state::known;
    use super::super::node::Nodes;
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64;

    const UNARY: [Unary; 5] = [
        Unary::Not,
        Unary::Negate,
        Unary::All,
        Unary::Any,
        Unary::Parity,
    ];
    const BINARY: [Binary; 12] = [
        Binary::And,
        Binary::Or,
        Binary::Xor,
        Binary::Add,
        Binary::Subtract,
        Binary::Multiply,
        Binary::Equal,
        Binary::Less,
        Binary::LessSigned,
        Binary::ShiftLeft,
        Binary::ShiftRight,
        Binary::ArithmeticShiftRight,
    ];

    /// Compares every operator of two inputs on words with the operator on wide numbers.
    #[test]
    fn words_are_calculated_with_as_wide_numbers_are() {
        let rng = &mut Pcg64::seed_from_u64(1);
        for width in 1..=u64::BITS {
            let mut nodes = Nodes::default();
            let [a, b] = [0, 1].map(|number| nodes.leaf(width, number));
            let mut observed: Vec<_> = UNARY.map(|unary| nodes.unary(unary, a)).to_vec();
            observed.extend(BINARY.map(|binary| nodes.binary(binary, a, b)));
            let observed = observed.into_iter().map(|node| known(&mut nodes, node));
            let mut running = Running::new(Program::new(&Circuit {
                observed: observed.collect(),
                inputs: vec![Some(a), Some(b)],
                registers: Vec::new(),
                memories: Vec::new(),
                nodes,
            }));
            for _ in 0..50 {
                let mut any = || rng.random::<u64>() >> rng.random_range(0..64) >> (64 - width);
                let row = [any(), any()];
                running.settle(&row);
                let [a, b] = row.map(|value| Bits::of(width, value));
                let unary = UNARY.iter().map(|unary| node::unary(*unary, &a));
                let binary = BINARY.iter().map(|binary| node::binary(*binary, &a, &b));
                let places = &running.program().observed;
                assert_eq!(places.len(), UNARY.len() + BINARY.len());
                for (expected, place) in unary.chain(binary).zip(places) {
                    assert_eq!(
                        Some(running.word(place.value)),
                        expected.to_u64(),
                        "{row:?}"
                    );
                }
            }
        }
    }
}
