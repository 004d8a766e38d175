//! The head: handshakes, the powers' delay line, the queue of results.

use photoncube_spec::{HeadSizes, Inputs, Outputs, Spatial, Sums};

use super::link::{Flags, Hop, Powers, ResultLink};
use super::memory::HeadStatus;

/// The head with its registers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Head {
    sizes: HeadSizes,
    engines: u32,
    pub(super) loaded: u32,
    pub(super) open: bool,
    pub(super) spacing: u32,
    pub(super) promised: u32,
    pub(super) write_place: u32,
    pub(super) read_place: u32,
    /// Stage 0, nearest to the pins, first.
    pub(super) delay: Vec<Powers>,
    queue: Vec<Sums>,
}

/// What is taken in a clock.
#[derive(Copy, Clone, Debug)]
struct Taken {
    query: bool,
    group: bool,
    flags: Flags,
    result: bool,
}

impl Head {
    pub(super) fn new(spatial: &Spatial) -> Self {
        let sizes = HeadSizes::of(spatial);
        Self {
            sizes,
            engines: spatial.engines() as u32,
            loaded: 0,
            open: false,
            spacing: 0,
            promised: 0,
            write_place: 0,
            read_place: 0,
            delay: vec![Powers::default(); spatial.cuts.latency() as usize],
            queue: vec![Sums::default(); sizes.queue],
        }
    }

    /// The output pins. They do not look at the reset pin.
    pub(super) fn outputs(&self, inputs: &Inputs) -> Outputs {
        let full = self.is_full();
        let fits = self.spacing == 0 && self.has_room();
        let group_ready = (self.open || full) && (!inputs.group.last || fits);
        let first_taken = !self.open && group_ready && inputs.group_valid;
        Outputs {
            query_ready: !full || first_taken,
            group_ready,
            result_valid: self.write_place != self.read_place,
            result: self.queue[self.place(self.read_place)],
        }
    }

    /// All queries of the next batch are taken.
    fn is_full(&self) -> bool {
        self.loaded == self.engines
    }

    /// The queue has room for the results of a batch.
    fn has_room(&self) -> bool {
        self.promised as usize + self.engines as usize <= self.sizes.queue
    }

    /// What the photon memory goes by in this clock.
    pub(super) fn status(&self, inputs: &Inputs) -> HeadStatus {
        HeadStatus {
            full: self.is_full(),
            has_room: self.has_room(),
            spacing: self.spacing,
            takes_query: self.taken(inputs).query,
        }
    }

    /// The index of a place: without the bit that tells full from empty.
    fn place(&self, place: u32) -> usize {
        place as usize % self.sizes.queue
    }

    fn after(&self, place: u32) -> u32 {
        (place + 1) % (2 * self.sizes.queue as u32)
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

    /// One clock with engine 0's place on the result chain; gives what comes to engine 0.
    pub(super) fn clock(&mut self, inputs: &Inputs, result: ResultLink) -> Hop {
        let taken = self.taken(inputs);
        let mut hop = Hop {
            reset: inputs.reset,
            token_valid: taken.query && !inputs.reset,
            token: inputs.query,
            swap: taken.flags.first && !inputs.reset,
            ..Hop::default()
        };
        for (photon, lane) in hop.photon.iter_mut().zip(&inputs.group.lanes) {
            *photon = lane.photon.position;
        }
        let mut powers = Powers {
            flags: taken.flags,
            ..Powers::default()
        };
        if taken.group {
            powers.decode(inputs);
        }
        hop.powers = self.delayed(powers);
        self.write(result);
        self.count(taken);
        if inputs.reset {
            self.clear();
        }
        hop
    }

    /// A step of the delay line: what its last stage held.
    fn delayed(&mut self, powers: Powers) -> Powers {
        self.delay.rotate_right(1);
        std::mem::replace(&mut self.delay[0], powers)
    }

    fn write(&mut self, result: ResultLink) {
        if result.valid {
            let place = self.place(self.write_place);
            self.queue[place] = result.sums;
            self.write_place = self.after(self.write_place);
        }
    }

    fn count(&mut self, taken: Taken) {
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
            self.promised += self.engines;
        }
        if taken.result {
            self.promised -= 1;
            self.read_place = self.after(self.read_place);
        }
    }

    /// All but the powers and presence in the delay line, and the queue's memory.
    fn clear(&mut self) {
        self.loaded = 0;
        self.open = false;
        self.spacing = 0;
        self.promised = 0;
        self.write_place = 0;
        self.read_place = 0;
        for stage in &mut self.delay {
            stage.flags = Flags::default();
        }
    }
}

impl Powers {
    fn decode(&mut self, inputs: &Inputs) {
        for (index, lane) in inputs.group.lanes.iter().enumerate() {
            if lane.present {
                let photon = &lane.photon;
                self.power[index] = photon.power.map(|p| u64::from(p) << photon.exponent);
                self.present[index] = true;
            }
        }
    }
}
