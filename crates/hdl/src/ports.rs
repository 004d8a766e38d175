//! The ports: which cell gets which word of the streams, and which cells hold the results.
//!
//! Wires only, laid by the spec's topology: a cell's role says which coordinate and which channel
//! are its own, its quad says which lane.

use photoncube_spec::{Hypercube, Role};
use rust_hdl::core::ast::{VerilogExpression, VerilogLiteral, VerilogStatement};
use rust_hdl::prelude::*;

/// `N` cells, `G` lanes (photons of a group); `C` coordinate, `P` power, `S` sum bits.
#[derive(LogicBlock)]
pub(crate) struct Ports<
    const N: usize,
    const G: usize,
    const C: usize,
    const P: usize,
    const S: usize,
> {
    pub query_x: Signal<In, Bits<C>>,
    pub query_y: Signal<In, Bits<C>>,
    pub query_z: Signal<In, Bits<C>>,
    pub present: [Signal<In, Bit>; G],
    pub x: [Signal<In, Bits<C>>; G],
    pub y: [Signal<In, Bits<C>>; G],
    pub z: [Signal<In, Bits<C>>; G],
    pub red: [Signal<In, Bits<P>>; G],
    pub green: [Signal<In, Bits<P>>; G],
    pub blue: [Signal<In, Bits<P>>; G],
    pub sum: [Signal<In, Bits<S>>; N],
    pub cell_query: [Signal<Out, Bits<C>>; N],
    pub cell_photon: [Signal<Out, Bits<C>>; N],
    pub cell_present: [Signal<Out, Bit>; N],
    pub cell_power: [Signal<Out, Bits<P>>; N],
    pub result_red: Signal<Out, Bits<S>>,
    pub result_green: Signal<Out, Bits<S>>,
    pub result_blue: Signal<Out, Bits<S>>,
    pub result_count: Signal<Out, Bits<S>>,
    _cube: Hypercube,
}

impl<const N: usize, const G: usize, const C: usize, const P: usize, const S: usize>
    Ports<N, G, C, P, S>
{
    pub fn new(cube: Hypercube) -> Self {
        assert_eq!((N, G), (cube.nodes(), cube.photons()));
        Self {
            query_x: Default::default(),
            query_y: Default::default(),
            query_z: Default::default(),
            present: std::array::from_fn(|_| Default::default()),
            x: std::array::from_fn(|_| Default::default()),
            y: std::array::from_fn(|_| Default::default()),
            z: std::array::from_fn(|_| Default::default()),
            red: std::array::from_fn(|_| Default::default()),
            green: std::array::from_fn(|_| Default::default()),
            blue: std::array::from_fn(|_| Default::default()),
            sum: std::array::from_fn(|_| Default::default()),
            cell_query: std::array::from_fn(|_| Default::default()),
            cell_photon: std::array::from_fn(|_| Default::default()),
            cell_present: std::array::from_fn(|_| Default::default()),
            cell_power: std::array::from_fn(|_| Default::default()),
            result_red: Default::default(),
            result_green: Default::default(),
            result_blue: Default::default(),
            result_count: Default::default(),
            _cube: cube,
        }
    }
}

impl<const N: usize, const G: usize, const C: usize, const P: usize, const S: usize> Logic
    for Ports<N, G, C, P, S>
{
    fn update(&mut self) {
        for node in 0..N {
            let lane = self._cube.photon(node);
            let (query, photon, power) = match self._cube.role(node) {
                Role::X => (self.query_x.val(), self.x[lane].val(), self.red[lane].val()),
                Role::Y => (
                    self.query_y.val(),
                    self.y[lane].val(),
                    self.green[lane].val(),
                ),
                Role::Z => (
                    self.query_z.val(),
                    self.z[lane].val(),
                    self.blue[lane].val(),
                ),
                Role::D => (0.into(), 0.into(), 1.into()),
            };
            self.cell_query[node].next = query;
            self.cell_photon[node].next = photon;
            self.cell_present[node].next = self.present[lane].val();
            self.cell_power[node].next = power;
        }
        self.result_red.next = self.sum[self._cube.result_node(Role::X)].val();
        self.result_green.next = self.sum[self._cube.result_node(Role::Y)].val();
        self.result_blue.next = self.sum[self._cube.result_node(Role::Z)].val();
        self.result_count.next = self.sum[self._cube.result_node(Role::D)].val();
    }

    fn connect(&mut self) {
        for node in 0..N {
            self.cell_query[node].connect();
            self.cell_photon[node].connect();
            self.cell_present[node].connect();
            self.cell_power[node].connect();
        }
        self.result_red.connect();
        self.result_green.connect();
        self.result_blue.connect();
        self.result_count.connect();
    }

    fn hdl(&self) -> Verilog {
        let mut wires = Vec::new();
        for node in 0..N {
            let lane = self._cube.photon(node);
            let role = self._cube.role(node);
            let (query, photon, power) = match role {
                Role::X => (name("query_x"), word("x", lane), word("red", lane)),
                Role::Y => (name("query_y"), word("y", lane), word("green", lane)),
                Role::Z => (name("query_z"), word("z", lane), word("blue", lane)),
                Role::D => (number::<C>(0), number::<C>(0), number::<P>(1)),
            };
            wires.push(wire(word("cell_query", node), query));
            wires.push(wire(word("cell_photon", node), photon));
            wires.push(wire(word("cell_present", node), word("present", lane)));
            wires.push(wire(word("cell_power", node), power));
        }
        for role in Role::ALL {
            let result = format!("result_{}", role.channel().name());
            let node = self._cube.result_node(role);
            wires.push(wire(name(&result), word("sum", node)));
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

fn wire(target: VerilogExpression, source: VerilogExpression) -> VerilogStatement {
    VerilogStatement::Assignment(target, source)
}
