//! A slice of a stream.

use std::collections::VecDeque;

/// The words in a slice, the first place first; at most two.
#[derive(Clone, Debug)]
pub(super) struct Slice<W> {
    words: VecDeque<W>,
}

impl<W> Default for Slice<W> {
    fn default() -> Self {
        Self {
            words: VecDeque::new(),
        }
    }
}

impl<W> Slice<W> {
    const PLACES: usize = 2;

    /// The slice takes a word, unless there is a reset.
    pub(super) fn is_ready(&self) -> bool {
        self.words.len() < Self::PLACES
    }

    /// The word that the slice gives.
    pub(super) fn front(&self) -> Option<&W> {
        self.words.front()
    }

    /// A clock in which the word in front moves out or not, and a word may move in.
    pub(super) fn clock(&mut self, moves_out: bool, moves_in: Option<W>, reset: bool) {
        if moves_out {
            self.words.pop_front();
        }
        self.words.extend(moves_in);
        if reset {
            self.words.clear();
        }
    }
}
