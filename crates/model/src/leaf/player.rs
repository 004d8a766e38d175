//! The groups of the pairs in the queue are played to the chain.

use photoncube_spec::{Leaf, LeafSizes};

use super::Events;
use super::scan::{Pair, Wanted};

/// A group's place in the memory.
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct Address {
    pub(super) bank: usize,
    pub(super) place: usize,
}

/// The flags of a group on its way from the memory to the chain.
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct WordFlags {
    pub(super) valid: bool,
    pub(super) last: bool,
    pub(super) blank: bool,
}

/// The pair that is played.
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct Entry {
    pub(super) valid: bool,
    pub(super) mask: u32,
    /// The next group is the entry's last.
    pub(super) last: bool,
    pub(super) pair: Pair,
}

impl Entry {
    pub(super) fn is_last_of_batch(&self) -> bool {
        self.pair.end && self.last
    }

    /// The address of the next group. Where no group is wanted, it is that of the pair's first.
    fn address(&self) -> Address {
        let groups = Leaf::PAIR * Leaf::GROUPS;
        let in_pair = self.mask.trailing_zeros() as usize % u32::BITS as usize;
        Address {
            bank: self.pair.bank,
            place: groups * self.pair.pair + in_pair,
        }
    }
}

#[derive(Copy, Clone, Debug, Default)]
pub(super) struct Player {
    pub(super) entry: Entry,
    pub(super) spacing: u32,
    /// A last group may be played.
    pub(super) may_end: bool,
    pub(super) outstanding: u32,
    pub(super) read: WordFlags,
    pub(super) word: WordFlags,
}

impl Player {
    /// The address of the group that is played next.
    pub(super) fn address(&self) -> Address {
        self.entry.address()
    }

    /// Whether a group is played in this clock.
    pub(super) fn plays(&self) -> bool {
        self.entry.valid && (self.may_end || !self.entry.is_last_of_batch())
    }

    pub(super) fn clock(
        &mut self,
        sizes: &LeafSizes,
        events: Events,
        oldest: Option<Wanted>,
        batch_leaves: bool,
    ) {
        let entry = self.entry;
        self.word = self.read;
        self.read = WordFlags {
            valid: events.plays,
            last: events.ends_batch,
            blank: entry.mask == 0,
        };
        if events.plays {
            self.entry.mask &= entry.mask.wrapping_sub(1);
            self.entry.last = entry.mask.count_ones() <= 2;
            self.entry.valid = !entry.last;
        }
        if let Some(Wanted { pair, mask }) = oldest.filter(|_| events.leaves_queue) {
            self.entry = Entry {
                valid: true,
                mask,
                last: mask.count_ones() <= 1,
                pair,
            };
        }
        let has_room = self.outstanding < sizes.most_outstanding;
        self.may_end = self.spacing == 0 && has_room && !events.ends_batch;
        self.spacing = match events.ends_batch {
            // A clock more passes until the next may end, in which `may_end` is set.
            true => sizes.least_spacing.saturating_sub(2),
            false => self.spacing.saturating_sub(1),
        };
        self.outstanding += u32::from(events.ends_batch);
        self.outstanding -= u32::from(batch_leaves);
    }

    pub(super) fn reset(&mut self) {
        self.entry.valid = false;
        (self.spacing, self.outstanding) = (0, 0);
        self.may_end = false;
        self.read.valid = false;
        self.word.valid = false;
    }
}
