//! The boxes around the groups of both banks, leaf by leaf, and the sets that are ready to be played.

use photoncube_spec::{Group, Leaf, Machine, Spatial, Widths};

use super::fill::Fill;

/// A box, by its borders in steps of photons or of queries.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Bounds {
    pub(super) low: [u32; 3],
    pub(super) high: [u32; 3],
}

impl Bounds {
    pub(super) fn at(point: [u32; 3]) -> Self {
        Self {
            low: point,
            high: point,
        }
    }

    pub(super) fn around(self, other: Self) -> Self {
        Self {
            low: [0, 1, 2].map(|axis| self.low[axis].min(other.low[axis])),
            high: [0, 1, 2].map(|axis| self.high[axis].max(other.high[axis])),
        }
    }
}

/// A leaf's entry.
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct LeafBox {
    /// The boxes of its groups.
    pub(super) groups: [Bounds; Leaf::GROUPS],
    pub(super) note: Note,
}

/// What an entry has beside the boxes.
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct Note {
    pub(super) facing: u32,
    /// The leaf has one group.
    pub(super) short: bool,
}

/// A stage on the way from a group to the entry of its leaf.
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct Stage {
    pub(super) valid: bool,
    pub(super) bank: usize,
    pub(super) place: usize,
    pub(super) last: bool,
    pub(super) facing: u32,
}

#[derive(Copy, Clone, Debug, Default)]
pub(super) struct BankSet {
    pub(super) full: bool,
    pub(super) end: usize,
}

#[derive(Clone, Debug)]
pub(super) struct Boxes {
    /// The entries of the two banks, one bank after the other.
    leaves: Vec<LeafBox>,
    bank_leaves: usize,
    /// The coordinate of all ones.
    largest: u32,
    pub(super) half: Stage,
    pub(super) halves: [Bounds; 2],
    pub(super) group: Stage,
    pub(super) of_group: Bounds,
    /// The stage of the leaf that is complete; `place` is the leaf's number.
    pub(super) leaf: Stage,
    pub(super) of_leaf: [Bounds; Leaf::GROUPS],
    /// The facings and lengths of the leaf's pair.
    pub(super) notes: [Note; Leaf::PAIR],
    pub(super) sets: [BankSet; 2],
}

impl Boxes {
    pub(super) fn new(machine: &Machine, leaf: &Leaf) -> Self {
        let bank_leaves = leaf.bank_groups as usize / Leaf::GROUPS;
        Self {
            leaves: vec![LeafBox::default(); 2 * bank_leaves],
            bank_leaves,
            largest: u32::MAX >> (u32::BITS - Widths::of(machine).photon),
            half: Stage::default(),
            halves: Default::default(),
            group: Stage::default(),
            of_group: Bounds::default(),
            leaf: Stage::default(),
            of_leaf: Default::default(),
            notes: Default::default(),
            sets: Default::default(),
        }
    }

    pub(super) fn set(&self, bank: usize) -> BankSet {
        self.sets[bank]
    }

    /// The entries of a pair.
    pub(super) fn pair(&self, bank: usize, pair: usize) -> [LeafBox; Leaf::PAIR] {
        [0, 1].map(|leaf| self.leaves[bank * self.bank_leaves + Leaf::PAIR * pair + leaf])
    }

    pub(super) fn clock(&mut self, fill: &Fill, written: &Group, frees: Option<usize>) {
        self.write_leaf();
        if let Some(bank) = frees {
            self.sets[bank].full = false;
        }
        let group = self.group;
        let is_first = group.place.is_multiple_of(Leaf::GROUPS);
        if group.valid {
            let first = match is_first {
                true => self.of_group,
                false => self.of_leaf[0],
            };
            self.of_leaf = [first, self.of_group];
            let own = group.place / Leaf::GROUPS % Leaf::PAIR;
            self.notes[own..].fill(Note {
                facing: group.facing,
                short: is_first,
            });
        }
        self.leaf = Stage {
            valid: group.valid && (!is_first || group.last),
            place: group.place / Leaf::GROUPS,
            ..group
        };
        self.of_group = self.halves[0].around(self.halves[1]);
        self.group = self.half;
        let half = |half: usize| {
            let lanes = &written.lanes[half * Spatial::LANES / 2..][..Spatial::LANES / 2];
            let nothing = Bounds {
                low: [self.largest; 3],
                high: [0; 3],
            };
            let present = lanes.iter().filter(|lane| lane.present);
            present
                .map(|lane| Bounds::at(lane.photon.position))
                .fold(nothing, Bounds::around)
        };
        self.halves = [0, 1].map(half);
        self.half = Stage {
            valid: fill.write.valid,
            bank: fill.write.bank,
            place: fill.write.place,
            last: fill.write.last,
            facing: written.facing,
        };
    }

    /// Writes the entry of a leaf that is complete.
    fn write_leaf(&mut self) {
        let Stage {
            valid,
            bank,
            place,
            last,
            ..
        } = self.leaf;
        if !valid {
            return;
        }
        let own = bank * self.bank_leaves + place;
        let first = own - place % Leaf::PAIR;
        for (entry, note) in self.leaves[first..].iter_mut().zip(self.notes) {
            entry.note = note;
        }
        for entry in &mut self.leaves[own..first + Leaf::PAIR] {
            entry.groups = self.of_leaf;
        }
        if last {
            self.sets[bank] = BankSet {
                full: true,
                end: place,
            };
        }
    }

    pub(super) fn reset(&mut self) {
        self.half.valid = false;
        self.group.valid = false;
        self.leaf.valid = false;
        for set in &mut self.sets {
            set.full = false;
        }
    }
}
