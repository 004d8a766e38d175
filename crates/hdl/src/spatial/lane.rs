//! A lane: from the squares of one photon's differences to its in-range flag.

use photoncube_spec::{Cut, Cuts};
use rust_hdl::prelude::*;

use super::arithmetic::{AnyFar, RangeOfFormat, RangeOfQuery, Sum};
use super::stage::Stage;
use super::wiring::{Wires, Wiring, logic_of_wires, wires, with_wires};
use crate::defaults::defaulted;

/// The D cell of one photon. Widths: `Q` square, `T = Q + 1` pair, `U = Q + 2` distance.
#[derive(LogicBlock)]
pub(crate) struct Lane<const Q: usize, const T: usize, const U: usize> {
    pub clock: Signal<In, Clock>,
    /// The squares on x, y, z.
    pub axis_square: [Signal<In, Bits<Q>>; 3],
    pub axis_far: [Signal<In, Bit>; 3],
    /// One squared radius; empty where distances are compared with the format's.
    pub radius_sq: Vec<Signal<In, Bits<Q>>>,
    pub photon_in_range: Signal<Out, Bit>,
    any_far: AnyFar,
    pair_sum: Sum<Q, Q, T>,
    pub pair_square: Stage<Bits<T>>,
    pub pair_z: Stage<Bits<Q>>,
    pub pair_far: Stage<Bit>,
    distance_sum: Sum<T, Q, U>,
    pub distance: Stage<Bits<U>>,
    pub distance_far: Stage<Bit>,
    range_of_query: Vec<RangeOfQuery<Q, U>>,
    range_of_format: Vec<RangeOfFormat<U>>,
    pub in_range: Stage<Bit>,
    pub range_wait: Vec<Stage<Bit>>,
    pub range_delay: Vec<Stage<Bit>>,
    _wires: Wires,
}

impl<const Q: usize, const T: usize, const U: usize> Lane<Q, T, U> {
    /// Builds a lane whose in-range flag is delayed by `range_waits` clocks. `fixed_radius_sq` is the
    /// format's squared radius, where queries have none.
    pub fn new(cuts: Cuts, range_waits: usize, fixed_radius_sq: Option<u32>) -> Self {
        assert!(T == Q + 1 && U == Q + 2);
        let own_radius = 0..usize::from(fixed_radius_sq.is_none());
        with_wires!(defaulted!(Self {
            radius_sq: own_radius.clone().map(|_| Default::default()).collect(),
            pair_square: Stage::new(cuts.has(Cut::Pair)),
            pair_z: Stage::new(cuts.has(Cut::Pair)),
            pair_far: Stage::new(cuts.has(Cut::Pair)),
            distance: Stage::new(cuts.has(Cut::Distance)),
            distance_far: Stage::new(cuts.has(Cut::Distance)),
            range_of_query: own_radius.map(|_| Default::default()).collect(),
            range_of_format: fixed_radius_sq
                .map(RangeOfFormat::new)
                .into_iter()
                .collect(),
            in_range: Stage::new(cuts.has(Cut::Range)),
            range_wait: Stage::several(range_waits, true),
            range_delay: Stage::several(cuts.has(Cut::RangeDelay).into(), true),
        };
            clock axis_square axis_far photon_in_range any_far pair_sum distance_sum _wires
        ))
    }

    fn wires(&mut self, wiring: &mut Wiring) {
        wires!(self, wiring:
            (pair_square.clock) = (clock);
            (pair_z.clock) = (clock);
            (pair_far.clock) = (clock);
            (distance.clock) = (clock);
            (distance_far.clock) = (clock);
            (in_range.clock) = (clock);
            (any_far.x) = (axis_far[0]);
            (any_far.y) = (axis_far[1]);
            (any_far.z) = (axis_far[2]);
            (pair_sum.a) = (axis_square[0]);
            (pair_sum.b) = (axis_square[1]);
            (pair_square.d) = (pair_sum.sum);
            (pair_z.d) = (axis_square[2]);
            (pair_far.d) = (any_far.any);
            (distance_sum.a) = (pair_square.q);
            (distance_sum.b) = (pair_z.q);
            (distance.d) = (distance_sum.sum);
            (distance_far.d) = (pair_far.q);
        );
        for range in 0..self.range_of_query.len() {
            wires!(self, wiring:
                (range_of_query[range].distance) = (distance.q);
                (range_of_query[range].far) = (distance_far.q);
                (range_of_query[range].largest) = (radius_sq[range]);
                (in_range.d) = (range_of_query[range].in_range);
            );
        }
        for range in 0..self.range_of_format.len() {
            wires!(self, wiring:
                (range_of_format[range].distance) = (distance.q);
                (range_of_format[range].far) = (distance_far.q);
                (in_range.d) = (range_of_format[range].in_range);
            );
        }
        for wait in 0..self.range_wait.len() {
            wires!(self, wiring: (range_wait[wait].clock) = (clock););
            match wait {
                0 => wires!(self, wiring: (range_wait[wait].d) = (in_range.q);),
                _ => wires!(self, wiring: (range_wait[wait].d) = (range_wait[wait - 1].q);),
            }
        }
        for delay in 0..self.range_delay.len() {
            wires!(self, wiring: (range_delay[delay].clock) = (clock););
            match self.range_wait.len() {
                0 => wires!(self, wiring: (range_delay[delay].d) = (in_range.q);),
                waits => wires!(self, wiring: (range_delay[delay].d) = (range_wait[waits - 1].q);),
            }
        }
        match (self.range_delay.len(), self.range_wait.len()) {
            (0, 0) => wires!(self, wiring: (photon_in_range) = (in_range.q);),
            (0, waits) => wires!(self, wiring: (photon_in_range) = (range_wait[waits - 1].q);),
            _ => wires!(self, wiring: (photon_in_range) = (range_delay[0].q);),
        }
    }
}

logic_of_wires!(Lane<Q, T, U>);
