//! Compares a photon memory on its own, with random signals of the head: sets of all lengths up to a whole
//! bank, played, kept and released, and resets.

use photoncube_hdl::{Level, level_pins};
use photoncube_model::{GoldenMemory, HeadStatus};
use photoncube_spec::{Group, Inputs, Lane, Machine, Photon, Pin, Pins, Spatial, Widths};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

use crate::device::{DeviceError, hdl_error};
use crate::stimulus::{Block, corner};

/// The number of clocks of short sets, and of sets of some dozens of groups.
const SHORT_CLOCKS: u64 = 200;
/// The number of clocks of a bank besides its groups, for its release and its start.
const MORE_CLOCKS: u64 = 60;
/// The most groups by which the longest sets are shorter than a bank.
const MOST_SHORT: usize = 3;

/// The probability of an event in a stretch of clocks.
#[derive(Copy, Clone, Debug)]
enum Often {
    Always,
    Mostly,
    Half,
    Rarely,
    Never,
}

impl Often {
    fn any(rng: &mut Pcg64) -> Self {
        match rng.random_range(0..8) {
            0..=2 => Self::Always,
            3 | 4 => Self::Mostly,
            5 => Self::Half,
            6 => Self::Rarely,
            _ => Self::Never,
        }
    }

    fn draw(self, rng: &mut Pcg64) -> bool {
        match self {
            Self::Always => true,
            Self::Mostly => rng.random_ratio(7, 8),
            Self::Half => rng.random(),
            Self::Rarely => rng.random_ratio(1, 24),
            Self::Never => false,
        }
    }
}

/// The rule for the ends of sets.
#[derive(Copy, Clone, Debug)]
enum Ends {
    /// Sets end at random.
    At(Often),
    /// Sets end that many places before the bank's last place.
    BeforeLast(usize),
}

/// A stretch of clocks with constant probabilities.
#[derive(Copy, Clone, Debug)]
struct Stretch {
    clocks: u64,
    ends: Ends,
    groups: Often,
    batches: Often,
    room: Often,
    releases: Often,
    queries: Often,
    resets: bool,
}

impl Stretch {
    fn any(rng: &mut Pcg64, bank: usize) -> Self {
        let (clocks, ends) = match rng.random_range(0..8) {
            0..=3 => (SHORT_CLOCKS, Ends::At(Often::Half)),
            4 => (2 * SHORT_CLOCKS, Ends::At(Often::Rarely)),
            // No group is marked as last, so the bank's last place ends the set.
            5 => (bank as u64 + MORE_CLOCKS, Ends::At(Often::Never)),
            _ => {
                let short = rng.random_range(0..=MOST_SHORT);
                (bank as u64 + MORE_CLOCKS, Ends::BeforeLast(short))
            }
        };
        let is_long = clocks > bank as u64;
        Self {
            clocks,
            ends,
            groups: if is_long {
                Often::Always
            } else {
                Often::any(rng)
            },
            batches: Often::any(rng),
            room: Often::any(rng),
            releases: Often::any(rng),
            queries: Often::any(rng),
            resets: rng.random_ratio(1, 4),
        }
    }
}

/// Drives the golden memory and records its rows.
pub(crate) struct MemoryWalk<'a> {
    machine: &'a Machine,
    pins: Pins,
    model: GoldenMemory,
    /// The number of groups of a bank.
    bank: usize,
    widths: Widths,
    rng: Pcg64,
    stretch: Stretch,
    /// The number of groups taken of the set that is being filled.
    place: usize,
    /// The last places of the two sets that ended last; one of them is played.
    ends: [usize; 2],
    block: Block,
    clocks: u64,
    seed: u64,
}

/// The input words of a clock.
#[derive(Clone, Debug)]
struct Row {
    inputs: Inputs,
    head: HeadStatus,
}

impl<'a> MemoryWalk<'a> {
    /// Starts a walk at power-up. Its first clocks set each register to a value that does not depend on its
    /// past.
    ///
    /// # Errors
    /// The machine has no memory that can be emitted.
    pub fn new(machine: &'a Machine, seed: u64) -> Result<Self, DeviceError> {
        let pins = level_pins(machine, Level::Memory).map_err(hdl_error(machine))?;
        let (Some(model), Some(spatial)) = (GoldenMemory::of(machine), machine.spatial()) else {
            unreachable!("a machine whose memory is emitted has one");
        };
        let bank = spatial.memory_groups as usize;
        let mut rng = Pcg64::seed_from_u64(seed);
        let mut walk = Self {
            machine,
            pins,
            model,
            bank,
            widths: Widths::of(machine),
            stretch: Stretch::any(&mut rng, bank),
            rng,
            place: 0,
            ends: [0; 2],
            block: Block::default(),
            clocks: 0,
            seed,
        };
        walk.scrub();
        Ok(walk)
    }

    /// Records `clocks` more clocks.
    pub fn block(&mut self, clocks: u64) -> Block {
        for _ in 0..clocks {
            if self.stretch.clocks == 0 {
                self.stretch = Stretch::any(&mut self.rng, self.bank);
            }
            self.stretch.clocks -= 1;
            let row = self.draw();
            self.step(&row);
        }
        let next = Block {
            seed: self.seed,
            first_clock: self.clocks,
            ..Block::default()
        };
        std::mem::replace(&mut self.block, next)
    }

    /// Reads a set of one group of zeros and releases it.
    fn scrub(&mut self) {
        let last = Inputs {
            group_valid: true,
            group: Group {
                last: true,
                ..self.absent()
            },
            ..self.idle()
        };
        let plays = HeadStatus {
            full: true,
            has_room: true,
            ..HeadStatus::default()
        };
        let rows = [
            (self.reset(), HeadStatus::default(), 1),
            (self.idle(), HeadStatus::default(), 1),
            (last, HeadStatus::default(), 1),
            (self.idle(), plays, 10),
            (self.reset(), HeadStatus::default(), 1),
            (self.idle(), HeadStatus::default(), 4),
        ];
        for (inputs, head, clocks) in rows {
            for _ in 0..clocks {
                let inputs = inputs.clone();
                self.step(&Row { inputs, head });
            }
        }
    }

    fn absent(&self) -> Group {
        Group {
            lanes: vec![Lane::default(); Spatial::LANES],
            last: false,
            facing: 0,
        }
    }

    fn idle(&self) -> Inputs {
        Inputs {
            group: self.absent(),
            ..Inputs::default()
        }
    }

    fn reset(&self) -> Inputs {
        Inputs {
            reset: true,
            ..self.idle()
        }
    }

    fn draw(&mut self) -> Row {
        let Stretch {
            ends,
            groups,
            batches,
            room,
            releases,
            queries,
            resets,
            ..
        } = self.stretch;
        let rng = &mut self.rng;
        let group_valid = groups.draw(rng);
        let last = match ends {
            Ends::At(often) => often.draw(rng),
            Ends::BeforeLast(short) => self.place + 1 + short == self.bank,
        };
        let spacing = match rng.random_range(0..8) {
            0 => corner(rng, 16) as u32,
            1 => rng.random_range(0..4),
            2 => self.place.saturating_sub(rng.random_range(0..2)) as u32,
            // Around the end of a set, with which it is compared.
            4 => {
                let end = self.ends[rng.random_range(0..2)] + rng.random_range(0..4);
                end.saturating_sub(rng.random_range(0..4)) as u32
            }
            // One bit of the word: it is compared with a number larger than a set's.
            3 => 1 << rng.random_range(0..16),
            _ => 0,
        };
        let reset = resets && rng.random_ratio(1, 100);
        let head = HeadStatus {
            full: batches.draw(rng),
            has_room: room.draw(rng),
            spacing,
            takes_query: queries.draw(rng),
        };
        let query_release = releases.draw(rng);
        Row {
            inputs: Inputs {
                reset,
                group_valid,
                group: self.group(last),
                query_release,
                ..Inputs::default()
            },
            head,
        }
    }

    /// A group of random words, also where it has no photon or is not valid.
    fn group(&mut self, last: bool) -> Group {
        let channels = self.machine.channels().names().len();
        let (widths, rng) = (&self.widths, &mut self.rng);
        let mut word = |bits: u32| match bits {
            0 => 0,
            bits => corner(rng, bits) as u32,
        };
        let lanes = (0..Spatial::LANES).map(|_| {
            let mut power = [0; 3];
            power[..channels].fill_with(|| word(widths.mantissa));
            Lane {
                present: word(1) == 1,
                photon: Photon {
                    position: [(); 3].map(|()| word(widths.coordinate)),
                    power,
                    exponent: word(widths.exponent),
                },
            }
        });
        Group {
            lanes: lanes.collect(),
            last,
            facing: 0,
        }
    }

    /// Records the inputs and the visible signals, then applies the rising edge.
    fn step(&mut self, row: &Row) {
        let value = |pin: &Pin| self.input(&pin.name, row);
        let values: Vec<_> = self.pins.inputs.iter().map(value).collect();
        self.block.inputs.extend(values);
        self.outputs();
        self.model.observe(&mut self.block.expected);
        let takes = row.inputs.group_valid && self.model.group_ready();
        self.model.clock(&row.inputs, row.head);
        let ends = row.inputs.group.last || self.place + 1 == self.bank;
        if takes && ends {
            self.ends = [self.place, self.ends[0]];
        }
        self.place = match takes {
            _ if row.inputs.reset => 0,
            true if ends => 0,
            true => self.place + 1,
            false => self.place,
        };
        self.clocks += 1;
        self.block.clocks += 1;
    }

    fn outputs(&mut self) {
        let channels = self.machine.channels().names().len();
        let has_exponent = self.machine.has_exponent();
        let (valid, group) = self.model.word();
        let row = &mut self.block.expected;
        row.extend([self.model.group_ready(), valid, group.last].map(u64::from));
        let lanes = &group.lanes;
        row.extend(lanes.iter().map(|lane| u64::from(lane.present)));
        for axis in 0..3 {
            let axis = lanes.iter().map(|lane| lane.photon.position[axis]);
            row.extend(axis.map(u64::from));
        }
        for channel in 0..channels {
            let channel = lanes.iter().map(|lane| lane.photon.power[channel]);
            row.extend(channel.map(u64::from));
        }
        if has_exponent {
            row.extend(lanes.iter().map(|lane| u64::from(lane.photon.exponent)));
        }
    }

    /// The value of an input pin.
    fn input(&self, pin: &str, Row { inputs, head }: &Row) -> u64 {
        match pin {
            "reset" => inputs.reset.into(),
            "group_valid" => inputs.group_valid.into(),
            "group_last" => inputs.group.last.into(),
            "release_in" => inputs.query_release.into(),
            "query_taken" => head.takes_query.into(),
            "is_full" => head.full.into(),
            "has_room" => head.has_room.into(),
            "clocks_to_last" => head.spacing.into(),
            of_lane => self.of_lane(of_lane, &inputs.group.lanes),
        }
    }

    fn of_lane(&self, pin: &str, lanes: &[Lane]) -> u64 {
        let (field, lane) = pin.rsplit_once('_').expect("a lane's pin has its number");
        let Lane { present, photon } = &lanes[lane.parse::<usize>().expect("a lane's number")];
        let mut channels = self.machine.channels().names().iter();
        match field {
            "present" => u64::from(*present),
            "x" => photon.position[0].into(),
            "y" => photon.position[1].into(),
            "z" => photon.position[2].into(),
            "exponent" => photon.exponent.into(),
            channel => {
                let channel = channels.position(|name| *name == channel);
                photon.power[channel.expect("a channel's pin")].into()
            }
        }
    }
}

/// Walks until `sink` breaks or `clocks` clocks are recorded.
///
/// # Errors
/// The machine has no memory that can be emitted.
pub(crate) fn walk(
    machine: &Machine,
    seed: u64,
    clocks: u64,
    sink: &mut dyn FnMut(Block) -> std::ops::ControlFlow<()>,
) -> Result<(), DeviceError> {
    /// The number of clocks of a block.
    const BLOCK: u64 = 4096;
    let mut walk = MemoryWalk::new(machine, seed)?;
    let mut left = clocks;
    while left > 0 {
        let some = left.min(BLOCK);
        left -= some;
        if sink(walk.block(some)).is_break() {
            break;
        }
    }
    Ok(())
}

/// The rows with which every walk begins.
///
/// # Errors
/// The machine has no memory that can be emitted.
pub(crate) fn scrub_rows(machine: &Machine) -> Result<Vec<u64>, DeviceError> {
    Ok(MemoryWalk::new(machine, 0)?.block(0).inputs)
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{MemoryRegister, SignalPlace, find_machine};

    use super::*;

    /// Each bit of each register is seen as 0 and as 1. Both banks end a set by a last group at the last
    /// place, without one there, and one place before.
    #[test]
    fn a_walk_uses_every_bit_and_fills_banks_in_every_way() {
        let machine = find_machine("tile-6-mixed").unwrap();
        let mut walk = MemoryWalk::new(machine, 1).unwrap();
        let block = walk.block(200_000);
        let pins = &walk.pins;
        let column = |register: MemoryRegister| {
            let place = SignalPlace::Memory { register, index: 0 };
            let mut observed = pins.observed.iter();
            observed.position(|pin| pin.place == place).unwrap()
        };
        let [bank, fill, ready] = [
            MemoryRegister::FillBank,
            MemoryRegister::FillPlace,
            MemoryRegister::FillReady,
        ]
        .map(column);
        let input = |name: &str| pins.inputs.iter().position(|pin| pin.name == name).unwrap();
        let [valid, last] = ["group_valid", "group_last"].map(input);
        let mut ends = [[0; 3]; 2];
        let mut seen = vec![[0; 2]; pins.observed.len()];
        let inputs = block.inputs.chunks_exact(pins.inputs.len());
        for (inputs, row) in inputs.zip(block.expected.chunks_exact(pins.observed.len())) {
            for (seen, value) in seen.iter_mut().zip(row) {
                *seen = [seen[0] | value, seen[1] | !value];
            }
            if inputs[valid] & row[ready] == 1 {
                let way = match (row[fill], inputs[last]) {
                    (1023, last) => last as usize,
                    (1022, 1) => 2,
                    _ => continue,
                };
                ends[row[bank] as usize][way] += 1;
            }
        }
        for (pin, seen) in pins.observed.iter().zip(seen) {
            let all = u64::MAX >> (u64::BITS - pin.width);
            assert_eq!(seen.map(|bits| bits & all), [all; 2], "{}", pin.name);
        }
        assert!(ends.iter().flatten().all(|&met| met > 0), "{ends:?}");
    }
}
