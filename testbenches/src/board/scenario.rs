//! What goes to a board: random words, damaged frames, more than its buffer holds.

use photoncube_model::SerialFrame;
use photoncube_spec::{
    Beat, Core, CoreCounter, CoreRegister, CoreStreams, Serial, SerialKind, SerialSizes,
};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

use crate::core::plan::{Draw, Plan};
use crate::device::Symbol;

/// A list of steps.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Scenario {
    /// Words and accesses, right and wrong ones, in right frames.
    Words,
    /// Frames that are damaged, cut, lost, doubled, too many, and what the host does then.
    Damage,
    /// More frames than the buffer holds, a session that begins behind them, and a reset by the board's button.
    Full,
}

/// Bytes that go to a board, after which it has time to answer.
#[derive(Clone, Debug, Default)]
pub(super) struct Step {
    symbols: Vec<Symbol>,
    right: usize,
    wrong: usize,
}

impl Step {
    pub(super) fn symbols(&self) -> Vec<Symbol> {
        self.symbols.clone()
    }

    pub(super) fn right(&self) -> usize {
        self.right
    }

    pub(super) fn wrong(&self) -> usize {
        self.wrong
    }

    fn frame(&mut self, frame: &SerialFrame) {
        self.symbols
            .extend(frame.line().into_iter().map(Symbol::Byte));
        self.right += 1;
    }

    fn wrong_symbols(&mut self, symbols: impl IntoIterator<Item = Symbol>) {
        self.symbols.extend(symbols);
        self.wrong += 1;
    }
}

impl Scenario {
    /// All scenarios.
    pub const ALL: [Self; 3] = [Self::Words, Self::Damage, Self::Full];

    /// Its steps on a core.
    pub(super) fn steps(self, core: &Core, seed: u64) -> Vec<Step> {
        let streams = CoreStreams::of(core);
        let mut host = Host::new(core, &streams, seed);
        match self {
            Self::Words => host.words(),
            Self::Damage => host.damage(),
            Self::Full => host.full(),
        }
        host.steps
    }
}

/// The host of a scenario.
struct Host<'a> {
    core: Core,
    sizes: SerialSizes,
    draw: Draw<'a, Pcg64>,
    rng: Pcg64,
    steps: Vec<Step>,
    number: u8,
    token: u8,
}

impl<'a> Host<'a> {
    fn new(core: &'a Core, streams: &'a CoreStreams, seed: u64) -> Self {
        let mut host = Self {
            core: *core,
            sizes: SerialSizes::of(core),
            draw: Draw::new(core, streams, Pcg64::seed_from_u64(seed)),
            rng: Pcg64::seed_from_u64(seed + 1),
            steps: Vec::new(),
            number: 0,
            token: 0,
        };
        host.sync(true);
        host
    }

    fn step(&mut self) -> &mut Step {
        self.steps.push(Step::default());
        self.steps.last_mut().expect("it was pushed")
    }

    fn sync(&mut self, begins: bool) {
        self.token = self.token.wrapping_add(1);
        if begins {
            self.number = 0;
        }
        let frame = SerialFrame {
            kind: SerialKind::Sync,
            // It is not looked at.
            number: self.rng.random(),
            payload: vec![self.token, if begins { Serial::BEGINS } else { 0 }],
        };
        self.step().frame(&frame);
    }

    /// The next frame.
    fn next(&mut self, kind: SerialKind, payload: Vec<u8>) -> SerialFrame {
        let number = self.number;
        self.number = number.wrapping_add(1);
        SerialFrame {
            kind,
            number,
            payload,
        }
    }

    fn word(&mut self, kind: SerialKind, beat: &Beat) -> SerialFrame {
        let mark = beat.dest | u32::from(beat.last) << Serial::MARK_LAST;
        let mut payload = vec![mark as u8];
        payload.extend(&beat.data);
        payload.truncate(self.sizes.payload(kind));
        self.next(kind, payload)
    }

    fn access(&mut self, register: CoreRegister, word: Option<u32>) -> SerialFrame {
        let rows = CoreRegister::all(&self.core, 0);
        let row = rows.iter().find(|row| row.register == register);
        let address = row.expect("the map has all registers").address as u16;
        let mut payload = address.to_le_bytes().to_vec();
        payload.extend(word.into_iter().flat_map(u32::to_le_bytes));
        let kind = match word {
            None => SerialKind::Read,
            Some(_) => SerialKind::Write,
        };
        self.next(kind, payload)
    }

    /// The frames of a round of words: sets for all chains, then their batches.
    fn round(&mut self) -> Vec<SerialFrame> {
        let mut plan = Plan::default();
        self.draw.round(&mut plan);
        let photons = plan.photons.into_iter();
        let words: Vec<_> = photons
            .map(|beat| (SerialKind::Photons, beat))
            .chain(
                plan.queries
                    .into_iter()
                    .map(|beat| (SerialKind::Query, beat)),
            )
            .collect();
        words
            .iter()
            .map(|(kind, beat)| self.word(*kind, beat))
            .collect()
    }

    /// A register whose word does not depend on the clocks of the line.
    fn register(&mut self) -> CoreRegister {
        use CoreCounter as C;
        let counters = [C::LeavesRead, C::QueriesRead, C::Results, C::PhotonsInRange];
        match self.rng.random_range(0..4) {
            0 => CoreRegister::DigestLow,
            1 => CoreRegister::Events,
            2 => CoreRegister::InterruptEnable,
            _ => CoreRegister::CounterLow(counters[self.rng.random_range(0..4)]),
        }
    }

    /// No event `stalled`, which depends on the clocks of the line.
    fn never_stalled(&mut self) {
        let frame = self.access(CoreRegister::StallLimit, Some(0));
        self.step().frame(&frame);
    }

    fn words(&mut self) {
        self.never_stalled();
        for _ in 0..3 {
            for frame in self.round() {
                self.step().frame(&frame);
            }
            let word = self.rng.random();
            let accesses = [
                self.access(CoreRegister::InterruptEnable, Some(word)),
                self.access(CoreRegister::UnderWay, Some(word)),
            ];
            let step = self.step();
            accesses.iter().for_each(|frame| step.frame(frame));
            for _ in 0..3 {
                let register = self.register();
                let frame = self.access(register, None);
                self.step().frame(&frame);
            }
        }
        // All frames of a round at once: the buffer fills.
        let frames = self.round();
        let step = self.step();
        frames.iter().for_each(|frame| step.frame(frame));
    }

    fn damage(&mut self) {
        self.never_stalled();
        let mut frames = self.round();
        frames.extend(self.round());
        for (place, frame) in frames.iter().enumerate() {
            if place % 2 == 0 {
                let wrong = self.wrong(place / 2, frame);
                self.step().wrong_symbols(wrong);
                // Dropped, because the board is deaf.
                self.step().frame(frame);
                self.sync(false);
            }
            self.step().frame(frame);
        }
    }

    /// What comes in the place of a frame.
    fn wrong(&mut self, way: usize, frame: &SerialFrame) -> Vec<Symbol> {
        let mut line = frame.line();
        let place = self.rng.random_range(1..line.len());
        match way % 8 {
            0 | 1 => line[place] ^= 1 << self.rng.random_range(0..8),
            2 => drop(line.remove(place)),
            3 => line.truncate(place),
            4 => line.insert(0, self.rng.random_range(0..Serial::ESCAPE)),
            5 => {
                let number = frame.number.wrapping_add(1);
                line = SerialFrame {
                    number,
                    ..frame.clone()
                }
                .line();
            }
            6 => line[1] = b'#',
            _ => {
                let mut symbols: Vec<_> = line.into_iter().map(Symbol::Byte).collect();
                symbols[place] = Symbol::Broken(self.rng.random());
                return symbols;
            }
        }
        // A frame that misses bytes is found wrong at the next flag.
        let ends = (way % 8 == 2 || way % 8 == 3).then_some(Serial::FLAG);
        line.into_iter().chain(ends).map(Symbol::Byte).collect()
    }

    /// Leaves for one chain, without a query: those behind its two sets wait.
    fn full(&mut self) {
        self.never_stalled();
        let bytes = self.sizes.payload(SerialKind::Photons);
        // The buffer, the queue of the chain, its two sets and the slice are full, and more.
        let frames = Serial::BUFFER_BYTES / (bytes + 1) + Core::LEAF_PLACES as usize + 8;
        let step_frames: Vec<_> = (0..frames)
            .map(|_| {
                let mut payload: Vec<u8> = (0..bytes).map(|_| self.rng.random()).collect();
                payload[0] = 1 << Serial::MARK_LAST;
                self.next(SerialKind::Photons, payload)
            })
            .collect();
        for frame in step_frames {
            self.step().frame(&frame);
        }
        self.sync(false);
        self.sync(true);
        let frames = self.round();
        let (before, behind) = frames.split_at(frames.len() / 2);
        for frame in before {
            self.step().frame(frame);
        }
        // What was in the core is gone, and the bridge is deaf.
        self.step().symbols.push(Symbol::Reset);
        for frame in behind {
            self.step().frame(frame);
        }
        self.sync(false);
        self.number = 0;
        for frame in self.round() {
            self.step().frame(&frame);
        }
    }
}
