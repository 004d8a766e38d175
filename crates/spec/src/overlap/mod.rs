//! The overlapped machine: its units work at the same time, and a scheduler finds its program.
//!
//! The cells, their units and the hypercube are the paper's (Ryu, Kim, Lee). Only two of the four cells of a
//! quad add up the distance, and the pairs take turns: for even groups Y adds x^2 + y^2 and D adds z^2, for
//! odd groups X and Z do so. All four cells then receive the distance; each gates its own channel and adds it
//! to its own sum. Two groups thus take twelve adds on four adders, which are three clocks. The sums cross
//! the photon axes only when the query ends.
//!
//! The words op, unit and register have the meaning that they have at the crate's root, applied to this
//! organisation.

mod bound;
mod check;
mod content;
mod control;
mod error;
mod graph;
mod listing;
mod op;
mod pins;
mod program;
mod register;
mod report;
mod schedule;

pub use bound::{Resource, UnitBound, recurrence_bound, resource_bound, unit_bounds};
pub use check::check_program;
pub use content::{AxisSet, Content};
pub use control::{ControlWord, FIELDS, Field, FieldRow, asked_of, control_word_bits};
pub use error::{Place, ProgramError};
pub use graph::{Adders, Bundle, Edge, FIXED, Graph, Part, ROTATED};
pub use op::{OPS, Op, OpRow, Read, Unit};
pub(crate) use pins::pins;
pub use pins::{CONTROL_REGISTERS, drain_bits};
pub use program::{EpilogueOp, KernelOp, Program};
pub use register::{POWER_WORDS, Register};
pub use report::{ProgramReport, UnitUse, program_report};
pub use schedule::{Schedule, SchedulerError, schedule, schedule_at};
