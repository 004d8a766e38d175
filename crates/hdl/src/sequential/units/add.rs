//! The unit `A+B`.

use rust_hdl::prelude::*;

use crate::pinned::unit_pins;

/// The adder: `sum = a + b`, modulo `2^S`.
#[derive(LogicBlock, Default)]
pub(crate) struct AddUnit<const S: usize> {
    pub a: Signal<In, Bits<S>>,
    pub b: Signal<In, Bits<S>>,
    pub sum: Signal<Out, Bits<S>>,
}

impl<const S: usize> Logic for AddUnit<S> {
    #[hdl_gen]
    fn update(&mut self) {
        self.sum.next = self.a.val() + self.b.val();
    }
}

unit_pins!(AddUnit<S>: a, b => sum);
