//! The top block of a leaf machine: the memories and their control, and the chain of engines.

use photoncube_spec::{Leaf, LeafSizes, Machine, Organisation, Pins, SignalPlace, Spatial};
use rust_hdl::prelude::*;

use super::boxes::{BoxBorders, BoxControl, OF_LEAF};
use super::culler::Culler;
use super::extent::{ExtentSoFar, Held};
use super::fill::Fill;
use super::former::{Former, TokenPlace};
use super::gathers::GathersOfPair;
use super::player::{Player, PresentUnlessBlank};
use super::scan::{CullStage, PairQueue, Scan};
use super::tags::Tags;
use super::words::{BoxWords, GroupWords};
use super::{FACING, FACINGS, TAG};
use crate::defaults::{defaulted, signals};
use crate::spatial::SpatialMachine;
use crate::spatial::wiring::{Wires, Wiring, logic_of_wires, wires, with_wires};

const LANES: usize = Spatial::LANES;
const AXES: usize = 3;

/// The machine. The widths up to `N` are those of the chain; `PB` place, `LB` leaf, `KB` pair, `QB` place
/// in the queue of pairs, `QN` number of pairs in it, `NB` number of tokens, `SB` spacing, `OB`
/// batches under way, `TB` tag's place, `RB` result's number.
#[derive(LogicBlock)]
pub(crate) struct LeafMachine<
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
    const PB: usize,
    const LB: usize,
    const KB: usize,
    const QB: usize,
    const QN: usize,
    const NB: usize,
    const SB: usize,
    const OB: usize,
    const TB: usize,
    const RB: usize,
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
    pub query_release: Signal<In, Bit>,
    pub query_last: Signal<In, Bit>,
    pub query_facings: Signal<In, Bits<FACINGS>>,
    pub query_tag: Signal<In, Bits<TAG>>,
    pub group_valid: Signal<In, Bit>,
    pub group_ready: Signal<Out, Bit>,
    pub group_last: Signal<In, Bit>,
    pub group_facing: Signal<In, Bits<FACING>>,
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
    pub result_tag: Signal<Out, Bits<TAG>>,
    pub compared: Signal<Out, Bits<2>>,
    pub wanted: Signal<Out, Bits<2>>,
    pub played: Signal<Out, Bit>,
    pub(super) fill: Fill<PB>,
    pub(super) group_words: GroupWords<H, B, E, PB>,
    pub(super) borders: BoxBorders<H>,
    pub(super) control: BoxControl<PB, LB>,
    pub(super) box_words: BoxWords<H, LB, KB>,
    pub(super) former: Former<NB>,
    /// The box around the batch's queries, axis by axis.
    pub(super) query_border: [ExtentSoFar<C>; AXES],
    token_place: [TokenPlace<C>; AXES],
    pub(super) scan: Scan<LB, KB, QN>,
    /// The box of the batch that is compared, axis by axis.
    pub(super) scan_low: [Held<C>; AXES],
    pub(super) scan_high: [Held<C>; AXES],
    pub(super) gathers: GathersOfPair,
    culler: Culler<C, H, D, R, Q, LP, HP, PR, T, U>,
    pub(super) cull: Vec<CullStage<KB>>,
    pub(super) queue: PairQueue<KB, QB, QN>,
    pub(super) player: Player<PB, KB, SB, OB>,
    pub(super) tags: Tags<TB, RB>,
    unless_blank: [PresentUnlessBlank; LANES],
    pub(super) chain: SpatialMachine<C, H, D, R, Q, L, LP, HP, PR, T, U, B, E, P, PP, GP, S, N>,
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
    const PB: usize,
    const LB: usize,
    const KB: usize,
    const QB: usize,
    const QN: usize,
    const NB: usize,
    const SB: usize,
    const OB: usize,
    const TB: usize,
    const RB: usize,
>
    LeafMachine<
        C,
        H,
        D,
        R,
        Q,
        L,
        LP,
        HP,
        PR,
        T,
        U,
        B,
        E,
        P,
        PP,
        GP,
        S,
        N,
        PB,
        LB,
        KB,
        QB,
        QN,
        NB,
        SB,
        OB,
        TB,
        RB,
    >
{
    /// Builds a machine. The type's widths must be those of the machine.
    pub fn new(machine: &Machine, leaf: &Leaf) -> Self {
        let chain = Machine {
            organisation: Organisation::Spatial(leaf.chain),
            ..*machine
        };
        let sizes = LeafSizes::of(leaf);
        let channels = machine.channels().names().len();
        let format = machine
            .format()
            .expect("a leaf machine has a photon format");
        let pins = Pins::of(machine);
        with_wires!(defaulted!(Self {
            query_radius_sq: signals(machine.fixed_radius_sq().is_none().into()),
            photon_channel: signals(channels * LANES),
            photon_exponent: signals(if E > 0 { LANES } else { 0 }),
            result: signals(channels),
            group_words: GroupWords::new(machine.channels().names()),
            former: Former::new(sizes.engines),
            gathers: GathersOfPair::new(sizes.cull_clocks),
            culler: Culler::new(leaf.culler, format.largest_in_range()),
            cull: signals(sizes.cull_clocks as usize),
            player: Player::new(sizes.least_spacing, sizes.most_outstanding),
            tags: Tags::new(sizes.engines),
            chain: SpatialMachine::new(&chain, &leaf.chain),
            _places: pins.observed[pins.outputs..]
                .iter()
                .map(|pin| pin.place)
                .collect(),
        };
            clock reset query_valid query_ready query_x query_y query_z query_release query_last query_facings
            query_tag group_valid group_ready group_last group_facing photon_present photon_x photon_y photon_z
            result_valid result_ready result_count result_tag compared wanted played fill borders control box_words query_border token_place scan scan_low
            scan_high queue unless_blank _wires
        ))
    }

    fn wires(&mut self, wiring: &mut Wiring) {
        self.fill_wires(wiring);
        self.box_wires(wiring);
        self.query_wires(wiring);
        self.scan_wires(wiring);
        self.cull_wires(wiring);
        self.player_wires(wiring);
        self.result_wires(wiring);
        self.chain_wires(wiring);
    }

    /// Wires groups from the pins to the memory.
    fn fill_wires(&mut self, wiring: &mut Wiring) {
        wires!(self, wiring:
            (fill.clock) = (clock);
            (fill.reset) = (reset);
            (fill.group_valid) = (group_valid);
            (fill.group_last) = (group_last);
            (fill.group_facing) = (group_facing);
            (fill.frees) = (player.frees);
            (fill.freed_bank) = (player.play_bank);
            (group_ready) = (fill.group_ready);
            (group_words.clock) = (clock);
            (group_words.write) = (fill.write_valid_out);
            (group_words.write_bank) = (fill.write_bank_out);
            (group_words.write_place) = (fill.write_place_out);
            (group_words.read) = (player.plays);
            (group_words.read_bank) = (player.play_bank);
            (group_words.read_place) = (player.play_place);
        );
        for lane in 0..LANES {
            wires!(self, wiring:
                (group_words.present[lane]) = (photon_present[lane]);
                (group_words.x[lane]) = (photon_x[lane]);
                (group_words.y[lane]) = (photon_y[lane]);
                (group_words.z[lane]) = (photon_z[lane]);
            );
        }
        for word in 0..self.photon_channel.len() {
            wires!(self, wiring: (group_words.channel[word]) = (photon_channel[word]););
        }
        for lane in 0..self.photon_exponent.len() {
            wires!(self, wiring: (group_words.exponent[lane]) = (photon_exponent[lane]););
        }
    }

    /// Wires the groups that are written to the entries of their leaves.
    fn box_wires(&mut self, wiring: &mut Wiring) {
        wires!(self, wiring:
            (borders.clock) = (clock);
            (borders.comes) = (control.comes);
            (borders.first_comes) = (control.first_comes);
            (control.clock) = (clock);
            (control.reset) = (reset);
            (control.write_valid) = (fill.write_valid_out);
            (control.write_bank) = (fill.write_bank_out);
            (control.write_place) = (fill.write_place_out);
            (control.write_last) = (fill.write_last_out);
            (control.write_facing) = (fill.write_facing_out);
            (control.frees) = (player.frees);
            (control.freed_bank) = (player.play_bank);
            (box_words.clock) = (clock);
            (box_words.write) = (control.box_valid_out);
            (box_words.write_bank) = (control.box_bank_out);
            (box_words.write_leaf) = (control.box_leaf_out);
            (box_words.read) = (scan.issues);
            (box_words.read_bank) = (scan.issue_bank);
            (box_words.read_pair) = (scan.issue_pair);
        );
        for leaf in 0..Leaf::PAIR {
            wires!(self, wiring:
                (box_words.facing[leaf]) = (control.box_facing_out[leaf]);
                (box_words.short[leaf]) = (control.box_short_out[leaf]);
            );
        }
        for lane in 0..LANES {
            wires!(self, wiring:
                (borders.present[lane]) = (group_words.write_present[lane]);
                (borders.x[lane]) = (group_words.write_x[lane]);
                (borders.y[lane]) = (group_words.write_y[lane]);
                (borders.z[lane]) = (group_words.write_z[lane]);
            );
        }
        for border in 0..OF_LEAF {
            wires!(self, wiring:
                (box_words.low[border]) = (borders.low[border]);
                (box_words.high[border]) = (borders.high[border]);
            );
        }
    }

    /// Wires queries to the batch that is formed.
    fn query_wires(&mut self, wiring: &mut Wiring) {
        wires!(self, wiring:
            (former.clock) = (clock);
            (former.reset) = (reset);
            (former.query_valid) = (query_valid);
            (former.query_last) = (query_last);
            (former.query_release) = (query_release);
            (former.query_facings) = (query_facings);
            (former.chain_ready) = (chain.query_ready);
            (former.starts) = (scan.starts);
            (query_ready) = (former.query_ready);
            (token_place[0].query) = (query_x);
            (token_place[1].query) = (query_y);
            (token_place[2].query) = (query_z);
            (query_border[0].low_in) = (query_x);
            (query_border[0].high_in) = (query_x);
            (query_border[1].low_in) = (query_y);
            (query_border[1].high_in) = (query_y);
            (query_border[2].low_in) = (query_z);
            (query_border[2].high_in) = (query_z);
        );
        for axis in 0..AXES {
            wires!(self, wiring:
                (query_border[axis].clock) = (clock);
                (query_border[axis].comes) = (former.offers_query);
                (query_border[axis].first) = (former.first);
                (token_place[axis].fills) = (former.fills);
                (token_place[axis].filler) = (query_border[axis].low_out);
            );
        }
    }

    /// Wires the batch that starts to the comparison.
    fn scan_wires(&mut self, wiring: &mut Wiring) {
        wires!(self, wiring:
            (scan.clock) = (clock);
            (scan.reset) = (reset);
            (scan.complete) = (former.complete);
            (scan.releases) = (former.release_out);
            (scan.facings) = (former.facings_out);
            (scan.full_0) = (control.full_0_out);
            (scan.full_1) = (control.full_1_out);
            (scan.end_0) = (control.end_0_out);
            (scan.end_1) = (control.end_1_out);
            (scan.drops) = (queue.drops);
            (scan.takes_pair) = (player.takes_pair);
            (gathers.clock) = (clock);
            (gathers.facings) = (scan.facings_out);
            (gathers.is_there[0]) = (scan.found_valid_out);
            (gathers.is_there[1]) = (scan.found_second_out);
            (culler.clock) = (clock);
        );
        for axis in 0..AXES {
            wires!(self, wiring:
                (scan_low[axis].clock) = (clock);
                (scan_low[axis].takes) = (scan.takes_box);
                (scan_low[axis].d) = (query_border[axis].low_out);
                (scan_high[axis].clock) = (clock);
                (scan_high[axis].takes) = (scan.takes_box);
                (scan_high[axis].d) = (query_border[axis].high_out);
                (culler.query_low[axis]) = (scan_low[axis].q);
                (culler.query_high[axis]) = (scan_high[axis].q);
            );
        }
        for border in 0..OF_LEAF * Leaf::PAIR {
            wires!(self, wiring:
                (culler.group_low[border]) = (box_words.found_low[border]);
                (culler.group_high[border]) = (box_words.found_high[border]);
            );
        }
    }

    /// Wires a pair's words beside the comparison, and the pair into the queue.
    fn cull_wires(&mut self, wiring: &mut Wiring) {
        let stages = self.cull.len();
        wires!(self, wiring:
            (cull[0].valid_in) = (scan.found_valid_out);
            (cull[0].pair_in) = (scan.found_pair_out);
            (cull[0].bank_in) = (scan.found_bank_out);
            (cull[0].end_in) = (scan.found_end_out);
            (cull[0].release_in) = (scan.found_release_out);
        );
        for leaf in 0..Leaf::PAIR {
            wires!(self, wiring:
                (gathers.facing[leaf]) = (box_words.found_facing[leaf]);
                (cull[0].short_in[leaf]) = (box_words.found_short[leaf]);
            );
        }
        for stage in 0..stages {
            wires!(self, wiring: (cull[stage].clock) = (clock); (cull[stage].reset) = (reset););
        }
        for stage in 1..stages {
            wires!(self, wiring:
                (cull[stage].valid_in) = (cull[stage - 1].valid_out);
                (cull[stage].pair_in) = (cull[stage - 1].pair_out);
                (cull[stage].bank_in) = (cull[stage - 1].bank_out);
                (cull[stage].end_in) = (cull[stage - 1].end_out);
                (cull[stage].release_in) = (cull[stage - 1].release_out);
            );
            for leaf in 0..Leaf::PAIR {
                wires!(self, wiring: (cull[stage].short_in[leaf]) = (cull[stage - 1].short_out[leaf]););
            }
        }
        wires!(self, wiring:
            (queue.clock) = (clock);
            (queue.reset) = (reset);
            (queue.valid) = (cull[stages - 1].valid_out);
            (queue.pair) = (cull[stages - 1].pair_out);
            (queue.bank) = (cull[stages - 1].bank_out);
            (queue.ends) = (cull[stages - 1].end_out);
            (queue.releases) = (cull[stages - 1].release_out);
            (queue.takes_pair) = (player.takes_pair);
        );
        for group in 0..Leaf::PAIR_GROUPS {
            wires!(self, wiring: (queue.in_range[group]) = (culler.in_range[group]););
        }
        for leaf in 0..Leaf::PAIR {
            wires!(self, wiring:
                (queue.gathered[leaf]) = (gathers.gathered[leaf]);
                (queue.short[leaf]) = (cull[stages - 1].short_out[leaf]);
            );
        }
    }

    /// Wires the queue to the player.
    fn player_wires(&mut self, wiring: &mut Wiring) {
        wires!(self, wiring:
            (player.clock) = (clock);
            (player.reset) = (reset);
            (player.has_pair) = (queue.has_pair);
            (player.pair) = (queue.oldest_pair);
            (player.mask) = (queue.oldest_mask);
            (player.flags) = (queue.oldest_flags);
            (player.batch_leaves) = (tags.batch_leaves);
        );
    }

    /// Wires results from the chain to the pins.
    fn result_wires(&mut self, wiring: &mut Wiring) {
        wires!(self, wiring:
            (tags.clock) = (clock);
            (tags.reset) = (reset);
            (tags.takes_token) = (former.takes_token);
            (tags.takes_query) = (former.takes_query);
            (tags.query_tag) = (query_tag);
            (tags.chain_valid) = (chain.result_valid);
            (tags.result_ready) = (result_ready);
            (result_valid) = (tags.result_valid);
            (result_tag) = (tags.result_tag);
            (result_count) = (chain.result_count);
            (compared) = (scan.compared);
            (wanted) = (queue.wanted);
            (played) = (player.word_valid_out);
        );
        for channel in 0..self.result.len() {
            wires!(self, wiring: (result[channel]) = (chain.result[channel]););
        }
    }

    /// Wires the inputs of the chain.
    fn chain_wires(&mut self, wiring: &mut Wiring) {
        wires!(self, wiring:
            (chain.clock) = (clock);
            (chain.reset) = (reset);
            (chain.query_valid) = (former.token_valid);
            (chain.query_x) = (token_place[0].token);
            (chain.query_y) = (token_place[1].token);
            (chain.query_z) = (token_place[2].token);
            (chain.group_valid) = (player.word_valid_out);
            (chain.group_last) = (player.word_last_out);
            (chain.result_ready) = (tags.chain_ready);
        );
        for radius in 0..self.query_radius_sq.len() {
            wires!(self, wiring: (chain.query_radius_sq[radius]) = (query_radius_sq[radius]););
        }
        for lane in 0..LANES {
            wires!(self, wiring:
                (unless_blank[lane].blank) = (player.word_blank_out);
                (unless_blank[lane].word) = (group_words.word_present[lane]);
                (chain.photon_present[lane]) = (unless_blank[lane].present);
                (chain.photon_x[lane]) = (group_words.word_x[lane]);
                (chain.photon_y[lane]) = (group_words.word_y[lane]);
                (chain.photon_z[lane]) = (group_words.word_z[lane]);
            );
        }
        for word in 0..self.photon_channel.len() {
            wires!(self, wiring: (chain.photon_channel[word]) = (group_words.word_channel[word]););
        }
        for lane in 0..self.photon_exponent.len() {
            wires!(self, wiring: (chain.photon_exponent[lane]) = (group_words.word_exponent[lane]););
        }
    }
}

logic_of_wires!(LeafMachine<C, H, D, R, Q, L, LP, HP, PR, T, U, B, E, P, PP, GP, S, N, PB, LB, KB, QB, QN, NB, SB, OB, TB, RB>);
