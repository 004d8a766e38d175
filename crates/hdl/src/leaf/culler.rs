//! Decides which boxes of the groups of a pair are in range of a batch's box.

use photoncube_spec::{Cut, EngineKind, Leaf, Squarer};
use rust_hdl::prelude::*;

use super::gap::BoxGap;
use crate::defaults::defaulted;
use crate::spatial::lane::Lane;
use crate::spatial::square::{DigitSquarer, ProductSquarer};
use crate::spatial::stage::Stage;
use crate::spatial::wiring::{Wires, Wiring, logic_of_wires, wires, with_wires};

const AXES: usize = 3;
const GROUPS: usize = Leaf::PAIR_GROUPS;
const BORDERS: usize = AXES * GROUPS;

/// The squares of the gaps on all axes, and for each group the lane that an engine has for a photon. The widths are those
/// of an engine.
#[derive(LogicBlock)]
pub(crate) struct Culler<
    const C: usize,
    const H: usize,
    const D: usize,
    const R: usize,
    const Q: usize,
    const LP: usize,
    const HP: usize,
    const PR: usize,
    const T: usize,
    const U: usize,
> {
    pub clock: Signal<In, Clock>,
    pub query_low: [Signal<In, Bits<C>>; AXES],
    pub query_high: [Signal<In, Bits<C>>; AXES],
    /// The borders of the groups: axis a of group i is at 3 i + a.
    pub group_low: [Signal<In, Bits<H>>; BORDERS],
    pub group_high: [Signal<In, Bits<H>>; BORDERS],
    pub in_range: [Signal<Out, Bit>; GROUPS],
    gap: [BoxGap<C, H, D>; BORDERS],
    difference: Vec<Stage<Bits<D>>>,
    /// Squarers, or none where they are of the other kind.
    digits: Vec<DigitSquarer<C, D, R, Q, LP, HP>>,
    product: Vec<ProductSquarer<D, Q, PR>>,
    square_stage: Vec<Stage<Bits<Q>>>,
    far_stage: Vec<Stage<Bit>>,
    lane: Vec<Lane<Q, T, U>>,
    _wires: Wires,
}

impl<
    const C: usize,
    const H: usize,
    const D: usize,
    const R: usize,
    const Q: usize,
    const LP: usize,
    const HP: usize,
    const PR: usize,
    const T: usize,
    const U: usize,
> Culler<C, H, D, R, Q, LP, HP, PR, T, U>
{
    /// Builds a culler with the squarer and the pipeline registers of a kind of engine.
    ///
    /// # Panics
    /// For squares from tables, which two gaps cannot share.
    pub fn new(kind: EngineKind, radius_sq: u32) -> Self {
        let EngineKind { squarer, cuts } = kind;
        assert_ne!(squarer, Squarer::Table, "a culler has no tables");
        let is_product = squarer == Squarer::Product;
        let products = if is_product { BORDERS } else { 0 };
        with_wires!(defaulted!(Self {
            difference: Stage::several(BORDERS, cuts.has(Cut::Difference)),
            digits: (products..BORDERS).map(|_| DigitSquarer::new(cuts)).collect(),
            product: (0..products).map(|_| ProductSquarer::new(cuts, H < C)).collect(),
            square_stage: Stage::several(BORDERS, cuts.has(Cut::Square)),
            far_stage: Stage::several(BORDERS, cuts.has(Cut::Square)),
            lane: (0..GROUPS).map(|_| Lane::new(cuts, 0, Some(radius_sq))).collect(),
        };
            clock query_low query_high group_low group_high in_range gap _wires
        ))
    }

    fn wires(&mut self, wiring: &mut Wiring) {
        for border in 0..BORDERS {
            let (group, axis) = (border / AXES, border % AXES);
            wires!(self, wiring:
                (gap[border].query_low) = (query_low[axis]);
                (gap[border].query_high) = (query_high[axis]);
                (gap[border].group_low) = (group_low[border]);
                (gap[border].group_high) = (group_high[border]);
                (difference[border].clock) = (clock);
                (difference[border].d) = (gap[border].difference);
                (square_stage[border].clock) = (clock);
                (far_stage[border].clock) = (clock);
                (lane[group].axis_square[axis]) = (square_stage[border].q);
                (lane[group].axis_far[axis]) = (far_stage[border].q);
            );
        }
        for border in 0..self.digits.len() {
            wires!(self, wiring:
                (digits[border].clock) = (clock);
                (digits[border].difference) = (difference[border].q);
                (square_stage[border].d) = (digits[border].square);
                (far_stage[border].d) = (digits[border].far);
            );
        }
        for border in 0..self.product.len() {
            wires!(self, wiring:
                (product[border].clock) = (clock);
                (product[border].difference) = (difference[border].q);
                (square_stage[border].d) = (product[border].square);
                (far_stage[border].d) = (product[border].far);
            );
        }
        for group in 0..GROUPS {
            wires!(self, wiring:
                (lane[group].clock) = (clock);
                (in_range[group]) = (lane[group].photon_in_range);
            );
        }
    }
}

logic_of_wires!(Culler<C, H, D, R, Q, LP, HP, PR, T, U>);
