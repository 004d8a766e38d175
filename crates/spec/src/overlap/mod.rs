//! The machine whose units work at the same time, and whose program is found by a scheduler.
//!
//! The cells, their units and the hypercube are the paper's (Ryu, Kim, Lee). Of a photon's quad,
//! not all four cells add up the distance, only two do, and they take turns: for even groups Y adds
//! x^2 + y^2 and D adds z^2, for odd groups X and Z do. The distance then goes to all four, each
//! gates its own channel and adds it to its own sum. So two groups are twelve adds on four adders,
//! three clocks. Only when the query ends do the sums cross the photon axes.
//!
//! The words op, unit and register mean here what they mean at the crate's root, in this other
//! organisation of the cell.

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
