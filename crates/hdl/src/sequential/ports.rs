//! The ports of a sequential machine: they connect each cell to its words of the streams, and the result pins
//! to the cells that hold the results.
//!
//! The block consists of wires that follow the spec's topology. A cell's role selects its coordinate and its
//! channel, its quad selects the lane. A power with an exponent is decoded here, so that cells receive
//! decoded powers only.

use photoncube_spec::{Channels, Hypercube, Role};
use rust_hdl::core::ast::{VerilogExpression, VerilogLiteral, VerilogOp, VerilogStatement};
use rust_hdl::prelude::*;

use crate::defaults::signals;

/// `N` cells, `G` lanes (photons of a group); `C` query coordinate, `H` photon coordinate, `B`
/// mantissa, `E` exponent, `P` power, `S` sum bits.
#[derive(LogicBlock)]
pub(crate) struct Ports<
    const N: usize,
    const G: usize,
    const C: usize,
    const H: usize,
    const B: usize,
    const E: usize,
    const P: usize,
    const S: usize,
> {
    pub query_x: Signal<In, Bits<C>>,
    pub query_y: Signal<In, Bits<C>>,
    pub query_z: Signal<In, Bits<C>>,
    pub present: [Signal<In, Bit>; G],
    pub x: [Signal<In, Bits<H>>; G],
    pub y: [Signal<In, Bits<H>>; G],
    pub z: [Signal<In, Bits<H>>; G],
    /// The mantissas: the first channel of every lane, then the next channel. Channel c of lane g is at
    /// `c G + g`.
    pub channel: Vec<Signal<In, Bits<B>>>,
    /// One exponent for each lane; empty where powers have no exponent.
    pub exponent: Vec<Signal<In, Bits<E>>>,
    pub sum: [Signal<In, Bits<S>>; N],
    pub cell_query: [Signal<Out, Bits<C>>; N],
    pub cell_photon: [Signal<Out, Bits<H>>; N],
    pub cell_present: [Signal<Out, Bit>; N],
    pub cell_power: [Signal<Out, Bits<P>>; N],
    /// The sums of the channels, then the count of photons in range.
    pub result: Vec<Signal<Out, Bits<S>>>,
    _cube: Hypercube,
    _channels: usize,
    _result_nodes: Vec<usize>,
}

/// The value that the cells of a role add up.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
enum Summand {
    /// The power of the photons in that channel.
    Channel(usize),
    /// 1 for each photon.
    Count,
    /// The value 0, for roles beyond the number of channels.
    Nothing,
}

impl Summand {
    fn of(role: Role, channels: usize) -> Self {
        match role.coordinate() {
            None => Self::Count,
            Some(channel) if channel < channels => Self::Channel(channel),
            Some(_) => Self::Nothing,
        }
    }
}

impl<
    const N: usize,
    const G: usize,
    const C: usize,
    const H: usize,
    const B: usize,
    const E: usize,
    const P: usize,
    const S: usize,
> Ports<N, G, C, H, B, E, P, S>
{
    /// The query coordinate of a cell without a coordinate. The cell's photon coordinate is 0 and its
    /// distance must be 0, so this is the index at photon 0, or the index below the grid line of photon 0.
    const NO_QUERY: u64 = ((1 << (C - H)) - 1) / 2;

    pub fn new(cube: Hypercube, channels: Channels) -> Self {
        assert_eq!((N, G), (cube.nodes(), cube.photons()));
        assert!(B == P || E > 0, "only an exponent makes a power wider");
        let channels = channels.count() as usize;
        let exponents = if E > 0 { G } else { 0 };
        let sums = |role: &Role| Summand::of(*role, channels) != Summand::Nothing;
        let result_nodes: Vec<_> = Role::ALL
            .into_iter()
            .filter(sums)
            .map(|role| cube.result_node(role))
            .collect();
        Self {
            query_x: Default::default(),
            query_y: Default::default(),
            query_z: Default::default(),
            present: std::array::from_fn(|_| Default::default()),
            x: std::array::from_fn(|_| Default::default()),
            y: std::array::from_fn(|_| Default::default()),
            z: std::array::from_fn(|_| Default::default()),
            channel: signals(channels * G),
            exponent: signals(exponents),
            sum: std::array::from_fn(|_| Default::default()),
            cell_query: std::array::from_fn(|_| Default::default()),
            cell_photon: std::array::from_fn(|_| Default::default()),
            cell_present: std::array::from_fn(|_| Default::default()),
            cell_power: std::array::from_fn(|_| Default::default()),
            result: result_nodes.iter().map(|_| Default::default()).collect(),
            _cube: cube,
            _channels: channels,
            _result_nodes: result_nodes,
        }
    }

    fn summand(&self, node: usize) -> Summand {
        Summand::of(self._cube.role(node), self._channels)
    }

    fn power(&self, channel: usize, lane: usize) -> Bits<P> {
        let mantissa = bit_cast::<P, B>(self.channel[channel * G + lane].val());
        match self.exponent.get(lane) {
            None => mantissa,
            Some(exponent) => mantissa << exponent.val(),
        }
    }

    /// Decodes a power. The mantissa is widened before the shift, because a shift is as wide as its operand.
    fn power_wires(&self, node: usize) -> Vec<VerilogStatement> {
        let lane = self._cube.photon(node);
        let power = || word("cell_power", node);
        let mantissa = |channel| word("channel", channel * G + lane);
        match self.summand(node) {
            Summand::Count => vec![wire(power(), number::<P>(1))],
            Summand::Nothing => vec![wire(power(), number::<P>(0))],
            Summand::Channel(channel) if self.exponent.is_empty() => {
                vec![wire(power(), mantissa(channel))]
            }
            Summand::Channel(channel) => vec![
                wire(power(), widened::<P>(mantissa(channel))),
                wire(power(), shifted(power(), word("exponent", lane))),
            ],
        }
    }
}

impl<
    const N: usize,
    const G: usize,
    const C: usize,
    const H: usize,
    const B: usize,
    const E: usize,
    const P: usize,
    const S: usize,
> Logic for Ports<N, G, C, H, B, E, P, S>
{
    fn update(&mut self) {
        for node in 0..N {
            let lane = self._cube.photon(node);
            let (query, photon) = match self._cube.role(node) {
                Role::X => (self.query_x.val(), self.x[lane].val()),
                Role::Y => (self.query_y.val(), self.y[lane].val()),
                Role::Z => (self.query_z.val(), self.z[lane].val()),
                Role::D => (Self::NO_QUERY.to_bits(), 0.into()),
            };
            let power = match self.summand(node) {
                Summand::Channel(channel) => self.power(channel, lane),
                Summand::Count => 1.into(),
                Summand::Nothing => 0.into(),
            };
            self.cell_query[node].next = query;
            self.cell_photon[node].next = photon;
            self.cell_present[node].next = self.present[lane].val();
            self.cell_power[node].next = power;
        }
        for (result, &node) in self.result.iter_mut().zip(&self._result_nodes) {
            result.next = self.sum[node].val();
        }
    }

    fn connect(&mut self) {
        for node in 0..N {
            self.cell_query[node].connect();
            self.cell_photon[node].connect();
            self.cell_present[node].connect();
            self.cell_power[node].connect();
        }
        for result in &mut self.result {
            result.connect();
        }
    }

    fn hdl(&self) -> Verilog {
        let mut wires = Vec::new();
        for node in 0..N {
            let lane = self._cube.photon(node);
            let (query, photon) = match self._cube.role(node) {
                Role::X => (name("query_x"), word("x", lane)),
                Role::Y => (name("query_y"), word("y", lane)),
                Role::Z => (name("query_z"), word("z", lane)),
                Role::D => (number::<C>(Self::NO_QUERY), number::<H>(0)),
            };
            wires.push(wire(word("cell_query", node), query));
            wires.push(wire(word("cell_photon", node), photon));
            wires.push(wire(word("cell_present", node), word("present", lane)));
            wires.extend(self.power_wires(node));
        }
        for (index, &node) in self._result_nodes.iter().enumerate() {
            wires.push(wire(word("result", index), word("sum", node)));
        }
        Verilog::Combinatorial(wires)
    }
}

fn name(name: &str) -> VerilogExpression {
    VerilogExpression::Signal(name.to_owned())
}

fn word(array: &str, index: usize) -> VerilogExpression {
    name(&format!("{array}${index}"))
}

fn number<const W: usize>(value: u64) -> VerilogExpression {
    let bits: Bits<W> = value.to_bits();
    VerilogExpression::Literal(VerilogLiteral::from(bits))
}

fn widened<const W: usize>(value: VerilogExpression) -> VerilogExpression {
    VerilogExpression::Cast(Box::new(value), W)
}

fn shifted(value: VerilogExpression, places: VerilogExpression) -> VerilogExpression {
    VerilogExpression::Binary(Box::new(value), VerilogOp::Shl, Box::new(places))
}

fn wire(target: VerilogExpression, source: VerilogExpression) -> VerilogStatement {
    VerilogStatement::Assignment(target, source)
}
