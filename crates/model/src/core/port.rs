//! The way of leaves to a chain.

use photoncube_spec::{Core, Group, Lane, Spatial};

/// A leaf in the slice of photons.
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
    /// It waits for the chain.
    Waits,
    /// Its first group is given to the chain.
    Given,
    /// It is dropped.
    Refused,
}

/// The state of the way to one chain.
#[derive(Clone, Debug, Default)]
pub(super) struct PhotonPort {
    second: Option<Group>,
    /// Leaves of the set that were given.
    leaves: u32,
    drops: bool,
}

impl PhotonPort {
    /// The group that the chain is offered, where `leaf` is the chain's leaf in front of the slice.
    pub(super) fn offers(&self, leaf: Option<&LeafWord>) -> Option<Group> {
        let first = leaf.filter(|_| !self.drops);
        let first = first.map(|leaf| leaf.group(0, !leaf.has_two_groups()));
        self.second.clone().or(first)
    }

    /// What becomes of the leaf, where the chain is ready or not.
    pub(super) fn fate(&self, chain_ready: bool) -> Fate {
        match (self.drops, self.second.is_some(), chain_ready) {
            (true, _, _) => Fate::Refused,
            (false, false, true) => Fate::Given,
            _ => Fate::Waits,
        }
    }

    /// The leaf, which is given, is the last that a bank holds, and not the last of its set.
    pub(super) fn is_too_long(&self, leaf: &LeafWord, core: &Core) -> bool {
        self.leaves + 1 == core.set_leaves() && !leaf.last
    }

    pub(super) fn clock(
        &mut self,
        core: &Core,
        leaf: Option<&LeafWord>,
        chain_ready: bool,
        reset: bool,
    ) {
        let fate = leaf.map(|leaf| (leaf, self.fate(chain_ready)));
        if chain_ready {
            self.second = None;
        }
        match fate {
            Some((leaf, Fate::Given)) => {
                self.drops = self.is_too_long(leaf, core);
                self.leaves = match leaf.last || self.drops {
                    true => 0,
                    false => self.leaves + 1,
                };
                self.second = leaf.has_two_groups().then(|| leaf.group(1, leaf.last));
            }
            Some((leaf, Fate::Refused)) => self.drops = !leaf.last,
            _ => {}
        }
        if reset {
            *self = Self::default();
        }
    }
}
