//! Pipeline stages that are registers or wires, as the machine's set of pipeline registers states.

use rust_hdl::core::ast::{VerilogExpression, VerilogStatement};
use rust_hdl::prelude::*;

use crate::defaults::defaulted;

/// A pipeline stage: a register, or a wire. The ports have the order of rust-hdl's own register, and the text
/// is that register's, so that both are merged into one module.
#[derive(LogicBlock)]
pub(crate) struct Stage<T: Synth> {
    pub d: Signal<In, T>,
    pub q: Signal<Out, T>,
    pub clock: Signal<In, Clock>,
    _register: bool,
}

impl<T: Synth> Stage<T> {
    /// A stage that is a register where `register` is true, else a wire.
    pub fn new(register: bool) -> Self {
        Self {
            d: Default::default(),
            q: Default::default(),
            clock: Default::default(),
            _register: register,
        }
    }

    /// `count` stages, all registers or all wires.
    pub fn several(count: usize, register: bool) -> Vec<Self> {
        (0..count).map(|_| Self::new(register)).collect()
    }
}

impl<T: Synth> Logic for Stage<T> {
    fn update(&mut self) {
        if !self._register || self.clock.pos_edge() {
            self.q.next = self.d.val();
        }
    }

    fn connect(&mut self) {
        self.q.connect();
    }

    fn hdl(&self) -> Verilog {
        if self._register {
            return DFF::<T>::default().hdl();
        }
        let [q, d] = ["q", "d"].map(|name| VerilogExpression::Signal(name.to_owned()));
        Verilog::Combinatorial(vec![VerilogStatement::Assignment(q, d)])
    }
}

/// A pipeline stage of a flag: a register that a reset clears, or a wire.
#[derive(LogicBlock)]
pub(crate) struct FlagStage {
    pub clock: Signal<In, Clock>,
    pub clear: Signal<In, Bit>,
    pub d: Signal<In, Bit>,
    pub q: Signal<Out, Bit>,
    /// One register, or none for a wire.
    pub flag: Vec<DFF<Bit>>,
}

impl FlagStage {
    /// A stage that is a register where `register` is true, else a wire.
    pub fn new(register: bool) -> Self {
        defaulted!(Self {
            flag: register.then(DFF::default).into_iter().collect(),
        };
            clock clear d q
        )
    }
}

impl Logic for FlagStage {
    #[hdl_gen]
    fn update(&mut self) {
        self.q.next = self.d.val();
        for i in 0..self.flag.len() {
            self.flag[i].clock.next = self.clock.val();
            self.flag[i].d.next = self.d.val() & !self.clear.val();
            self.q.next = self.flag[i].q.val();
        }
    }
}
