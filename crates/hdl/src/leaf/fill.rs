//! Reads sets of groups into the two banks.

use rust_hdl::prelude::*;

use super::FACING;

/// Takes groups and says where they are written. `PB` bits of a place.
#[derive(LogicBlock, Default)]
pub(crate) struct Fill<const PB: usize> {
    pub clock: Signal<In, Clock>,
    pub reset: Signal<In, Bit>,
    pub group_valid: Signal<In, Bit>,
    pub group_last: Signal<In, Bit>,
    pub group_facing: Signal<In, Bits<FACING>>,
    /// The bank that is freed in this clock, if one is.
    pub frees: Signal<In, Bit>,
    pub freed_bank: Signal<In, Bit>,
    pub group_ready: Signal<Out, Bit>,
    pub write_valid_out: Signal<Out, Bit>,
    pub write_bank_out: Signal<Out, Bit>,
    pub write_place_out: Signal<Out, Bits<PB>>,
    pub write_last_out: Signal<Out, Bit>,
    pub write_facing_out: Signal<Out, Bits<FACING>>,
    pub fill_bank: DFF<Bit>,
    pub fill_place: DFF<Bits<PB>>,
    pub fill_ready: DFF<Bit>,
    pub filled_0: DFF<Bit>,
    pub filled_1: DFF<Bit>,
    pub write_valid: DFF<Bit>,
    pub write_bank: DFF<Bit>,
    pub write_place: DFF<Bits<PB>>,
    pub write_last: DFF<Bit>,
    pub write_facing: DFF<Bits<FACING>>,
    takes: Signal<Local, Bit>,
    at_end: Signal<Local, Bit>,
    is_last: Signal<Local, Bit>,
    is_filled: Signal<Local, Bit>,
}

impl<const PB: usize> Logic for Fill<PB> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(
            self,
            clock,
            fill_bank,
            fill_place,
            fill_ready,
            filled_0,
            filled_1,
            write_valid,
            write_bank,
            write_place,
            write_last,
            write_facing
        );
        self.takes.next = self.group_valid.val() & self.fill_ready.q.val();
        self.at_end.next = self.fill_place.q.val().all();
        self.is_last.next = self.takes.val() & (self.group_last.val() | self.at_end.val());
        self.is_filled.next = self.filled_0.q.val();
        if self.fill_bank.q.val() {
            self.is_filled.next = self.filled_1.q.val();
        }
        self.fill_ready.d.next = !self.is_filled.val() & !self.is_last.val();
        if self.takes.val() {
            self.fill_place.d.next = self.fill_place.q.val() + 1;
        }
        if self.is_last.val() {
            self.fill_place.d.next = 0.into();
            self.fill_bank.d.next = !self.fill_bank.q.val();
            if self.fill_bank.q.val() {
                self.filled_1.d.next = true;
            } else {
                self.filled_0.d.next = true;
            }
        }
        if self.frees.val() {
            if self.freed_bank.val() {
                self.filled_1.d.next = false;
            } else {
                self.filled_0.d.next = false;
            }
        }
        self.write_valid.d.next = self.takes.val();
        self.write_bank.d.next = self.fill_bank.q.val();
        self.write_place.d.next = self.fill_place.q.val();
        self.write_last.d.next = self.is_last.val();
        self.write_facing.d.next = self.group_facing.val();
        if self.reset.val() {
            self.fill_bank.d.next = false;
            self.fill_place.d.next = 0.into();
            self.fill_ready.d.next = false;
            self.filled_0.d.next = false;
            self.filled_1.d.next = false;
            self.write_valid.d.next = false;
        }
        self.group_ready.next = self.fill_ready.q.val();
        self.write_valid_out.next = self.write_valid.q.val();
        self.write_bank_out.next = self.write_bank.q.val();
        self.write_place_out.next = self.write_place.q.val();
        self.write_last_out.next = self.write_last.q.val();
        self.write_facing_out.next = self.write_facing.q.val();
    }
}
