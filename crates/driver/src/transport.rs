//! The way to a core and back.

use photoncube_spec::{CoreAnswer, CoreWords};

/// The error of a way to a core.
pub type TransportError = Box<dyn std::error::Error + Send + Sync>;

/// A way to a core and back.
pub trait Transport: Send {
    /// Gives the core words, and waits until it has answered every query among them.
    ///
    /// # Errors
    /// The core does not answer.
    fn exchange(&mut self, words: &CoreWords) -> Result<CoreAnswer, TransportError>;

    /// Whether words may have rounds of other kinds than [`photoncube_spec::QueryRounds::Own`].
    fn has_rounds(&self) -> bool {
        false
    }
}
