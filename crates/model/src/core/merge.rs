//! The merging of a chain's results with those that pass it.

use super::slice::Places;

/// The slice of a chain's results and of those that come from behind it.
#[derive(Clone, Debug)]
pub(super) struct Merge<W> {
    slice: Places<W, 2>,
    /// The last word was the chain's own.
    was_own: bool,
}

impl<W> Default for Merge<W> {
    fn default() -> Self {
        Self {
            slice: Places::default(),
            was_own: false,
        }
    }
}

/// The word that goes into the slice in a clock.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) enum Merged {
    /// The chain's own.
    Own,
    /// One that passes.
    Passing,
}

impl<W> Merge<W> {
    /// The word that is given to the next slice.
    pub(super) fn front(&self) -> Option<&W> {
        self.slice.front()
    }

    /// Which word goes into the slice, of those that there are.
    pub(super) fn takes(&self, own: bool, passing: bool) -> Option<Merged> {
        match (self.slice.is_ready(), own, passing) {
            (false, ..) | (_, false, false) => None,
            (true, true, false) => Some(Merged::Own),
            (true, false, true) => Some(Merged::Passing),
            (true, true, true) if self.was_own => Some(Merged::Passing),
            (true, true, true) => Some(Merged::Own),
        }
    }

    /// A clock in which the word in front moves out or not, and a word may move in.
    pub(super) fn clock(&mut self, moves_out: bool, moves_in: Option<(Merged, W)>, reset: bool) {
        if let Some((kind, _)) = &moves_in {
            self.was_own = *kind == Merged::Own;
        }
        self.slice
            .clock(moves_out, moves_in.map(|(_, word)| word), reset);
        if reset {
            self.was_own = false;
        }
    }
}
