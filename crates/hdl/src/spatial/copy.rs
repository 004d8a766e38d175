//! Copies of registers, each placed near the logic that uses it.

use rust_hdl::prelude::*;

/// A register of one bit that synthesis must not merge with registers of the same value. The attribute `keep`
/// on the statement that makes it is kept on the flip-flop.
#[derive(LogicBlock, Default)]
pub(crate) struct RegisterCopy {
    pub d: Signal<In, Bit>,
    pub q: Signal<Out, Bit>,
    pub clock: Signal<In, Clock>,
}

impl Logic for RegisterCopy {
    fn update(&mut self) {
        if self.clock.pos_edge() {
            self.q.next = self.d.val();
        }
    }

    fn connect(&mut self) {
        self.q.connect();
    }

    fn hdl(&self) -> Verilog {
        Verilog::Custom(
            "initial q = 1'd0;\n(* keep *) always @(posedge clock) q <= d;\n".to_owned(),
        )
    }
}
