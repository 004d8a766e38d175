//! The top block of an overlapped machine: control block, cells and links between valid/ready streams.
//!
//! The links are wires: a cell's neighbour on the axis of index bit b is `i + B - 2 B ((i / B) % 2)` with
//! `B = 2^b`. Cells 0 to 3 are the X cells of the four quads; the Y, Z and D cells follow.

use photoncube_spec::Machine;
use rust_hdl::prelude::*;

use super::cell::Cell;
use super::control::Control;
use crate::defaults::defaulted;

/// The processor: 16 cells, 8-bit coordinates. Widths: `R` radius_sq, `P` power, `V` sums of
/// squares, `S` sum; `A` address, `D` drain, `W` control word.
#[derive(LogicBlock)]
pub(crate) struct Processor<
    const R: usize,
    const P: usize,
    const V: usize,
    const S: usize,
    const A: usize,
    const D: usize,
    const W: usize,
> {
    pub clock: Signal<In, Clock>,
    pub reset: Signal<In, Bit>,
    pub query_valid: Signal<In, Bit>,
    pub query_x: Signal<In, Bits<8>>,
    pub query_y: Signal<In, Bits<8>>,
    pub query_z: Signal<In, Bits<8>>,
    pub query_radius_sq: Signal<In, Bits<R>>,
    pub group_valid: Signal<In, Bit>,
    pub group_last: Signal<In, Bit>,
    pub photon_present: [Signal<In, Bit>; 4],
    pub photon_x: [Signal<In, Bits<8>>; 4],
    pub photon_y: [Signal<In, Bits<8>>; 4],
    pub photon_z: [Signal<In, Bits<8>>; 4],
    pub photon_red: [Signal<In, Bits<P>>; 4],
    pub photon_green: [Signal<In, Bits<P>>; 4],
    pub photon_blue: [Signal<In, Bits<P>>; 4],
    pub result_ready: Signal<In, Bit>,
    pub query_ready: Signal<Out, Bit>,
    pub group_ready: Signal<Out, Bit>,
    pub result_valid: Signal<Out, Bit>,
    pub result_red: Signal<Out, Bits<S>>,
    pub result_green: Signal<Out, Bits<S>>,
    pub result_blue: Signal<Out, Bits<S>>,
    pub result_count: Signal<Out, Bits<S>>,
    pub control: Control<A, D, W>,
    pub cell: [Cell<R, P, V, S, W>; 16],
    /// A photon is present in the lane, and its group is taken.
    present: [Signal<Local, Bit>; 4],
    /// The power of a photon in the counting channel, which is 1.
    one: Constant<Bits<P>>,
}

impl<
    const R: usize,
    const P: usize,
    const V: usize,
    const S: usize,
    const A: usize,
    const D: usize,
    const W: usize,
> Processor<R, P, V, S, A, D, W>
{
    /// Builds the processor of a machine. The type's widths must be those of the machine.
    pub fn new(machine: &Machine) -> Self {
        let program = machine
            .overlap_program()
            .expect("the machine's units overlap");
        defaulted!(Self {
            control: Control::new(&program),
            one: Constant::new(1.into()),
        };
            clock reset query_valid query_x query_y query_z query_radius_sq group_valid group_last
            photon_present photon_x photon_y photon_z photon_red photon_green photon_blue result_ready
            query_ready group_ready result_valid result_red result_green result_blue result_count cell present
        )
    }
}

impl<
    const R: usize,
    const P: usize,
    const V: usize,
    const S: usize,
    const A: usize,
    const D: usize,
    const W: usize,
> Logic for Processor<R, P, V, S, A, D, W>
{
    #[hdl_gen]
    fn update(&mut self) {
        self.control.clock.next = self.clock.val();
        self.control.reset.next = self.reset.val();
        self.control.query_valid.next = self.query_valid.val();
        self.control.group_valid.next = self.group_valid.val();
        self.control.group_last.next = self.group_last.val();
        self.control.result_ready.next = self.result_ready.val();
        self.query_ready.next = self.control.query_ready.val();
        self.group_ready.next = self.control.group_ready.val();
        self.result_valid.next = self.control.result_valid.val();

        for i in 0..16 {
            self.cell[i].clock.next = self.clock.val();
            self.cell[i].write_query.next = self.control.write_query.val();
            self.cell[i].radius_sq_in.next = self.query_radius_sq.val();
            self.cell[i].link_x.next = self.cell[i + 1 - 2 * (i % 2)].sum_out.val();
            self.cell[i].link_y.next = self.cell[i + 2 - 4 * ((i / 2) % 2)].sum_out.val();
            self.cell[i].link_z.next = self.cell[i + 4 - 8 * ((i / 4) % 2)].z_out.val();
            self.cell[i].link_w.next = self.cell[i + 8 - 16 * ((i / 8) % 2)].w_out.val();
        }
        for i in 0..4 {
            self.present[i].next = self.control.group_taken.val() & self.photon_present[i].val();

            self.cell[i].word.next = self.control.to_x.val();
            self.cell[i].query_in.next = self.query_x.val();
            self.cell[i].photon_in.next = self.photon_x[i].val();
            self.cell[i].power_in.next = self.photon_red[i].val();
            self.cell[i].present_in.next = self.present[i].val();

            self.cell[i + 4].word.next = self.control.to_y.val();
            self.cell[i + 4].query_in.next = self.query_y.val();
            self.cell[i + 4].photon_in.next = self.photon_y[i].val();
            self.cell[i + 4].power_in.next = self.photon_green[i].val();
            self.cell[i + 4].present_in.next = self.present[i].val();

            self.cell[i + 8].word.next = self.control.to_z.val();
            self.cell[i + 8].query_in.next = self.query_z.val();
            self.cell[i + 8].photon_in.next = self.photon_z[i].val();
            self.cell[i + 8].power_in.next = self.photon_blue[i].val();
            self.cell[i + 8].present_in.next = self.present[i].val();

            self.cell[i + 12].word.next = self.control.to_d.val();
            self.cell[i + 12].query_in.next = self.query_z.val();
            self.cell[i + 12].photon_in.next = self.photon_z[i].val();
            self.cell[i + 12].power_in.next = self.one.val();
            self.cell[i + 12].present_in.next = self.present[i].val();
        }
        self.result_red.next = self.cell[0].sum_out.val();
        self.result_green.next = self.cell[4].sum_out.val();
        self.result_blue.next = self.cell[8].sum_out.val();
        self.result_count.next = self.cell[12].sum_out.val();
    }
}
