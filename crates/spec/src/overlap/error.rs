//! The errors of the program checker: the clock, the node, the value found and the value expected.

use thiserror::Error;

use super::content::Content;
use crate::hypercube::Axis;

/// The place of an error in a run of the program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// `kernel` or `epilogue`.
    pub phase: &'static str,
    /// The pass of the kernel; 0 in the epilogue.
    pub pass: u32,
    /// The clock, counted from 0 in its pass or in the epilogue.
    pub clock: u32,
    /// The node, in the quad of photon 0. All quads do the same.
    pub node: usize,
    /// The op as it is written in listings.
    pub op: String,
}

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self {
            phase,
            pass,
            clock,
            node,
            op,
        } = self;
        match *phase {
            "kernel" => write!(f, "kernel pass {pass} clock {clock}, node {node}: `{op}`"),
            _ => write!(f, "{phase} clock {clock}, node {node}: `{op}`"),
        }
    }
}

/// The reason why the checker rejects a program.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[allow(missing_docs)] // the messages say what the fields are
pub enum ProgramError {
    #[error("{place} is in clock {clock} of a kernel of {interval} clocks")]
    NoSuchClock {
        place: Box<Place>,
        clock: u32,
        interval: u32,
    },
    #[error("{place} and `{other}` both {what}; move one to another clock")]
    Conflict {
        place: Box<Place>,
        other: String,
        what: String,
    },
    #[error("{place} needs {register} on axis {axis} of node {sender}, which sends {other} then")]
    Link {
        place: Box<Place>,
        sender: usize,
        axis: Axis,
        register: String,
        other: String,
    },
    #[error("{place} reads {register} of node {holder}, which holds {found}; expected {expected}")]
    Precedence {
        place: Box<Place>,
        register: String,
        holder: usize,
        found: Content,
        expected: String,
    },
    #[error("{place} does not belong to this phase")]
    WrongPhase { place: Box<Place> },
    #[error(
        "clock {clock} of the kernel takes no group in node {node}; expected that all nodes do"
    )]
    NotTaken { clock: u32, node: usize },
    #[error("after a query of {groups} groups, node {node}: s holds {found}; expected {expected}")]
    Incomplete {
        groups: usize,
        node: usize,
        found: Content,
        expected: Content,
    },
}
