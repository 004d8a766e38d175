//! The square of the difference on one axis: `(A-B)^2`, or the half square of a photon format.

use photoncube_spec::Squarer;
use rust_hdl::prelude::*;

use super::squarer::{Power, SquarerBlock};
use crate::defaults::defaulted;
use crate::parts::Difference;
use crate::pinned::unit_pins;

/// The square of the difference of query `a` (`C` bits) and photon `b` (`H` bits), of which `M` bits are
/// squared; `Q = 2 M`, exact. With the photon between two queries it is the half square, see
/// `photoncube_spec::PhotonFormat`.
#[derive(LogicBlock)]
pub(crate) struct SquareUnit<const C: usize, const H: usize, const M: usize, const Q: usize> {
    pub a: Signal<In, Bits<C>>,
    pub b: Signal<In, Bits<H>>,
    pub square: Signal<Out, Bits<Q>>,
    difference: Difference<C, H, M>,
    squarer: SquarerBlock<M, Q>,
}

impl<const C: usize, const H: usize, const M: usize, const Q: usize> SquareUnit<C, H, M, Q> {
    pub fn new(squarer: Squarer) -> Self {
        let power = if H < C {
            Power::HalfSquare
        } else {
            Power::Square
        };
        defaulted!(Self {
            squarer: SquarerBlock::new(squarer, power),
        };
            a b square difference
        )
    }
}

impl<const C: usize, const H: usize, const M: usize, const Q: usize> Logic
    for SquareUnit<C, H, M, Q>
{
    #[hdl_gen]
    fn update(&mut self) {
        self.difference.a.next = self.a.val();
        self.difference.b.next = self.b.val();
        self.squarer.root.next = self.difference.magnitude.val();
        self.square.next = self.squarer.square.val();
    }
}

unit_pins!(SquareUnit<C, H, M, Q>: a, b => square);
