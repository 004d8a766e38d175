//! The photon memory of a spatial machine, see [`photoncube_spec::MemoryRegister`].

use std::mem;

use photoncube_spec::{Group, Inputs, Lane, Machine, MemoryRegister, Spatial};

/// The head's signals to the memory in a clock, before its edge.
#[derive(Copy, Clone, Debug, Default)]
pub struct HeadStatus {
    /// All queries of the next batch are taken.
    pub full: bool,
    /// The queue has room for the results of a batch.
    pub has_room: bool,
    /// Clocks until a last group may be taken.
    pub spacing: u32,
    /// A query is taken.
    pub takes_query: bool,
}

/// The registers and words of the memory.
#[derive(Clone, Debug)]
pub(super) struct PhotonMemory {
    banks: [Bank; 2],
    fill_bank: usize,
    fill_place: usize,
    fill_ready: bool,
    write: Write,
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
    read: Word,
    word: Word,
    channels: usize,
    has_exponent: bool,
}

/// A group that is written to its place one clock after it was taken.
#[derive(Clone, Debug)]
struct Write {
    bank: usize,
    place: usize,
    word: Word,
}

/// A group on its way to its place or to the head, with its valid flag.
#[derive(Clone, Debug)]
struct Word {
    valid: bool,
    group: Group,
}

impl Word {
    /// Whether the word is valid and the last of its batch.
    fn ends(&self) -> bool {
        self.valid && self.group.last
    }

    fn reset(&mut self) {
        self.valid = false;
        self.group.last = false;
    }

    fn observe_presence(&self, row: &mut Vec<u64>) {
        row.extend(self.group.lanes.iter().map(|lane| u64::from(lane.present)));
    }

    fn observe_positions(&self, row: &mut Vec<u64>) {
        let positions = self
            .group
            .lanes
            .iter()
            .flat_map(|lane| lane.photon.position);
        row.extend(positions.map(u64::from));
    }

    fn observe_powers(&self, channels: usize, row: &mut Vec<u64>) {
        let lanes = self.group.lanes.iter();
        let powers = lanes.flat_map(|lane| &lane.photon.power[..channels]);
        row.extend(powers.map(|&power| u64::from(power)));
    }

    fn observe_exponents(&self, row: &mut Vec<u64>) {
        let lanes = self.group.lanes.iter();
        row.extend(lanes.map(|lane| u64::from(lane.photon.exponent)));
    }
}

#[derive(Clone, Debug)]
struct Bank {
    groups: Vec<Group>,
    full: bool,
    end: usize,
}

impl PhotonMemory {
    /// Makes an empty memory; `None` if the machine has none.
    pub fn of(machine: &Machine, spatial: &Spatial) -> Option<Self> {
        if !machine.has_memory() {
            return None;
        }
        let nothing = Group {
            lanes: vec![Lane::default(); Spatial::LANES],
            last: false,
        };
        let bank = Bank {
            groups: vec![nothing.clone(); spatial.memory_groups as usize],
            full: false,
            end: 0,
        };
        let word = Word {
            valid: false,
            group: nothing,
        };
        Some(Self {
            banks: [bank.clone(), bank],
            fill_bank: 0,
            fill_place: 0,
            fill_ready: false,
            write: Write {
                bank: 0,
                place: 0,
                word: word.clone(),
            },
            play_bank: 0,
            play_full: false,
            play_end: 0,
            before_end: 0,
            play_place: 0,
            at_end: false,
            may_start: false,
            playing: false,
            releases: false,
            release_taken: false,
            release_next: false,
            read: word.clone(),
            word,
            channels: machine.channels().names().len(),
            has_exponent: machine.has_exponent(),
        })
    }

    /// The memory's ready: it takes the group of this clock, if it is valid.
    pub fn group_ready(&self) -> bool {
        self.fill_ready
    }

    /// The pins with the group replaced by the word that was read, as the head receives them.
    pub fn head_inputs(&self, inputs: &Inputs) -> Inputs {
        Inputs {
            group_valid: self.word.valid,
            group: self.word.group.clone(),
            ..inputs.clone()
        }
    }

    /// Applies one rising clock edge.
    pub fn clock(&mut self, inputs: &Inputs, head: HeadStatus) {
        let starts = self.may_start;
        self.may_start = self.may_start_next(head);
        let reads = self.playing || starts;
        let read = self.banks[self.play_bank].groups[self.play_place].clone();
        let at_end = self.at_end;
        self.at_end = self.at_end_next(reads);
        let takes = inputs.group_valid && self.group_ready();
        let was_full = self.banks[self.fill_bank].full;

        let bank = &self.banks[self.play_bank];
        (self.play_full, self.play_end) = (bank.full, bank.end);
        self.before_end = bank.end.checked_sub(1).unwrap_or(bank.groups.len() - 1);
        let read = Word {
            valid: reads,
            group: Group {
                last: reads && at_end,
                ..read
            },
        };
        self.word = mem::replace(&mut self.read, read);
        if reads {
            self.advance(starts, at_end);
        }
        if starts {
            self.releases = self.release_next;
            self.release_next = false;
        }
        self.release_next |= self.release_taken;
        self.release_taken = head.takes_query && inputs.query_release;
        self.write_and_take(takes, &inputs.group);
        self.fill(takes, inputs.group.last, was_full);
        if inputs.reset {
            self.reset();
        }
    }

    /// Whether a batch begins in the next clock.
    fn may_start_next(&self, head: HeadStatus) -> bool {
        let ends = self.read.ends() || self.word.ends();
        !self.playing
            && !self.may_start
            && self.play_full
            && head.full
            && head.has_room
            && head.spacing as usize <= self.play_end
            && !ends
    }

    /// Whether the place that is read in the next clock is the last of its set.
    fn at_end_next(&self, reads: bool) -> bool {
        if reads {
            !self.at_end && self.play_place == self.before_end
        } else {
            self.play_end == 0
        }
    }

    fn advance(&mut self, starts: bool, at_end: bool) {
        self.playing = !at_end;
        if !at_end {
            self.play_place += 1;
            return;
        }
        self.play_place = 0;
        let releases = if starts {
            self.release_next
        } else {
            self.releases
        };
        if releases {
            self.banks[self.play_bank].full = false;
            self.play_bank = 1 - self.play_bank;
        }
    }

    /// Writes the group that was taken one clock before, and stores the group on the pins.
    fn write_and_take(&mut self, takes: bool, group: &Group) {
        let Write { bank, place, word } = &mut self.write;
        if word.valid {
            self.banks[*bank].groups[*place].clone_from(&word.group);
        }
        (*bank, *place) = (self.fill_bank, self.fill_place);
        word.valid = takes;
        word.group.clone_from(group);
    }

    /// Advances the filling of a bank. `takes` is that a group is taken, `last` that it is a last one,
    /// `was_full` that the bank was full before this clock.
    fn fill(&mut self, takes: bool, last: bool, was_full: bool) {
        let bank = &mut self.banks[self.fill_bank];
        let place = self.fill_place;
        if self.fill_ready {
            bank.end = place;
        }
        self.fill_ready = !was_full;
        if !takes {
            return;
        }
        if last || place + 1 == bank.groups.len() {
            bank.full = true;
            self.fill_ready = false;
            self.fill_place = 0;
            self.fill_bank = 1 - self.fill_bank;
        } else {
            self.fill_place += 1;
        }
    }

    fn reset(&mut self) {
        for bank in &mut self.banks {
            (bank.full, bank.end) = (false, 0);
        }
        (self.fill_bank, self.fill_place, self.fill_ready) = (0, 0, false);
        (self.play_bank, self.play_place) = (0, 0);
        (self.play_full, self.play_end, self.may_start) = (false, 0, false);
        (self.before_end, self.at_end) = (0, false);
        (self.playing, self.releases) = (false, false);
        (self.release_taken, self.release_next) = (false, false);
        (self.write.bank, self.write.place) = (0, 0);
        self.write.word.reset();
        self.read.reset();
        self.word.reset();
    }

    /// Appends the registers in the order of [`photoncube_spec::Pins`].
    pub fn observe(&self, row: &mut Vec<u64>) {
        for register in MemoryRegister::ALL {
            self.observe_register(register, row);
        }
    }

    fn observe_register(&self, register: MemoryRegister, row: &mut Vec<u64>) {
        match register {
            MemoryRegister::FillBank => row.push(self.fill_bank as u64),
            MemoryRegister::FillPlace => row.push(self.fill_place as u64),
            MemoryRegister::FillReady => row.push(self.fill_ready.into()),
            MemoryRegister::WriteValid => row.push(self.write.word.valid.into()),
            MemoryRegister::WriteBank => row.push(self.write.bank as u64),
            MemoryRegister::WritePlace => row.push(self.write.place as u64),
            MemoryRegister::WritePresent => self.write.word.observe_presence(row),
            MemoryRegister::WritePosition => self.write.word.observe_positions(row),
            MemoryRegister::WritePower => self.write.word.observe_powers(self.channels, row),
            MemoryRegister::Full => row.extend(self.banks.iter().map(|b| u64::from(b.full))),
            MemoryRegister::End => row.extend(self.banks.iter().map(|b| b.end as u64)),
            MemoryRegister::PlayBank => row.push(self.play_bank as u64),
            MemoryRegister::PlayFull => row.push(self.play_full.into()),
            MemoryRegister::PlayEnd => row.push(self.play_end as u64),
            MemoryRegister::BeforeEnd => row.push(self.before_end as u64),
            MemoryRegister::PlayPlace => row.push(self.play_place as u64),
            MemoryRegister::AtEnd => row.push(self.at_end.into()),
            MemoryRegister::MayStart => row.push(self.may_start.into()),
            MemoryRegister::Playing => row.push(self.playing.into()),
            MemoryRegister::Releases => row.push(self.releases.into()),
            MemoryRegister::ReleaseTaken => row.push(self.release_taken.into()),
            MemoryRegister::ReleaseNext => row.push(self.release_next.into()),
            MemoryRegister::ReadValid => row.push(self.read.valid.into()),
            MemoryRegister::ReadLast => row.push(self.read.group.last.into()),
            MemoryRegister::ReadPresent => self.read.observe_presence(row),
            MemoryRegister::ReadPosition => self.read.observe_positions(row),
            MemoryRegister::ReadPower => self.read.observe_powers(self.channels, row),
            MemoryRegister::WordValid => row.push(self.word.valid.into()),
            MemoryRegister::WordLast => row.push(self.word.group.last.into()),
            MemoryRegister::WordPresent => self.word.observe_presence(row),
            MemoryRegister::WordPosition => self.word.observe_positions(row),
            MemoryRegister::WordPower => self.word.observe_powers(self.channels, row),
            MemoryRegister::WriteExponent
            | MemoryRegister::ReadExponent
            | MemoryRegister::WordExponent
                if !self.has_exponent => {}
            MemoryRegister::WriteExponent => self.write.word.observe_exponents(row),
            MemoryRegister::ReadExponent => self.read.observe_exponents(row),
            MemoryRegister::WordExponent => self.word.observe_exponents(row),
        }
    }
}

/// The photon memory on its own. The pins that lead to the head are the word's registers, the pins that come
/// from it are a [`HeadStatus`].
#[derive(Clone, Debug)]
pub struct GoldenMemory(PhotonMemory);

impl GoldenMemory {
    /// Makes a memory in its power-up state, with all registers and words 0; `None` where the machine has
    /// none.
    pub fn of(machine: &Machine) -> Option<Self> {
        PhotonMemory::of(machine, machine.spatial()?).map(Self)
    }

    /// The memory's ready: it takes the group of this clock, if it is valid.
    pub fn group_ready(&self) -> bool {
        self.0.group_ready()
    }

    /// The word for the head, with its valid flag.
    pub fn word(&self) -> (bool, &Group) {
        (self.0.word.valid, &self.0.word.group)
    }

    /// Applies one rising clock edge. Of the inputs the memory uses the group, the reset and `query_release`.
    pub fn clock(&mut self, inputs: &Inputs, head: HeadStatus) {
        self.0.clock(inputs, head);
    }

    /// Appends the registers in the order of [`photoncube_spec::Pins`].
    pub fn observe(&self, row: &mut Vec<u64>) {
        self.0.observe(row);
    }
}
