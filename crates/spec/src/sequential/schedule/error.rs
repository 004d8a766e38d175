//! The errors of the schedule checker: the clock, the node, the value found and the value expected.

use thiserror::Error;

use super::content::Content;
use crate::hypercube::Axis;

/// The reason why the checker rejects a microprogram. Clocks count from 0 in their phase.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[allow(missing_docs)] // the messages say what the fields are
pub enum ScheduleError {
    #[error("{phase} phase: it has no step; expected at least one")]
    Empty { phase: &'static str },
    #[error(
        "{phase} clock {clock}, node {node}: `{first}` and `{second}` both {what}; \
         move one to another clock"
    )]
    Conflict {
        phase: &'static str,
        clock: u32,
        node: usize,
        first: String,
        second: String,
        what: String,
    },
    #[error("{phase} clock {clock}, node {node}: the {dimension}-D cube has no axis {axis}")]
    NoSuchLink {
        phase: &'static str,
        clock: u32,
        node: usize,
        axis: Axis,
        dimension: u32,
    },
    #[error(
        "query clock {clock}: `{step}` takes a second query, as clock {first} has taken one; leave \
         one of the two out"
    )]
    TakenTwice {
        clock: u32,
        first: u32,
        step: String,
    },
    #[error("{phase} phase: no step takes a {stream}; expected `{expected}`")]
    NotTaken {
        phase: &'static str,
        stream: &'static str,
        expected: &'static str,
    },
    #[error(
        "iteration clock {clock}: `{step}` takes the group in the iteration's last clock, in which \
         the machine must know already whether it is the query's last; let another step follow"
    )]
    TakenLate { clock: u32, step: String },
    #[error("{phase} clock {clock}, node {node}: `{step}` does not belong to this phase")]
    WrongPhase {
        phase: &'static str,
        clock: u32,
        node: usize,
        step: String,
    },
    #[error(
        "{phase} clock {clock}, node {node}: `{step}` reads {register} of node {holder}, \
         which holds {found}; expected {expected}"
    )]
    Precedence {
        phase: &'static str,
        clock: u32,
        node: usize,
        step: String,
        register: &'static str,
        holder: usize,
        found: Content,
        expected: String,
    },
    #[error(
        "after {phase} clock {clock}, node {node}: {register} holds {found}; expected {expected}"
    )]
    Incomplete {
        phase: &'static str,
        clock: u32,
        node: usize,
        register: &'static str,
        found: Content,
        expected: String,
    },
}
