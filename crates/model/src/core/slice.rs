//! The places of words in a stream.

use std::collections::VecDeque;

/// The words in several places, the first place first: a slice has two.
#[derive(Clone, Debug)]
pub(super) struct Places<W, const N: usize> {
    words: VecDeque<W>,
}

impl<W, const N: usize> Default for Places<W, N> {
    fn default() -> Self {
        Self {
            words: VecDeque::new(),
        }
    }
}

impl<W, const N: usize> Places<W, N> {
    /// A place is empty, and takes a word unless there is a reset.
    pub(super) fn is_ready(&self) -> bool {
        self.words.len() < N
    }

    /// The word that is given.
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
