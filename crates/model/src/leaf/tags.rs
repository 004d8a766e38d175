//! The tags of the queries in the machine.

use photoncube_spec::LeafSizes;

use super::{Events, Token};

#[derive(Clone, Debug)]
pub(super) struct Tags {
    /// For each place of the memory, a token and its tag.
    places: Vec<(Token, u32)>,
    pub(super) write: usize,
    pub(super) read: usize,
    /// The token of the chain's next result, and its tag.
    oldest: (Token, u32),
    pub(super) has_oldest: bool,
    pub(super) result: u32,
}

impl Tags {
    pub(super) fn new(sizes: &LeafSizes) -> Self {
        Self {
            places: vec![(Token::Filler, 0); 1 << sizes.tag_place],
            write: 0,
            read: 0,
            oldest: (Token::Filler, 0),
            has_oldest: false,
            result: 0,
        }
    }

    /// Whether the chain's next result is that of a filler.
    pub(super) fn is_filler(&self) -> bool {
        self.oldest.0 == Token::Filler
    }

    /// The tag of the chain's next result.
    pub(super) fn tag(&self) -> u32 {
        self.oldest.1
    }

    /// The register of the chain's next result.
    pub(super) fn oldest_word(&self) -> u64 {
        u64::from(self.tag()) * 2 + u64::from(!self.is_filler())
    }

    /// Whether the last result of a batch is taken from the chain.
    pub(super) fn ends_batch(&self, events: Events, sizes: &LeafSizes) -> bool {
        events.takes_result && self.result + 1 == sizes.engines
    }

    pub(super) fn clock(&mut self, sizes: &LeafSizes, events: Events, tag: u32) {
        assert!(
            self.has_oldest || !events.takes_result,
            "the chain has a token's result only after the token is the oldest"
        );
        let waits = self.read != self.write;
        let after = |place: usize| (place + 1) % self.places.len();
        let (next_write, next_read) = (after(self.write), after(self.read));
        if events.takes_result {
            self.has_oldest = false;
            self.result = (self.result + 1) % sizes.engines;
        }
        if waits && !self.has_oldest {
            self.oldest = self.places[self.read];
            self.has_oldest = true;
            self.read = next_read;
        }
        if let Some(token) = events.token {
            self.places[self.write] = (token, tag);
            self.write = next_write;
        }
    }

    pub(super) fn reset(&mut self) {
        (self.write, self.read, self.result) = (0, 0, 0);
        self.has_oldest = false;
    }
}
