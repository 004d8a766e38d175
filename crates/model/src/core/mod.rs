//! The step-exact model of cores, by the rules of [`photoncube_spec::Core`]. Its chains are [`LeafMachine`]s.

mod link;
mod merge;
mod port;
mod registers;
mod rounds;
mod serial;
mod slice;

use photoncube_spec::{
    BatchPins, Beat, Core, CoreCounter, CoreInputs, CoreOutputs, CoreStreams, Group, Inputs, Lane,
    Outputs, Query, QueryResult, QueryWord, ResultWord, Rounds, Spatial, Sums,
};

use crate::golden::GoldenMachine;
use crate::leaf::LeafMachine;
use link::Link;
use merge::{Merge, Merged};
use port::{Fate, LeafWord, PhotonPort};
use registers::{Happens, InChains, Registers};
use rounds::{Shown, Store};
use slice::Places;

pub use serial::{SerialFrame, SerialModel};

/// A core with its state. It starts in the power-up state, in which all registers have their reset values.
#[derive(Clone, Debug)]
pub struct CoreModel {
    core: Core,
    streams: CoreStreams,
    digest: u64,
    /// The radius of all queries; none where each has its own.
    fixed_radius_sq: Option<u32>,
    photons: Places<LeafWord, 2>,
    queries: Places<QueryIn, 2>,
    results: Places<CoreResult, 2>,
    /// The queue in front of each chain, or of its store.
    to_chains: Vec<Link<QueryIn, { Core::QUERY_PLACES as usize }>>,
    /// In front of each chain, and behind it; none where all queries have the format's radius.
    stores: Vec<RoundsOfChain>,
    /// Behind each chain, or behind its store.
    from_chains: Vec<Places<CoreResult, 1>>,
    ports: Vec<PhotonPort>,
    chains: Vec<LeafMachine>,
    /// The slices in which the results of a chain are merged with those of the chains behind it.
    merges: Vec<Merge<CoreResult>>,
    /// What the chains did in the clock before.
    in_chains: InChains,
    registers: Registers,
}

/// A query in its slice.
#[derive(Copy, Clone, Debug)]
struct QueryIn {
    word: QueryWord,
    outside: bool,
    chain: u32,
}

/// A result in its slice.
#[derive(Copy, Clone, Debug)]
struct CoreResult {
    sums: Sums,
    tag: u32,
    last: bool,
    outside: bool,
    chain: u32,
    radius_sq: Option<u32>,
    /// The query has no further result.
    is_final: bool,
}

/// The store of a chain, the slice of queries and the place for a result between the two.
#[derive(Clone, Debug)]
struct RoundsOfChain {
    store: Store,
    given: Places<QueryIn, 2>,
    found: Places<Outputs, 1>,
}

impl CoreModel {
    /// Makes a core in its power-up state. `digest` is that of its configuration, which the registers show.
    ///
    /// # Panics
    /// Where the machine of the core is not a legal leaf machine.
    pub fn new(core: &Core, digest: u64) -> Self {
        Self {
            core: *core,
            streams: CoreStreams::of(core),
            digest,
            fixed_radius_sq: core.machine.fixed_radius_sq(),
            photons: Places::default(),
            queries: Places::default(),
            results: Places::default(),
            stores: Rounds::of(core).map_or(Vec::new(), |rounds| {
                let store = Store::new(rounds, core.engines());
                let rounds = RoundsOfChain {
                    store,
                    given: Places::default(),
                    found: Places::default(),
                };
                vec![rounds; core.chains as usize]
            }),
            to_chains: core_stages(core).map(Link::new).collect(),
            from_chains: vec![Places::default(); core.chains as usize],
            ports: core_stages(core).map(PhotonPort::new).collect(),
            chains: vec![LeafMachine::new(core.machine); core.chains as usize],
            merges: vec![Merge::default(); core.chains as usize],
            in_chains: InChains::default(),
            registers: Registers::new(core, digest),
        }
    }

    /// This core with counters that power-up and every clearing set to `cleared` in the place of 0. So a short run can see the
    /// carry into a counter's high word.
    #[must_use]
    pub fn with_counters_from(mut self, cleared: u64) -> Self {
        self.registers.clear_to(cleared);
        self
    }

    /// The value of a counter.
    pub fn counter(&self, counter: CoreCounter) -> u64 {
        self.registers.counter(counter)
    }

    /// The events that are set.
    pub fn events(&self) -> u32 {
        self.registers.events()
    }

    /// Whether this clock is a reset: `aresetn` was 0 in the clock before, or a restart was written.
    pub fn resets(&self) -> bool {
        self.registers.reset
    }

    /// The values of the output pins in this clock, for these inputs.
    pub fn outputs(&self, inputs: &CoreInputs) -> CoreOutputs {
        let reset = self.resets();
        CoreOutputs {
            photon_ready: self.photons.is_ready() && !reset,
            query_ready: self.queries.is_ready() && !reset,
            result: self.result().map(|result| self.result_word(result)),
            write_ready: self.registers.writes(&inputs.lite) && !inputs.reset,
            write_answer: self.registers.write_answer(),
            read_ready: self.registers.is_ready_to_read() && !inputs.reset,
            read_answer: self.registers.read_answer(),
            interrupt: self.registers.interrupt(),
        }
    }

    /// The result on its port.
    fn result(&self) -> Option<&CoreResult> {
        self.results.front().filter(|_| !self.resets())
    }

    fn result_word(&self, result: &CoreResult) -> ResultWord {
        let fields = QueryResult {
            sums: result.sums,
            tag: result.tag,
            radius_sq: result.radius_sq,
        };
        let values = CoreStreams::result_values(&self.core, &fields);
        ResultWord {
            data: self.streams.results.bytes(&values),
            last: result.last,
            id: result.chain,
            outside: result.outside,
        }
    }

    /// Applies one rising clock edge with these inputs.
    pub fn clock(&mut self, inputs: &CoreInputs) {
        let outputs = self.outputs(inputs);
        let reset = self.resets();
        let to_chains: Vec<_> = (0..self.chains.len())
            .map(|chain| self.chain_inputs(chain, reset))
            .collect();
        let from_chains: Vec<_> = self
            .chains
            .iter()
            .zip(&to_chains)
            .map(|(chain, inputs)| chain.outputs(inputs))
            .collect();
        let happens = self.happens(inputs, &outputs);
        self.in_chains = match reset {
            true => InChains::default(),
            false => InChains::of(&from_chains),
        };
        let leaf_moves = happens.leaf_given || happens.leaf_refused;
        let query_moves = happens.query_given || happens.query_refused;

        for (number, port) in self.ports.iter_mut().enumerate() {
            let leaf = self.photons.front();
            let leaf = leaf.filter(|leaf| leaf.chain as usize == number);
            port.clock(&self.core, leaf, from_chains[number].group_ready, reset);
        }
        for (chain, inputs) in self.chains.iter_mut().zip(&to_chains) {
            chain.clock(inputs);
        }
        let of_stores = self.results_to_stores(&from_chains, reset);
        self.results(&from_chains, &of_stores.shown, happens.result_moves, reset);
        self.queries_to_chains(&from_chains, &of_stores.comes, happens.query_given, reset);
        let leaf = happens
            .photon_moves
            .then(|| self.leaf(&inputs.photons.beat));
        self.photons.clock(leaf_moves, leaf, reset);
        let query = happens
            .query_moves
            .then(|| self.query(&inputs.queries.beat));
        self.queries.clock(query_moves, query, reset);
        match inputs.reset {
            true => self.registers.reset(&self.core, self.digest),
            false => self.registers.clock(&inputs.lite, &happens),
        }
    }

    fn chain_inputs(&self, chain: usize, reset: bool) -> Inputs {
        let query = match self.stores.get(chain) {
            Some(rounds) => rounds.given.front(),
            None => self.to_chains[chain].front(),
        };
        let group = self.ports[chain].offers();
        let word = query.map_or_else(QueryWord::default, |query| query.word);
        let flags = query.map_or(0, |query| {
            u32::from(query.word.batch.last) << Core::LAST_BIT
                | u32::from(query.outside) << Core::OUTSIDE_BIT
        });
        Inputs {
            reset,
            query_valid: query.is_some(),
            query: word.query,
            query_release: word.release,
            batch: BatchPins {
                tag: word.batch.tag | flags,
                ..word.batch
            },
            group_valid: group.is_some(),
            group: group.unwrap_or_else(|| Group {
                lanes: vec![Lane::default(); Spatial::LANES],
                ..Group::default()
            }),
            result_ready: !reset
                && match self.stores.get(chain) {
                    Some(rounds) => rounds.found.is_ready(),
                    None => self.from_chains[chain].is_ready(),
                },
        }
    }

    /// The queries: from their slice to the queue in front of a chain, and from there to the chain, or to its store and from the store by
    /// a slice. `comes` has the results that the stores take.
    fn queries_to_chains(
        &mut self,
        from_chains: &[Outputs],
        comes: &[Option<Outputs>],
        given: bool,
        reset: bool,
    ) {
        let query = self.queries.front().copied().filter(|_| given);
        let settings = &self.registers.settings;
        for (chain, (queue, outputs)) in self.to_chains.iter_mut().zip(from_chains).enumerate() {
            let queued = queue.front().copied();
            let moves = match self.stores.get_mut(chain) {
                None => queued.is_some() && outputs.query_ready,
                Some(RoundsOfChain { store, given, .. }) => {
                    let takes = queued.filter(|_| store.is_ready() && !reset);
                    let moves = given.front().is_some() && outputs.query_ready;
                    let ready = given.is_ready() && !reset;
                    let offered = store.offers(settings).filter(|_| ready);
                    store.clock(settings, takes, ready, comes[chain].as_ref(), reset);
                    given.clock(moves, offered, reset);
                    takes.is_some()
                }
            };
            let query = query.filter(|query| query.chain as usize == chain);
            queue.clock(moves, query, reset);
        }
    }

    /// The results between chains and stores: each that leaves its place in this clock. A store's own result goes to the place behind it.
    fn results_to_stores(&mut self, from_chains: &[Outputs], reset: bool) -> ResultsOfStores {
        let settings = &self.registers.settings;
        let mut all = ResultsOfStores::default();
        for (chain, rounds) in self.stores.iter_mut().enumerate() {
            let shown = rounds
                .found
                .front()
                .map(|found| (*found, rounds.store.shows(found, settings)));
            let ready = self.from_chains[chain].is_ready() && !reset;
            let moving = shown.filter(|(_, shown)| shown.is_none() || ready);
            let outputs = &from_chains[chain];
            let takes = outputs.result_valid && rounds.found.is_ready() && !reset;
            rounds
                .found
                .clock(moving.is_some(), takes.then_some(*outputs), reset);
            all.comes.push(moving.as_ref().map(|(found, _)| *found));
            all.shown.push(moving.and_then(|(_, shown)| shown));
        }
        all
    }

    /// The results: from the chains to their places, from there through the slices of the chains in front, and to the slice of the stream.
    fn results(
        &mut self,
        from_chains: &[Outputs],
        shown: &[Option<Shown>],
        result_moves: bool,
        reset: bool,
    ) {
        let first = self.merges[0].front().copied();
        let first = first.filter(|_| self.results.is_ready() && !reset);
        self.results.clock(result_moves, first, reset);
        let mut moves_out = first.is_some();
        for (chain, outputs) in from_chains.iter().enumerate() {
            let moves_in = self.moves_in(chain).filter(|_| !reset);
            let takes = moves_in.as_ref().map(|(kind, _)| *kind);
            self.merges[chain].clock(moves_out, moves_in, reset);
            moves_out = takes == Some(Merged::Passing);
            let place = &mut self.from_chains[chain];
            let found = match shown.get(chain) {
                Some(shown) => shown.as_ref().map(|shown| CoreResult {
                    radius_sq: Some(shown.radius_sq),
                    is_final: shown.is_last,
                    ..result_of(chain, &shown.outputs)
                }),
                None => (outputs.result_valid && place.is_ready() && !reset)
                    .then(|| result_of(chain, outputs)),
            };
            place.clock(takes == Some(Merged::Own), found, reset);
        }
    }

    /// The result that goes into the slice of a chain, unless there is a reset.
    fn moves_in(&self, chain: usize) -> Option<(Merged, CoreResult)> {
        let own = self.from_chains[chain].front().copied();
        let behind = self.merges.get(chain + 1);
        let passing = behind.and_then(|merge| merge.front().copied());
        let kind = self.merges[chain].takes(own.is_some(), passing.is_some())?;
        let word = match kind {
            Merged::Own => own,
            Merged::Passing => passing,
        };
        word.map(|word| (kind, word))
    }

    fn happens(&self, inputs: &CoreInputs, outputs: &CoreOutputs) -> Happens {
        let leaf = self.photons.front();
        let fate = leaf.map(|leaf| match self.ports.get(leaf.chain as usize) {
            Some(port) => port.fate(self.resets()),
            None => Fate::Refused,
        });
        let leaf_given = fate == Some(Fate::Given);
        let leaf_unknown = leaf.is_some_and(|leaf| leaf.chain >= self.core.chains);
        let too_long =
            |leaf: &LeafWord| self.ports[leaf.chain as usize].is_too_long(leaf, &self.core);
        let query = self.queries.front();
        let query_refused = query.is_some_and(|query| query.chain >= self.core.chains);
        let query_given = query.is_some_and(|query| {
            let chain = query.chain as usize;
            self.to_chains.get(chain).is_some_and(Link::is_ready) && !self.resets()
        });
        let result = self.result();
        let result_moves = result.is_some() && inputs.result_ready;
        Happens {
            photon_moves: inputs.photons.valid && outputs.photon_ready,
            photon_waits: inputs.photons.valid && !outputs.photon_ready,
            query_moves: inputs.queries.valid && outputs.query_ready,
            query_waits: inputs.queries.valid && !outputs.query_ready,
            result_moves,
            result_ends: result_moves && result.is_some_and(|result| result.is_final),
            result_waits: result.is_some() && !inputs.result_ready,
            result_photons: result
                .filter(|_| result_moves)
                .map_or(0, |result| result.sums.count),
            leaf_given,
            leaf_refused: fate == Some(Fate::Refused),
            leaf_malformed: leaf_given && leaf.is_some_and(LeafWord::is_malformed),
            set_too_long: leaf_given && leaf.is_some_and(too_long),
            query_given,
            query_refused,
            query_outside: query_given && query.is_some_and(|query| query.outside),
            chain_unknown: leaf_unknown || query_refused,
            in_chains: match self.resets() {
                true => InChains::default(),
                false => self.in_chains,
            },
        }
    }

    /// The leaf of a word of the photon stream. Where a photon is absent, its other bits mean nothing.
    fn leaf(&self, beat: &Beat) -> LeafWord {
        let values = self.streams.photons.values(&beat.data);
        let (mut lanes, facing) = CoreStreams::leaf_of(&self.core, &values);
        for lane in lanes.iter_mut().filter(|lane| !lane.present) {
            *lane = Lane::default();
        }
        LeafWord {
            lanes,
            facing,
            last: beat.last,
            chain: beat.dest,
        }
    }

    /// The query of a word of the query stream.
    fn query(&self, beat: &Beat) -> QueryIn {
        let word = &self.streams.queries;
        let values = word.values(&beat.data);
        let number = |place: usize| values[place] as u32;
        // The same fields without any other bit: a query in its frame has no other.
        let outside = word.bytes(&values) != beat.data;
        QueryIn {
            word: QueryWord {
                query: Query {
                    position: [number(0), number(1), number(2)],
                    radius_sq: self.fixed_radius_sq.unwrap_or_else(|| number(6)),
                },
                release: number(5) != 0,
                batch: BatchPins {
                    last: beat.last,
                    facings: number(4),
                    tag: number(3),
                },
            },
            outside,
            chain: beat.dest,
        }
    }
}

/// The stages in front of each chain.
fn core_stages(core: &Core) -> impl Iterator<Item = usize> {
    (0..core.chains).map(|chain| core.stages(chain) as usize)
}

/// The result of a chain, as it enters its slice.
fn result_of(chain: usize, outputs: &Outputs) -> CoreResult {
    let flag = |bit: u32| outputs.result_tag >> bit & 1 == 1;
    let outside = flag(Core::OUTSIDE_BIT);
    CoreResult {
        sums: match outside {
            true => Sums::default(),
            false => outputs.result,
        },
        tag: outputs.result_tag & ((1 << Core::TAG_BITS) - 1),
        last: flag(Core::LAST_BIT),
        outside,
        chain: chain as u32,
        radius_sq: None,
        is_final: true,
    }
}

/// Of each store, the result of its chain that it takes in a clock, and the result that it gives. Empty where there are no stores.
#[derive(Debug, Default)]
struct ResultsOfStores {
    comes: Vec<Option<Outputs>>,
    shown: Vec<Option<Shown>>,
}
