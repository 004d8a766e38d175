//! The way of words to a chain that is far away.

use super::slice::Places;

/// The places of a chain for the words of a stream, and the registers of the way to them and back.
#[derive(Clone, Debug)]
pub(super) struct Link<W, const N: usize> {
    /// Places that the stream knows to be empty, without a word under way to them.
    left: usize,
    /// The word that left the stream in the clock before.
    arrives: Option<W>,
    places: Places<W, N>,
    /// A word left its place in the clock before.
    returned: bool,
}

impl<W, const N: usize> Default for Link<W, N> {
    fn default() -> Self {
        Self {
            left: N,
            arrives: None,
            places: Places::default(),
            returned: false,
        }
    }
}

impl<W, const N: usize> Link<W, N> {
    /// A word may leave the stream, unless there is a reset.
    pub(super) fn is_ready(&self) -> bool {
        self.left > 0
    }

    /// The word that the chain is given.
    pub(super) fn front(&self) -> Option<&W> {
        self.places.front()
    }

    /// A clock in which the word in front moves out or not, and a word may leave the stream.
    pub(super) fn clock(&mut self, moves_out: bool, moves_in: Option<W>, reset: bool) {
        if reset {
            *self = Self::default();
            return;
        }
        self.left += usize::from(self.returned);
        self.left -= usize::from(moves_in.is_some());
        self.returned = moves_out;
        self.places.clock(moves_out, self.arrives.take(), false);
        self.arrives = moves_in;
    }
}
