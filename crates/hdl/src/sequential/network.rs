//! The hypercube network: every cell receives the work register of its neighbour on the selected axis.
//!
//! A rust-hdl kernel has no form for `i ^ (1 << k)`, so this block builds its simulation and its Verilog in
//! two loops over the spec's topology.

use photoncube_spec::Hypercube;
use rust_hdl::core::ast::{
    VerilogBlockOrConditional, VerilogConditional, VerilogExpression, VerilogLiteral, VerilogOp,
    VerilogStatement,
};
use rust_hdl::prelude::*;

/// `link[i]` is the `work` input of cell i's neighbour on the selected axis, for `N` cells and `X` axes. It
/// is 0 if no axis is selected, and the OR of the neighbours if several are; no control word selects several.
#[derive(LogicBlock)]
pub(crate) struct Network<const N: usize, const V: usize, const X: usize> {
    pub axis: Signal<In, Bits<X>>,
    pub work: [Signal<In, Bits<V>>; N],
    pub link: [Signal<Out, Bits<V>>; N],
    _cube: Hypercube,
}

impl<const N: usize, const V: usize, const X: usize> Network<N, V, X> {
    pub fn new(cube: Hypercube) -> Self {
        assert_eq!((N, X), (cube.nodes(), cube.dimension() as usize));
        Self {
            axis: Default::default(),
            work: std::array::from_fn(|_| Default::default()),
            link: std::array::from_fn(|_| Default::default()),
            _cube: cube,
        }
    }
}

impl<const N: usize, const V: usize, const X: usize> Logic for Network<N, V, X> {
    fn update(&mut self) {
        let cube = self._cube;
        let selected = self.axis.val();
        for node in 0..N {
            let mut link: Bits<V> = 0.into();
            for axis in cube.axes() {
                if selected.get_bit(axis.bit() as usize) {
                    link = link | self.work[cube.neighbour(node, axis)].val();
                }
            }
            self.link[node].next = link;
        }
    }

    fn connect(&mut self) {
        for link in &mut self.link {
            link.connect();
        }
    }

    fn hdl(&self) -> Verilog {
        let none: Bits<V> = 0.into();
        let clear = (0..N).map(|node| assign(link(node), VerilogExpression::Literal(none.into())));
        let select = self._cube.axes().map(|axis| {
            let heard = |node| {
                let neighbour = signal("work", self._cube.neighbour(node, axis));
                let either = [link(node), neighbour].map(Box::new);
                let [heard, neighbour] = either;
                assign(
                    link(node),
                    VerilogExpression::Binary(heard, VerilogOp::BitOr, neighbour),
                )
            };
            VerilogStatement::If(VerilogConditional {
                test: VerilogExpression::Index(
                    Box::new(VerilogExpression::Signal("axis".to_owned())),
                    Box::new(VerilogExpression::Literal(VerilogLiteral::from(axis.bit()))),
                ),
                then: (0..N).map(heard).collect(),
                otherwise: VerilogBlockOrConditional::None,
            })
        });
        Verilog::Combinatorial(clear.chain(select).collect())
    }
}

fn signal(array: &str, index: usize) -> VerilogExpression {
    VerilogExpression::Signal(format!("{array}${index}"))
}

fn link(node: usize) -> VerilogExpression {
    signal("link", node)
}

fn assign(target: VerilogExpression, source: VerilogExpression) -> VerilogStatement {
    VerilogStatement::Assignment(target, source)
}
