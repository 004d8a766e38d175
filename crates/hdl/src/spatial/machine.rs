//! The top block of a spatial machine: the entry, the head and the chain of engines.

use photoncube_spec::{Machine, Pins, SignalPlace, Spatial};
use rust_hdl::prelude::*;

use super::engine::{Engine, EngineShape};
use super::head::Head;
use super::memory::PhotonMemory;
use super::stage::{FlagStage, Stage};
use super::wiring::{Wires, Wiring, logic_of_wires, wires, with_wires, zeros};
use crate::defaults::{defaulted, signals};

const LANES: usize = Spatial::LANES;
const AXES: usize = 3;

/// The machine. `B` mantissa and `E` exponent bits; the other widths are those of an engine.
#[derive(LogicBlock)]
pub(crate) struct SpatialMachine<
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
    const B: usize,
    const E: usize,
    const P: usize,
    const PP: usize,
    const GP: usize,
    const S: usize,
    const N: usize,
> {
    pub clock: Signal<In, Clock>,
    pub reset: Signal<In, Bit>,
    pub query_valid: Signal<In, Bit>,
    pub query_ready: Signal<Out, Bit>,
    pub query_x: Signal<In, Bits<C>>,
    pub query_y: Signal<In, Bits<C>>,
    pub query_z: Signal<In, Bits<C>>,
    /// One squared radius; empty where the radius is the format's.
    pub query_radius_sq: Vec<Signal<In, Bits<Q>>>,
    /// One flag; empty where there is no photon memory.
    pub query_release: Vec<Signal<In, Bit>>,
    pub group_valid: Signal<In, Bit>,
    pub group_ready: Signal<Out, Bit>,
    pub group_last: Signal<In, Bit>,
    pub photon_present: [Signal<In, Bits<1>>; LANES],
    pub photon_x: [Signal<In, Bits<H>>; LANES],
    pub photon_y: [Signal<In, Bits<H>>; LANES],
    pub photon_z: [Signal<In, Bits<H>>; LANES],
    /// The mantissas: channel c of lane g is at 4 c + g.
    pub photon_channel: Vec<Signal<In, Bits<B>>>,
    pub photon_exponent: Vec<Signal<In, Bits<E>>>,
    pub result_valid: Signal<Out, Bit>,
    pub result_ready: Signal<In, Bit>,
    pub result: Vec<Signal<Out, Bits<S>>>,
    pub result_count: Signal<Out, Bits<N>>,
    /// One photon memory, or none.
    pub(super) memory: Vec<PhotonMemory<H, B, E>>,
    /// The entry, which holds the values of the pins or of the memory one clock later. So the nets from the
    /// pins to the engines, and from the logic that decides whether a group is taken, start and end at
    /// registers.
    pub(super) entry_token_valid: FlagStage,
    pub(super) entry_token: Vec<Stage<Bits<C>>>,
    /// One radius; empty where queries have none.
    pub(super) entry_radius: Vec<Stage<Bits<Q>>>,
    /// The photons' coordinates: axis a of lane g is at 3 g + a.
    pub(super) entry_photon: Vec<Stage<Bits<H>>>,
    /// The photons' mantissas: channel c of lane g is at 4 c + g.
    pub(super) entry_mantissa: Vec<Stage<Bits<B>>>,
    pub(super) entry_exponent: Vec<Stage<Bits<E>>>,
    pub(super) entry_present: Vec<Stage<Bits<1>>>,
    pub(super) entry_taken: Stage<Bit>,
    pub(super) entry_first: FlagStage,
    pub(super) entry_last: FlagStage,
    pub(super) head: Head<B, E, P, S, N>,
    pub(super) engine: Vec<Engine<C, H, D, R, Q, L, LP, HP, PR, T, U, P, PP, GP, S, N>>,
    /// The places of the registers, in the order of the machine's pins.
    pub(super) _places: Vec<SignalPlace>,
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
    const B: usize,
    const E: usize,
    const P: usize,
    const PP: usize,
    const GP: usize,
    const S: usize,
    const N: usize,
> SpatialMachine<C, H, D, R, Q, L, LP, HP, PR, T, U, B, E, P, PP, GP, S, N>
{
    /// Builds a machine. The type's widths must be those of the machine.
    pub fn new(machine: &Machine, spatial: &Spatial) -> Self {
        let names = machine.channels().names();
        let channels = names.len();
        let radii = usize::from(machine.fixed_radius_sq().is_none());
        let exponents = if E > 0 { LANES } else { 0 };
        let memories = 0..usize::from(machine.has_memory());
        let pins = Pins::of(machine);
        let engine = |index| EngineShape::of(machine, spatial, index);
        with_wires!(defaulted!(Self {
            query_radius_sq: signals(radii),
            query_release: memories.clone().map(|_| Default::default()).collect(),
            photon_channel: signals(channels * LANES),
            photon_exponent: signals(exponents),
            result: signals(channels),
            memory: memories
                .map(|_| PhotonMemory::new(spatial, names))
                .collect(),
            entry_token_valid: FlagStage::new(true),
            entry_token: Stage::several(AXES, true),
            entry_radius: Stage::several(radii, true),
            entry_photon: Stage::several(AXES * LANES, true),
            entry_mantissa: Stage::several(channels * LANES, true),
            entry_exponent: Stage::several(exponents, true),
            entry_present: Stage::several(LANES, true),
            entry_taken: Stage::new(true),
            entry_first: FlagStage::new(true),
            entry_last: FlagStage::new(true),
            head: Head::new(spatial, channels),
            engine: (0..spatial.engines())
                .map(|index| Engine::new(engine(index)))
                .collect(),
            _places: pins.observed[pins.outputs..]
                .iter()
                .map(|pin| pin.place)
                .collect(),
        };
            clock reset query_valid query_ready query_x query_y query_z group_valid group_ready group_last
            photon_present photon_x photon_y photon_z result_valid result_ready result_count _wires
        ))
    }

    fn wires(&mut self, wiring: &mut Wiring) {
        self.head_wires(wiring);
        if self.memory.is_empty() {
            self.stream_wires(wiring);
        }
        for memory in 0..self.memory.len() {
            self.memory_wires(wiring, memory);
            self.played_wires(wiring, memory);
        }
        self.entry_wires(wiring);
        self.first_engine_wires(wiring);
        for engine in 1..self.engine.len() {
            self.chain_wires(wiring, engine);
        }
        self.chain_end(wiring);
    }

    fn head_wires(&mut self, wiring: &mut Wiring) {
        wires!(self, wiring:
            (head.clock) = (clock);
            (head.reset) = (reset);
            (head.query_valid) = (query_valid);
            (query_ready) = (head.query_ready);
            (head.result_ready) = (result_ready);
            (result_valid) = (head.result_valid);
            (result_count) = (head.result_count);
            (head.result_valid_in) = (engine[0].result_valid_out);
            (head.result_count_in) = (engine[0].result_count_out);
        );
        for channel in 0..self.result.len() {
            wires!(self, wiring:
                (head.result_in[channel]) = (engine[0].result_out[channel]);
                (result[channel]) = (head.result[channel]);
            );
        }
    }

    /// Wires groups from the pins to the entry, in a machine without a memory.
    fn stream_wires(&mut self, wiring: &mut Wiring) {
        wires!(self, wiring:
            (head.group_valid) = (group_valid);
            (head.group_last) = (group_last);
            (group_ready) = (head.group_ready);
        );
        for lane in 0..LANES {
            wires!(self, wiring:
                (entry_present[lane].d) = (photon_present[lane]);
                (entry_photon[AXES * lane].d) = (photon_x[lane]);
                (entry_photon[AXES * lane + 1].d) = (photon_y[lane]);
                (entry_photon[AXES * lane + 2].d) = (photon_z[lane]);
            );
        }
        for word in 0..self.photon_channel.len() {
            wires!(self, wiring: (entry_mantissa[word].d) = (photon_channel[word]););
        }
        for lane in 0..self.photon_exponent.len() {
            wires!(self, wiring: (entry_exponent[lane].d) = (photon_exponent[lane]););
        }
    }

    /// Wires groups from the pins to the memory.
    fn memory_wires(&mut self, wiring: &mut Wiring, m: usize) {
        wires!(self, wiring:
            (memory[m].clock) = (clock);
            (memory[m].reset) = (reset);
            (memory[m].release_in) = (query_release[m]);
            (memory[m].query_taken) = (head.token_valid);
            (memory[m].is_full) = (head.is_full);
            (memory[m].has_room) = (head.has_room);
            (memory[m].clocks_to_last) = (head.clocks_to_last);
            (memory[m].group_valid) = (group_valid);
            (memory[m].group_last) = (group_last);
            (group_ready) = (memory[m].group_ready);
        );
        for lane in 0..LANES {
            wires!(self, wiring:
                (memory[m].present[lane]) = (photon_present[lane]);
                (memory[m].x[lane]) = (photon_x[lane]);
                (memory[m].y[lane]) = (photon_y[lane]);
                (memory[m].z[lane]) = (photon_z[lane]);
            );
        }
        for word in 0..self.photon_channel.len() {
            wires!(self, wiring: (memory[m].channel[word]) = (photon_channel[word]););
        }
        for lane in 0..self.photon_exponent.len() {
            wires!(self, wiring: (memory[m].exponent[lane]) = (photon_exponent[lane]););
        }
    }

    /// Wires groups from the memory to the entry.
    fn played_wires(&mut self, wiring: &mut Wiring, m: usize) {
        wires!(self, wiring:
            (head.group_valid) = (memory[m].word_valid);
            (head.group_last) = (memory[m].word_last);
        );
        for lane in 0..LANES {
            wires!(self, wiring:
                (entry_present[lane].d) = (memory[m].word_present[lane]);
                (entry_photon[AXES * lane].d) = (memory[m].word_x[lane]);
                (entry_photon[AXES * lane + 1].d) = (memory[m].word_y[lane]);
                (entry_photon[AXES * lane + 2].d) = (memory[m].word_z[lane]);
            );
        }
        for word in 0..self.photon_channel.len() {
            wires!(self, wiring: (entry_mantissa[word].d) = (memory[m].word_channel[word]););
        }
        for lane in 0..self.photon_exponent.len() {
            wires!(self, wiring: (entry_exponent[lane].d) = (memory[m].word_exponent[lane]););
        }
    }

    /// Wires the rest of the entry, and the entry to the head's delay line.
    fn entry_wires(&mut self, wiring: &mut Wiring) {
        wires!(self, wiring:
            (entry_token_valid.clock) = (clock);
            (entry_token_valid.clear) = (reset);
            (entry_token_valid.d) = (head.token_valid);
            (entry_token[0].d) = (query_x);
            (entry_token[1].d) = (query_y);
            (entry_token[2].d) = (query_z);
            (entry_first.clock) = (clock);
            (entry_first.clear) = (reset);
            (entry_first.d) = (head.first_taken);
            (entry_last.clock) = (clock);
            (entry_last.clear) = (reset);
            (entry_last.d) = (head.last_taken);
            (entry_taken.clock) = (clock);
            (entry_taken.d) = (head.taken);
            (head.taken_in) = (entry_taken.q);
            (head.first_in) = (entry_first.q);
            (head.last_in) = (entry_last.q);
        );
        for axis in 0..AXES {
            wires!(self, wiring: (entry_token[axis].clock) = (clock););
        }
        for radius in 0..self.entry_radius.len() {
            wires!(self, wiring:
                (entry_radius[radius].clock) = (clock);
                (entry_radius[radius].d) = (query_radius_sq[radius]);
            );
        }
        for place in 0..AXES * LANES {
            wires!(self, wiring: (entry_photon[place].clock) = (clock););
        }
        for word in 0..self.entry_mantissa.len() {
            wires!(self, wiring:
                (entry_mantissa[word].clock) = (clock);
                (head.channel[word]) = (entry_mantissa[word].q);
            );
        }
        for lane in 0..self.entry_exponent.len() {
            wires!(self, wiring:
                (entry_exponent[lane].clock) = (clock);
                (head.exponent[lane]) = (entry_exponent[lane].q);
            );
        }
        for lane in 0..LANES {
            wires!(self, wiring:
                (entry_present[lane].clock) = (clock);
                (head.present[lane]) = (entry_present[lane].q);
            );
        }
    }

    fn first_engine_wires(&mut self, wiring: &mut Wiring) {
        wires!(self, wiring:
            (engine[0].clock) = (clock);
            (engine[0].reset_in) = (reset);
            (engine[0].token_valid_in) = (entry_token_valid.q);
            (engine[0].swap_in) = (entry_first.q);
            (engine[0].first_in) = (head.first);
            (engine[0].last_in) = (head.last);
        );
        for radius in 0..self.query_radius_sq.len() {
            wires!(self, wiring:
                (engine[0].token_radius_sq_in[radius]) = (entry_radius[radius].q);
            );
        }
        for axis in 0..AXES {
            wires!(self, wiring: (engine[0].token_in[axis]) = (entry_token[axis].q););
        }
        for place in 0..AXES * LANES {
            wires!(self, wiring: (engine[0].photon_in[place]) = (entry_photon[place].q););
        }
        for lane in 0..LANES {
            wires!(self, wiring: (engine[0].present_in[lane]) = (head.power_present[lane]););
        }
        for word in 0..self.head.power.len() {
            wires!(self, wiring: (engine[0].power_in[word]) = (head.power[word]););
        }
    }

    /// Wires an engine to its neighbour nearer to the head, and its results back to that neighbour.
    fn chain_wires(&mut self, wiring: &mut Wiring, e: usize) {
        wires!(self, wiring:
            (engine[e].clock) = (clock);
            (engine[e].reset_in) = (engine[e - 1].reset_out);
            (engine[e].token_valid_in) = (engine[e - 1].token_valid_out);
            (engine[e].swap_in) = (engine[e - 1].swap_out);
            (engine[e].first_in) = (engine[e - 1].first_out);
            (engine[e].last_in) = (engine[e - 1].last_out);
            (engine[e - 1].result_valid_in) = (engine[e].result_valid_out);
            (engine[e - 1].result_count_in) = (engine[e].result_count_out);
        );
        for axis in 0..AXES {
            wires!(self, wiring: (engine[e].token_in[axis]) = (engine[e - 1].token_out[axis]););
        }
        for radius in 0..self.query_radius_sq.len() {
            wires!(self, wiring:
                (engine[e].token_radius_sq_in[radius]) = (engine[e - 1].token_radius_sq_out[radius]);
            );
        }
        for place in 0..AXES * LANES {
            wires!(self, wiring: (engine[e].photon_in[place]) = (engine[e - 1].photon_out[place]););
        }
        for word in 0..self.head.power.len() {
            wires!(self, wiring: (engine[e].power_in[word]) = (engine[e - 1].power_out[word]););
        }
        for lane in 0..LANES {
            wires!(self, wiring: (engine[e].present_in[lane]) = (engine[e - 1].present_out[lane]););
        }
        for channel in 0..self.result.len() {
            wires!(self, wiring:
                (engine[e - 1].result_in[channel]) = (engine[e].result_out[channel]);
            );
        }
    }

    /// Ties the result inputs of the last engine to 0.
    fn chain_end(&mut self, wiring: &mut Wiring) {
        let last = self.engine.len() - 1;
        zeros!(self, wiring:
            (engine[last].result_valid_in);
            (engine[last].result_count_in);
        );
        for channel in 0..self.result.len() {
            zeros!(self, wiring: (engine[last].result_in[channel]););
        }
    }
}

logic_of_wires!(SpatialMachine<C, H, D, R, Q, L, LP, HP, PR, T, U, B, E, P, PP, GP, S, N>);
