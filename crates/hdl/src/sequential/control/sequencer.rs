//! The sequencer, which selects the control word of each clock.
//!
//! The program counter is the only state machine. Address 0 waits for a query, and the first steps of the
//! iteration wait for a group. After the query's last iteration the machine stops until its result is taken.

use photoncube_spec::Microprogram;
use rust_hdl::prelude::*;

use super::decoder::Decoder;
use crate::defaults::defaulted;
use crate::parts::ControlStore;

/// The control block. `A` address bits, `W` control-word bits, `X` axis bits.
#[derive(LogicBlock)]
pub(crate) struct Control<const A: usize, const W: usize, const X: usize> {
    pub clock: Signal<In, Clock>,
    pub reset: Signal<In, Bit>,
    pub query_valid: Signal<In, Bit>,
    pub query_ready: Signal<Out, Bit>,
    pub group_valid: Signal<In, Bit>,
    pub group_last: Signal<In, Bit>,
    pub group_ready: Signal<Out, Bit>,
    pub result_valid: Signal<Out, Bit>,
    pub result_ready: Signal<In, Bit>,
    pub write_query: Signal<Out, Bit>,
    pub write_photon: Signal<Out, Bit>,
    pub write_power: Signal<Out, Bit>,
    pub write_work: Signal<Out, Bit>,
    pub write_sum: Signal<Out, Bit>,
    pub work_source: Signal<Out, Bits<2>>,
    pub add_sum: Signal<Out, Bit>,
    pub axis: Signal<Out, Bits<X>>,
    /// The program counter: the address of the next step.
    pub address: DFF<Bits<A>>,
    /// The group at work is the query's last.
    pub last: DFF<Bit>,
    /// The result is complete and waits to be taken.
    pub done: DFF<Bit>,
    store: ControlStore<A, W>,
    decoder: Decoder<W, X>,
    runs: Signal<Local, Bit>,
    at_end: Signal<Local, Bit>,
    taken: Signal<Local, Bit>,
    iteration_address: Constant<Bits<A>>,
    final_address: Constant<Bits<A>>,
}

impl<const A: usize, const W: usize, const X: usize> Control<A, W, X> {
    pub fn new(program: &Microprogram, dimension: u32) -> Self {
        let words = program.control_words();
        let address = |address: u64| Constant::new(address.to_bits());
        defaulted!(Self {
            iteration_address: address(u64::from(program.query_clocks())),
            final_address: address(words.len() as u64 - 1),
            store: ControlStore::new(words),
            decoder: Decoder::new(dimension),
        };
            clock reset query_valid query_ready group_valid group_last group_ready result_valid result_ready
            write_query write_photon write_power write_work write_sum work_source add_sum axis address last done
            runs at_end taken
        )
    }
}

impl<const A: usize, const W: usize, const X: usize> Logic for Control<A, W, X> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, address, last, done);
        self.store.address.next = self.address.q.val();
        self.decoder.word.next = self.store.word.val();

        // A step waits for the streams that it reads. All steps wait while a result waits.
        self.runs.next = true;
        if self.decoder.takes_query.val() {
            self.runs.next = self.query_valid.val();
        }
        if self.decoder.reads_group.val() {
            self.runs.next = self.group_valid.val();
        }
        if self.done.q.val() {
            self.runs.next = false;
        }

        self.query_ready.next = self.decoder.takes_query.val();
        self.group_ready.next = self.decoder.takes_group.val();
        if self.done.q.val() {
            self.query_ready.next = false;
            self.group_ready.next = false;
        }
        self.result_valid.next = self.done.q.val();

        self.write_query.next = self.decoder.write_query.val() & self.runs.val();
        self.write_photon.next = self.decoder.write_photon.val() & self.runs.val();
        self.write_power.next = self.decoder.write_power.val() & self.runs.val();
        self.write_work.next = self.decoder.write_work.val() & self.runs.val();
        self.write_sum.next = self.decoder.write_sum.val() & self.runs.val();
        self.work_source.next = self.decoder.work_source.val();
        self.add_sum.next = self.decoder.add_sum.val();
        self.axis.next = self.decoder.axis.val();

        self.at_end.next = self.address.q.val() == self.final_address.val();
        if self.runs.val() {
            self.address.d.next = self.address.q.val() + 1;
            if self.at_end.val() {
                self.address.d.next = self.iteration_address.val();
                if self.last.q.val() {
                    self.address.d.next = 0.into();
                    self.done.d.next = true;
                }
            }
            if self.decoder.takes_group.val() {
                self.last.d.next = self.group_last.val();
            }
        }
        self.taken.next = self.done.q.val() & self.result_ready.val();
        if self.taken.val() {
            self.done.d.next = false;
        }
        if self.reset.val() {
            self.address.d.next = 0.into();
            self.last.d.next = false;
            self.done.d.next = false;
        }
    }
}
