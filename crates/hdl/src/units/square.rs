//! `(A-B)^2`.

use photoncube_spec::Squarer;
use rust_hdl::prelude::*;

use super::squarer::SquarerBlock;

/// The squared difference of two unsigned coordinates; `Q = 2 C`, exact.
///
/// |A-B| is chosen from the two differences, so that the squarer stays unsigned and `C` bits
/// wide; synthesis shares the comparison with a subtraction.
#[derive(LogicBlock)]
pub(crate) struct SquareUnit<const C: usize, const Q: usize> {
    pub a: Signal<In, Bits<C>>,
    pub b: Signal<In, Bits<C>>,
    pub square: Signal<Out, Bits<Q>>,
    a_minus_b: Signal<Local, Bits<C>>,
    b_minus_a: Signal<Local, Bits<C>>,
    below: Signal<Local, Bit>,
    squarer: SquarerBlock<C, Q>,
}

impl<const C: usize, const Q: usize> SquareUnit<C, Q> {
    pub fn new(squarer: Squarer) -> Self {
        Self {
            a: Default::default(),
            b: Default::default(),
            square: Default::default(),
            a_minus_b: Default::default(),
            b_minus_a: Default::default(),
            below: Default::default(),
            squarer: SquarerBlock::new(squarer),
        }
    }
}

impl<const C: usize, const Q: usize> Logic for SquareUnit<C, Q> {
    #[hdl_gen]
    fn update(&mut self) {
        self.a_minus_b.next = self.a.val() - self.b.val();
        self.b_minus_a.next = self.b.val() - self.a.val();
        self.below.next = self.a.val() < self.b.val();
        self.squarer.root.next = self.a_minus_b.val();
        if self.below.val() {
            self.squarer.root.next = self.b_minus_a.val();
        }
        self.square.next = self.squarer.square.val();
    }
}
