//! The sums of one channel, from the hop register to the result chain.

use photoncube_spec::{Cut, Cuts, Spatial};
use rust_hdl::prelude::*;

use super::arithmetic::{Accumulate, GateStage, GatedSum, ResultLink, Sum};
use super::copy::RegisterCopy;
use super::stage::Stage;
use super::wiring::{Wires, Wiring, logic_of_wires, wires, with_wires};
use crate::defaults::{defaulted, signals};

const LANES: usize = Spatial::LANES;
const PAIRS: usize = LANES / 2;

/// Sums one channel's powers, or the photons' presence, whose sum is the count. Widths: `P` power,
/// `PP = P + 1` of a pair, `GP = P + 2` of a group, `S` sum.
#[derive(LogicBlock)]
pub(crate) struct ChannelSum<const P: usize, const PP: usize, const GP: usize, const S: usize> {
    pub clock: Signal<In, Clock>,
    pub power_in: [Signal<In, Bits<P>>; LANES],
    pub power: [Signal<Out, Bits<P>>; LANES],
    pub in_range: [Signal<In, Bit>; LANES],
    /// The group beside the sum is the first of its batch.
    pub first: Signal<In, Bit>,
    /// The sum of the query is complete.
    pub done: Signal<In, Bit>,
    pub result_in: Signal<In, Bits<S>>,
    pub result_out: Signal<Out, Bits<S>>,
    pub hop: Vec<Stage<Bits<P>>>,
    /// Copies of the in-range flags beside this sum.
    pub decision: Vec<RegisterCopy>,
    /// The gate: with registers behind it and separate adders, or with the adders in the gate's block.
    pub gate: Vec<GateStage<P>>,
    pair_sum: Vec<Sum<P, P, PP>>,
    gated_sum: Vec<GatedSum<P, PP>>,
    pub pair: Vec<Stage<Bits<PP>>>,
    group_sum: Sum<PP, PP, GP>,
    pub group: Stage<Bits<GP>>,
    accumulate: Accumulate<GP, S>,
    pub sum: Stage<Bits<S>>,
    result_link: ResultLink<S>,
    pub result: Stage<Bits<S>>,
    _wires: Wires,
}

impl<const P: usize, const PP: usize, const GP: usize, const S: usize> ChannelSum<P, PP, GP, S> {
    pub fn new(cuts: Cuts) -> Self {
        assert!(PP == P + 1 && GP == P + 2 && S >= GP);
        let gate_stages = if cuts.has(Cut::Gate) { LANES } else { 0 };
        let decisions = if cuts.has(Cut::Decision) { LANES } else { 0 };
        let behind_gate = if cuts.has(Cut::Gate) { PAIRS } else { 0 };
        with_wires!(defaulted!(Self {
            hop: Stage::several(LANES, true),
            decision: signals(decisions),
            gate: signals(gate_stages),
            pair_sum: signals(behind_gate),
            gated_sum: (behind_gate..PAIRS).map(|_| Default::default()).collect(),
            pair: Stage::several(PAIRS, cuts.has(Cut::PairPower)),
            group: Stage::new(cuts.has(Cut::GroupPower)),
            sum: Stage::new(true),
            result: Stage::new(true),
        };
            clock power_in power in_range first done result_in result_out group_sum accumulate result_link
            _wires
        ))
    }

    fn wires(&mut self, wiring: &mut Wiring) {
        for lane in 0..LANES {
            wires!(self, wiring:
                (hop[lane].clock) = (clock);
                (hop[lane].d) = (power_in[lane]);
                (power[lane]) = (hop[lane].q);
            );
        }
        for lane in 0..self.decision.len() {
            wires!(self, wiring:
                (decision[lane].clock) = (clock);
                (decision[lane].d) = (in_range[lane]);
            );
        }
        for lane in 0..self.gate.len() {
            wires!(self, wiring:
                (gate[lane].clock) = (clock);
                (gate[lane].power) = (hop[lane].q);
            );
            match self.decision.is_empty() {
                true => wires!(self, wiring: (gate[lane].in_range) = (in_range[lane]);),
                false => wires!(self, wiring: (gate[lane].in_range) = (decision[lane].q);),
            }
        }
        for pair in 0..self.pair_sum.len() {
            wires!(self, wiring:
                (pair_sum[pair].a) = (gate[2 * pair].gated);
                (pair_sum[pair].b) = (gate[2 * pair + 1].gated);
                (pair[pair].d) = (pair_sum[pair].sum);
            );
        }
        for pair in 0..self.gated_sum.len() {
            wires!(self, wiring:
                (gated_sum[pair].a) = (hop[2 * pair].q);
                (gated_sum[pair].b) = (hop[2 * pair + 1].q);
            );
            if self.decision.is_empty() {
                wires!(self, wiring:
                    (gated_sum[pair].a_in_range) = (in_range[2 * pair]);
                    (gated_sum[pair].b_in_range) = (in_range[2 * pair + 1]);
                );
            } else {
                wires!(self, wiring:
                    (gated_sum[pair].a_in_range) = (decision[2 * pair].q);
                    (gated_sum[pair].b_in_range) = (decision[2 * pair + 1].q);
                );
            }
            wires!(self, wiring: (pair[pair].d) = (gated_sum[pair].sum););
        }
        wires!(self, wiring:
            (pair[0].clock) = (clock);
            (pair[1].clock) = (clock);
            (group_sum.a) = (pair[0].q);
            (group_sum.b) = (pair[1].q);
            (group.clock) = (clock);
            (group.d) = (group_sum.sum);
            (accumulate.group) = (group.q);
            (accumulate.sum) = (sum.q);
            (accumulate.first) = (first);
            (sum.clock) = (clock);
            (sum.d) = (accumulate.next_sum);
            (result_link.done) = (done);
            (result_link.own) = (sum.q);
            (result_link.further) = (result_in);
            (result.clock) = (clock);
            (result.d) = (result_link.result);
            (result_out) = (result.q);
        );
    }
}

logic_of_wires!(ChannelSum<P, PP, GP, S>);
