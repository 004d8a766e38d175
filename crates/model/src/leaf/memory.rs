//! The words of the groups.

use std::mem;

use photoncube_spec::{Group, Inputs, Leaf, Spatial};

use super::fill::Write;
use super::no_group;
use super::player::{Address, WordFlags};

#[derive(Clone, Debug)]
pub(super) struct GroupMemory {
    /// The groups of the two banks, one bank after the other.
    groups: Vec<Group>,
    bank_groups: usize,
    pub(super) write: Group,
    pub(super) read: Group,
    pub(super) word: Group,
}

impl GroupMemory {
    pub(super) fn new(leaf: &Leaf) -> Self {
        let bank_groups = leaf.bank_groups as usize;
        Self {
            groups: vec![no_group(); 2 * bank_groups],
            bank_groups,
            write: no_group(),
            read: no_group(),
            word: no_group(),
        }
    }

    /// The group that the chain is given.
    pub(super) fn word(&self, flags: WordFlags) -> Group {
        let mut group = self.word.clone();
        group.last = flags.last;
        for lane in group.lanes.iter_mut().filter(|_| flags.blank) {
            lane.present = false;
        }
        group
    }

    pub(super) fn clock(&mut self, write: Write, inputs: &Inputs, read: Option<Address>) {
        mem::swap(&mut self.word, &mut self.read);
        match read {
            Some(address) => {
                let place = address.bank * self.bank_groups + address.place;
                self.read.clone_from(&self.groups[place]);
            }
            // What was in `Read` stays there too.
            None => self.read.clone_from(&self.word),
        }
        if write.valid {
            let place = write.bank * self.bank_groups + write.place;
            self.groups[place].clone_from(&self.write);
        }
        self.write.clone_from(&inputs.group);
        self.write.lanes.resize(Spatial::LANES, Default::default());
    }
}
