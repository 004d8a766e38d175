//! The flags of an engine: the waiting query, the position of a batch's groups in the pipeline, the complete
//! sums.

use photoncube_spec::{Cut, Cuts};
use rust_hdl::prelude::*;

use super::copy::RegisterCopy;
use super::stage::FlagStage;
use crate::defaults::{defaulted, signals};

/// The handling of tokens, and the pipeline of the reset and of a batch's first positions.
#[derive(LogicBlock, Default)]
pub(crate) struct QueryFlags {
    pub clock: Signal<In, Clock>,
    pub reset_in: Signal<In, Bit>,
    pub token_valid_in: Signal<In, Bit>,
    pub swap_in: Signal<In, Bit>,
    /// The incoming token is kept as the next query.
    pub keeps: Signal<Out, Bit>,
    pub reset_out: Signal<Out, Bit>,
    pub token_valid_out: Signal<Out, Bit>,
    pub swap_out: Signal<Out, Bit>,
    pub reset: DFF<Bit>,
    pub token_valid: DFF<Bit>,
    pub next_valid: DFF<Bit>,
    pub keep: DFF<Bit>,
    pub swap: DFF<Bit>,
    is_free: Signal<Local, Bit>,
}

impl Logic for QueryFlags {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, reset, token_valid, next_valid, keep, swap);
        self.is_free.next = !self.next_valid.q.val() | self.swap_in.val();
        self.keep.d.next = self.token_valid_in.val() & self.is_free.val();
        self.keeps.next = self.keep.q.val();
        self.reset.d.next = self.reset_in.val();
        self.token_valid.d.next = self.token_valid_in.val() & !self.is_free.val();
        self.next_valid.d.next = !self.is_free.val() | self.token_valid_in.val();
        self.swap.d.next = self.swap_in.val();
        if self.reset_in.val() {
            self.token_valid.d.next = false;
            self.next_valid.d.next = false;
            self.swap.d.next = false;
        }
        self.reset_out.next = self.reset.q.val();
        self.token_valid_out.next = self.token_valid.q.val();
        self.swap_out.next = self.swap.q.val();
    }
}

/// A word of the queries, `W` bits: the passing, the next and the current query. The next query is copied
/// from the token one clock after it arrived, so the word may still be in `Token` when it becomes the current
/// query.
#[derive(LogicBlock, Default)]
pub(crate) struct QueryWord<const W: usize> {
    pub clock: Signal<In, Clock>,
    pub token_in: Signal<In, Bits<W>>,
    pub keeps: Signal<In, Bit>,
    pub swap_in: Signal<In, Bit>,
    pub token: DFF<Bits<W>>,
    pub waiting: DFF<Bits<W>>,
    pub query: DFF<Bits<W>>,
    pub token_out: Signal<Out, Bits<W>>,
    pub query_out: Signal<Out, Bits<W>>,
    newest: Signal<Local, Bits<W>>,
}

impl<const W: usize> Logic for QueryWord<W> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, token, waiting, query);
        self.token.d.next = self.token_in.val();
        self.newest.next = self.waiting.q.val();
        if self.keeps.val() {
            self.newest.next = self.token.q.val();
            self.waiting.d.next = self.token.q.val();
        }
        if self.swap_in.val() {
            self.query.d.next = self.newest.val();
        }
        self.token_out.next = self.token.q.val();
        self.query_out.next = self.query.q.val();
    }
}

/// The flags that accompany the powers of a group, and those of the result chain.
#[derive(LogicBlock)]
pub(crate) struct GroupFlags {
    pub clock: Signal<In, Clock>,
    pub reset_in: Signal<In, Bit>,
    /// The reset, as it reaches this engine.
    pub reset: Signal<In, Bit>,
    pub first_in: Signal<In, Bit>,
    pub last_in: Signal<In, Bit>,
    pub result_valid_in: Signal<In, Bit>,
    /// The flag for the next engine.
    pub first_out: Signal<Out, Bit>,
    pub last_out: Signal<Out, Bit>,
    /// The group whose sums are beside the accumulators is the first of its batch.
    pub replace: Signal<Out, Bit>,
    pub sums_done: Signal<Out, Bit>,
    /// Copies of `replace` and `done` beside each channel's sum, where the machine has copies.
    pub replace_copy: Vec<Signal<Out, Bit>>,
    pub sums_done_copy: Vec<Signal<Out, Bit>>,
    pub result_valid_out: Signal<Out, Bit>,
    pub first: FlagStage,
    pub last: FlagStage,
    pub gate_first: FlagStage,
    pub gate_last: FlagStage,
    pub pair_first: FlagStage,
    pub pair_last: FlagStage,
    pub group_first: FlagStage,
    pub group_last: FlagStage,
    pub done: DFF<Bit>,
    /// The delayed flags that feed the copies.
    pub pair_first_delay: Vec<RegisterCopy>,
    pub group_last_delay: Vec<RegisterCopy>,
    pub first_copy: Vec<RegisterCopy>,
    pub done_copy: Vec<RegisterCopy>,
    pub result_valid: DFF<Bit>,
}

impl GroupFlags {
    /// Builds the flags. Where the machine has in-range flags beside the sums, the flags have copies beside
    /// `channels` sums.
    pub fn new(cuts: Cuts, channels: usize) -> Self {
        let stage = |cut| FlagStage::new(cuts.has(cut));
        let copies = channels * usize::from(cuts.has(Cut::Decision));
        let delays = channels * usize::from(cuts.has(Cut::RangeDelay));
        defaulted!(Self {
            replace_copy: signals(copies),
            sums_done_copy: signals(copies),
            first: FlagStage::new(true),
            last: FlagStage::new(true),
            gate_first: stage(Cut::Gate),
            gate_last: stage(Cut::Gate),
            pair_first: stage(Cut::PairPower),
            pair_last: stage(Cut::PairPower),
            group_first: stage(Cut::GroupPower),
            group_last: stage(Cut::GroupPower),
            pair_first_delay: signals(delays),
            group_last_delay: signals(delays),
            first_copy: signals(copies),
            done_copy: signals(copies),
        };
            clock reset_in reset first_in last_in result_valid_in first_out last_out replace sums_done
            result_valid_out done result_valid
        )
    }
}

impl Logic for GroupFlags {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, done, result_valid);
        self.first.clock.next = self.clock.val();
        self.last.clock.next = self.clock.val();
        self.gate_first.clock.next = self.clock.val();
        self.gate_last.clock.next = self.clock.val();
        self.pair_first.clock.next = self.clock.val();
        self.pair_last.clock.next = self.clock.val();
        self.group_first.clock.next = self.clock.val();
        self.group_last.clock.next = self.clock.val();
        self.first.clear.next = self.reset_in.val();
        self.last.clear.next = self.reset_in.val();
        self.gate_first.clear.next = self.reset_in.val();
        self.gate_last.clear.next = self.reset_in.val();
        self.pair_first.clear.next = self.reset_in.val();
        self.pair_last.clear.next = self.reset_in.val();
        self.group_first.clear.next = self.reset_in.val();
        self.group_last.clear.next = self.reset_in.val();

        self.first.d.next = self.first_in.val();
        self.last.d.next = self.last_in.val();
        self.first_out.next = self.first.q.val();
        self.last_out.next = self.last.q.val();
        self.gate_first.d.next = self.first.q.val();
        self.gate_last.d.next = self.last.q.val();
        self.pair_first.d.next = self.gate_first.q.val();
        self.pair_last.d.next = self.gate_last.q.val();
        self.group_first.d.next = self.pair_first.q.val();
        self.group_last.d.next = self.pair_last.q.val();
        self.replace.next = self.group_first.q.val();

        self.done.d.next = self.group_last.q.val() & !self.reset_in.val();
        self.sums_done.next = self.done.q.val();
        for i in 0..self.first_copy.len() {
            self.first_copy[i].clock.next = self.clock.val();
            self.first_copy[i].d.next = self.pair_first.q.val() & !self.reset_in.val();
            self.replace_copy[i].next = self.first_copy[i].q.val();
        }
        for i in 0..self.done_copy.len() {
            self.done_copy[i].clock.next = self.clock.val();
            self.done_copy[i].d.next = self.group_last.q.val() & !self.reset_in.val();
            self.sums_done_copy[i].next = self.done_copy[i].q.val();
        }
        for i in 0..self.pair_first_delay.len() {
            self.pair_first_delay[i].clock.next = self.clock.val();
            self.pair_first_delay[i].d.next = self.gate_first.q.val() & !self.reset_in.val();
            self.first_copy[i].d.next = self.pair_first_delay[i].q.val() & !self.reset_in.val();
        }
        for i in 0..self.group_last_delay.len() {
            self.group_last_delay[i].clock.next = self.clock.val();
            self.group_last_delay[i].d.next = self.pair_last.q.val() & !self.reset_in.val();
            self.done_copy[i].d.next = self.group_last_delay[i].q.val() & !self.reset_in.val();
        }
        self.result_valid.d.next = self.done.q.val() | self.result_valid_in.val();
        // A result of the next engine, which the reset reaches one clock later, is on its way back.
        if self.reset_in.val() | self.reset.val() {
            self.result_valid.d.next = false;
        }
        self.result_valid_out.next = self.result_valid.q.val();
    }
}
