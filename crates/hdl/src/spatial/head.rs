//! The head: the logic between the machine's pins and the first engine, except the entry.

use photoncube_spec::Spatial;
use rust_hdl::prelude::*;

use super::admission::Admission;
use super::delay::{FlagDelay, WordDelay};
use super::presence::{PowerOfPresent, Presence};
use super::queue::ResultQueue;
use super::stage::Stage;
use super::wiring::{Wires, Wiring, logic_of_wires, wires, with_wires};
use crate::defaults::{defaulted, signals};

const LANES: usize = Spatial::LANES;

/// Decodes a power for the engines: mantissa << exponent. `B` mantissa, `E` exponent, `P` power bits.
#[derive(LogicBlock)]
pub(crate) struct PowerDecoder<const B: usize, const E: usize, const P: usize> {
    pub mantissa: Signal<In, Bits<B>>,
    /// One exponent; empty where powers have no exponent.
    pub exponent: Vec<Signal<In, Bits<E>>>,
    pub power: Signal<Out, Bits<P>>,
    decoded: Signal<Local, Bits<P>>,
}

impl<const B: usize, const E: usize, const P: usize> Default for PowerDecoder<B, E, P> {
    fn default() -> Self {
        let exponents = 0..usize::from(E > 0);
        Self {
            mantissa: Default::default(),
            exponent: exponents.map(|_| Default::default()).collect(),
            power: Default::default(),
            decoded: Default::default(),
        }
    }
}

impl<const B: usize, const E: usize, const P: usize> Logic for PowerDecoder<B, E, P> {
    #[hdl_gen]
    fn update(&mut self) {
        self.decoded.next = bit_cast::<P, B>(self.mantissa.val());
        for e in 0..self.exponent.len() {
            self.decoded.next = self.decoded.val() << self.exponent[e].val();
        }
        self.power.next = self.decoded.val();
    }
}

/// The head. `B` mantissa, `E` exponent, `P` power, `S` sum, `N` count bits.
#[derive(LogicBlock)]
pub(crate) struct Head<
    const B: usize,
    const E: usize,
    const P: usize,
    const S: usize,
    const N: usize,
> {
    pub clock: Signal<In, Clock>,
    pub reset: Signal<In, Bit>,
    pub query_valid: Signal<In, Bit>,
    pub query_ready: Signal<Out, Bit>,
    pub group_valid: Signal<In, Bit>,
    pub group_last: Signal<In, Bit>,
    pub group_ready: Signal<Out, Bit>,
    /// A group is taken; a first group is taken; a last group is taken.
    pub taken: Signal<Out, Bit>,
    pub first_taken: Signal<Out, Bit>,
    pub last_taken: Signal<Out, Bit>,
    /// Inputs from the entry. Channel c of lane g is at 4 c + g.
    pub channel: Vec<Signal<In, Bits<B>>>,
    pub exponent: Vec<Signal<In, Bits<E>>>,
    pub present: [Signal<In, Bits<1>>; LANES],
    pub taken_in: Signal<In, Bit>,
    pub first_in: Signal<In, Bit>,
    pub last_in: Signal<In, Bit>,
    pub result_valid: Signal<Out, Bit>,
    pub result: Vec<Signal<Out, Bits<S>>>,
    pub result_count: Signal<Out, Bits<N>>,
    pub result_ready: Signal<In, Bit>,
    /// A query is taken in this clock.
    pub token_valid: Signal<Out, Bit>,
    /// Outputs to the photon memory, as in [`Admission`].
    pub is_full: Signal<Out, Bit>,
    pub has_room: Signal<Out, Bit>,
    pub clocks_to_last: Signal<Out, Bits<16>>,
    /// Words to engine 0 and from it. Channel c of lane g is at `channels` g + c.
    pub power: Vec<Signal<Out, Bits<P>>>,
    pub power_present: [Signal<Out, Bits<1>>; LANES],
    pub first: Signal<Out, Bit>,
    pub last: Signal<Out, Bit>,
    pub result_valid_in: Signal<In, Bit>,
    pub result_in: Vec<Signal<In, Bits<S>>>,
    pub result_count_in: Signal<In, Bits<N>>,
    pub(super) admission: Admission,
    power_decoder: Vec<PowerDecoder<B, E, P>>,
    /// Stage 0 of the delay lines of powers and of presence. The later stages are in the lines below.
    pub(super) decoded: Vec<Stage<Bits<P>>>,
    pub(super) presence: [Presence; LANES],
    power_of_present: Vec<PowerOfPresent<P>>,
    pub(super) power_delay: Vec<WordDelay<P>>,
    pub(super) present_delay: Vec<WordDelay<1>>,
    pub(super) first_delay: FlagDelay,
    pub(super) last_delay: FlagDelay,
    pub(super) queue: ResultQueue<S, N>,
    pub(super) _channels: usize,
    _wires: Wires,
}

impl<const B: usize, const E: usize, const P: usize, const S: usize, const N: usize>
    Head<B, E, P, S, N>
{
    pub fn new(spatial: &Spatial, channels: usize) -> Self {
        assert!(B == P || E > 0, "only an exponent makes a power wider");
        let stages = spatial.latency() as usize;
        let exponents = if E > 0 { LANES } else { 0 };
        let words = channels * LANES;
        with_wires!(defaulted!(Self {
            channel: signals(words),
            exponent: signals(exponents),
            result: signals(channels),
            power: signals(words),
            result_in: signals(channels),
            admission: Admission::new(spatial),
            power_decoder: signals(words),
            decoded: Stage::several(words, true),
            power_of_present: signals(words),
            power_delay: (0..words).map(|_| WordDelay::new(stages - 1)).collect(),
            present_delay: (0..LANES).map(|_| WordDelay::new(stages - 1)).collect(),
            first_delay: FlagDelay::new(stages),
            last_delay: FlagDelay::new(stages),
            queue: ResultQueue::new(spatial, channels),
            _channels: channels,
        };
            clock reset query_valid query_ready group_valid group_last group_ready taken first_taken last_taken
            present taken_in first_in last_in result_valid result_count result_ready token_valid is_full
            has_room clocks_to_last power_present first last result_valid_in result_count_in presence _wires
        ))
    }

    fn wires(&mut self, wiring: &mut Wiring) {
        self.stream_wires(wiring);
        self.group_wires(wiring);
    }

    fn stream_wires(&mut self, wiring: &mut Wiring) {
        wires!(self, wiring:
            (admission.clock) = (clock);
            (admission.reset) = (reset);
            (admission.query_valid) = (query_valid);
            (admission.group_valid) = (group_valid);
            (admission.group_last) = (group_last);
            (admission.batch_read) = (queue.batch_read);
            (query_ready) = (admission.query_ready);
            (group_ready) = (admission.group_ready);
            (token_valid) = (admission.token_valid);
            (taken) = (admission.taken);
            (first_taken) = (admission.first_taken);
            (last_taken) = (admission.last_taken);
            (is_full) = (admission.is_full);
            (has_room) = (admission.has_room);
            (clocks_to_last) = (admission.clocks_to_last);
            (queue.clock) = (clock);
            (queue.reset) = (reset);
            (queue.result_ready) = (result_ready);
            (queue.result_valid_in) = (result_valid_in);
            (queue.result_count_in) = (result_count_in);
            (result_valid) = (queue.result_valid);
            (result_count) = (queue.result_count);
        );
        for channel in 0..self._channels {
            wires!(self, wiring:
                (queue.result_in[channel]) = (result_in[channel]);
                (result[channel]) = (queue.result[channel]);
            );
        }
    }

    fn group_wires(&mut self, wiring: &mut Wiring) {
        let channels = self._channels;
        for lane in 0..LANES {
            wires!(self, wiring:
                (presence[lane].clock) = (clock);
                (presence[lane].photon_present) = (present[lane]);
                (presence[lane].taken) = (taken_in);
                (present_delay[lane].clock) = (clock);
                (present_delay[lane].word) = (presence[lane].present);
                (power_present[lane]) = (present_delay[lane].delayed);
            );
            for channel in 0..channels {
                let place = channels * lane + channel;
                wires!(self, wiring:
                    (power_decoder[place].mantissa) = (channel[LANES * channel + lane]);
                    (decoded[place].clock) = (clock);
                    (decoded[place].d) = (power_decoder[place].power);
                    (power_of_present[place].absent) = (presence[lane].absent);
                    (power_of_present[place].word) = (decoded[place].q);
                    (power_delay[place].clock) = (clock);
                    (power_delay[place].word) = (power_of_present[place].power);
                    (power[place]) = (power_delay[place].delayed);
                );
            }
        }
        for lane in 0..self.exponent.len() {
            for place in channels * lane..channels * (lane + 1) {
                wires!(self, wiring: (power_decoder[place].exponent[0]) = (exponent[lane]););
            }
        }
        wires!(self, wiring:
            (first_delay.clock) = (clock);
            (first_delay.clear) = (reset);
            (first_delay.flag) = (first_in);
            (first) = (first_delay.delayed);
            (last_delay.clock) = (clock);
            (last_delay.clear) = (reset);
            (last_delay.flag) = (last_in);
            (last) = (last_delay.delayed);
        );
    }
}

logic_of_wires!(Head<B, E, P, S, N>);
