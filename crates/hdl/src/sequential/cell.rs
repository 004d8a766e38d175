//! The reconfigurable cell: register file, operand multiplexers, three units.
//!
//! The cell is figure 2 of Ryu, Kim, Lee. In every clock the control word selects the registers that are
//! written and the operands of the units; see `photoncube_spec::SEQUENTIAL` for the meaning of the ops.

use photoncube_spec::Squarer;
use rust_hdl::prelude::*;

use super::units::{AddUnit, GateUnit, SquareUnit};
use crate::defaults::defaulted;
use crate::pinned::{Word, sample};

/// One cell. Widths: `C` query coordinate, `H` photon coordinate, `M` their difference, `Q = 2 M`
/// its square, `R` radius_sq, `P` power, `V` work and link, `S` sum.
#[derive(LogicBlock)]
pub(crate) struct Cell<
    const C: usize,
    const H: usize,
    const M: usize,
    const Q: usize,
    const R: usize,
    const P: usize,
    const V: usize,
    const S: usize,
> {
    pub clock: Signal<In, Clock>,
    pub write_query: Signal<In, Bit>,
    pub write_photon: Signal<In, Bit>,
    pub write_power: Signal<In, Bit>,
    pub write_work: Signal<In, Bit>,
    pub write_sum: Signal<In, Bit>,
    pub work_source: Signal<In, Bits<2>>,
    pub add_sum: Signal<In, Bit>,
    pub query_in: Signal<In, Bits<C>>,
    pub radius_sq_in: Signal<In, Bits<R>>,
    pub photon_in: Signal<In, Bits<H>>,
    pub present_in: Signal<In, Bit>,
    pub power_in: Signal<In, Bits<P>>,
    pub link_in: Signal<In, Bits<V>>,
    pub work_out: Signal<Out, Bits<V>>,
    pub sum_out: Signal<Out, Bits<S>>,
    pub query: DFF<Bits<C>>,
    pub radius_sq: DFF<Bits<R>>,
    pub photon: DFF<Bits<H>>,
    pub power: DFF<Bits<P>>,
    pub work: DFF<Bits<V>>,
    pub sum: DFF<Bits<S>>,
    square_unit: SquareUnit<C, H, M, Q>,
    gate_unit: GateUnit<V, R, P>,
    add_unit: AddUnit<S>,
    addend: Signal<Local, Bits<V>>,
    sum_low: Signal<Local, Bits<V>>,
    sum_high: Signal<Local, Bits<S>>,
    wide_addend: Signal<Local, Bits<S>>,
    high_bits: Constant<Bits<S>>,
}

impl<
    const C: usize,
    const H: usize,
    const M: usize,
    const Q: usize,
    const R: usize,
    const P: usize,
    const V: usize,
    const S: usize,
> Cell<C, H, M, Q, R, P, V, S>
{
    pub fn new(squarer: Squarer) -> Self {
        assert!(Q == 2 * M && Q <= V && R <= V && P <= V && V <= S && S <= 64);
        let high_bits = (u64::MAX >> (64 - S)) & !(u64::MAX >> (64 - V));
        defaulted!(Self {
            square_unit: SquareUnit::new(squarer),
            high_bits: Constant::new(high_bits.to_bits()),
        };
            clock write_query write_photon write_power write_work write_sum work_source add_sum query_in
            radius_sq_in photon_in present_in power_in link_in work_out sum_out query radius_sq photon power
            work sum gate_unit add_unit addend sum_low sum_high wide_addend
        )
    }

    /// Appends the values of the registers, in the order of the spec.
    pub fn sample_registers(&self, row: &mut Vec<u64>) {
        sample!(self, row: query.q, radius_sq.q, photon.q, power.q, work.q, sum.q);
    }
}

impl<
    const C: usize,
    const H: usize,
    const M: usize,
    const Q: usize,
    const R: usize,
    const P: usize,
    const V: usize,
    const S: usize,
> Logic for Cell<C, H, M, Q, R, P, V, S>
{
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, query, radius_sq, photon, power, work, sum);
        self.square_unit.a.next = self.query.q.val();
        self.square_unit.b.next = self.photon.q.val();
        self.gate_unit.a.next = self.work.q.val();
        self.gate_unit.b.next = self.radius_sq.q.val();
        self.gate_unit.power.next = self.power.q.val();

        // A is the work register. B is the link or the sum. The link is 0 where the control word selects no
        // axis, so the choice is an OR. Above the link's width B is always the sum, because a result of that
        // width is stored only in the sum.
        self.sum_low.next = 0.into();
        if self.add_sum.val() {
            self.sum_low.next = bit_cast::<V, S>(self.sum.q.val());
        }
        self.addend.next = self.link_in.val() | self.sum_low.val();
        self.sum_high.next = self.sum.q.val() & self.high_bits.val();
        self.wide_addend.next = bit_cast::<S, V>(self.addend.val());
        self.add_unit.a.next = bit_cast::<S, V>(self.work.q.val());
        self.add_unit.b.next = self.sum_high.val() | self.wide_addend.val();

        if self.write_query.val() {
            self.query.d.next = self.query_in.val();
            self.radius_sq.d.next = self.radius_sq_in.val();
            self.sum.d.next = 0.into();
        }
        if self.write_photon.val() {
            self.photon.d.next = self.photon_in.val();
        }
        if self.write_power.val() {
            self.power.d.next = self.power_in.val();
            if !self.present_in.val() {
                self.power.d.next = 0.into();
            }
        }
        if self.write_work.val() {
            match self.work_source.val().index() {
                0 => {
                    self.work.d.next = bit_cast::<V, Q>(self.square_unit.square.val());
                }
                1 => {
                    self.work.d.next = bit_cast::<V, S>(self.add_unit.sum.val());
                }
                _ => {
                    self.work.d.next = self.gate_unit.gated.val();
                }
            }
        }
        if self.write_sum.val() {
            self.sum.d.next = self.add_unit.sum.val();
        }
        self.work_out.next = self.work.q.val();
        self.sum_out.next = self.sum.q.val();
    }
}
