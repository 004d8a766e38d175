//! The small operations of the pipeline, one block each, so that each has one text. Operations that
//! rust-hdl's kernels can express are kernels here; the parts of a square are in `digits`.

use rust_hdl::prelude::*;

use crate::defaults::defaulted;

/// `sum = a + b`, exact: `S` bits are one more than the wider of `A` and `B`.
#[derive(LogicBlock, Default)]
pub(crate) struct Sum<const A: usize, const B: usize, const S: usize> {
    pub a: Signal<In, Bits<A>>,
    pub b: Signal<In, Bits<B>>,
    pub sum: Signal<Out, Bits<S>>,
    wide_a: Signal<Local, Bits<S>>,
    wide_b: Signal<Local, Bits<S>>,
}

impl<const A: usize, const B: usize, const S: usize> Logic for Sum<A, B, S> {
    #[hdl_gen]
    fn update(&mut self) {
        self.wide_a.next = bit_cast::<S, A>(self.a.val());
        self.wide_b.next = bit_cast::<S, B>(self.b.val());
        self.sum.next = self.wide_a.val() + self.wide_b.val();
    }
}

/// `difference = a - b` in two's complement, where query and photon have equal steps; `H = C`, `D = C + 1`.
#[derive(LogicBlock, Default)]
pub(crate) struct Subtract<const C: usize, const H: usize, const D: usize> {
    pub a: Signal<In, Bits<C>>,
    pub b: Signal<In, Bits<H>>,
    pub difference: Signal<Out, Bits<D>>,
    wide_a: Signal<Local, Bits<D>>,
    wide_b: Signal<Local, Bits<D>>,
}

impl<const C: usize, const H: usize, const D: usize> Logic for Subtract<C, H, D> {
    #[hdl_gen]
    fn update(&mut self) {
        self.wide_a.next = bit_cast::<D, C>(self.a.val());
        self.wide_b.next = bit_cast::<D, H>(self.b.val());
        self.difference.next = self.wide_a.val() - self.wide_b.val();
    }
}

/// `difference = a - line` in two's complement. The photon `b` is on a grid line between two queries, the line's place
/// being `C - H` bits finer; `D = C + 1`.
#[derive(LogicBlock)]
pub(crate) struct SubtractLine<const C: usize, const H: usize, const D: usize> {
    pub a: Signal<In, Bits<C>>,
    pub b: Signal<In, Bits<H>>,
    pub difference: Signal<Out, Bits<D>>,
    wide_a: Signal<Local, Bits<D>>,
    wide_b: Signal<Local, Bits<D>>,
    line: Signal<Local, Bits<D>>,
    places: Constant<Bits<2>>,
    middle: Constant<Bits<D>>,
}

impl<const C: usize, const H: usize, const D: usize> Default for SubtractLine<C, H, D> {
    fn default() -> Self {
        let places = (C - H) as u64;
        defaulted!(Self {
            places: Constant::new(places.to_bits()),
            middle: Constant::new((1_u64 << (places - 1)).to_bits()),
        };
            a b difference wide_a wide_b line
        )
    }
}

impl<const C: usize, const H: usize, const D: usize> Logic for SubtractLine<C, H, D> {
    #[hdl_gen]
    fn update(&mut self) {
        self.wide_a.next = bit_cast::<D, C>(self.a.val());
        self.wide_b.next = bit_cast::<D, H>(self.b.val());
        self.line.next = (self.wide_b.val() << self.places.val()) | self.middle.val();
        self.difference.next = self.wide_a.val() - self.line.val();
    }
}

/// `in_range`: a distance (`U` bits) is at most `largest`, a query's `radius_sq` (`Q` bits), and no axis is
/// far.
#[derive(LogicBlock, Default)]
pub(crate) struct RangeOfQuery<const Q: usize, const U: usize> {
    pub distance: Signal<In, Bits<U>>,
    pub far: Signal<In, Bit>,
    pub largest: Signal<In, Bits<Q>>,
    pub in_range: Signal<Out, Bit>,
    limit: Signal<Local, Bits<U>>,
    near: Signal<Local, Bit>,
}

impl<const Q: usize, const U: usize> Logic for RangeOfQuery<Q, U> {
    #[hdl_gen]
    fn update(&mut self) {
        self.limit.next = bit_cast::<U, Q>(self.largest.val());
        self.near.next = self.distance.val() <= self.limit.val();
        self.in_range.next = self.near.val() & !self.far.val();
    }
}

/// `in_range`: a distance (`U` bits) is at most the format's `radius_sq`, a constant, and no axis is far.
#[derive(LogicBlock)]
pub(crate) struct RangeOfFormat<const U: usize> {
    pub distance: Signal<In, Bits<U>>,
    pub far: Signal<In, Bit>,
    pub in_range: Signal<Out, Bit>,
    near: Signal<Local, Bit>,
    limit: Constant<Bits<U>>,
}

impl<const U: usize> RangeOfFormat<U> {
    pub fn new(radius_sq: u32) -> Self {
        defaulted!(Self {
            limit: Constant::new(u64::from(radius_sq).to_bits()),
        };
            distance far in_range near
        )
    }
}

impl<const U: usize> Logic for RangeOfFormat<U> {
    #[hdl_gen]
    fn update(&mut self) {
        self.near.next = self.distance.val() <= self.limit.val();
        self.in_range.next = self.near.val() & !self.far.val();
    }
}

/// `any = x | y | z`.
#[derive(LogicBlock, Default)]
pub(crate) struct AnyFar {
    pub x: Signal<In, Bit>,
    pub y: Signal<In, Bit>,
    pub z: Signal<In, Bit>,
    pub any: Signal<Out, Bit>,
}

impl Logic for AnyFar {
    #[hdl_gen]
    fn update(&mut self) {
        self.any.next = self.x.val() | self.y.val() | self.z.val();
    }
}

/// The gate and the adder behind it: adds the powers of the photons that are in range; `W = P + 1`.
#[derive(LogicBlock, Default)]
pub(crate) struct GatedSum<const P: usize, const W: usize> {
    pub a: Signal<In, Bits<P>>,
    pub b: Signal<In, Bits<P>>,
    pub a_in_range: Signal<In, Bit>,
    pub b_in_range: Signal<In, Bit>,
    pub sum: Signal<Out, Bits<W>>,
    gated_a: Signal<Local, Bits<W>>,
    gated_b: Signal<Local, Bits<W>>,
}

impl<const P: usize, const W: usize> Logic for GatedSum<P, W> {
    #[hdl_gen]
    fn update(&mut self) {
        self.gated_a.next = 0.into();
        self.gated_b.next = 0.into();
        if self.a_in_range.val() {
            self.gated_a.next = bit_cast::<W, P>(self.a.val());
        }
        if self.b_in_range.val() {
            self.gated_b.next = bit_cast::<W, P>(self.b.val());
        }
        self.sum.next = self.gated_a.val() + self.gated_b.val();
    }
}

/// The gate with a register behind it, which is cleared for a photon out of range.
#[derive(LogicBlock, Default)]
pub(crate) struct GateStage<const P: usize> {
    pub clock: Signal<In, Clock>,
    pub power: Signal<In, Bits<P>>,
    pub in_range: Signal<In, Bit>,
    pub gated: Signal<Out, Bits<P>>,
    pub register: DFF<Bits<P>>,
}

impl<const P: usize> Logic for GateStage<P> {
    #[hdl_gen]
    fn update(&mut self) {
        self.register.clock.next = self.clock.val();
        self.register.d.next = 0.into();
        if self.in_range.val() {
            self.register.d.next = self.power.val();
        }
        self.gated.next = self.register.q.val();
    }
}

/// `next = (first ? 0 : sum) + group`, modulo `2^S`.
#[derive(LogicBlock, Default)]
pub(crate) struct Accumulate<const W: usize, const S: usize> {
    pub group: Signal<In, Bits<W>>,
    pub sum: Signal<In, Bits<S>>,
    pub first: Signal<In, Bit>,
    pub next_sum: Signal<Out, Bits<S>>,
    wide_group: Signal<Local, Bits<S>>,
    kept: Signal<Local, Bits<S>>,
}

impl<const W: usize, const S: usize> Logic for Accumulate<W, S> {
    #[hdl_gen]
    fn update(&mut self) {
        self.wide_group.next = bit_cast::<S, W>(self.group.val());
        self.kept.next = self.sum.val();
        if self.first.val() {
            self.kept.next = 0.into();
        }
        self.next_sum.next = self.kept.val() + self.wide_group.val();
    }
}

/// A link of the result chain: this engine's sum where it is complete, else the word from the next engine.
#[derive(LogicBlock, Default)]
pub(crate) struct ResultLink<const S: usize> {
    pub done: Signal<In, Bit>,
    pub own: Signal<In, Bits<S>>,
    pub further: Signal<In, Bits<S>>,
    pub result: Signal<Out, Bits<S>>,
}

impl<const S: usize> Logic for ResultLink<S> {
    #[hdl_gen]
    fn update(&mut self) {
        self.result.next = self.further.val();
        if self.done.val() {
            self.result.next = self.own.val();
        }
    }
}
