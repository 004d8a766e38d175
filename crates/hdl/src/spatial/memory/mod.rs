//! The photon memory, by the rules of `photoncube_spec::MemoryRegister`.
//!
//! Its depth and the layout of its words follow from the machine, which rust-hdl's const generics cannot
//! express. So its Verilog is written by hand, with the block RAM and its registers inside.

mod pinned;
mod text;

pub(super) use text::GROUPS;

use photoncube_spec::{MemoryRegister, Spatial};
use rust_hdl::prelude::*;

use crate::defaults::{defaulted, signals};
use crate::parts::{Field, GroupPins, group_fields};

const LANES: usize = Spatial::LANES;
const AXES: [&str; 3] = ["x", "y", "z"];

/// Two banks of groups and the logic that plays them. `H` coordinate, `B` mantissa, `E` exponent bits.
#[derive(LogicBlock)]
pub(crate) struct PhotonMemory<const H: usize, const B: usize, const E: usize> {
    pub clock: Signal<In, Clock>,
    pub reset: Signal<In, Bit>,
    pub group_valid: Signal<In, Bit>,
    pub group_ready: Signal<Out, Bit>,
    pub group_last: Signal<In, Bit>,
    pub present: [Signal<In, Bits<1>>; LANES],
    pub x: [Signal<In, Bits<H>>; LANES],
    pub y: [Signal<In, Bits<H>>; LANES],
    pub z: [Signal<In, Bits<H>>; LANES],
    /// The mantissas: channel c of lane g is at 4 c + g.
    pub channel: Vec<Signal<In, Bits<B>>>,
    pub exponent: Vec<Signal<In, Bits<E>>>,
    pub release_in: Signal<In, Bit>,
    /// Signals from the head: a query is taken; all queries of a batch are taken; there is room for its
    /// results; and the clocks until a last group may be taken.
    pub query_taken: Signal<In, Bit>,
    pub is_full: Signal<In, Bit>,
    pub has_room: Signal<In, Bit>,
    pub clocks_to_last: Signal<In, Bits<16>>,
    pub word_valid: Signal<Out, Bit>,
    pub word_last: Signal<Out, Bit>,
    pub word_present: [Signal<Out, Bits<1>>; LANES],
    pub word_x: [Signal<Out, Bits<H>>; LANES],
    pub word_y: [Signal<Out, Bits<H>>; LANES],
    pub word_z: [Signal<Out, Bits<H>>; LANES],
    pub word_channel: Vec<Signal<Out, Bits<B>>>,
    pub word_exponent: Vec<Signal<Out, Bits<E>>>,
    _state: State,
    /// The words of both banks; a word has a number for each of its fields.
    _groups: Vec<Vec<u64>>,
    /// The word that is written; the word that was read; that word one clock later.
    _write: Vec<u64>,
    _read: Vec<u64>,
    _word: Vec<u64>,
    _bank_groups: usize,
    _channels: &'static [&'static str],
}

/// The registers, except those of the words.
#[derive(Copy, Clone, Debug, Default)]
struct State {
    fill_bank: usize,
    fill_place: usize,
    fill_ready: bool,
    write_valid: bool,
    write_bank: usize,
    write_place: usize,
    full: [bool; 2],
    end: [usize; 2],
    play_bank: usize,
    play_full: bool,
    play_end: usize,
    before_end: usize,
    play_place: usize,
    at_end: bool,
    may_start: bool,
    playing: bool,
    releases: bool,
    release_taken: bool,
    release_next: bool,
    read_valid: bool,
    read_last: bool,
    word_valid: bool,
    word_last: bool,
}

impl<const H: usize, const B: usize, const E: usize> PhotonMemory<H, B, E> {
    pub fn new(spatial: &Spatial, channels: &'static [&'static str]) -> Self {
        let words = channels.len() * LANES;
        let exponents = if E > 0 { LANES } else { 0 };
        let bank_groups = spatial.memory_groups as usize;
        let mut memory = defaulted!(Self {
            channel: signals(words),
            exponent: signals(exponents),
            word_channel: signals(words),
            word_exponent: signals(exponents),
            _state: State::default(),
            _groups: Vec::new(),
            _write: Vec::new(),
            _read: Vec::new(),
            _word: Vec::new(),
            _bank_groups: bank_groups,
            _channels: channels,
        };
            clock reset group_valid group_ready group_last present x y z release_in query_taken is_full has_room
            clocks_to_last word_valid word_last word_present word_x word_y word_z
        );
        memory._word = vec![0; memory.fields().len()];
        memory._read = memory._word.clone();
        memory._write = memory._word.clone();
        memory._groups = vec![memory._word.clone(); 2 * bank_groups];
        memory
    }

    /// The fields of a word, from bit 0 up: for each lane presence, coordinates, mantissas and exponent.
    fn fields(&self) -> Vec<Field> {
        group_fields([H, B, E], self.channel.len())
    }

    /// The number of words in both banks.
    pub fn words(&self) -> usize {
        2 * self._bank_groups
    }

    /// Packs the group on the pins into a word.
    fn group(&self) -> Vec<u64> {
        GroupPins {
            present: &self.present,
            position: [&self.x, &self.y, &self.z],
            channel: &self.channel,
            exponent: &self.exponent,
        }
        .word()
    }

    fn show(&mut self) {
        let mut fields = self._word.iter();
        let mut next = || *fields.next().expect("a word has a number for each field");
        for lane in 0..LANES {
            self.word_present[lane].next = next().to_bits();
            self.word_x[lane].next = next().to_bits();
            self.word_y[lane].next = next().to_bits();
            self.word_z[lane].next = next().to_bits();
            for channel in self.word_channel.iter_mut().skip(lane).step_by(LANES) {
                channel.next = next().to_bits();
            }
            if let Some(exponent) = self.word_exponent.get_mut(lane) {
                exponent.next = next().to_bits();
            }
        }
        self.word_valid.next = self._state.word_valid;
        self.word_last.next = self._state.word_last;
        self.group_ready.next = self._state.fill_ready;
    }

    fn may_start(&self) -> bool {
        let state = &self._state;
        let ends = (state.read_valid && state.read_last) || (state.word_valid && state.word_last);
        let busy = state.playing || state.may_start || ends;
        let in_time = self.clocks_to_last.val().to_u64() <= state.play_end as u64;
        !busy && state.play_full && self.is_full.val() && self.has_room.val() && in_time
    }

    fn step(&mut self) {
        let before = self._state;
        let starts = before.may_start;
        let reads = before.playing || starts;
        let at_end = before.at_end;
        let read = before.play_bank * self._bank_groups + before.play_place;
        self._word.clone_from(&self._read);
        self._read.clone_from(&self._groups[read]);
        if before.write_valid {
            let write = before.write_bank * self._bank_groups + before.write_place;
            self._groups[write].clone_from(&self._write);
        }
        self._write = self.group();
        let mut state = before;
        state.may_start = self.may_start();
        state.play_full = before.full[before.play_bank];
        state.play_end = before.end[before.play_bank];
        let places = self._bank_groups;
        state.before_end = (before.end[before.play_bank] + places - 1) % places;
        state.at_end = match reads {
            true => !at_end && before.play_place == before.before_end,
            false => before.play_end == 0,
        };
        (state.word_valid, state.word_last) = (before.read_valid, before.read_last);
        state.read_valid = reads;
        state.read_last = reads && at_end;
        if reads {
            state.playing = !at_end;
            state.play_place = if at_end { 0 } else { before.play_place + 1 };
            let releases = if starts {
                before.release_next
            } else {
                before.releases
            };
            if at_end && releases {
                state.full[before.play_bank] = false;
                state.play_bank = 1 - before.play_bank;
            }
        }
        if starts {
            state.releases = before.release_next;
            state.release_next = false;
        }
        state.release_taken = self.query_taken.val() && self.release_in.val();
        if before.release_taken {
            state.release_next = true;
        }
        state.fill_ready = !before.full[before.fill_bank];
        if before.fill_ready {
            state.end[before.fill_bank] = before.fill_place;
        }
        let takes_group = self.group_valid.val() && before.fill_ready;
        (state.write_bank, state.write_place) = (before.fill_bank, before.fill_place);
        state.write_valid = takes_group;
        if takes_group {
            let is_last = self.group_last.val() || before.fill_place + 1 == self._bank_groups;
            state.fill_place = if is_last { 0 } else { before.fill_place + 1 };
            if is_last {
                state.full[before.fill_bank] = true;
                state.fill_ready = false;
                state.fill_bank = 1 - before.fill_bank;
            }
        }
        self._state = if self.reset.val() {
            State::default()
        } else {
            state
        };
    }

    /// A register's value in the simulation, by the spec's index.
    pub fn value(&self, register: MemoryRegister, index: usize) -> u64 {
        let state = &self._state;
        match register {
            MemoryRegister::FillBank => state.fill_bank as u64,
            MemoryRegister::FillPlace => state.fill_place as u64,
            MemoryRegister::FillReady => state.fill_ready.into(),
            MemoryRegister::WriteValid => state.write_valid.into(),
            MemoryRegister::WriteBank => state.write_bank as u64,
            MemoryRegister::WritePlace => state.write_place as u64,
            MemoryRegister::WritePresent => self._write[self.field_place(index, 0)],
            MemoryRegister::WritePosition => self._write[self.position_place(index)],
            MemoryRegister::WritePower => self._write[self.power_place(index)],
            MemoryRegister::WriteExponent => self._write[self.exponent_place(index)],
            MemoryRegister::Full => state.full[index].into(),
            MemoryRegister::End => state.end[index] as u64,
            MemoryRegister::PlayBank => state.play_bank as u64,
            MemoryRegister::PlayFull => state.play_full.into(),
            MemoryRegister::PlayEnd => state.play_end as u64,
            MemoryRegister::BeforeEnd => state.before_end as u64,
            MemoryRegister::PlayPlace => state.play_place as u64,
            MemoryRegister::AtEnd => state.at_end.into(),
            MemoryRegister::MayStart => state.may_start.into(),
            MemoryRegister::Playing => state.playing.into(),
            MemoryRegister::Releases => state.releases.into(),
            MemoryRegister::ReleaseTaken => state.release_taken.into(),
            MemoryRegister::ReleaseNext => state.release_next.into(),
            MemoryRegister::ReadValid => state.read_valid.into(),
            MemoryRegister::ReadLast => state.read_last.into(),
            MemoryRegister::ReadPresent => self._read[self.field_place(index, 0)],
            MemoryRegister::ReadPosition => self._read[self.position_place(index)],
            MemoryRegister::ReadPower => self._read[self.power_place(index)],
            MemoryRegister::ReadExponent => self._read[self.exponent_place(index)],
            MemoryRegister::WordValid => state.word_valid.into(),
            MemoryRegister::WordLast => state.word_last.into(),
            MemoryRegister::WordPresent => self.word_present[index].val().to_u64(),
            MemoryRegister::WordPosition => {
                let axes = [&self.word_x, &self.word_y, &self.word_z];
                axes[index % 3][index / 3].val().to_u64()
            }
            MemoryRegister::WordPower => {
                self.word_channel[self.channel_place(index)].val().to_u64()
            }
            MemoryRegister::WordExponent => self.word_exponent[index].val().to_u64(),
        }
    }

    /// A register's path in the block's text, by the spec's index.
    pub fn path(&self, register: MemoryRegister, index: usize) -> String {
        // The registers of words: `write`, `read` or `word`.
        let name = register.name();
        let word = name.split('_').next().unwrap_or_default();
        match register {
            MemoryRegister::WritePosition
            | MemoryRegister::ReadPosition
            | MemoryRegister::WordPosition => format!("{word}_{}", self.position(index)),
            MemoryRegister::WritePower | MemoryRegister::ReadPower | MemoryRegister::WordPower => {
                format!("{word}_{}", self.power(index))
            }
            MemoryRegister::Full
            | MemoryRegister::End
            | MemoryRegister::WritePresent
            | MemoryRegister::ReadPresent
            | MemoryRegister::WordPresent
            | MemoryRegister::WriteExponent
            | MemoryRegister::ReadExponent
            | MemoryRegister::WordExponent => format!("{name}_{index}"),
            // `WordValid` and `WordLast` drive the pins `word_valid` and `word_last`.
            MemoryRegister::WordValid => "valid".to_owned(),
            MemoryRegister::WordLast => "last".to_owned(),
            _ => name.to_owned(),
        }
    }

    /// The suffix of a coordinate's name.
    fn position(&self, index: usize) -> String {
        format!("{}_{}", AXES[index % 3], index / 3)
    }

    /// The suffix of a power's name.
    fn power(&self, index: usize) -> String {
        let channels = self._channels;
        format!(
            "{}_{}",
            channels[index % channels.len()],
            index / channels.len()
        )
    }

    /// The index in a word of a lane's field, in the order of `fields`.
    fn field_place(&self, lane: usize, field: usize) -> usize {
        lane * self._word.len() / LANES + field
    }

    /// The index in a word of a coordinate, by the spec's index.
    fn position_place(&self, index: usize) -> usize {
        self.field_place(index / 3, 1 + index % 3)
    }

    fn power_place(&self, index: usize) -> usize {
        let channels = self._channels.len();
        self.field_place(index / channels, 4 + index % channels)
    }

    fn exponent_place(&self, lane: usize) -> usize {
        self.field_place(lane, 4 + self._channels.len())
    }

    /// Converts the spec's index `channels` g + c, of channel c of lane g, to the port's index 4 c + g.
    fn channel_place(&self, index: usize) -> usize {
        let channels = self._channels.len();
        index % channels * LANES + index / channels
    }
}

impl<const H: usize, const B: usize, const E: usize> Logic for PhotonMemory<H, B, E> {
    fn update(&mut self) {
        if self.clock.pos_edge() {
            self.step();
        }
        self.show();
    }

    fn connect(&mut self) {
        self.group_ready.connect();
        self.word_valid.connect();
        self.word_last.connect();
        for lane in 0..LANES {
            self.word_present[lane].connect();
            self.word_x[lane].connect();
            self.word_y[lane].connect();
            self.word_z[lane].connect();
        }
        self.word_channel.iter_mut().for_each(Signal::connect);
        self.word_exponent.iter_mut().for_each(Signal::connect);
    }

    fn hdl(&self) -> Verilog {
        let bits = self._bank_groups.ilog2() as usize;
        let fields = self.fields();
        let width: usize = fields.iter().map(|field| field.width).sum();
        let group: Vec<_> = fields
            .iter()
            .rev()
            .map(|field| field.name.as_str())
            .collect();
        let mut low = 0;
        let outputs: String = fields
            .iter()
            .map(|Field { name, width }| {
                let first = low;
                low += width;
                format!(
                    "always @(*) word_{name} = word[{high}:{first}];\n\
                     wire [{top}:0] read_{name} = read_word[{high}:{first}];\n\
                     wire [{top}:0] write_{name} = write_word[{high}:{first}];\n",
                    high = low - 1,
                    top = width - 1,
                )
            })
            .collect();
        // The registers come first, because Verilog-2001 requires a declaration before use.
        Verilog::Custom(format!(
            "{}{}{outputs}",
            text::state(bits),
            text::block_ram(width, self._bank_groups, bits, &group.join(", ")),
        ))
    }
}
