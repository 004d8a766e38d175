//! The head: handshakes, the entry, the delay line of powers, the queue of results.

use std::mem;

use photoncube_spec::{HeadSizes, Inputs, Outputs, Spatial, Sums};

use super::entry::Entry;
use super::link::{Flags, Hop, Powers, ResultLink};
use super::memory::HeadStatus;

/// The head's registers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Head {
    pub(super) sizes: HeadSizes,
    engines: u32,
    /// Whether each group is given only when it can be taken. The registers that decide this are then no signals of the machine.
    pub(super) paced: bool,
    /// Bits of a decoded power.
    power_bits: u32,
    pub(super) loaded: u32,
    pub(super) open: bool,
    pub(super) spacing: u32,
    /// The last result of a batch was read in the clock before, and `promised` shrinks in this clock.
    pub(super) batch_read: bool,
    /// The number of batches whose results have places in the queue's memory.
    pub(super) promised: u32,
    pub(super) write_place: usize,
    pub(super) newest_place: usize,
    pub(super) read_place: usize,
    /// The number of results in the queue's memory.
    pub(super) waiting: usize,
    pub(super) has_result: bool,
    pub(super) entry: Entry,
    /// The stages of the delay line; stage 0, nearest to the entry, is the first.
    pub(super) delay: Vec<Powers>,
    /// For each lane of stage 0, whether it has no photon.
    pub(super) absent: [bool; Spatial::LANES],
    queue: Vec<Sums>,
    /// The result on the pins.
    word: Sums,
}

/// The handshakes of one clock.
#[derive(Copy, Clone, Debug)]
pub(super) struct Taken {
    pub(super) query: bool,
    pub(super) group: bool,
    pub(super) flags: Flags,
    result: bool,
}

impl Head {
    pub(super) fn new(spatial: &Spatial, power_bits: u32) -> Self {
        let sizes = HeadSizes::of(spatial);
        Self {
            sizes,
            engines: spatial.engines() as u32,
            paced: spatial.paced,
            power_bits,
            loaded: 0,
            open: false,
            spacing: 0,
            batch_read: false,
            promised: 0,
            write_place: 0,
            newest_place: 0,
            read_place: 0,
            waiting: 0,
            has_result: false,
            entry: Entry::default(),
            delay: vec![Powers::default(); spatial.latency() as usize],
            absent: Default::default(),
            queue: vec![Sums::default(); sizes.queue],
            word: Sums::default(),
        }
    }

    /// The output pins. They do not depend on the reset pin.
    pub(super) fn outputs(&self, inputs: &Inputs) -> Outputs {
        let full = self.is_full();
        let fits = self.spacing == 0 && self.has_room();
        let group_ready = self.has_batch() && (!inputs.group.last || fits);
        let first_taken = !self.open && group_ready && inputs.group_valid;
        Outputs {
            query_ready: !full || first_taken,
            group_ready,
            result_valid: self.has_result,
            result: self.word,
            ..Outputs::default()
        }
    }

    /// Whether all queries of the next batch are taken.
    fn is_full(&self) -> bool {
        self.loaded == self.engines
    }

    /// Whether a batch is open or can be opened.
    pub(super) fn has_batch(&self) -> bool {
        self.open || self.is_full()
    }

    /// Whether the queue has room for the results of a batch.
    fn has_room(&self) -> bool {
        (self.promised + 1) * self.engines <= self.sizes.queue as u32
    }

    /// The head's signals to the photon memory in this clock.
    pub(super) fn status(&self, inputs: &Inputs) -> HeadStatus {
        HeadStatus {
            full: self.is_full(),
            has_room: self.has_room(),
            spacing: self.spacing,
            takes_query: self.taken(inputs).query,
        }
    }

    fn after(&self, place: usize) -> usize {
        (place + 1) % self.sizes.queue
    }

    fn taken(&self, inputs: &Inputs) -> Taken {
        let outputs = self.outputs(inputs);
        let group = inputs.group_valid && outputs.group_ready;
        Taken {
            query: inputs.query_valid && outputs.query_ready,
            group,
            flags: Flags {
                first: group && !self.open,
                last: group && inputs.group.last,
            },
            result: outputs.result_valid && inputs.result_ready,
        }
    }

    /// Applies one clock with engine 0's link of the result chain. Returns the values for engine 0.
    pub(super) fn clock(&mut self, inputs: &Inputs, result: ResultLink) -> Hop {
        let taken = self.taken(inputs);
        let entered = mem::replace(&mut self.entry, Entry::of(inputs, taken));
        let hop = Hop {
            reset: inputs.reset,
            powers: self.delayed(entered.powers(self.power_bits)),
            ..entered.hop()
        };
        let ends_batch = self.read(taken);
        self.count(taken, ends_batch);
        self.write(result);
        if inputs.reset {
            self.clear();
        }
        hop
    }

    /// Advances the delay line and returns the previous values of its last stage.
    fn delayed(&mut self, powers: Powers) -> Powers {
        for (power, _) in self.delay[0]
            .power
            .iter_mut()
            .zip(self.absent)
            .filter(|(_, absent)| *absent)
        {
            *power = [0; 3];
        }
        self.absent = powers.present.map(|present| !present);
        self.delay.rotate_right(1);
        mem::replace(&mut self.delay[0], powers)
    }

    /// Moves a result from the queue's memory to the pins where there is room. Returns whether it is the last
    /// of its batch.
    fn read(&mut self, taken: Taken) -> bool {
        self.has_result &= !taken.result;
        if self.has_result || self.waiting == 0 {
            return false;
        }
        let of_batch = self.read_place as u32 % self.engines;
        self.word = self.queue[self.read_place];
        self.read_place = self.after(self.read_place);
        self.waiting -= 1;
        self.has_result = true;
        of_batch == self.engines - 1
    }

    fn write(&mut self, result: ResultLink) {
        if result.valid {
            self.queue[self.write_place] = result.sums;
            self.newest_place = self.write_place;
            self.write_place = self.after(self.write_place);
            self.waiting += 1;
        }
    }

    fn count(&mut self, taken: Taken, ends_batch: bool) {
        if taken.group {
            self.open = !taken.flags.last;
        }
        if taken.flags.first {
            self.loaded = 0;
        }
        self.loaded += u32::from(taken.query);
        self.spacing = self.spacing.saturating_sub(1);
        if taken.flags.last {
            self.spacing = self.sizes.spacing - 1;
            self.promised += 1;
        }
        let heard = mem::replace(&mut self.batch_read, ends_batch);
        let gives_back = if self.sizes.has_waits() {
            heard
        } else {
            ends_batch
        };
        self.promised -= u32::from(gives_back);
    }

    /// Clears all registers but the words and presence in the entry and the delay line, and the queue's
    /// memory and word.
    fn clear(&mut self) {
        self.loaded = 0;
        self.open = false;
        self.spacing = 0;
        self.batch_read = false;
        self.promised = 0;
        self.write_place = 0;
        self.newest_place = 0;
        self.read_place = 0;
        self.waiting = 0;
        self.has_result = false;
        self.entry.clear_flags();
        for stage in &mut self.delay {
            stage.flags = Flags::default();
        }
    }
}
