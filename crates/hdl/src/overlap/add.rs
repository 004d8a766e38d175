//! The adder of an overlapped machine's cell, with the selection of its first operand.

use rust_hdl::prelude::*;

use crate::defaults::defaulted;

/// `total = (add_sum ? sum : addend) + operand`, modulo `2^S`. Widths: `V` sums of squares, `S` sum.
///
/// Above V bits the first operand is always the sum, because a result of V bits is stored only in the sum.
/// Selection and adder are one block, so that on an ECP5 the selection fits into the carry cells.
#[derive(LogicBlock)]
pub(crate) struct ChosenSum<const V: usize, const S: usize> {
    pub sum: Signal<In, Bits<S>>,
    /// The lowest `V` bits of the sum.
    pub sum_low: Signal<In, Bits<V>>,
    pub addend: Signal<In, Bits<16>>,
    pub operand: Signal<In, Bits<S>>,
    pub add_sum: Signal<In, Bit>,
    pub total: Signal<Out, Bits<S>>,
    low: Signal<Local, Bits<V>>,
    wide_low: Signal<Local, Bits<S>>,
    high: Signal<Local, Bits<S>>,
    first: Signal<Local, Bits<S>>,
    /// A mask of ones above `V` bits.
    high_bits: Constant<Bits<S>>,
}

impl<const V: usize, const S: usize> Default for ChosenSum<V, S> {
    fn default() -> Self {
        let ones = |bits: usize| u64::MAX >> (64 - bits);
        defaulted!(Self {
            high_bits: Constant::new((ones(S) & !ones(V)).to_bits()),
        };
            sum sum_low addend operand add_sum total low wide_low high first
        )
    }
}

impl<const V: usize, const S: usize> Logic for ChosenSum<V, S> {
    #[hdl_gen]
    fn update(&mut self) {
        self.low.next = bit_cast::<V, 16>(self.addend.val());
        if self.add_sum.val() {
            self.low.next = self.sum_low.val();
        }
        self.wide_low.next = bit_cast::<S, V>(self.low.val());
        self.high.next = self.sum.val() & self.high_bits.val();
        self.first.next = self.high.val() | self.wide_low.val();
        self.total.next = self.first.val() + self.operand.val();
    }
}
