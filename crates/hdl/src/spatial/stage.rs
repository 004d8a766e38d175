//! Registers that stand in the pipeline or not, as the machine's cuts say.

use rust_hdl::core::ast::{VerilogExpression, VerilogStatement};
use rust_hdl::prelude::*;

/// A place in the pipeline: a register, or a wire. Its ports stand in the order of rust-hdl's own
/// register, whose text it has, so that both become one module.
#[derive(LogicBlock)]
pub(crate) struct Stage<T: Synth> {
    pub d: Signal<In, T>,
    pub q: Signal<Out, T>,
    pub clock: Signal<In, Clock>,
    _register: bool,
}

impl<T: Synth> Stage<T> {
    /// A register where `register`, else a wire.
    pub fn new(register: bool) -> Self {
        Self {
            d: Default::default(),
            q: Default::default(),
            clock: Default::default(),
            _register: register,
        }
    }

    /// So many registers or wires.
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

/// A flag in the pipeline: a register that the wave of a reset clears, or a wire.
#[derive(LogicBlock)]
pub(crate) struct FlagStage {
    pub clock: Signal<In, Clock>,
    pub clear: Signal<In, Bit>,
    pub d: Signal<In, Bit>,
    pub q: Signal<Out, Bit>,
    /// One, or none for a wire.
    pub flag: Vec<DFF<Bit>>,
}

impl FlagStage {
    /// A register where `register`, else a wire.
    pub fn new(register: bool) -> Self {
        Self {
            clock: Default::default(),
            clear: Default::default(),
            d: Default::default(),
            q: Default::default(),
            flag: register.then(DFF::default).into_iter().collect(),
        }
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
