//! The photon memory of a spatial machine, by the rules of [`photoncube_spec::MemoryRegister`].
//!
//! The model has one function for each paragraph of the rules. Each computes the registers after the clock edge from
//! those before it, and changes nothing. The HDL changes its registers one after the other.

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

/// The memory: the words of both banks, and the three words on their way.
#[derive(Clone, Debug)]
pub(super) struct PhotonMemory {
    /// The words, bank by bank; those of a bank are a set from place 0 to its end.
    banks: [Vec<Group>; 2],
    /// The word that is written to its place in this clock, if [`Write::valid`].
    write: Group,
    /// The words that left the banks one and two clocks ago, if their [`Tag`]s are valid.
    read: Group,
    word: Group,
    control: Control,
    channels: usize,
    has_exponent: bool,
}

/// The registers that are no words. All are 0 after a reset.
#[derive(Copy, Clone, Debug, Default)]
struct Control {
    fill: Fill,
    write: Write,
    sets: [Set; 2],
    play: Play,
    seen: Seen,
    release: Release,
    read: Tag,
    word: Tag,
}

/// The place for the next group, and the memory's ready.
#[derive(Copy, Clone, Debug, Default)]
struct Fill {
    bank: usize,
    place: usize,
    ready: bool,
}

/// The place of the group that was taken one clock before.
#[derive(Copy, Clone, Debug, Default)]
struct Write {
    valid: bool,
    bank: usize,
    place: usize,
}

/// The contents of a bank.
#[derive(Copy, Clone, Debug, Default)]
struct Set {
    full: bool,
    end: usize,
}

/// The batch that is played.
#[derive(Copy, Clone, Debug, Default)]
struct Play {
    bank: usize,
    place: usize,
    at_end: bool,
    may_start: bool,
    playing: bool,
}

/// The set of the bank that is played, one clock late.
#[derive(Copy, Clone, Debug, Default)]
struct Seen {
    full: bool,
    end: usize,
    before_end: usize,
}

/// Whether a query asks that its batch is the last on the set: the query taken in the clock before, any query
/// of the next batch, any query of the batch that is played.
#[derive(Copy, Clone, Debug, Default)]
struct Release {
    taken: bool,
    next: bool,
    batch: bool,
}

/// The flags of a word for the head.
#[derive(Copy, Clone, Debug, Default)]
struct Tag {
    valid: bool,
    last: bool,
}

/// The events of a clock, which follow from the registers and pins before its edge.
#[derive(Copy, Clone, Debug)]
struct Events {
    /// A group is taken.
    takes: bool,
    /// A group is taken that completes its set.
    completes: bool,
    /// A batch begins.
    starts: bool,
    /// A place is read.
    reads: bool,
    /// The last place of the set is read, which ends the batch.
    ends: bool,
    /// The batch ends, and its set goes with it.
    empties: bool,
}

impl Control {
    fn events(&self, inputs: &Inputs, places: usize) -> Events {
        let Self {
            fill,
            play,
            release,
            ..
        } = self;
        let takes = fill.ready && inputs.group_valid;
        let reads = play.playing || play.may_start;
        let ends = reads && play.at_end;
        // In the clock in which a batch begins, its queries' wish is still that of the next batch.
        let is_last_batch = match play.may_start {
            true => release.next,
            false => release.batch,
        };
        Events {
            takes,
            completes: takes && (inputs.group.last || fill.place == places - 1),
            starts: play.may_start,
            reads,
            ends,
            empties: ends && is_last_batch,
        }
    }

    fn next(&self, events: Events, inputs: &Inputs, head: HeadStatus, places: usize) -> Self {
        Self {
            fill: self.next_fill(events),
            write: Write {
                valid: events.takes,
                bank: self.fill.bank,
                place: self.fill.place,
            },
            sets: [0, 1].map(|bank| self.next_set(bank, events)),
            play: self.next_play(events, head),
            seen: self.next_seen(places),
            release: Release {
                taken: head.takes_query && inputs.query_release,
                next: self.release.taken || (self.release.next && !events.starts),
                batch: match events.starts {
                    true => self.release.next,
                    false => self.release.batch,
                },
            },
            read: Tag {
                valid: events.reads,
                last: events.ends,
            },
            word: self.read,
        }
    }

    fn next_fill(&self, events: Events) -> Fill {
        let Fill { bank, place, .. } = self.fill;
        let ready = !self.sets[bank].full && !events.completes;
        match (events.takes, events.completes) {
            (_, true) => Fill {
                bank: bank ^ 1,
                place: 0,
                ready,
            },
            (taken, false) => Fill {
                bank,
                place: place + usize::from(taken),
                ready,
            },
        }
    }

    fn next_set(&self, bank: usize, events: Events) -> Set {
        let Set { full, end } = self.sets[bank];
        let (is_filled, is_played) = (bank == self.fill.bank, bank == self.play.bank);
        Set {
            full: (full || (is_filled && events.completes)) && !(is_played && events.empties),
            end: match is_filled && self.fill.ready {
                true => self.fill.place,
                false => end,
            },
        }
    }

    fn next_play(&self, events: Events, head: HeadStatus) -> Play {
        let Play {
            bank,
            place,
            at_end,
            ..
        } = self.play;
        let last_is_on_its_way = [self.read, self.word]
            .iter()
            .any(|tag| tag.valid && tag.last);
        let may_start = !events.reads
            && !last_is_on_its_way
            && self.seen.full
            && head.full
            && head.has_room
            && self.seen.end >= head.spacing as usize;
        Play {
            bank: bank ^ usize::from(events.empties),
            place: match (events.reads, events.ends) {
                (_, true) => 0,
                (reads, false) => place + usize::from(reads),
            },
            at_end: match events.reads {
                true => !at_end && place == self.seen.before_end,
                // A batch begins at place 0.
                false => self.seen.end == 0,
            },
            may_start,
            playing: events.reads && !events.ends,
        }
    }

    fn next_seen(&self, places: usize) -> Seen {
        let Set { full, end } = self.sets[self.play.bank];
        Seen {
            full,
            end,
            before_end: if end == 0 { places - 1 } else { end - 1 },
        }
    }
}

impl PhotonMemory {
    /// Makes an empty memory; `None` if the machine has none.
    pub fn of(machine: &Machine, spatial: &Spatial) -> Option<Self> {
        let nothing = Group {
            lanes: vec![Lane::default(); Spatial::LANES],
            ..Group::default()
        };
        let bank = vec![nothing.clone(); spatial.memory_groups as usize];
        machine.has_memory().then(|| Self {
            banks: [bank.clone(), bank],
            write: nothing.clone(),
            read: nothing.clone(),
            word: nothing,
            control: Control::default(),
            channels: machine.channels().names().len(),
            has_exponent: machine.has_exponent(),
        })
    }

    /// The memory's ready: it takes the group of this clock, if it is valid.
    pub fn group_ready(&self) -> bool {
        self.control.fill.ready
    }

    /// The pins with the group replaced by the word that was read, as the head receives them.
    pub fn head_inputs(&self, inputs: &Inputs) -> Inputs {
        Inputs {
            group_valid: self.control.word.valid,
            group: self.word.clone(),
            ..inputs.clone()
        }
    }

    /// Applies one rising clock edge.
    pub fn clock(&mut self, inputs: &Inputs, head: HeadStatus) {
        let before = self.control;
        let places = self.banks[0].len();
        let events = before.events(inputs, places);
        self.control = match inputs.reset {
            true => Control::default(),
            false => before.next(events, inputs, head, places),
        };
        // From the head back to the pins, so that each word moves by one register. A place that is read in the
        // clock in which it is written gives its old word.
        mem::swap(&mut self.word, &mut self.read);
        self.read
            .clone_from(&self.banks[before.play.bank][before.play.place]);
        self.read.last = self.control.read.last;
        self.word.last = self.control.word.last;
        if before.write.valid {
            self.banks[before.write.bank][before.write.place].clone_from(&self.write);
        }
        self.write.clone_from(&inputs.group);
    }

    /// Appends the registers in the order of [`photoncube_spec::Pins`].
    pub fn observe(&self, row: &mut Vec<u64>) {
        for register in MemoryRegister::ALL {
            self.observe_register(register, row);
        }
    }

    fn observe_register(&self, register: MemoryRegister, row: &mut Vec<u64>) {
        use MemoryRegister as M;
        let Control {
            fill,
            write,
            sets,
            play,
            seen,
            release,
            read,
            word,
        } = self.control;
        let group = match register {
            M::WritePresent | M::WritePosition | M::WritePower | M::WriteExponent => &self.write,
            M::ReadPresent | M::ReadPosition | M::ReadPower | M::ReadExponent => &self.read,
            _ => &self.word,
        };
        let lanes = group.lanes.iter();
        match register {
            M::FillBank => row.push(fill.bank as u64),
            M::FillPlace => row.push(fill.place as u64),
            M::FillReady => row.push(fill.ready.into()),
            M::WriteValid => row.push(write.valid.into()),
            M::WriteBank => row.push(write.bank as u64),
            M::WritePlace => row.push(write.place as u64),
            M::Full => row.extend(sets.map(|set| u64::from(set.full))),
            M::End => row.extend(sets.map(|set| set.end as u64)),
            M::PlayBank => row.push(play.bank as u64),
            M::PlayFull => row.push(seen.full.into()),
            M::PlayEnd => row.push(seen.end as u64),
            M::BeforeEnd => row.push(seen.before_end as u64),
            M::PlayPlace => row.push(play.place as u64),
            M::AtEnd => row.push(play.at_end.into()),
            M::MayStart => row.push(play.may_start.into()),
            M::Playing => row.push(play.playing.into()),
            M::Releases => row.push(release.batch.into()),
            M::ReleaseTaken => row.push(release.taken.into()),
            M::ReleaseNext => row.push(release.next.into()),
            M::ReadValid => row.push(read.valid.into()),
            M::ReadLast => row.push(read.last.into()),
            M::WordValid => row.push(word.valid.into()),
            M::WordLast => row.push(word.last.into()),
            M::WritePresent | M::ReadPresent | M::WordPresent => {
                row.extend(lanes.map(|lane| u64::from(lane.present)));
            }
            M::WritePosition | M::ReadPosition | M::WordPosition => {
                row.extend(lanes.flat_map(|lane| lane.photon.position.map(u64::from)));
            }
            M::WritePower | M::ReadPower | M::WordPower => {
                let powers = lanes.flat_map(|lane| &lane.photon.power[..self.channels]);
                row.extend(powers.map(|&power| u64::from(power)));
            }
            M::WriteExponent | M::ReadExponent | M::WordExponent if self.has_exponent => {
                row.extend(lanes.map(|lane| u64::from(lane.photon.exponent)));
            }
            M::WriteExponent | M::ReadExponent | M::WordExponent => {}
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
        (self.0.control.word.valid, &self.0.word)
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
