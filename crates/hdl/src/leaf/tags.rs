//! Gives results the tags of their queries, and drops those of fillers.

use rust_hdl::prelude::*;

use super::TAG;
use super::ram::AsyncRam;
use crate::defaults::defaulted;

/// Bits of a tag and of what it is the tag of.
const WORD: usize = TAG + 1;

/// The queue of tags. `TB` bits of a place, `RB` of a result's number in its batch.
#[derive(LogicBlock)]
pub(crate) struct Tags<const TB: usize, const RB: usize> {
    pub clock: Signal<In, Clock>,
    pub reset: Signal<In, Bit>,
    pub takes_token: Signal<In, Bit>,
    pub takes_query: Signal<In, Bit>,
    pub query_tag: Signal<In, Bits<TAG>>,
    pub chain_valid: Signal<In, Bit>,
    pub result_ready: Signal<In, Bit>,
    pub chain_ready: Signal<Out, Bit>,
    pub result_valid: Signal<Out, Bit>,
    pub result_tag: Signal<Out, Bits<TAG>>,
    /// The last result of a batch is taken from the chain.
    pub batch_leaves: Signal<Out, Bit>,
    pub tag_write: DFF<Bits<TB>>,
    pub tag_read: DFF<Bits<TB>>,
    pub has_oldest: DFF<Bit>,
    /// The word of the chain's next result. A register, since the result is ready only if it is a filler's or the port's is.
    pub oldest: DFF<Bits<WORD>>,
    pub tag_result: DFF<Bits<RB>>,
    /// The tags, each with a bit below that says whether it is a query's.
    tag_ram: AsyncRam<TB, WORD>,
    tag_in: Signal<Local, Bits<WORD>>,
    kind_in: Signal<Local, Bits<WORD>>,
    last_result: Constant<Bits<RB>>,
    is_query: Signal<Local, Bit>,
    valid: Signal<Local, Bit>,
    ready: Signal<Local, Bit>,
    takes: Signal<Local, Bit>,
    has_more: Signal<Local, Bit>,
    loads: Signal<Local, Bit>,
    is_last: Signal<Local, Bit>,
}

impl<const TB: usize, const RB: usize> Tags<TB, RB> {
    /// Builds the queue for that many engines.
    pub fn new(engines: u32) -> Self {
        defaulted!(Self {
            last_result: Constant::new(u64::from(engines - 1).to_bits()),
        };
            clock reset takes_token takes_query query_tag chain_valid result_ready chain_ready result_valid
            result_tag batch_leaves tag_write tag_read has_oldest oldest tag_result tag_ram tag_in kind_in
            is_query valid ready takes has_more loads is_last
        )
    }
}

impl<const TB: usize, const RB: usize> Logic for Tags<TB, RB> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(
            self, clock, tag_write, tag_read, has_oldest, oldest, tag_result
        );
        self.tag_ram.clock.next = self.clock.val();
        self.tag_in.next = bit_cast::<WORD, TAG>(self.query_tag.val()) << 1;
        self.kind_in.next = 0.into();
        if self.takes_query.val() {
            self.kind_in.next = 1.into();
        }
        self.tag_ram.write.next = self.takes_token.val();
        self.tag_ram.write_place.next = self.tag_write.q.val();
        self.tag_ram.write_word.next = self.tag_in.val() | self.kind_in.val();
        self.tag_ram.read_place.next = self.tag_read.q.val();
        self.is_query.next = self.oldest.q.val().get_bit(0);
        self.valid.next = self.chain_valid.val() & self.is_query.val();
        self.ready.next = self.result_ready.val() | !self.is_query.val();
        self.takes.next = self.chain_valid.val() & self.ready.val();
        self.is_last.next = self.tag_result.q.val() == self.last_result.val();
        if self.takes_token.val() {
            self.tag_write.d.next = self.tag_write.q.val() + 1;
        }
        self.has_more.next = self.tag_read.q.val() != self.tag_write.q.val();
        self.loads.next = self.has_more.val() & (self.takes.val() | !self.has_oldest.q.val());
        self.has_oldest.d.next = self.loads.val() | (self.has_oldest.q.val() & !self.takes.val());
        if self.loads.val() {
            self.tag_read.d.next = self.tag_read.q.val() + 1;
            self.oldest.d.next = self.tag_ram.read_word.val();
        }
        if self.takes.val() {
            self.tag_result.d.next = self.tag_result.q.val() + 1;
            if self.is_last.val() {
                self.tag_result.d.next = 0.into();
            }
        }
        if self.reset.val() {
            self.tag_write.d.next = 0.into();
            self.tag_read.d.next = 0.into();
            self.has_oldest.d.next = false;
            self.tag_result.d.next = 0.into();
        }
        self.chain_ready.next = self.ready.val();
        self.result_valid.next = self.valid.val();
        self.result_tag.next = 0.into();
        if self.valid.val() {
            self.result_tag.next = self.oldest.q.val().get_bits::<TAG>(1);
        }
        self.batch_leaves.next = self.takes.val() & self.is_last.val();
    }
}
