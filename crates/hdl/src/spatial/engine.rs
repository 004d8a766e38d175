//! An engine: the 16 cells that test the photons against one query.

use photoncube_spec::{Cut, EngineKind, Machine, Spatial, Widths};
use rust_hdl::prelude::*;

use super::flags::{GroupFlags, QueryFlags, QueryWord};
use super::lane::Lane;
use super::square::SquarePair;
use super::stage::Stage;
use super::sums::ChannelSum;
use super::wiring::{Wires, Wiring, logic_of_wires, wires, with_wires};
use crate::defaults::{defaulted, signals};

const LANES: usize = Spatial::LANES;
const AXES: usize = 3;
const COORDINATES: usize = AXES * LANES;
/// Bits of a photon's presence, of the count of a pair and of the count of a group.
const PRESENCE: usize = 1;
const PAIR_COUNT: usize = Widths::PAIR_COUNT as usize;
const GROUP_COUNT: usize = Widths::GROUP_COUNT as usize;

/// The parameters that an engine is built from.
#[derive(Copy, Clone)]
pub(crate) struct EngineShape {
    pub kind: EngineKind,
    /// Clocks that the in-range flags are delayed, to arrive with those of the slowest engines.
    pub range_waits: usize,
    pub channels: usize,
    /// The format's squared radius, where queries have none.
    pub fixed_radius_sq: Option<u32>,
}

impl EngineShape {
    /// The parameters of engine number `engine` of a machine.
    pub fn of(machine: &Machine, spatial: &Spatial, engine: usize) -> Self {
        let kind = spatial.kind(machine.squarer, engine);
        Self {
            kind,
            range_waits: spatial.range_waits(kind) as usize,
            channels: machine.channels().names().len(),
            fixed_radius_sq: machine.fixed_radius_sq(),
        }
    }
}

/// An engine. Widths: `C` query's and `H` photon's coordinate, `D` difference, `R` radius bits, `Q` square and radius_sq,
/// `L` table's word, `LP`, `HP` digit products, `PR` product, `T` pair, `U` distance; `P` power,
/// `PP` of a pair, `GP` of a group, `S` sum, `N` count.
#[derive(LogicBlock)]
pub(crate) struct Engine<
    const C: usize,
    const H: usize,
    const D: usize,
    const R: usize,
    const Q: usize,
    const L: usize,
    const LP: usize,
    const HP: usize,
    const PR: usize,
    const T: usize,
    const U: usize,
    const P: usize,
    const PP: usize,
    const GP: usize,
    const S: usize,
    const N: usize,
> {
    pub clock: Signal<In, Clock>,
    pub reset_in: Signal<In, Bit>,
    pub token_valid_in: Signal<In, Bit>,
    pub token_in: [Signal<In, Bits<C>>; AXES],
    pub token_radius_sq_in: Vec<Signal<In, Bits<Q>>>,
    pub swap_in: Signal<In, Bit>,
    /// The coordinates: axis a of lane g is at 3 g + a.
    pub photon_in: [Signal<In, Bits<H>>; COORDINATES],
    /// The powers: channel c of lane g is at `channels` g + c.
    pub power_in: Vec<Signal<In, Bits<P>>>,
    pub present_in: [Signal<In, Bits<PRESENCE>>; LANES],
    pub first_in: Signal<In, Bit>,
    pub last_in: Signal<In, Bit>,
    pub result_valid_in: Signal<In, Bit>,
    pub result_in: Vec<Signal<In, Bits<S>>>,
    pub result_count_in: Signal<In, Bits<N>>,
    pub reset_out: Signal<Out, Bit>,
    pub token_valid_out: Signal<Out, Bit>,
    pub token_out: [Signal<Out, Bits<C>>; AXES],
    pub token_radius_sq_out: Vec<Signal<Out, Bits<Q>>>,
    pub swap_out: Signal<Out, Bit>,
    pub photon_out: [Signal<Out, Bits<H>>; COORDINATES],
    pub power_out: Vec<Signal<Out, Bits<P>>>,
    pub present_out: [Signal<Out, Bits<PRESENCE>>; LANES],
    pub first_out: Signal<Out, Bit>,
    pub last_out: Signal<Out, Bit>,
    pub result_valid_out: Signal<Out, Bit>,
    pub result_out: Vec<Signal<Out, Bits<S>>>,
    pub result_count_out: Signal<Out, Bits<N>>,
    pub(super) query_flags: QueryFlags,
    pub(super) query: [QueryWord<C>; AXES],
    pub(super) radius_word: Vec<QueryWord<Q>>,
    pub(super) radius_sq_delay: Vec<Stage<Bits<Q>>>,
    pub(super) photon: Vec<Stage<Bits<H>>>,
    /// The squarers: axis a of pair i is at 3 i + a.
    pub(super) square_pair: Vec<SquarePair<C, H, D, R, Q, L, LP, HP, PR>>,
    pub(super) lane: Vec<Lane<Q, T, U>>,
    pub(super) group_flags: GroupFlags,
    pub(super) channel_sum: Vec<ChannelSum<P, PP, GP, S>>,
    pub(super) count_sum: ChannelSum<PRESENCE, PAIR_COUNT, GROUP_COUNT, N>,
    pub(super) _channels: usize,
    _wires: Wires,
}

impl<
    const C: usize,
    const H: usize,
    const D: usize,
    const R: usize,
    const Q: usize,
    const L: usize,
    const LP: usize,
    const HP: usize,
    const PR: usize,
    const T: usize,
    const U: usize,
    const P: usize,
    const PP: usize,
    const GP: usize,
    const S: usize,
    const N: usize,
> Engine<C, H, D, R, Q, L, LP, HP, PR, T, U, P, PP, GP, S, N>
{
    pub fn new(shape: EngineShape) -> Self {
        let EngineShape {
            kind: EngineKind { squarer, cuts },
            range_waits,
            channels,
            fixed_radius_sq,
        } = shape;
        let radii = usize::from(fixed_radius_sq.is_none());
        let to_range = Cut::ALL.into_iter().filter(|&cut| cut < Cut::Range);
        let delays = radii * to_range.filter(|&cut| cuts.has(cut)).count();
        let pairs = 0..AXES * LANES / 2;
        with_wires!(defaulted!(Self {
            token_radius_sq_in: signals(radii),
            power_in: signals(channels * LANES),
            result_in: signals(channels),
            token_radius_sq_out: signals(radii),
            power_out: signals(channels * LANES),
            result_out: signals(channels),
            radius_word: signals(radii),
            radius_sq_delay: Stage::several(delays, true),
            photon: Stage::several(COORDINATES, true),
            square_pair: pairs.map(|_| SquarePair::new(cuts, squarer)).collect(),
            lane: (0..LANES)
                .map(|_| Lane::new(cuts, range_waits, fixed_radius_sq))
                .collect(),
            group_flags: GroupFlags::new(cuts, channels),
            channel_sum: (0..channels).map(|_| ChannelSum::new(cuts)).collect(),
            count_sum: ChannelSum::new(cuts),
            _channels: channels,
        };
            clock reset_in token_valid_in token_in swap_in photon_in present_in first_in last_in result_valid_in
            result_count_in reset_out token_valid_out token_out swap_out photon_out present_out first_out
            last_out result_valid_out result_count_out query_flags query _wires
        ))
    }

    fn wires(&mut self, wiring: &mut Wiring) {
        self.query_wires(wiring);
        self.position_wires(wiring);
        self.power_wires(wiring);
    }

    fn query_wires(&mut self, wiring: &mut Wiring) {
        wires!(self, wiring:
            (query_flags.clock) = (clock);
            (query_flags.reset_in) = (reset_in);
            (query_flags.token_valid_in) = (token_valid_in);
            (query_flags.swap_in) = (swap_in);
            (reset_out) = (query_flags.reset_out);
            (token_valid_out) = (query_flags.token_valid_out);
            (swap_out) = (query_flags.swap_out);
        );
        for axis in 0..AXES {
            wires!(self, wiring:
                (query[axis].clock) = (clock);
                (query[axis].keeps) = (query_flags.keeps);
                (query[axis].swap_in) = (swap_in);
                (query[axis].token_in) = (token_in[axis]);
                (token_out[axis]) = (query[axis].token_out);
            );
        }
        for radius in 0..self.radius_word.len() {
            wires!(self, wiring:
                (radius_word[radius].clock) = (clock);
                (radius_word[radius].keeps) = (query_flags.keeps);
                (radius_word[radius].swap_in) = (swap_in);
                (radius_word[radius].token_in) = (token_radius_sq_in[radius]);
                (token_radius_sq_out[radius]) = (radius_word[radius].token_out);
            );
        }
        for stage in 0..self.radius_sq_delay.len() {
            wires!(self, wiring: (radius_sq_delay[stage].clock) = (clock););
            match stage {
                0 => wires!(self, wiring: (radius_sq_delay[0].d) = (radius_word[0].query_out);),
                _ => {
                    wires!(self, wiring: (radius_sq_delay[stage].d) = (radius_sq_delay[stage - 1].q););
                }
            }
        }
    }

    fn position_wires(&mut self, wiring: &mut Wiring) {
        for place in 0..COORDINATES {
            wires!(self, wiring:
                (photon[place].clock) = (clock);
                (photon[place].d) = (photon_in[place]);
                (photon_out[place]) = (photon[place].q);
            );
        }
        for pair in 0..self.square_pair.len() {
            let (axis, even, odd) = (pair % AXES, pair / AXES * 2, pair / AXES * 2 + 1);
            wires!(self, wiring:
                (square_pair[pair].clock) = (clock);
                (square_pair[pair].query) = (query[axis].query_out);
                (square_pair[pair].photon_a) = (photon[AXES * even + axis].q);
                (square_pair[pair].photon_b) = (photon[AXES * odd + axis].q);
                (lane[even].axis_square[axis]) = (square_pair[pair].square_a);
                (lane[odd].axis_square[axis]) = (square_pair[pair].square_b);
                (lane[even].axis_far[axis]) = (square_pair[pair].far_a);
                (lane[odd].axis_far[axis]) = (square_pair[pair].far_b);
            );
        }
        for lane in 0..LANES {
            wires!(self, wiring: (lane[lane].clock) = (clock););
        }
        if self.radius_word.is_empty() {
            return;
        }
        for lane in 0..LANES {
            match self.radius_sq_delay.len() {
                0 => wires!(self, wiring: (lane[lane].radius_sq[0]) = (radius_word[0].query_out);),
                stages => {
                    wires!(self, wiring: (lane[lane].radius_sq[0]) = (radius_sq_delay[stages - 1].q););
                }
            }
        }
    }

    fn power_wires(&mut self, wiring: &mut Wiring) {
        wires!(self, wiring:
            (group_flags.clock) = (clock);
            (group_flags.reset_in) = (reset_in);
            (group_flags.reset) = (query_flags.reset_out);
            (group_flags.first_in) = (first_in);
            (group_flags.last_in) = (last_in);
            (group_flags.result_valid_in) = (result_valid_in);
            (first_out) = (group_flags.first_out);
            (last_out) = (group_flags.last_out);
            (result_valid_out) = (group_flags.result_valid_out);
            (count_sum.clock) = (clock);
            (count_sum.first) = (group_flags.replace);
            (count_sum.done) = (group_flags.sums_done);
            (count_sum.result_in) = (result_count_in);
            (result_count_out) = (count_sum.result_out);
        );
        for lane in 0..LANES {
            wires!(self, wiring:
                (count_sum.power_in[lane]) = (present_in[lane]);
                (count_sum.in_range[lane]) = (lane[lane].photon_in_range);
                (present_out[lane]) = (count_sum.power[lane]);
            );
        }
        let channels = self._channels;
        for channel in 0..channels {
            wires!(self, wiring: (channel_sum[channel].clock) = (clock););
            if self.group_flags.done_copy.is_empty() {
                wires!(self, wiring:
                    (channel_sum[channel].first) = (group_flags.replace);
                    (channel_sum[channel].done) = (group_flags.sums_done);
                );
            } else {
                wires!(self, wiring:
                    (channel_sum[channel].first) = (group_flags.replace_copy[channel]);
                    (channel_sum[channel].done) = (group_flags.sums_done_copy[channel]);
                );
            }
            wires!(self, wiring:
                (channel_sum[channel].result_in) = (result_in[channel]);
                (result_out[channel]) = (channel_sum[channel].result_out);
            );
            for lane in 0..LANES {
                let place = channels * lane + channel;
                wires!(self, wiring:
                    (channel_sum[channel].power_in[lane]) = (power_in[place]);
                    (channel_sum[channel].in_range[lane]) = (lane[lane].photon_in_range);
                    (power_out[place]) = (channel_sum[channel].power[lane]);
                );
            }
        }
    }
}

logic_of_wires!(Engine<C, H, D, R, Q, L, LP, HP, PR, T, U, P, PP, GP, S, N>);
