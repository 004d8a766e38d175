//! The entry: the values of the pins, one clock later.

use photoncube_spec::{Inputs, Lane, Query, Spatial};

use super::head::Taken;
use super::link::{Flags, Hop, Powers};
use super::rules::ones;

/// The entry's registers.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Entry {
    pub(super) token_valid: bool,
    pub(super) token: Query,
    pub(super) lanes: [EntryLane; Spatial::LANES],
    /// The group in the entry was taken.
    pub(super) taken: bool,
    pub(super) flags: Flags,
}

/// A lane of the group in the entry, as it was on the pins.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct EntryLane {
    pub(super) photon: [u32; 3],
    pub(super) mantissa: [u32; 3],
    pub(super) exponent: u32,
    /// Whether the lane has a photon.
    pub(super) present: bool,
}

impl Entry {
    /// The entry's next value, from the pins and the handshakes of this clock.
    pub(super) fn of(inputs: &Inputs, taken: Taken) -> Self {
        let mut lanes = [EntryLane::default(); Spatial::LANES];
        for (entered, lane) in lanes.iter_mut().zip(&inputs.group.lanes) {
            *entered = EntryLane::of(lane);
        }
        Self {
            token_valid: taken.query,
            token: inputs.query,
            lanes,
            taken: taken.group,
            flags: taken.flags,
        }
    }

    /// The entry's values for engine 0, without the powers, which pass the delay line.
    pub(super) fn hop(&self) -> Hop {
        Hop {
            token_valid: self.token_valid,
            token: self.token,
            swap: self.flags.first,
            photon: self.lanes.map(|lane| lane.photon),
            ..Hop::default()
        }
    }

    /// The group's decoded powers, those of absent photons included, in `bits` bits.
    pub(super) fn powers(&self, bits: u32) -> Powers {
        Powers {
            power: self.lanes.map(|lane| lane.power(bits)),
            present: self.lanes.map(|lane| self.taken && lane.present),
            flags: self.flags,
        }
    }

    /// Clears the registers that a reset clears.
    pub(super) fn clear_flags(&mut self) {
        self.token_valid = false;
        self.flags = Flags::default();
    }
}

impl EntryLane {
    fn of(lane: &Lane) -> Self {
        Self {
            photon: lane.photon.position,
            mantissa: lane.photon.power,
            exponent: lane.photon.exponent,
            present: lane.present,
        }
    }

    /// The powers in `bits` bits. Those of a photon fit; an absent one may have any exponent on its pins.
    fn power(self, bits: u32) -> [u64; 3] {
        self.mantissa
            .map(|m| (u64::from(m) << self.exponent) & ones(bits))
    }
}
