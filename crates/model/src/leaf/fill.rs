//! Sets of groups are read in.

use photoncube_spec::{Inputs, LeafSizes};

#[derive(Clone, Debug, Default)]
pub(super) struct Fill {
    pub(super) bank: usize,
    pub(super) place: usize,
    pub(super) ready: bool,
    pub(super) filled: [bool; 2],
    pub(super) write: Write,
}

/// The group that was taken in the clock before, except its words.
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct Write {
    pub(super) valid: bool,
    pub(super) bank: usize,
    pub(super) place: usize,
    pub(super) last: bool,
}

impl Fill {
    pub(super) fn clock(&mut self, sizes: &LeafSizes, inputs: &Inputs, frees: Option<usize>) {
        let taken = self.ready && inputs.group_valid;
        let at_end = self.place + 1 == 1 << sizes.place;
        let last = taken && (inputs.group.last || at_end);
        self.write = Write {
            valid: taken,
            bank: self.bank,
            place: self.place,
            last,
        };
        self.ready = !self.filled[self.bank] && !last;
        if last {
            self.filled[self.bank] = true;
            (self.bank, self.place) = (self.bank ^ 1, 0);
        } else {
            self.place += usize::from(taken);
        }
        if let Some(bank) = frees {
            self.filled[bank] = false;
        }
    }

    pub(super) fn reset(&mut self) {
        self.bank = 0;
        self.place = 0;
        self.ready = false;
        self.filled = [false; 2];
        self.write.valid = false;
    }
}
