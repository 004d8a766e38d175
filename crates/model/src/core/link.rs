//! Flow control by credits, between a stream and a chain.

use std::collections::VecDeque;

use super::slice::Places;

/// The queue of a chain for the words of a stream, and the way to it.
#[derive(Clone, Debug)]
pub(super) struct Link<W, const N: usize> {
    /// The credits: places that the stream knows to be empty.
    left: usize,
    /// What is in each stage of the way and in the queue's memory for its first clock, the next to arrive in front.
    on_the_way: VecDeque<Option<W>>,
    places: Places<W, N>,
    /// Whether a credit is in each stage of the way back, the next to arrive in front.
    returning: VecDeque<bool>,
}

impl<W: Clone, const N: usize> Link<W, N> {
    /// An empty queue with this many stages in front of it.
    pub(super) fn new(stages: usize) -> Self {
        Self {
            left: N,
            on_the_way: vec![None; stages + 1].into(),
            places: Places::default(),
            returning: vec![false; stages].into(),
        }
    }

    /// The stages in front of the queue.
    pub(super) fn stages(&self) -> usize {
        self.returning.len()
    }

    /// A word may leave the stream, unless there is a reset.
    pub(super) fn is_ready(&self) -> bool {
        self.left > 0
    }

    /// The word that the chain is given.
    pub(super) fn front(&self) -> Option<&W> {
        self.places.front()
    }

    /// A clock in which the word in front moves out or not, and a word may leave the stream.
    pub(super) fn clock(&mut self, moves_out: bool, leaves: Option<W>, reset: bool) {
        if reset {
            *self = Self::new(self.stages());
            return;
        }
        self.left -= usize::from(leaves.is_some());
        self.returning.push_back(moves_out);
        self.left += usize::from(self.returning.pop_front() == Some(true));
        self.on_the_way.push_back(leaves);
        let arrives = self.on_the_way.pop_front().flatten();
        self.places.clock(moves_out, arrives, false);
    }
}
