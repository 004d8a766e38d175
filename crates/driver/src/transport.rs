//! The way to a core and back.

use photoncube_spec::{Beat, CoreCounter, CounterRow, ResultWord};

/// The error of a way to a core.
pub type TransportError = Box<dyn std::error::Error + Send + Sync>;

/// Words for both input streams of a core, each in its order. The batches release all sets.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CoreWords {
    /// The leaves.
    pub photons: Vec<Beat>,
    /// The queries.
    pub queries: Vec<Beat>,
}

/// The answer of a core.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CoreAnswer {
    /// The results, in the order in which they left the core.
    pub results: Vec<ResultWord>,
    /// What the core's counters counted, in the order of [`CounterRow::ALL`].
    pub counters: Vec<u64>,
}

impl CoreAnswer {
    /// The value of a counter.
    ///
    /// # Panics
    /// Where the answer has not all counters.
    pub fn counter(&self, counter: CoreCounter) -> u64 {
        assert_eq!(
            self.counters.len(),
            CounterRow::ALL.len(),
            "a value for each counter"
        );
        self.counters[counter as usize]
    }
}

/// A way to a core and back.
pub trait Transport: Send {
    /// Gives the core words, and waits until it has answered every query among them.
    ///
    /// # Errors
    /// The core does not answer.
    fn exchange(&mut self, words: &CoreWords) -> Result<CoreAnswer, TransportError>;
}
