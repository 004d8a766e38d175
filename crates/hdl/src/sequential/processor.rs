//! The top block of a sequential machine: control block, ports, cells and network between valid/ready
//! streams.

use photoncube_spec::Machine;
use rust_hdl::prelude::*;

use super::cell::Cell;
use super::control::Control;
use super::network::Network;
use super::ports::Ports;
use crate::defaults::defaulted;

/// The processor. Widths: `C` query coordinate, `H` photon coordinate, `M` difference, `Q` square,
/// `R` radius_sq, `B` mantissa, `E` exponent, `P` power, `V` work, `S` sum; `A` address, `W` control
/// word, `X` axis; `N` cells, `G` lanes.
#[derive(LogicBlock)]
pub(crate) struct Processor<
    const C: usize,
    const H: usize,
    const M: usize,
    const Q: usize,
    const R: usize,
    const B: usize,
    const E: usize,
    const P: usize,
    const V: usize,
    const S: usize,
    const A: usize,
    const W: usize,
    const X: usize,
    const N: usize,
    const G: usize,
> {
    pub clock: Signal<In, Clock>,
    pub reset: Signal<In, Bit>,
    pub query_valid: Signal<In, Bit>,
    pub query_x: Signal<In, Bits<C>>,
    pub query_y: Signal<In, Bits<C>>,
    pub query_z: Signal<In, Bits<C>>,
    pub query_radius_sq: Signal<In, Bits<R>>,
    pub group_valid: Signal<In, Bit>,
    pub group_last: Signal<In, Bit>,
    pub photon_present: [Signal<In, Bit>; G],
    pub photon_x: [Signal<In, Bits<H>>; G],
    pub photon_y: [Signal<In, Bits<H>>; G],
    pub photon_z: [Signal<In, Bits<H>>; G],
    /// The mantissas, ordered as in [`Ports`]; `emit` renames them by channel.
    pub photon_channel: Vec<Signal<In, Bits<B>>>,
    pub photon_exponent: Vec<Signal<In, Bits<E>>>,
    pub result_ready: Signal<In, Bit>,
    pub query_ready: Signal<Out, Bit>,
    pub group_ready: Signal<Out, Bit>,
    pub result_valid: Signal<Out, Bit>,
    pub result: Vec<Signal<Out, Bits<S>>>,
    pub control: Control<A, W, X>,
    ports: Ports<N, G, C, H, B, E, P, S>,
    network: Network<N, V, X>,
    pub cell: [Cell<C, H, M, Q, R, P, V, S>; N],
}

impl<
    const C: usize,
    const H: usize,
    const M: usize,
    const Q: usize,
    const R: usize,
    const B: usize,
    const E: usize,
    const P: usize,
    const V: usize,
    const S: usize,
    const A: usize,
    const W: usize,
    const X: usize,
    const N: usize,
    const G: usize,
> Processor<C, H, M, Q, R, B, E, P, V, S, A, W, X, N, G>
{
    /// Builds the processor of a machine. The type's widths must be those of the machine.
    pub fn new(machine: &Machine) -> Self {
        let cube = machine.hypercube();
        let program = machine.microprogram().expect("a processor runs a program");
        let ports = Ports::new(cube, machine.channels());
        defaulted!(Self {
            photon_present: std::array::from_fn(|_| Default::default()),
            photon_x: std::array::from_fn(|_| Default::default()),
            photon_y: std::array::from_fn(|_| Default::default()),
            photon_z: std::array::from_fn(|_| Default::default()),
            photon_channel: ports.channel.iter().map(|_| Default::default()).collect(),
            photon_exponent: ports.exponent.iter().map(|_| Default::default()).collect(),
            result: ports.result.iter().map(|_| Default::default()).collect(),
            control: Control::new(&program, machine.dimension),
            ports,
            network: Network::new(cube),
            cell: std::array::from_fn(|_| Cell::new(machine.squarer)),
        };
            clock reset query_valid query_x query_y query_z query_radius_sq group_valid group_last result_ready
            query_ready group_ready result_valid
        )
    }
}

impl<
    const C: usize,
    const H: usize,
    const M: usize,
    const Q: usize,
    const R: usize,
    const B: usize,
    const E: usize,
    const P: usize,
    const V: usize,
    const S: usize,
    const A: usize,
    const W: usize,
    const X: usize,
    const N: usize,
    const G: usize,
> Logic for Processor<C, H, M, Q, R, B, E, P, V, S, A, W, X, N, G>
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

        self.ports.query_x.next = self.query_x.val();
        self.ports.query_y.next = self.query_y.val();
        self.ports.query_z.next = self.query_z.val();
        for g in 0..G {
            self.ports.present[g].next = self.photon_present[g].val();
            self.ports.x[g].next = self.photon_x[g].val();
            self.ports.y[g].next = self.photon_y[g].val();
            self.ports.z[g].next = self.photon_z[g].val();
        }
        for i in 0..self.photon_channel.len() {
            self.ports.channel[i].next = self.photon_channel[i].val();
        }
        for i in 0..self.photon_exponent.len() {
            self.ports.exponent[i].next = self.photon_exponent[i].val();
        }

        self.network.axis.next = self.control.axis.val();
        for i in 0..N {
            self.cell[i].clock.next = self.clock.val();
            self.cell[i].write_query.next = self.control.write_query.val();
            self.cell[i].write_photon.next = self.control.write_photon.val();
            self.cell[i].write_power.next = self.control.write_power.val();
            self.cell[i].write_work.next = self.control.write_work.val();
            self.cell[i].write_sum.next = self.control.write_sum.val();
            self.cell[i].work_source.next = self.control.work_source.val();
            self.cell[i].add_sum.next = self.control.add_sum.val();
            self.cell[i].query_in.next = self.ports.cell_query[i].val();
            self.cell[i].radius_sq_in.next = self.query_radius_sq.val();
            self.cell[i].photon_in.next = self.ports.cell_photon[i].val();
            self.cell[i].present_in.next = self.ports.cell_present[i].val();
            self.cell[i].power_in.next = self.ports.cell_power[i].val();
            self.network.work[i].next = self.cell[i].work_out.val();
            self.cell[i].link_in.next = self.network.link[i].val();
            self.ports.sum[i].next = self.cell[i].sum_out.val();
        }

        for i in 0..self.result.len() {
            self.result[i].next = self.ports.result[i].val();
        }
    }
}
