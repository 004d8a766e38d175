//! The schedule checker and the utilisation of a schedule.
//!
//! The checker follows the *kind of value* that each register holds, clock by clock: a distance that lacks the
//! sum across w, for example, may not be compared. It uses no photon values, only what must have happened
//! before each op. It is the oracle for the microprogram that model and HDL both read.

mod check;
mod content;
mod report;
mod streams;

pub use check::check_schedule;
pub use content::{Content, Contents, Unreadable};
pub use report::{ScheduleReport, schedule_report};
pub use streams::check_streams;
