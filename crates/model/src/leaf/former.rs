//! Queries are put into batches.

use photoncube_spec::{Inputs, LeafSizes};

use super::boxes::Bounds;
use super::{Events, Token};

#[derive(Copy, Clone, Debug, Default)]
pub(super) struct Former {
    pub(super) loaded: u32,
    pub(super) closed: bool,
    pub(super) release: bool,
    pub(super) facings: u32,
    pub(super) bounds: Bounds,
}

impl Former {
    /// The token that the chain is offered.
    pub(super) fn offers(&self, inputs: &Inputs, engines: u32) -> Option<Token> {
        match self.closed {
            false => inputs.query_valid.then_some(Token::Query),
            true => (self.loaded < engines).then_some(Token::Filler),
        }
    }

    /// The chain has all tokens of the batch.
    pub(super) fn is_complete(&self, engines: u32) -> bool {
        self.closed && self.loaded == engines
    }

    pub(super) fn clock(&mut self, sizes: &LeafSizes, events: Events, inputs: &Inputs) {
        let is_first = self.loaded == 0;
        if inputs.query_valid && !self.closed {
            let query = Bounds::at(inputs.query.position);
            self.bounds = match is_first {
                true => query,
                false => self.bounds.around(query),
            };
            if is_first {
                self.facings = inputs.batch.facings;
            }
        }
        if events.token == Some(Token::Query) {
            self.release = inputs.query_release || (self.release && !is_first);
            self.closed = inputs.batch.last || self.loaded + 1 == sizes.engines;
        }
        self.loaded += u32::from(events.token.is_some());
        if events.starts {
            (self.loaded, self.closed) = (0, false);
        }
    }

    pub(super) fn reset(&mut self) {
        (self.loaded, self.closed) = (0, false);
    }
}
