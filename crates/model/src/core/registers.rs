//! The registers of a core, and its counters.

use photoncube_spec::{
    Core, CoreCounter, CoreEvent, CoreRegister, CoreRegisterRow, CounterRow, LiteAnswer, LiteIn,
    Outputs,
};

use super::rounds::Settings;

/// What happens in a clock outside of the registers.
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct Happens {
    pub(super) photon_moves: bool,
    pub(super) photon_waits: bool,
    pub(super) query_moves: bool,
    pub(super) query_waits: bool,
    pub(super) result_moves: bool,
    /// The result that moves is the last of its query.
    pub(super) result_ends: bool,
    pub(super) result_waits: bool,
    /// The count of the result that moves.
    pub(super) result_photons: u64,
    pub(super) leaf_given: bool,
    pub(super) leaf_refused: bool,
    pub(super) leaf_malformed: bool,
    pub(super) set_too_long: bool,
    pub(super) query_given: bool,
    pub(super) query_refused: bool,
    pub(super) query_outside: bool,
    pub(super) chain_unknown: bool,
    /// Of the clock before.
    pub(super) in_chains: InChains,
}

/// What all chains do in a clock.
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct InChains {
    compared: u64,
    wanted: u64,
    played: u64,
}

impl InChains {
    /// The sums over the chains.
    pub(super) fn of(chains: &[Outputs]) -> Self {
        let sum = |of: fn(&Outputs) -> u32| chains.iter().map(|chain| u64::from(of(chain))).sum();
        Self {
            compared: sum(|outputs| outputs.events.compared),
            wanted: sum(|outputs| outputs.events.wanted),
            played: sum(|outputs| outputs.events.played.into()),
        }
    }
}

/// A write in a clock, with the bits that its strobe leaves.
#[derive(Copy, Clone, Debug)]
struct Write {
    register: Option<CoreRegister>,
    mask: u32,
    word: u32,
}

#[derive(Clone, Debug)]
pub(super) struct Registers {
    rows: Vec<CoreRegisterRow>,
    write_answer: Option<LiteAnswer>,
    read_answer: Option<LiteAnswer>,
    /// The read that was taken in the clock before: its register, if there is one at its address.
    reading: Option<Option<CoreRegisterRow>>,
    /// The answer that was found in the clock before.
    found: Option<LiteAnswer>,
    /// The next clock is a reset of streams and chains.
    pub(super) reset: bool,
    events: u32,
    interrupt_enable: u32,
    stall_limit: u32,
    pub(super) settings: Settings,
    under_way: u32,
    /// Whether a query was given in the clock before.
    query_came: bool,
    /// Whether the last result of a query left in the clock before.
    result_went: bool,
    /// Whether the clock before was silent.
    seen_silent: bool,
    /// Silent clocks up to the one before that.
    silent_clocks: u32,
    counter_high: u32,
    counters: Vec<u64>,
    /// The value of a counter that is cleared.
    cleared: u64,
    /// What happened in the clock before.
    before: Seen,
}

/// What counters and events are told of a clock.
#[derive(Copy, Clone, Debug, Default)]
struct Seen {
    happens: Happens,
    busy: bool,
    /// Accesses that were refused.
    refused: u64,
    /// Bits of the events that occurred.
    events: u32,
}

impl Registers {
    pub(super) fn new(core: &Core, digest: u64) -> Self {
        let rows = CoreRegister::all(core, digest);
        let limit = rows
            .iter()
            .find(|row| row.register == CoreRegister::StallLimit);
        Self {
            write_answer: None,
            read_answer: None,
            reading: None,
            found: None,
            reset: false,
            events: 0,
            interrupt_enable: 0,
            stall_limit: limit.map_or(0, |row| row.reset),
            settings: Settings::default(),
            under_way: 0,
            query_came: false,
            result_went: false,
            seen_silent: false,
            silent_clocks: 0,
            counter_high: 0,
            counters: vec![0; CounterRow::ALL.len()],
            cleared: 0,
            before: Seen::default(),
            rows,
        }
    }

    /// Clears the counters to another value than 0.
    pub(super) fn clear_to(&mut self, cleared: u64) {
        self.cleared = cleared;
        self.counters.fill(cleared);
    }

    pub(super) fn events(&self) -> u32 {
        self.events
    }

    pub(super) fn interrupt(&self) -> bool {
        self.events & self.interrupt_enable != 0
    }

    pub(super) fn write_answer(&self) -> Option<LiteAnswer> {
        self.write_answer
    }

    pub(super) fn read_answer(&self) -> Option<LiteAnswer> {
        self.read_answer
    }

    /// Whether a query is under way.
    pub(super) fn is_busy(&self) -> bool {
        self.under_way > 0
    }

    /// A read is taken if there is one.
    pub(super) fn is_ready_to_read(&self) -> bool {
        self.read_answer.is_none() && self.reading.is_none() && self.found.is_none()
    }

    /// A write is taken.
    pub(super) fn writes(&self, lite: &LiteIn) -> bool {
        lite.write_address_valid && lite.write_data_valid && self.write_answer.is_none()
    }

    /// The register of the word at an address.
    fn at(&self, address: u32) -> Option<&CoreRegisterRow> {
        self.rows.iter().find(|row| row.address == address & !3)
    }

    fn write(&self, lite: &LiteIn) -> Write {
        let bytes = (0..4).filter(|byte| lite.write_strobe >> byte & 1 == 1);
        let mask = bytes.map(|byte| 0xff << (8 * byte)).sum();
        let row = self.at(lite.write_address);
        Write {
            register: row
                .filter(|row| row.access != photoncube_spec::Access::Read)
                .map(|row| row.register),
            mask,
            word: lite.write_data & mask,
        }
    }

    /// The word of a register, in a clock with these events.
    fn word(&self, row: &CoreRegisterRow, happens: &Happens) -> u32 {
        use CoreRegister as R;
        match row.register {
            R::Identity | R::Version | R::DigestLow | R::DigestHigh | R::Shape => row.reset,
            R::Control => 0,
            R::Status => {
                let bits = [
                    self.under_way > 0,
                    happens.photon_waits,
                    happens.query_waits,
                    happens.result_waits,
                ];
                let bits = bits.into_iter().zip(0..);
                bits.map(|(bit, place)| u32::from(bit) << place).sum()
            }
            R::Events => self.events,
            R::InterruptEnable => self.interrupt_enable,
            R::StallLimit => self.stall_limit,
            R::UnderWay => self.under_way,
            R::CounterLow(counter) => self.counters[counter as usize] as u32,
            R::CounterHigh(_) => self.counter_high,
            R::Nearest => self.settings.nearest,
            R::Rungs => self.settings.rungs,
            R::Rung(rung) => self.settings.radii[rung as usize],
        }
    }

    /// A clock without `aresetn` = 0.
    pub(super) fn clock(&mut self, lite: &LiteIn, happens: &Happens) {
        let resets = self.reset;
        let write = self.writes(lite).then(|| self.write(lite));
        let reads = lite.read_address_valid && self.is_ready_to_read();
        let taken = reads.then(|| self.at(lite.read_address).cloned());
        let read = std::mem::replace(&mut self.reading, taken);
        let found = read.map(|row| self.find(row, happens));
        let found = std::mem::replace(&mut self.found, found);
        let write_refused = write.is_some_and(|write| write.register.is_none());
        let read_refused = found.is_some_and(|answer| answer.refused);
        let refused = u64::from(write_refused) + u64::from(read_refused);
        let stalls = self.stalls(happens);
        let seen = Seen {
            happens: *happens,
            busy: self.under_way > 0,
            refused,
            events: self.occurs(happens, refused > 0, stalls),
        };
        self.answer_read(lite, found);
        let before = std::mem::replace(&mut self.before, seen);
        self.count(&before);
        self.answer_write(lite, write);
        self.events |= before.events;
        self.under_way += u32::from(std::mem::replace(&mut self.query_came, happens.query_given));
        self.under_way -= u32::from(std::mem::replace(
            &mut self.result_went,
            happens.result_ends,
        ));
        if let Some(write) = write
            && write.register == Some(CoreRegister::Control)
            && write.word & CoreRegister::CLEAR_COUNTERS != 0
        {
            self.counters.fill(self.cleared);
        }
        if resets {
            self.under_way = 0;
            self.query_came = false;
            self.result_went = false;
            self.seen_silent = false;
            self.silent_clocks = 0;
        }
    }

    /// A clock with `aresetn` = 0.
    pub(super) fn reset(&mut self, core: &Core, digest: u64) {
        let cleared = self.cleared;
        *self = Self::new(core, digest);
        self.clear_to(cleared);
        self.reset = true;
    }

    /// Counts the clock before if it was silent, and says whether the core is now stalled.
    fn stalls(&mut self, happens: &Happens) -> bool {
        let moves = happens.photon_moves || happens.query_moves || happens.result_moves;
        let waits = self.under_way > 0 || happens.photon_waits || happens.query_waits;
        let plays = self.has_rounds() && happens.in_chains.played > 0;
        let stalls = self.stall_limit > 0 && self.silent_clocks == self.stall_limit;
        self.silent_clocks = match self.seen_silent {
            true => self.silent_clocks.wrapping_add(1),
            false => 0,
        };
        self.seen_silent = waits && !moves && !happens.result_waits && !plays;
        stalls
    }

    fn occurs(&self, happens: &Happens, refused: bool, stalls: bool) -> u32 {
        let ends = self.result_went && self.under_way == 1 && !self.query_came;
        let events = [
            (CoreEvent::Done, ends),
            (CoreEvent::LeafMalformed, happens.leaf_malformed),
            (CoreEvent::SetTooLong, happens.set_too_long),
            (CoreEvent::QueryOutside, happens.query_outside),
            (CoreEvent::ChainUnknown, happens.chain_unknown),
            (CoreEvent::AccessRefused, refused),
            (CoreEvent::Stalled, stalls),
        ];
        let occurring = events.into_iter().filter(|(_, occurs)| *occurs);
        occurring.map(|(event, _)| event.bit()).sum()
    }

    /// The answer to a read of a register, as the registers are in this clock.
    fn find(&mut self, row: Option<CoreRegisterRow>, happens: &Happens) -> LiteAnswer {
        let answer = LiteAnswer {
            refused: row.is_none(),
            word: row.as_ref().map_or(0, |row| self.word(row, happens)),
        };
        if let Some(CoreRegister::CounterLow(counter)) = row.map(|row| row.register) {
            self.counter_high = (self.counters[counter as usize] >> 32) as u32;
        }
        answer
    }

    fn answer_read(&mut self, lite: &LiteIn, found: Option<LiteAnswer>) {
        match found {
            Some(_) => self.read_answer = found,
            None if lite.read_answer_ready => self.read_answer = None,
            None => {}
        }
    }

    fn answer_write(&mut self, lite: &LiteIn, write: Option<Write>) {
        self.reset = false;
        let Some(write) = write else {
            if lite.write_answer_ready {
                self.write_answer = None;
            }
            return;
        };
        self.write_answer = Some(LiteAnswer {
            refused: write.register.is_none(),
            word: 0,
        });
        let put = |value: u32| value & !write.mask | write.word;
        match write.register {
            Some(CoreRegister::Control) => {
                self.reset = write.word & CoreRegister::RESTART != 0;
            }
            Some(CoreRegister::Events) => self.events &= !write.word,
            Some(CoreRegister::InterruptEnable) => {
                self.interrupt_enable = put(self.interrupt_enable) & CoreRegister::all_events();
            }
            Some(CoreRegister::StallLimit) => self.stall_limit = put(self.stall_limit),
            Some(register) => {
                let width = self.width(register);
                let setting = match register {
                    CoreRegister::Nearest => &mut self.settings.nearest,
                    CoreRegister::Rungs => &mut self.settings.rungs,
                    CoreRegister::Rung(rung) => &mut self.settings.radii[rung as usize],
                    _ => return,
                };
                *setting = put(*setting) & (u32::MAX >> (u32::BITS - width));
            }
            None => {}
        }
    }

    /// Whether each query may have several rounds.
    fn has_rounds(&self) -> bool {
        self.rows
            .iter()
            .any(|row| row.register == CoreRegister::Nearest)
    }

    /// Bits of the first field of a register; of a register without fields all.
    fn width(&self, register: CoreRegister) -> u32 {
        let row = self.rows.iter().find(|row| row.register == register);
        let field = row.and_then(|row| row.fields.first());
        field.map_or(u32::BITS, |field| field.width)
    }

    fn count(&mut self, seen: &Seen) {
        use CoreCounter as C;
        let (happens, chains) = (&seen.happens, &seen.happens.in_chains);
        for row in CounterRow::ALL {
            let more = match row.counter {
                C::Clocks => 1,
                C::BusyClocks => seen.busy.into(),
                C::LeavesRead => happens.leaf_given.into(),
                C::QueriesRead => happens.query_given.into(),
                C::Results => happens.result_moves.into(),
                C::LeavesCompared => chains.compared,
                C::LeavesWanted => chains.wanted,
                C::GroupsPlayed => chains.played,
                C::PhotonsInRange => happens.result_photons,
                C::PhotonStalls => happens.photon_waits.into(),
                C::QueryStalls => happens.query_waits.into(),
                C::ResultStalls => happens.result_waits.into(),
                C::LeavesMalformed => happens.leaf_malformed.into(),
                C::LeavesRefused => happens.leaf_refused.into(),
                C::QueriesOutside => happens.query_outside.into(),
                C::QueriesRefused => happens.query_refused.into(),
                C::AccessesRefused => seen.refused,
            };
            let counter = &mut self.counters[row.counter as usize];
            *counter = (*counter + more) % (1 << Core::COUNTER_BITS);
        }
    }

    /// The value of a counter.
    pub(super) fn counter(&self, counter: CoreCounter) -> u64 {
        self.counters[counter as usize]
    }
}
