//! The cell of an overlapped machine, whose units work at the same time.
//!
//! Every unit has its own registers at its output. In every clock the control word selects the registers that
//! are written and their sources; see `photoncube_spec::OVERLAPPED` for the words. The stages of the square
//! unit, the addend and the operand are written in every clock.

use rust_hdl::prelude::*;

use super::add::ChosenSum;
use super::decoder::Decoder;
use super::digits::Digits;
use crate::defaults::defaulted;
use crate::parts::Difference;

/// One cell. 8-bit coordinates; widths: `R` radius_sq, `P` power, `V` sums of squares, `S` sum, `W`
/// control word.
#[derive(LogicBlock)]
pub(crate) struct Cell<
    const R: usize,
    const P: usize,
    const V: usize,
    const S: usize,
    const W: usize,
> {
    pub clock: Signal<In, Clock>,
    pub word: Signal<In, Bits<W>>,
    pub write_query: Signal<In, Bit>,
    pub query_in: Signal<In, Bits<8>>,
    pub radius_sq_in: Signal<In, Bits<R>>,
    pub photon_in: Signal<In, Bits<8>>,
    pub present_in: Signal<In, Bit>,
    pub power_in: Signal<In, Bits<P>>,
    pub link_x: Signal<In, Bits<S>>,
    pub link_y: Signal<In, Bits<S>>,
    pub link_z: Signal<In, Bits<V>>,
    pub link_w: Signal<In, Bits<V>>,
    /// The word that is sent on x and on y.
    pub sum_out: Signal<Out, Bits<S>>,
    pub z_out: Signal<Out, Bits<V>>,
    pub w_out: Signal<Out, Bits<V>>,
    pub query: DFF<Bits<8>>,
    pub radius_sq: DFF<Bits<R>>,
    pub photon: DFF<Bits<8>>,
    pub magnitude: DFF<Bits<8>>,
    pub digit_squares: DFF<Bits<16>>,
    pub low_product: DFF<Bits<6>>,
    pub high_product: DFF<Bits<6>>,
    pub square: DFF<Bits<16>>,
    pub addend: DFF<Bits<16>>,
    pub operand: DFF<Bits<S>>,
    pub work: DFF<Bits<V>>,
    pub distance: DFF<Bits<V>>,
    pub in_range: DFF<Bit>,
    pub sum: DFF<Bits<S>>,
    pub power: [DFF<Bits<P>>; 8],
    pub present: [DFF<Bit>; 8],
    decoder: Decoder<W>,
    difference: Difference<8, 8, 8>,
    digits: Digits,
    chosen_sum: ChosenSum<V, S>,
    wide_low: Signal<Local, Bits<16>>,
    wide_high: Signal<Local, Bits<16>>,
    shifted_low: Signal<Local, Bits<16>>,
    shifted_high: Signal<Local, Bits<16>>,
    products: Signal<Local, Bits<16>>,
    new_square: Signal<Local, Bits<16>>,
    wide_square: Signal<Local, Bits<V>>,
    from_x: Signal<Local, Bits<S>>,
    from_y: Signal<Local, Bits<S>>,
    from_z: Signal<Local, Bits<V>>,
    from_w: Signal<Local, Bits<V>>,
    wide_radius_sq: Signal<Local, Bits<V>>,
    in_range_now: Signal<Local, Bit>,
    is_there: Signal<Local, Bit>,
    opens: Signal<Local, Bit>,
    wide_power: Signal<Local, Bits<V>>,
    from_gate: Signal<Local, Bits<V>>,
    from_role_axes: Signal<Local, Bits<V>>,
    from_photon_axes: Signal<Local, Bits<S>>,
    from_quad: Signal<Local, Bits<V>>,
    wide_from_quad: Signal<Local, Bits<S>>,
}

impl<const R: usize, const P: usize, const V: usize, const S: usize, const W: usize> Default
    for Cell<R, P, V, S, W>
{
    fn default() -> Self {
        assert!(16 <= V && R <= V && P <= V && V <= S && S <= 64);
        defaulted!(Self {
            decoder: Decoder::new(4),
        };
            clock word write_query query_in radius_sq_in photon_in present_in power_in link_x link_y link_z
            link_w sum_out z_out w_out query radius_sq photon magnitude digit_squares low_product high_product
            square addend operand work distance in_range sum power present difference digits chosen_sum wide_low
            wide_high shifted_low shifted_high products new_square wide_square from_x from_y from_z from_w
            wide_radius_sq in_range_now is_there opens wide_power from_gate from_role_axes from_photon_axes
            from_quad wide_from_quad
        )
    }
}

impl<const R: usize, const P: usize, const V: usize, const S: usize, const W: usize> Logic
    for Cell<R, P, V, S, W>
{
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(
            self,
            clock,
            query,
            radius_sq,
            photon,
            magnitude,
            digit_squares,
            low_product,
            high_product,
            square,
            addend,
            operand,
            work,
            distance,
            in_range,
            sum
        );
        for i in 0..8 {
            self.power[i].clock.next = self.clock.val();
            self.power[i].d.next = self.power[i].q.val();
            self.present[i].clock.next = self.clock.val();
            self.present[i].d.next = self.present[i].q.val();
        }
        self.decoder.word.next = self.word.val();

        // The square unit: the difference, its digits, the sum of their squares and products.
        self.difference.a.next = self.query.q.val();
        self.difference.b.next = self.photon.q.val();
        self.magnitude.d.next = self.difference.magnitude.val();
        self.digits.root.next = self.magnitude.q.val();
        self.digit_squares.d.next = self.digits.squares.val();
        self.low_product.d.next = self.digits.low_product.val();
        self.high_product.d.next = self.digits.high_product.val();
        self.wide_low.next = bit_cast::<16, 6>(self.low_product.q.val());
        self.wide_high.next = bit_cast::<16, 6>(self.high_product.q.val());
        self.shifted_low.next = self.wide_low.val() << 5;
        self.shifted_high.next = self.wide_high.val() << 7;
        self.products.next = self.shifted_low.val() + self.shifted_high.val();
        self.new_square.next = self.digit_squares.q.val() + self.products.val();
        if self.decoder.write_square.val() {
            self.square.d.next = self.new_square.val();
        }
        self.addend.d.next = self.square.q.val();
        self.wide_square.next = bit_cast::<V, 16>(self.square.q.val());

        // The gate compares in one clock and gates in the next. `>=` of these operands is the carry of one
        // subtraction; `>` would need that and a comparison with 0.
        self.wide_radius_sq.next = bit_cast::<V, R>(self.radius_sq.q.val());
        self.in_range_now.next = self.wide_radius_sq.val() >= self.distance.q.val();
        self.in_range.d.next = self.in_range_now.val();
        self.is_there.next = self.in_range.q.val() & self.present[7].q.val();
        self.opens.next = self.is_there.val() & self.decoder.gate.val();
        self.wide_power.next = bit_cast::<V, P>(self.power[7].q.val());

        // The operand: sources that are not selected are 0, so the selection is an OR.
        self.from_gate.next = 0.into();
        if self.opens.val() {
            self.from_gate.next = self.wide_power.val();
        }
        self.from_x.next = 0.into();
        if self.decoder.axis.val().get_bit(0) {
            self.from_x.next = self.link_x.val();
        }
        self.from_y.next = 0.into();
        if self.decoder.axis.val().get_bit(1) {
            self.from_y.next = self.link_y.val();
        }
        self.from_z.next = 0.into();
        if self.decoder.axis.val().get_bit(2) {
            self.from_z.next = self.link_z.val();
        }
        self.from_w.next = 0.into();
        if self.decoder.axis.val().get_bit(3) {
            self.from_w.next = self.link_w.val();
        }
        self.from_role_axes.next = self.from_z.val() | self.from_w.val();
        self.from_photon_axes.next = self.from_x.val() | self.from_y.val();
        self.from_quad.next = self.from_role_axes.val() | self.from_gate.val();
        self.wide_from_quad.next = bit_cast::<S, V>(self.from_quad.val());
        self.operand.d.next = self.from_photon_axes.val() | self.wide_from_quad.val();

        self.chosen_sum.sum.next = self.sum.q.val();
        self.chosen_sum.sum_low.next = bit_cast::<V, S>(self.sum.q.val());
        self.chosen_sum.addend.next = self.addend.q.val();
        self.chosen_sum.operand.next = self.operand.q.val();
        self.chosen_sum.add_sum.next = self.decoder.add_sum.val();
        if self.decoder.write_work.val() {
            self.work.d.next = bit_cast::<V, S>(self.chosen_sum.total.val());
        }
        if self.decoder.write_sum.val() {
            self.sum.d.next = self.chosen_sum.total.val();
        }
        if self.decoder.write_distance.val() {
            match self.decoder.distance_source.val().index() {
                0 => {
                    self.distance.d.next = self.work.q.val();
                }
                1 => {
                    self.distance.d.next = self.link_z.val();
                }
                _ => {
                    self.distance.d.next = self.link_w.val();
                }
            }
        }

        if self.decoder.write_photon.val() {
            self.photon.d.next = self.photon_in.val();
        }
        if self.decoder.write_power.val() {
            self.power[0].d.next = self.power_in.val();
            self.present[0].d.next = self.present_in.val();
        }
        for i in 0..7 {
            if self.decoder.move_power.val().get_bit(i) {
                self.power[i + 1].d.next = self.power[i].q.val();
                self.present[i + 1].d.next = self.present[i].q.val();
            }
        }

        // Results that are still in flight when a query is taken do not belong to it.
        if self.write_query.val() {
            self.query.d.next = self.query_in.val();
            self.radius_sq.d.next = self.radius_sq_in.val();
            self.sum.d.next = 0.into();
            for i in 0..8 {
                self.present[i].d.next = false;
            }
        }

        self.sum_out.next = self.sum.q.val();
        self.z_out.next = self.wide_square.val();
        if self.decoder.send_work.val() {
            self.z_out.next = self.work.q.val();
        }
        self.w_out.next = self.work.q.val();
        if self.decoder.send_distance.val() {
            self.w_out.next = self.distance.q.val();
        }
    }
}
