//! Drives the golden model of a core with random words, waits, accesses and resets, and writes down its pins.

use std::collections::{BTreeMap, VecDeque};

use photoncube_model::CoreModel;
use photoncube_spec::{
    Core, CoreEvent, CoreInputs, CoreOutputs, CorePins, CoreRegister, CoreRegisterRow, CoreStreams,
    EventRow, LiteIn, QueryResult, StreamIn,
};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

use super::plan::{Draw, Plan};
use super::{CoreError, CoreOptions};

/// Rows of pins of successive clocks.
#[derive(Debug, Default)]
pub(super) struct Rows {
    pub(super) inputs: Vec<u64>,
    pub(super) expected: Vec<u64>,
}

/// What happened in the stimulus.
#[derive(Clone, Debug, Default)]
pub(super) struct Happened {
    pub(super) leaves: u64,
    pub(super) queries: u64,
    pub(super) results: u64,
    pub(super) accesses: u64,
    pub(super) resets: u64,
    pub(super) restarts: u64,
    /// How often each event was set, by name.
    pub(super) events: BTreeMap<&'static str, u64>,
}

/// The chances, of 256, that a word is offered or a result taken in a clock. They are drawn anew from time to time.
#[derive(Copy, Clone, Debug)]
struct Pace {
    photons: u32,
    queries: u32,
    results: u32,
    accesses: u32,
}

pub(super) struct Drive<'a> {
    core: &'a Core,
    streams: &'a CoreStreams,
    rows: Vec<CoreRegisterRow>,
    draw: Draw<'a, Pcg64>,
    model: CoreModel,
    plan: Plan,
    inputs: CoreInputs,
    pace: Pace,
    /// [`seldom()`] of the core.
    seldom: u32,
    clock: u64,
    events_before: u32,
    reset_before: bool,
    /// A reset waits for the next leaf that is taken.
    reset_waits: bool,
    /// Clocks until a reset that follows a leaf.
    reset_in: Option<u32>,
    /// A read of an address without a register was taken in the clock before, in which its answer is found.
    read_found: bool,
    /// The answer to such a read was found in the clock before: in this clock it is answered.
    read_refused: bool,
    /// No words are drawn until no query is under way; then other rounds are.
    drains: bool,
    /// Words that wait to be written to registers of the rounds: their addresses and the words.
    settings: VecDeque<(u32, u32)>,
    /// Such a word is offered.
    sets: bool,
    pub(super) happened: Happened,
}

/// Clocks between two changes of pace, on average.
const PACE_CLOCKS: u32 = 256;
/// A round has a set for each chain. Where the sets of a round have more leaves than this, resets and restarts come less often
/// in proportion, so that a core of large banks comes to the end of its work between them.
const LEAVES_OF_ROUND: u32 = 64;
/// A reset comes once in so many clocks. Every second one waits for a leaf and comes behind it.
const RESET_CLOCKS: u32 = 3000;
/// The clocks behind a leaf in which it passes the stages on its way to a chain.
const CLOCKS_TO_CHAINS: u32 = 4;
/// Behind a read that is refused a reset comes once in so many times, in the clock of its answer.
const RESET_REFUSALS: u32 = 16;
/// The core drains after so many sets of each chain, on average, and its rounds change.
const SETS_TO_DRAIN: u32 = 3;
/// One word in so many that are written may be a command to restart.
const RESTART_WORDS: u32 = 8;

/// How many times less often resets and restarts come than in a core of small banks.
pub(super) fn seldom(core: &Core) -> u32 {
    (core.chains * core.set_leaves() / LEAVES_OF_ROUND).max(1)
}

impl<'a> Drive<'a> {
    pub(super) fn new(
        core: &'a Core,
        streams: &'a CoreStreams,
        digest: u64,
        options: &CoreOptions,
    ) -> Self {
        let model = CoreModel::new(core, digest);
        Self {
            core,
            streams,
            rows: CoreRegister::all(core, digest),
            draw: Draw::new(core, streams, Pcg64::seed_from_u64(options.seed)),
            model: model.with_counters_from(options.counters_from),
            plan: Plan::default(),
            inputs: CoreInputs::default(),
            pace: Pace {
                photons: 256,
                queries: 256,
                results: 256,
                accesses: 64,
            },
            seldom: seldom(core),
            clock: 0,
            events_before: 0,
            reset_before: false,
            reset_waits: false,
            reset_in: None,
            read_found: false,
            read_refused: false,
            drains: false,
            settings: VecDeque::new(),
            sets: false,
            happened: Happened::default(),
        }
    }

    /// Runs so many clocks.
    pub(super) fn run(&mut self, clocks: usize, rows: &mut Rows) -> Result<(), CoreError> {
        for _ in 0..clocks {
            self.clock(rows)?;
        }
        Ok(())
    }

    fn chance(&mut self, of_256: u32) -> bool {
        self.draw.rng().random_range(0..256) < of_256
    }

    fn one_in(&mut self, number: u32) -> bool {
        self.draw.rng().random_range(0..number) == 0
    }

    fn clock(&mut self, rows: &mut Rows) -> Result<(), CoreError> {
        if self.plan.photons.is_empty() && self.plan.queries.is_empty() {
            self.next_words();
        }
        if self.one_in(PACE_CLOCKS) {
            let mut chance = || [8, 64, 192, 256][self.draw.rng().random_range(0..4)];
            self.pace = Pace {
                photons: chance(),
                queries: chance(),
                results: chance(),
                accesses: chance() / 2,
            };
        }
        self.offer();
        self.inputs.reset = self.resets();
        self.inputs.result_ready = self.chance(self.pace.results);
        rows.inputs
            .extend(CorePins::input_row(self.streams, &self.inputs));
        let outputs = self.model.outputs(&self.inputs);
        rows.expected
            .extend(CorePins::output_row(self.streams, &outputs));
        let ends = self.inputs.reset || self.model.resets();
        self.note(&outputs)?;
        self.model.clock(&self.inputs);
        self.note_events();
        self.retire(&outputs);
        if ends {
            // What was under way is lost, and so are the words that would have followed it.
            self.plan = Plan::default();
            self.inputs = CoreInputs::default();
            self.settings.clear();
            self.sets = false;
            self.set_rounds();
            // Often the events are read before an access can set one, so that an event which the reset left is seen.
            self.inputs.lite.read_address = self.events_address();
            self.inputs.lite.read_address_valid = self.one_in(2);
        }
        self.clock += 1;
        Ok(())
    }

    /// Whether there is a reset in this clock.
    fn resets(&mut self) -> bool {
        let clocks = match self.read_refused {
            true => RESET_REFUSALS,
            false => RESET_CLOCKS,
        };
        if let Some(left) = &mut self.reset_in {
            *left -= 1;
            let is_due = *left == 0;
            self.reset_in = self.reset_in.filter(|_| !is_due);
            return is_due;
        }
        let comes = self.one_in(clocks * self.seldom);
        let waits = comes && !self.read_refused && self.one_in(2);
        self.reset_waits |= waits;
        comes && !waits
    }

    /// Draws the next words. Now and then it waits until no query is under way, which alone is when rounds may change.
    fn next_words(&mut self) {
        let is_idle = self.plan.owed.iter().all(VecDeque::is_empty);
        match self.drains {
            true if is_idle => {
                self.drains = false;
                self.set_rounds();
            }
            false if self.settings.is_empty() && !self.sets => {
                self.draw.round(&mut self.plan);
                self.drains = self.one_in(SETS_TO_DRAIN);
            }
            _ => {}
        }
    }

    /// Draws other rounds, and has the words of their registers wait.
    fn set_rounds(&mut self) {
        if !self.core.has_radii() {
            return;
        }
        for (register, word) in self.draw.other_rounds() {
            let row = self.rows.iter().find(|row| row.register == register);
            let row = row.expect("the map has all registers");
            self.settings.push_back((row.address, word));
        }
    }

    /// Offers words where none is offered. A word that is offered stays.
    fn offer(&mut self) {
        let offers = self.chance(self.pace.photons);
        if !self.inputs.photons.valid {
            let next = self.plan.photons.front().filter(|_| offers).cloned();
            let idle = || self.draw.idle(self.streams.photons.bits);
            self.inputs.photons = StreamIn {
                valid: next.is_some(),
                beat: next.unwrap_or_else(idle),
            };
        }
        let offers = self.chance(self.pace.queries);
        if !self.inputs.queries.valid {
            let next = self.plan.queries.front().filter(|_| offers).cloned();
            let idle = || self.draw.idle(self.streams.queries.bits);
            self.inputs.queries = StreamIn {
                valid: next.is_some(),
                beat: next.unwrap_or_else(idle),
            };
        }
        self.access();
    }

    /// Accesses to registers. Address and data of a write may come in either order.
    fn access(&mut self) {
        let [address, data, read] = [(); 3].map(|()| self.chance(self.pace.accesses));
        let mut lite = self.inputs.lite;
        if !lite.write_address_valid
            && !lite.write_data_valid
            && let Some((address, word)) = self.settings.pop_front()
        {
            (lite.write_address, lite.write_data, lite.write_strobe) = (address, word, 15);
            (lite.write_address_valid, lite.write_data_valid) = (true, true);
            self.sets = true;
        }
        if !lite.write_address_valid {
            lite.write_address = self.address_to_write();
            lite.write_address_valid = address;
        }
        if !lite.write_data_valid {
            lite.write_data_valid = data;
            lite.write_data = self.word();
            lite.write_strobe = match self.one_in(4) {
                true => self.draw.rng().random_range(0..16),
                false => 15,
            };
        }
        if !lite.read_address_valid {
            lite.read_address = self.address();
            lite.read_address_valid = read;
        }
        lite.write_answer_ready = self.chance(self.pace.accesses);
        lite.read_answer_ready = self.chance(self.pace.accesses);
        self.inputs.lite = lite;
    }

    fn events_address(&self) -> u32 {
        let mut rows = self.rows.iter();
        let events = rows.find(|row| row.register == CoreRegister::Events);
        events.expect("the map has all registers").address
    }

    /// An address that changes no rounds. It is often that of the events, so that some are cleared in the clock in which they occur.
    fn address_to_write(&mut self) -> u32 {
        if self.one_in(4) {
            return self.events_address();
        }
        let of_rounds = |row: &CoreRegisterRow| row.address >= CoreRegister::ROUNDS;
        let rounds: Vec<_> = self.rows.iter().filter(|row| of_rounds(row)).collect();
        let rounds: Vec<_> = rounds.iter().map(|row| row.address).collect();
        loop {
            let address = self.address();
            if !rounds.contains(&(address & !3)) {
                return address;
            }
        }
    }

    /// An address: mostly that of a register, sometimes any.
    fn address(&mut self) -> u32 {
        match self.one_in(8) {
            true => self.draw.rng().random_range(0..1 << Core::ADDRESS_BITS),
            false => {
                // Most accesses are to registers that are no counters.
                let counters = self.one_in(4);
                let is_counter = |row: &CoreRegisterRow| row.address >= CoreRegister::COUNTERS;
                let rows = self.rows.iter();
                let rows: Vec<_> = rows.filter(|row| is_counter(row) == counters).collect();
                let place = self.draw.rng().random_range(0..rows.len());
                rows[place].address
            }
        }
    }

    /// A word to write: small, so that it is a stall limit that a test can reach, and seldom the command to restart.
    fn word(&mut self) -> u32 {
        let word = self.draw.rng().random_range(0..256);
        match self.one_in(RESTART_WORDS * self.seldom) {
            true => word | CoreRegister::RESTART,
            false => word & !CoreRegister::RESTART,
        }
    }

    /// Holds the results against what the chains owe, and counts.
    fn note(&mut self, outputs: &CoreOutputs) -> Result<(), CoreError> {
        self.happened.resets += u64::from(self.inputs.reset);
        let restarts = self.model.resets() && !self.reset_before;
        self.reset_before = self.inputs.reset;
        self.happened.restarts += u64::from(restarts);
        if let Some(result) = outputs.result.as_ref().filter(|_| self.inputs.result_ready) {
            let QueryResult {
                sums,
                tag,
                radius_sq,
            } = CoreStreams::result_of(self.core, &self.streams.results.values(&result.data));
            let owed = self.plan.owed.get_mut(result.id as usize);
            let expected = owed.and_then(|owed| owed.pop_front());
            let found = super::plan::Expected {
                sums,
                tag,
                radius_sq: radius_sq.filter(|_| !result.outside),
                last: result.last,
                outside: result.outside,
            };
            if expected.as_ref() != Some(&found) {
                return Err(CoreError::Model {
                    clock: self.clock,
                    found: format!("{found:?} of chain {}", result.id),
                    expected: format!("{expected:?}"),
                });
            }
            self.happened.results += 1;
        }
        Ok(())
    }

    fn note_events(&mut self) {
        let events = self.model.events();
        let fresh = events & !self.events_before;
        for row in EventRow::ALL
            .iter()
            .filter(|row| fresh & row.event.bit() != 0)
        {
            *self.happened.events.entry(row.name).or_default() += 1;
        }
        self.events_before = events;
    }

    /// Takes back the words that moved.
    fn retire(&mut self, outputs: &CoreOutputs) {
        let moved = |stream: &mut StreamIn, ready: bool| {
            let moved = stream.valid && ready;
            stream.valid &= !ready;
            moved
        };
        if moved(&mut self.inputs.photons, outputs.photon_ready) {
            self.plan.photons.pop_front();
            self.happened.leaves += 1;
            if std::mem::take(&mut self.reset_waits) {
                self.reset_in = Some(self.draw.rng().random_range(1..=CLOCKS_TO_CHAINS));
            }
        }
        if moved(&mut self.inputs.queries, outputs.query_ready) {
            self.plan.queries.pop_front();
            self.happened.queries += 1;
        }
        let lite: &mut LiteIn = &mut self.inputs.lite;
        let reads = outputs.read_ready && lite.read_address_valid;
        let is_read = |row: &CoreRegisterRow| row.address == lite.read_address & !3;
        let refused = reads && !self.rows.iter().any(is_read);
        self.read_refused = std::mem::replace(&mut self.read_found, refused);
        if outputs.write_ready {
            lite.write_address_valid = false;
            lite.write_data_valid = false;
            self.sets = false;
            self.happened.accesses += 1;
        }
        if reads {
            lite.read_address_valid = false;
            self.happened.accesses += 1;
        }
    }
}

/// The events that a core of these chains can have.
pub(super) fn possible_events(core: &Core) -> impl Iterator<Item = &'static EventRow> {
    let names_unknown = core.chains < 1 << core.chain_bits();
    EventRow::ALL
        .iter()
        .filter(move |row| names_unknown || row.event != CoreEvent::ChainUnknown)
}
