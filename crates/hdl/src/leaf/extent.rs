//! The box around points, one axis at a time.

use rust_hdl::prelude::*;

/// The borders around two photons of `H` bits, each of which may be absent. Around none they are borders that change no
/// other: all ones and 0.
#[derive(LogicBlock, Default)]
pub(crate) struct ExtentOfLanes<const H: usize> {
    pub present_a: Signal<In, Bits<1>>,
    pub present_b: Signal<In, Bits<1>>,
    pub place_a: Signal<In, Bits<H>>,
    pub place_b: Signal<In, Bits<H>>,
    pub low: Signal<Out, Bits<H>>,
    pub high: Signal<Out, Bits<H>>,
    has_a: Signal<Local, Bit>,
    has_b: Signal<Local, Bit>,
    is_lower: Signal<Local, Bit>,
    is_higher: Signal<Local, Bit>,
    zero: Signal<Local, Bits<H>>,
}

impl<const H: usize> Logic for ExtentOfLanes<H> {
    #[hdl_gen]
    fn update(&mut self) {
        self.zero.next = 0.into();
        self.has_a.next = self.present_a.val().any();
        self.has_b.next = self.present_b.val().any();
        self.is_lower.next = self.place_b.val() < self.place_a.val();
        self.is_higher.next = self.place_b.val() > self.place_a.val();
        self.low.next = self.place_a.val();
        self.high.next = self.place_a.val();
        if self.has_b.val() & (self.is_lower.val() | !self.has_a.val()) {
            self.low.next = self.place_b.val();
        }
        if self.has_b.val() & (self.is_higher.val() | !self.has_a.val()) {
            self.high.next = self.place_b.val();
        }
        if !self.has_a.val() & !self.has_b.val() {
            self.low.next = !self.zero.val();
            self.high.next = 0.into();
        }
    }
}

/// The borders around two boxes of `W` bits.
#[derive(LogicBlock, Default)]
pub(crate) struct ExtentOfBoth<const W: usize> {
    pub low_a: Signal<In, Bits<W>>,
    pub low_b: Signal<In, Bits<W>>,
    pub high_a: Signal<In, Bits<W>>,
    pub high_b: Signal<In, Bits<W>>,
    pub low: Signal<Out, Bits<W>>,
    pub high: Signal<Out, Bits<W>>,
    is_lower: Signal<Local, Bit>,
    is_higher: Signal<Local, Bit>,
}

impl<const W: usize> Logic for ExtentOfBoth<W> {
    #[hdl_gen]
    fn update(&mut self) {
        self.is_lower.next = self.low_b.val() < self.low_a.val();
        self.is_higher.next = self.high_b.val() > self.high_a.val();
        self.low.next = self.low_a.val();
        self.high.next = self.high_a.val();
        if self.is_lower.val() {
            self.low.next = self.low_b.val();
        }
        if self.is_higher.val() {
            self.high.next = self.high_b.val();
        }
    }
}

/// The borders around boxes of `W` bits that come one after another; the first of them replaces the borders.
#[derive(LogicBlock, Default)]
pub(crate) struct ExtentSoFar<const W: usize> {
    pub clock: Signal<In, Clock>,
    /// A box comes in this clock.
    pub comes: Signal<In, Bit>,
    pub first: Signal<In, Bit>,
    pub low_in: Signal<In, Bits<W>>,
    pub high_in: Signal<In, Bits<W>>,
    pub low_out: Signal<Out, Bits<W>>,
    pub high_out: Signal<Out, Bits<W>>,
    pub low: DFF<Bits<W>>,
    pub high: DFF<Bits<W>>,
    is_lower: Signal<Local, Bit>,
    is_higher: Signal<Local, Bit>,
}

impl<const W: usize> Logic for ExtentSoFar<W> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, low, high);
        self.is_lower.next = self.low_in.val() < self.low.q.val();
        self.is_higher.next = self.high_in.val() > self.high.q.val();
        if self.comes.val() & (self.first.val() | self.is_lower.val()) {
            self.low.d.next = self.low_in.val();
        }
        if self.comes.val() & (self.first.val() | self.is_higher.val()) {
            self.high.d.next = self.high_in.val();
        }
        self.low_out.next = self.low.q.val();
        self.high_out.next = self.high.q.val();
    }
}

/// A word of `W` bits that is held until the next is taken.
#[derive(LogicBlock, Default)]
pub(crate) struct Held<const W: usize> {
    pub clock: Signal<In, Clock>,
    pub takes: Signal<In, Bit>,
    pub d: Signal<In, Bits<W>>,
    pub q: Signal<Out, Bits<W>>,
    pub held: DFF<Bits<W>>,
}

impl<const W: usize> Logic for Held<W> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, held);
        if self.takes.val() {
            self.held.d.next = self.d.val();
        }
        self.q.next = self.held.q.val();
    }
}
