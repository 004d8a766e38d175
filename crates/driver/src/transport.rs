//! The way to a machine and back.

use photoncube_spec::{LeafAnswer, LeafWords};

/// The error of a way to a machine.
pub type TransportError = Box<dyn std::error::Error + Send + Sync>;

/// A way to a machine and back.
pub trait Transport: Send {
    /// Gives the machine words, and waits until it has answered every query among them. The words begin with a new set, and
    /// release all of theirs.
    ///
    /// # Errors
    /// The machine does not answer.
    fn exchange(&mut self, words: &LeafWords) -> Result<LeafAnswer, TransportError>;
}
