//! The tags of the queries in the machine.

use photoncube_spec::LeafSizes;

use super::{Events, Token};

#[derive(Clone, Debug)]
pub(super) struct Tags {
    /// For each place, the token whose result has it, and its tag.
    places: Vec<(Token, u32)>,
    pub(super) write: usize,
    pub(super) read: usize,
    pub(super) result: u32,
}

impl Tags {
    pub(super) fn new(sizes: &LeafSizes) -> Self {
        Self {
            places: vec![(Token::Filler, 0); 1 << sizes.tag_place],
            write: 0,
            read: 0,
            result: 0,
        }
    }

    /// Whether the chain's next result is that of a filler.
    pub(super) fn is_filler(&self) -> bool {
        self.places[self.read].0 == Token::Filler
    }

    /// The tag of the chain's next result.
    pub(super) fn tag(&self) -> u32 {
        self.places[self.read].1
    }

    /// Whether the last result of a batch is taken from the chain.
    pub(super) fn ends_batch(&self, events: Events, sizes: &LeafSizes) -> bool {
        events.takes_result && self.result + 1 == sizes.engines
    }

    pub(super) fn clock(&mut self, sizes: &LeafSizes, events: Events, tag: u32) {
        let after = |place: usize| (place + 1) % self.places.len();
        let (next_write, next_read) = (after(self.write), after(self.read));
        if let Some(token) = events.token {
            self.places[self.write] = (token, tag);
            self.write = next_write;
        }
        if events.takes_result {
            self.read = next_read;
            self.result = (self.result + 1) % sizes.engines;
        }
    }

    pub(super) fn reset(&mut self) {
        (self.write, self.read, self.result) = (0, 0, 0);
    }
}
