//! Finds the boxes around the groups of a set, leaf by leaf.

use photoncube_spec::{Leaf, Spatial};
use rust_hdl::prelude::*;

use super::FACING;
use super::extent::{ExtentOfBoth, ExtentOfLanes, Held};
use crate::defaults::defaulted;
use crate::spatial::stage::Stage;
use crate::spatial::wiring::{Wires, Wiring, logic_of_wires, wires, with_wires};

const AXES: usize = 3;
const LANES: usize = Spatial::LANES;
/// The borders of the two halves of a group.
const HALVES: usize = 2 * AXES;
/// The borders of the groups of a leaf: axis a of group g is at 3 g + a.
pub(super) const OF_LEAF: usize = AXES * Leaf::GROUPS;

/// The borders of the boxes of a leaf's groups, in three clocks: around the halves of a group, around the group, and beside those of the
/// leaf's other group. `H` bits.
#[derive(LogicBlock)]
pub(crate) struct BoxBorders<const H: usize> {
    pub clock: Signal<In, Clock>,
    pub present: [Signal<In, Bits<1>>; LANES],
    pub x: [Signal<In, Bits<H>>; LANES],
    pub y: [Signal<In, Bits<H>>; LANES],
    pub z: [Signal<In, Bits<H>>; LANES],
    /// The group in `Group` is one of a set; it is also the first of its leaf.
    pub comes: Signal<In, Bit>,
    pub first_comes: Signal<In, Bit>,
    pub low: [Signal<Out, Bits<H>>; OF_LEAF],
    pub high: [Signal<Out, Bits<H>>; OF_LEAF],
    /// Axis a of half h is at 3 h + a.
    half: [ExtentOfLanes<H>; HALVES],
    pub half_low: Vec<Stage<Bits<H>>>,
    pub half_high: Vec<Stage<Bits<H>>>,
    both: [ExtentOfBoth<H>; AXES],
    pub group_low: Vec<Stage<Bits<H>>>,
    pub group_high: Vec<Stage<Bits<H>>>,
    pub held_low: [Held<H>; OF_LEAF],
    pub held_high: [Held<H>; OF_LEAF],
    _wires: Wires,
}

impl<const H: usize> Default for BoxBorders<H> {
    fn default() -> Self {
        with_wires!(defaulted!(Self {
            half_low: Stage::several(HALVES, true),
            half_high: Stage::several(HALVES, true),
            group_low: Stage::several(AXES, true),
            group_high: Stage::several(AXES, true),
        };
            clock present x y z comes first_comes low high half both held_low held_high _wires
        ))
    }
}

impl<const H: usize> BoxBorders<H> {
    fn wires(&mut self, wiring: &mut Wiring) {
        for half in 0..LANES / 2 {
            let (even, odd) = (2 * half, 2 * half + 1);
            wires!(self, wiring:
                (half[AXES * half].place_a) = (x[even]);
                (half[AXES * half].place_b) = (x[odd]);
                (half[AXES * half + 1].place_a) = (y[even]);
                (half[AXES * half + 1].place_b) = (y[odd]);
                (half[AXES * half + 2].place_a) = (z[even]);
                (half[AXES * half + 2].place_b) = (z[odd]);
            );
        }
        for place in 0..HALVES {
            let (even, odd) = (place / AXES * 2, place / AXES * 2 + 1);
            wires!(self, wiring:
                (half[place].present_a) = (present[even]);
                (half[place].present_b) = (present[odd]);
                (half_low[place].clock) = (clock);
                (half_low[place].d) = (half[place].low);
                (half_high[place].clock) = (clock);
                (half_high[place].d) = (half[place].high);
            );
        }
        for axis in 0..AXES {
            wires!(self, wiring:
                (both[axis].low_a) = (half_low[axis].q);
                (both[axis].low_b) = (half_low[AXES + axis].q);
                (both[axis].high_a) = (half_high[axis].q);
                (both[axis].high_b) = (half_high[AXES + axis].q);
                (group_low[axis].clock) = (clock);
                (group_low[axis].d) = (both[axis].low);
                (group_high[axis].clock) = (clock);
                (group_high[axis].d) = (both[axis].high);
                (held_low[axis].takes) = (first_comes);
                (held_high[axis].takes) = (first_comes);
                (held_low[AXES + axis].takes) = (comes);
                (held_high[AXES + axis].takes) = (comes);
            );
        }
        for border in 0..OF_LEAF {
            let axis = border % AXES;
            wires!(self, wiring:
                (held_low[border].clock) = (clock);
                (held_low[border].d) = (group_low[axis].q);
                (held_high[border].clock) = (clock);
                (held_high[border].d) = (group_high[axis].q);
                (low[border]) = (held_low[border].q);
                (high[border]) = (held_high[border].q);
            );
        }
    }
}

logic_of_wires!(BoxBorders<H>);

/// Follows the groups of a set to the entries of its leaves, and says which banks are full. `PB` bits of a group's place, `LB` of a
/// leaf's.
#[derive(LogicBlock, Default)]
pub(crate) struct BoxControl<const PB: usize, const LB: usize> {
    pub clock: Signal<In, Clock>,
    pub reset: Signal<In, Bit>,
    pub write_valid: Signal<In, Bit>,
    pub write_bank: Signal<In, Bit>,
    pub write_place: Signal<In, Bits<PB>>,
    pub write_last: Signal<In, Bit>,
    pub write_facing: Signal<In, Bits<FACING>>,
    pub frees: Signal<In, Bit>,
    pub freed_bank: Signal<In, Bit>,
    /// For the borders: a group comes; it is also the first of its leaf.
    pub comes: Signal<Out, Bit>,
    pub first_comes: Signal<Out, Bit>,
    pub box_valid_out: Signal<Out, Bit>,
    pub box_bank_out: Signal<Out, Bit>,
    pub box_leaf_out: Signal<Out, Bits<LB>>,
    pub box_short_out: [Signal<Out, Bit>; Leaf::PAIR],
    pub box_facing_out: [Signal<Out, Bits<FACING>>; Leaf::PAIR],
    pub full_0_out: Signal<Out, Bit>,
    pub full_1_out: Signal<Out, Bit>,
    pub end_0_out: Signal<Out, Bits<LB>>,
    pub end_1_out: Signal<Out, Bits<LB>>,
    pub half_valid: DFF<Bit>,
    pub half_bank: DFF<Bit>,
    pub half_place: DFF<Bits<PB>>,
    pub half_last: DFF<Bit>,
    pub half_facing: DFF<Bits<FACING>>,
    pub group_valid: DFF<Bit>,
    pub group_bank: DFF<Bit>,
    pub group_place: DFF<Bits<PB>>,
    pub group_last: DFF<Bit>,
    pub group_facing: DFF<Bits<FACING>>,
    pub box_valid: DFF<Bit>,
    pub box_bank: DFF<Bit>,
    pub box_leaf: DFF<Bits<LB>>,
    pub box_last: DFF<Bit>,
    pub box_short_0: DFF<Bit>,
    pub box_short_1: DFF<Bit>,
    pub box_facing_0: DFF<Bits<FACING>>,
    pub box_facing_1: DFF<Bits<FACING>>,
    pub full_0: DFF<Bit>,
    pub full_1: DFF<Bit>,
    pub end_0: DFF<Bits<LB>>,
    pub end_1: DFF<Bits<LB>>,
    /// The group is the second of its leaf; it is one of its pair's second leaf.
    is_second: Signal<Local, Bit>,
    is_of_second: Signal<Local, Bit>,
}

impl<const PB: usize, const LB: usize> Logic for BoxControl<PB, LB> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(
            self,
            clock,
            half_valid,
            half_bank,
            half_place,
            half_last,
            half_facing,
            group_valid,
            group_bank,
            group_place,
            group_last,
            group_facing,
            box_valid,
            box_bank,
            box_leaf,
            box_last,
            box_short_0,
            box_short_1,
            box_facing_0,
            box_facing_1,
            full_0,
            full_1,
            end_0,
            end_1
        );
        self.half_valid.d.next = self.write_valid.val();
        self.half_bank.d.next = self.write_bank.val();
        self.half_place.d.next = self.write_place.val();
        self.half_last.d.next = self.write_last.val();
        self.half_facing.d.next = self.write_facing.val();
        self.group_valid.d.next = self.half_valid.q.val();
        self.group_bank.d.next = self.half_bank.q.val();
        self.group_place.d.next = self.half_place.q.val();
        self.group_last.d.next = self.half_last.q.val();
        self.group_facing.d.next = self.half_facing.q.val();
        self.is_second.next = self.group_place.q.val().get_bit(0);
        self.is_of_second.next = self.group_place.q.val().get_bit(1);
        self.comes.next = self.group_valid.q.val();
        self.first_comes.next = self.group_valid.q.val() & !self.is_second.val();
        self.box_valid.d.next =
            self.group_valid.q.val() & (self.is_second.val() | self.group_last.q.val());
        self.box_bank.d.next = self.group_bank.q.val();
        self.box_leaf.d.next = self.group_place.q.val().get_bits::<LB>(1);
        self.box_last.d.next = self.group_last.q.val();
        if self.group_valid.q.val() {
            self.box_short_1.d.next = !self.is_second.val();
            self.box_facing_1.d.next = self.group_facing.q.val();
        }
        if self.group_valid.q.val() & !self.is_of_second.val() {
            self.box_short_0.d.next = !self.is_second.val();
            self.box_facing_0.d.next = self.group_facing.q.val();
        }
        if self.box_valid.q.val() & self.box_last.q.val() {
            if self.box_bank.q.val() {
                self.full_1.d.next = true;
                self.end_1.d.next = self.box_leaf.q.val();
            } else {
                self.full_0.d.next = true;
                self.end_0.d.next = self.box_leaf.q.val();
            }
        }
        if self.frees.val() {
            if self.freed_bank.val() {
                self.full_1.d.next = false;
            } else {
                self.full_0.d.next = false;
            }
        }
        if self.reset.val() {
            self.half_valid.d.next = false;
            self.group_valid.d.next = false;
            self.box_valid.d.next = false;
            self.full_0.d.next = false;
            self.full_1.d.next = false;
        }
        self.box_valid_out.next = self.box_valid.q.val();
        self.box_bank_out.next = self.box_bank.q.val();
        self.box_leaf_out.next = self.box_leaf.q.val();
        self.box_short_out[0].next = self.box_short_0.q.val();
        self.box_short_out[1].next = self.box_short_1.q.val();
        self.box_facing_out[0].next = self.box_facing_0.q.val();
        self.box_facing_out[1].next = self.box_facing_1.q.val();
        self.full_0_out.next = self.full_0.q.val();
        self.full_1_out.next = self.full_1.q.val();
        self.end_0_out.next = self.end_0.q.val();
        self.end_1_out.next = self.end_1.q.val();
    }
}
