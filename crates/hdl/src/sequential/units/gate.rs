//! The unit `if A>B, output 0`.

use rust_hdl::prelude::*;

use crate::pinned::unit_pins;

/// The gate: `gated = a > b ? 0 : power`; `a` is a squared distance (V bits, like the work
/// register it comes from), `b` is radius_sq (R bits), so the boundary is in range.
#[derive(LogicBlock, Default)]
pub(crate) struct GateUnit<const V: usize, const R: usize, const P: usize> {
    pub a: Signal<In, Bits<V>>,
    pub b: Signal<In, Bits<R>>,
    pub power: Signal<In, Bits<P>>,
    pub gated: Signal<Out, Bits<V>>,
    wide_b: Signal<Local, Bits<V>>,
    out_of_range: Signal<Local, Bit>,
}

impl<const V: usize, const R: usize, const P: usize> Logic for GateUnit<V, R, P> {
    #[hdl_gen]
    fn update(&mut self) {
        self.wide_b.next = bit_cast::<V, R>(self.b.val());
        self.out_of_range.next = self.a.val() > self.wide_b.val();
        self.gated.next = bit_cast::<V, P>(self.power.val());
        if self.out_of_range.val() {
            self.gated.next = 0.into();
        }
    }
}

unit_pins!(GateUnit<V, R, P>: a, b, power => gated);
