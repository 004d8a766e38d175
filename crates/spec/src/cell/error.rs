//! The errors of the schedule checkers: the clock, the node, the value found and the value expected.

use std::fmt;

use thiserror::Error;

use crate::hypercube::Axis;

/// The place of a step in a run of its program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// `query` or `iteration`; of an overlapped program `kernel` or `epilogue`.
    pub phase: &'static str,
    /// The pass of the kernel; `None` in other phases.
    pub pass: Option<u32>,
    /// The clock, counted from 0 in its phase or pass.
    pub clock: u32,
    /// The node. In an overlapped machine it is in the quad of photon 0, as all quads do the same.
    pub node: usize,
    /// The step as it is written in listings.
    pub step: String,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            phase,
            pass,
            clock,
            node,
            step,
        } = self;
        let pass = pass.map_or(String::new(), |pass| format!("pass {pass} "));
        write!(f, "{phase} {pass}clock {clock}, node {node}: `{step}`")
    }
}

/// The reason why a checker rejects a program.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[allow(missing_docs)] // the messages say what the fields are
pub enum ScheduleError {
    #[error("{phase} phase: it has no step; expected at least one")]
    Empty { phase: &'static str },
    #[error("{place} is in clock {clock} of a kernel of {interval} clocks")]
    NoSuchClock {
        place: Box<Place>,
        clock: u32,
        interval: u32,
    },
    #[error("{phase} clock {clock}, node 0: the {dimension}-D cube has no axis {axis}")]
    NoSuchLink {
        phase: &'static str,
        clock: u32,
        axis: Axis,
        dimension: u32,
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
        register: &'static str,
        other: &'static str,
    },
    #[error("{place} reads {register} of node {holder}, which holds {found}; expected {expected}")]
    Precedence {
        place: Box<Place>,
        register: &'static str,
        holder: usize,
        found: String,
        expected: String,
    },
    #[error("{place} does not belong to this phase")]
    WrongPhase { place: Box<Place> },
    #[error(
        "query clock {clock}: `{step}` takes a second query, as clock {first} has taken one; leave \
         one of the two out"
    )]
    TakenTwice {
        clock: u32,
        first: u32,
        step: String,
    },
    #[error(
        "iteration clock {clock}: `{step}` takes the group in the iteration's last clock, in which \
         the machine must know already whether it is the query's last; let another step follow"
    )]
    TakenLate { clock: u32, step: String },
    #[error("{phase} phase: no step takes a {stream}; expected `{expected}`")]
    NotTaken {
        phase: &'static str,
        stream: &'static str,
        expected: &'static str,
    },
    #[error(
        "clock {clock} of the kernel takes no group in node {node}; expected that all nodes do"
    )]
    NotTakenByAll { clock: u32, node: usize },
    #[error("after {after}, node {node}: s holds {found}; expected {expected}")]
    Incomplete {
        after: String,
        node: usize,
        found: String,
        expected: String,
    },
}
