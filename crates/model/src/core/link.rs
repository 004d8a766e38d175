//! Flow control by credits, between a stream and a chain.

use super::slice::Places;

/// The places of a chain for the words of a stream, and what the stream knows of them.
#[derive(Clone, Debug)]
pub(super) struct Link<W, const N: usize> {
    /// The credits: places that the stream knows to be empty.
    left: usize,
    places: Places<W, N>,
    /// A word left its place in the clock before.
    returned: bool,
}

impl<W, const N: usize> Default for Link<W, N> {
    fn default() -> Self {
        Self {
            left: N,
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
        self.places.clock(moves_out, moves_in, false);
    }
}
