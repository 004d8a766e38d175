//! The control store: the encoded microprogram as a read-only memory.

use photoncube_spec::ControlWord;
use rust_hdl::core::ast::{
    VerilogCase, VerilogExpression, VerilogLiteral, VerilogMatch, VerilogStatement,
};
use rust_hdl::prelude::*;

/// `word = words[address]`, combinational. Past the end the word is 0, which does nothing. `A` address bits,
/// `W` word bits.
#[derive(LogicBlock)]
pub(crate) struct ControlStore<const A: usize, const W: usize> {
    pub address: Signal<In, Bits<A>>,
    pub word: Signal<Out, Bits<W>>,
    _words: Vec<ControlWord>,
}

impl<const A: usize, const W: usize> ControlStore<A, W> {
    pub fn new(words: Vec<ControlWord>) -> Self {
        assert!(words.len() <= 1 << A);
        Self {
            address: Default::default(),
            word: Default::default(),
            _words: words,
        }
    }
}

impl<const A: usize, const W: usize> Logic for ControlStore<A, W> {
    fn update(&mut self) {
        let word = self._words.get(self.address.val().index());
        self.word.next = u64::from(word.copied().unwrap_or(0)).to_bits();
    }

    fn connect(&mut self) {
        self.word.connect();
    }

    fn hdl(&self) -> Verilog {
        let assign = |word: ControlWord| {
            let bits: Bits<W> = u64::from(word).to_bits();
            vec![VerilogStatement::Assignment(
                VerilogExpression::Signal("word".to_owned()),
                VerilogExpression::Literal(VerilogLiteral::from(bits)),
            )]
        };
        let mut cases: Vec<_> = self
            ._words
            .iter()
            .enumerate()
            .map(|(address, &word)| VerilogCase {
                condition: format!("{A}'d{address}"),
                block: assign(word),
            })
            .collect();
        cases.push(VerilogCase {
            condition: "default".to_owned(),
            block: assign(0),
        });
        Verilog::Combinatorial(vec![VerilogStatement::Match(VerilogMatch {
            test: VerilogExpression::Signal("address".to_owned()),
            cases,
        })])
    }
}
