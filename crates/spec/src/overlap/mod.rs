//! The overlapped machine: its units work at the same time, and a scheduler finds its program.
//!
//! The cells, their units and the hypercube are the paper's (Ryu, Kim, Lee). Only two of the four cells of a
//! quad add up the distance, and the pairs take turns: for even groups Y adds x^2 + y^2 and D adds z^2, for
//! odd groups X and Z do so. All four cells then receive the distance; each gates its own channel and adds it
//! to its own sum. Two groups thus take twelve adds on four adders, which are three clocks. The sums cross
//! the photon axes only when the query ends.
//!
//! The cell's ops, registers and control fields are the rows of [`crate::OVERLAPPED`].

mod bound;
mod check;
mod content;
mod control;
mod graph;
mod listing;
mod program;
mod report;
mod schedule;

pub use bound::{Resource, recurrence_bound, resource_bound};
pub use check::check_program;
pub use control::{asked_of, control_word_bits, drain_bits};
pub use graph::{Adders, Bundle, Edge, FIXED, Graph, Part, ROTATED};
pub use program::{KernelOp, Program};
pub use report::{ProgramReport, program_report};
pub use schedule::{Schedule, SchedulerError, schedule, schedule_at};
