//! The control block of an overlapped machine: it selects the control words of each clock and makes the
//! handshakes.
//!
//! The current control words are in registers, and the address is that of the next words. So no cell waits
//! for the store, and the store does not wait for the streams. A query starts the kernel at address 0. The
//! kernel repeats until the query's last group has been accumulated; then the epilogue runs. Past the
//! epilogue's end the words are 0 until the result is taken and a query arrives.

use photoncube_spec::Role;
use photoncube_spec::overlap::Program;
use rust_hdl::prelude::*;

use super::decoder::Decoder;
use crate::defaults::defaulted;
use crate::parts::ControlStore;

/// The control block. `A` address bits, `D` drain bits, `W` control-word bits.
#[derive(LogicBlock)]
pub(crate) struct Control<const A: usize, const D: usize, const W: usize> {
    pub clock: Signal<In, Clock>,
    pub reset: Signal<In, Bit>,
    pub query_valid: Signal<In, Bit>,
    pub query_ready: Signal<Out, Bit>,
    pub group_valid: Signal<In, Bit>,
    pub group_last: Signal<In, Bit>,
    pub group_ready: Signal<Out, Bit>,
    pub result_valid: Signal<Out, Bit>,
    pub result_ready: Signal<In, Bit>,
    /// A query can be taken in this clock, whether or not one is valid. The signal is independent of `valid`,
    /// which keeps the stream out of the path to the registers of all cells.
    pub write_query: Signal<Out, Bit>,
    /// A group is taken in this clock.
    pub group_taken: Signal<Out, Bit>,
    /// The current control words, for the cells of each role.
    pub to_x: Signal<Out, Bits<W>>,
    pub to_y: Signal<Out, Bits<W>>,
    pub to_z: Signal<Out, Bits<W>>,
    pub to_d: Signal<Out, Bits<W>>,
    /// The address of the next control words.
    pub address: DFF<Bits<A>>,
    /// A query is in the machine, at work or with a waiting result.
    pub occupied: DFF<Bit>,
    /// The query's last group was taken.
    pub last: DFF<Bit>,
    /// The clocks since the query's last group was taken.
    pub drain: DFF<Bits<D>>,
    /// The result is complete and waits to be taken.
    pub done: DFF<Bit>,
    pub word_x: DFF<Bits<W>>,
    pub word_y: DFF<Bits<W>>,
    pub word_z: DFF<Bits<W>>,
    pub word_d: DFF<Bits<W>>,
    store_x: ControlStore<A, W>,
    store_y: ControlStore<A, W>,
    store_z: ControlStore<A, W>,
    store_d: ControlStore<A, W>,
    /// The decoder of one role; all roles take a group in the same clocks.
    decoder: Decoder<W>,
    accepts: Signal<Local, Bit>,
    takes_query: Signal<Local, Bit>,
    accepts_group: Signal<Local, Bit>,
    takes_group: Signal<Local, Bit>,
    takes_last: Signal<Local, Bit>,
    drain_ends: Signal<Local, Bit>,
    drained: Signal<Local, Bit>,
    kernel_ends: Signal<Local, Bit>,
    is_at_end: Signal<Local, Bit>,
    is_at_work: Signal<Local, Bit>,
    works: Signal<Local, Bit>,
    fetches: Signal<Local, Bit>,
    taken: Signal<Local, Bit>,
    kernel_end: Constant<Bits<A>>,
    epilogue_address: Constant<Bits<A>>,
    end_address: Constant<Bits<A>>,
    drain_end: Constant<Bits<D>>,
}

impl<const A: usize, const D: usize, const W: usize> Control<A, D, W> {
    pub fn new(program: &Program) -> Self {
        let address = |address: u32| Constant::new(u64::from(address).to_bits());
        let store = |role| ControlStore::new(program.control_words(role));
        // One clock until the last group is seen, and two for the epilogue's first words: one to their
        // address, one out of the store.
        let drain_end = u64::from(program.drain_clocks - 3);
        defaulted!(Self {
            store_x: store(Role::X),
            store_y: store(Role::Y),
            store_z: store(Role::Z),
            store_d: store(Role::D),
            decoder: Decoder::new(4),
            kernel_end: address(program.epilogue_address() - 1),
            epilogue_address: address(program.epilogue_address()),
            end_address: address(program.end_address()),
            drain_end: Constant::new(drain_end.to_bits()),
        };
            clock reset query_valid query_ready group_valid group_last group_ready result_valid result_ready
            write_query group_taken to_x to_y to_z to_d address occupied last drain done word_x word_y word_z
            word_d accepts takes_query accepts_group takes_group takes_last drain_ends drained kernel_ends
            is_at_end is_at_work works fetches taken
        )
    }
}

impl<const A: usize, const D: usize, const W: usize> Logic for Control<A, D, W> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(
            self, clock, address, occupied, last, drain, done, word_x, word_y, word_z, word_d
        );
        self.decoder.word.next = self.word_x.q.val();
        self.to_x.next = self.word_x.q.val();
        self.to_y.next = self.word_y.q.val();
        self.to_z.next = self.word_z.q.val();
        self.to_d.next = self.word_d.q.val();

        self.accepts.next = !self.occupied.q.val();
        self.takes_query.next = self.accepts.val() & self.query_valid.val();
        self.query_ready.next = self.accepts.val();
        self.write_query.next = self.accepts.val();
        self.accepts_group.next = self.decoder.write_power.val() & !self.last.q.val();
        self.takes_group.next = self.accepts_group.val() & self.group_valid.val();
        self.takes_last.next = self.takes_group.val() & self.group_last.val();
        self.group_ready.next = self.accepts_group.val();
        self.group_taken.next = self.takes_group.val();
        self.result_valid.next = self.done.q.val();

        if self.last.q.val() {
            self.drain.d.next = self.drain.q.val() + 1;
        }
        if self.takes_last.val() {
            self.last.d.next = true;
            self.drain.d.next = 0.into();
        }
        self.drain_ends.next = self.drain.q.val() == self.drain_end.val();
        self.drained.next = self.drain_ends.val() & self.last.q.val();
        self.kernel_ends.next = self.address.q.val() == self.kernel_end.val();
        self.is_at_end.next = self.address.q.val() == self.end_address.val();

        self.taken.next = self.done.q.val() & self.result_ready.val();
        if self.taken.val() {
            self.done.d.next = false;
            self.occupied.d.next = false;
        }
        self.is_at_work.next = self.occupied.q.val() & !self.done.q.val();
        self.works.next = self.is_at_work.val() | self.takes_query.val();
        if self.works.val() {
            self.occupied.d.next = true;
            self.address.d.next = self.address.q.val() + 1;
            if self.kernel_ends.val() {
                self.address.d.next = 0.into();
            }
            if self.drained.val() {
                self.address.d.next = self.epilogue_address.val();
            }
            // Not earlier: the kernel's last words, which take groups, are still current.
            if self.is_at_end.val() {
                self.address.d.next = 0.into();
                self.last.d.next = false;
                self.done.d.next = true;
            }
        }
        self.store_x.address.next = self.address.q.val();
        self.store_y.address.next = self.address.q.val();
        self.store_z.address.next = self.address.q.val();
        self.store_d.address.next = self.address.q.val();
        self.fetches.next = self.works.val() & !self.reset.val();
        self.word_x.d.next = 0.into();
        self.word_y.d.next = 0.into();
        self.word_z.d.next = 0.into();
        self.word_d.d.next = 0.into();
        if self.fetches.val() {
            self.word_x.d.next = self.store_x.word.val();
            self.word_y.d.next = self.store_y.word.val();
            self.word_z.d.next = self.store_z.word.val();
            self.word_d.d.next = self.store_d.word.val();
        }
        if self.reset.val() {
            self.address.d.next = 0.into();
            self.occupied.d.next = false;
            self.last.d.next = false;
            self.drain.d.next = 0.into();
            self.done.d.next = false;
        }
    }
}
