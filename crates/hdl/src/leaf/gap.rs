//! The gap between the box of a batch and that of a group on one axis.

use rust_hdl::prelude::*;

use crate::defaults::defaulted;
use crate::spatial::arithmetic::{Subtract, SubtractLine};
use crate::spatial::wiring::{Wires, Wiring, logic_of_wires, wires, with_wires};

/// Selects the difference of the two nearest borders, in two's complement of `D` bits: `above` where it is negative, as the
/// group is then above the batch; `below` where it is not negative, as the group is then below; 0 where the boxes overlap.
#[derive(LogicBlock)]
pub(crate) struct NearestBorders<const D: usize> {
    pub above: Signal<In, Bits<D>>,
    pub below: Signal<In, Bits<D>>,
    pub difference: Signal<Out, Bits<D>>,
    is_above: Signal<Local, Bit>,
    is_not_below: Signal<Local, Bit>,
    /// The lowest negative number; numbers from it on, read without a sign, are negative.
    negative: Constant<Bits<D>>,
}

impl<const D: usize> Default for NearestBorders<D> {
    fn default() -> Self {
        defaulted!(Self {
            negative: Constant::new((1_u64 << (D - 1)).to_bits()),
        };
            above below difference is_above is_not_below
        )
    }
}

impl<const D: usize> Logic for NearestBorders<D> {
    #[hdl_gen]
    fn update(&mut self) {
        self.is_above.next = self.above.val() >= self.negative.val();
        self.is_not_below.next = self.below.val() >= self.negative.val();
        self.difference.next = self.below.val();
        if self.is_not_below.val() {
            self.difference.next = 0.into();
        }
        if self.is_above.val() {
            self.difference.next = self.above.val();
        }
    }
}

/// The difference of the nearest borders of a batch's box and a group's, as an engine computes that of a query and a
/// photon. `C` query's and `H` photon's coordinate, `D = C + 1`.
#[derive(LogicBlock)]
pub(crate) struct BoxGap<const C: usize, const H: usize, const D: usize> {
    pub query_low: Signal<In, Bits<C>>,
    pub query_high: Signal<In, Bits<C>>,
    pub group_low: Signal<In, Bits<H>>,
    pub group_high: Signal<In, Bits<H>>,
    pub difference: Signal<Out, Bits<D>>,
    /// Two, or none where the photons are on grid lines.
    subtract: Vec<Subtract<C, H, D>>,
    /// Two, or none where the photons have the steps of the query.
    subtract_line: Vec<SubtractLine<C, H, D>>,
    nearest: NearestBorders<D>,
    _wires: Wires,
}

impl<const C: usize, const H: usize, const D: usize> Default for BoxGap<C, H, D> {
    fn default() -> Self {
        let lines = if H < C { 2 } else { 0 };
        with_wires!(defaulted!(Self {
            subtract: (lines..2).map(|_| Default::default()).collect(),
            subtract_line: (0..lines).map(|_| Default::default()).collect(),
        };
            query_low query_high group_low group_high difference nearest _wires
        ))
    }
}

impl<const C: usize, const H: usize, const D: usize> BoxGap<C, H, D> {
    fn wires(&mut self, wiring: &mut Wiring) {
        if self.subtract.is_empty() {
            wires!(self, wiring:
                (subtract_line[0].a) = (query_high);
                (subtract_line[0].b) = (group_low);
                (subtract_line[1].a) = (query_low);
                (subtract_line[1].b) = (group_high);
                (nearest.above) = (subtract_line[0].difference);
                (nearest.below) = (subtract_line[1].difference);
            );
        } else {
            wires!(self, wiring:
                (subtract[0].a) = (query_high);
                (subtract[0].b) = (group_low);
                (subtract[1].a) = (query_low);
                (subtract[1].b) = (group_high);
                (nearest.above) = (subtract[0].difference);
                (nearest.below) = (subtract[1].difference);
            );
        }
        wires!(self, wiring: (difference) = (nearest.difference););
    }
}

logic_of_wires!(BoxGap<C, H, D>);
