//! Decides whether a batch gathers the facings of a pair of leaves, beside the comparison of their boxes.

use photoncube_spec::Leaf;
use rust_hdl::prelude::*;

use super::{FACING, FACINGS};
use crate::defaults::defaulted;
use crate::spatial::stage::Stage;
use crate::spatial::wiring::{Wires, Wiring, logic_of_wires, wires, with_wires};

/// The facings near a leaf's, and the bits of its number among them.
const NEAR: usize = Leaf::FACINGS_NEAR as usize;
const NUMBER: usize = NEAR.ilog2() as usize;

/// Looks a facing up in two clocks: the bits of four facings, and the facing's own among them.
#[derive(LogicBlock)]
pub(crate) struct Gathers {
    pub clock: Signal<In, Clock>,
    pub facings: Signal<In, Bits<FACINGS>>,
    pub facing: Signal<In, Bits<FACING>>,
    /// The leaf is one of the set.
    pub is_there: Signal<In, Bit>,
    pub gathered: Signal<Out, Bit>,
    pub near: DFF<Bits<NEAR>>,
    pub number: DFF<Bits<NUMBER>>,
    /// The facing except for its lowest bits.
    first: Signal<Local, Bits<FACING>>,
    first_bits: Constant<Bits<FACING>>,
    from_first: Signal<Local, Bits<FACINGS>>,
    from_own: Signal<Local, Bits<NEAR>>,
}

impl Default for Gathers {
    fn default() -> Self {
        defaulted!(Self {
            first_bits: Constant::new(u64::from(Leaf::FACINGS - Leaf::FACINGS_NEAR).to_bits()),
        };
            clock facings facing is_there gathered near number first from_first from_own
        )
    }
}

impl Logic for Gathers {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, near, number);
        self.first.next = self.facing.val() & self.first_bits.val();
        self.from_first.next = self.facings.val() >> self.first.val();
        self.near.d.next = 0.into();
        if self.is_there.val() {
            self.near.d.next = self.from_first.val().get_bits::<NEAR>(0);
        }
        self.number.d.next = self.facing.val().get_bits::<NUMBER>(0);
        self.from_own.next = self.near.q.val() >> self.number.q.val();
        self.gathered.next = self.from_own.val().get_bit(0);
    }
}

/// Looks up the facings of a pair, and delays the answers until the boxes are compared.
#[derive(LogicBlock)]
pub(crate) struct GathersOfPair {
    pub clock: Signal<In, Clock>,
    pub facings: Signal<In, Bits<FACINGS>>,
    pub facing: [Signal<In, Bits<FACING>>; Leaf::PAIR],
    pub is_there: [Signal<In, Bit>; Leaf::PAIR],
    pub gathered: [Signal<Out, Bit>; Leaf::PAIR],
    pub leaf: [Gathers; Leaf::PAIR],
    /// Leaf i of stage s is at 2 s + i.
    pub stage: Vec<Stage<Bit>>,
    _wires: Wires,
}

impl GathersOfPair {
    /// The lookup where the comparison of boxes takes that many clocks.
    pub fn new(cull_clocks: u32) -> Self {
        assert!(cull_clocks > 1, "a lookup takes two clocks");
        let stages = cull_clocks as usize - 1;
        with_wires!(defaulted!(Self {
            stage: Stage::several(stages * Leaf::PAIR, true),
        };
            clock facings facing is_there gathered leaf _wires
        ))
    }

    fn wires(&mut self, wiring: &mut Wiring) {
        for leaf in 0..Leaf::PAIR {
            wires!(self, wiring:
                (leaf[leaf].clock) = (clock);
                (leaf[leaf].facings) = (facings);
                (leaf[leaf].facing) = (facing[leaf]);
                (leaf[leaf].is_there) = (is_there[leaf]);
                (stage[leaf].d) = (leaf[leaf].gathered);
            );
        }
        for place in 0..self.stage.len() {
            wires!(self, wiring: (stage[place].clock) = (clock););
            if place >= Leaf::PAIR {
                wires!(self, wiring: (stage[place].d) = (stage[place - Leaf::PAIR].q););
            }
        }
        let last = self.stage.len() - Leaf::PAIR;
        for leaf in 0..Leaf::PAIR {
            wires!(self, wiring: (gathered[leaf]) = (stage[last + leaf].q););
        }
    }
}

logic_of_wires!(GathersOfPair);
