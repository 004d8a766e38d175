//! The way of leaves to a chain.

use photoncube_spec::{Core, Group, Lane, Spatial};

use super::link::Link;

/// A leaf in the slice of photons, or in a place in front of a chain.
#[derive(Clone, Debug)]
pub(super) struct LeafWord {
    pub(super) lanes: [Lane; Core::LEAF_PHOTONS],
    pub(super) facing: u32,
    pub(super) last: bool,
    pub(super) chain: u32,
}

impl LeafWord {
    /// One of the two groups.
    fn group(&self, number: usize, last: bool) -> Group {
        let lanes = &self.lanes[number * Spatial::LANES..][..Spatial::LANES];
        Group {
            lanes: lanes.to_vec(),
            last,
            facing: self.facing,
        }
    }

    fn photons_of_second(&self) -> usize {
        let second = &self.lanes[Spatial::LANES..];
        second.iter().filter(|lane| lane.present).count()
    }

    /// The leaf is given as two groups.
    fn has_two_groups(&self) -> bool {
        !self.last || self.photons_of_second() > 0
    }

    /// A photon comes behind an absent one.
    pub(super) fn is_malformed(&self) -> bool {
        let first_absent = self.lanes.iter().position(|lane| !lane.present);
        let behind = first_absent.map_or(&[][..], |place| &self.lanes[place..]);
        behind.iter().any(|lane| lane.present)
    }
}

/// What becomes of the leaf in front of the slice in a clock.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) enum Fate {
    /// It waits for a place in front of its chain.
    Waits,
    /// It leaves for such a place.
    Given,
    /// It is dropped.
    Refused,
}

/// The state of the way to one chain.
#[derive(Clone, Debug)]
pub(super) struct PhotonPort {
    leaves: Link<LeafWord, { Core::LEAF_PLACES as usize }>,
    /// A place was left in the clock before, and no leaf was given then.
    open: bool,
    /// The chain took the first group of the leaf in front.
    has_first: bool,
    /// Leaves of the set that were given.
    number: u32,
    drops: bool,
}

impl PhotonPort {
    /// The way to a chain behind this many stages.
    pub(super) fn new(stages: usize) -> Self {
        Self {
            leaves: Link::new(stages),
            open: true,
            has_first: false,
            number: 0,
            drops: false,
        }
    }

    /// The group that the chain is offered.
    pub(super) fn offers(&self) -> Option<Group> {
        self.leaves.front().map(|leaf| match self.has_first {
            false => leaf.group(0, !leaf.has_two_groups()),
            true => leaf.group(1, leaf.last),
        })
    }

    /// What becomes of a leaf of the chain in front of the slice.
    pub(super) fn fate(&self, reset: bool) -> Fate {
        match (self.drops, self.open && !reset) {
            (true, _) => Fate::Refused,
            (false, true) => Fate::Given,
            (false, false) => Fate::Waits,
        }
    }

    /// The leaf, which is given, is the last that a bank holds, and not the last of its set.
    pub(super) fn is_too_long(&self, leaf: &LeafWord, core: &Core) -> bool {
        self.number + 1 == core.set_leaves() && !leaf.last
    }

    /// A clock in which `leaf` is the chain's leaf in front of the slice, and the chain takes a group or not.
    pub(super) fn clock(
        &mut self,
        core: &Core,
        leaf: Option<&LeafWord>,
        chain_ready: bool,
        reset: bool,
    ) {
        if reset {
            *self = Self::new(self.leaves.stages());
            return;
        }
        let leaf = leaf.map(|leaf| (leaf, self.fate(false)));
        let given = leaf.filter(|(_, fate)| *fate == Fate::Given);
        self.open = self.leaves.is_ready() && given.is_none();
        self.groups(given.map(|(leaf, _)| leaf.clone()), chain_ready);
        match leaf {
            Some((leaf, Fate::Given)) => {
                self.drops = self.is_too_long(leaf, core);
                self.number = match leaf.last || self.drops {
                    true => 0,
                    false => self.number + 1,
                };
            }
            Some((leaf, Fate::Refused)) => self.drops = !leaf.last,
            _ => {}
        }
    }

    /// The groups: the leaf in front leaves its place with its last.
    fn groups(&mut self, given: Option<LeafWord>, chain_ready: bool) {
        let front = self.leaves.front().filter(|_| chain_ready);
        let has_more = front.map(|leaf| leaf.has_two_groups() && !self.has_first);
        self.leaves.clock(has_more == Some(false), given, false);
        self.has_first = has_more.unwrap_or(self.has_first);
    }
}
