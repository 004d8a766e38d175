//! The sequential machine: all cells execute one op per clock, by a microprogram.

mod control;
mod listing;
mod microprogram;
mod own_program;
mod schedule;

pub use control::encode;
pub use listing::{ListingError, parse_listing};
pub use microprogram::Microprogram;
pub use own_program::{MOST_OWN_STEPS, OwnProgram};
pub use schedule::{
    Content, Contents, ScheduleReport, Unreadable, check_schedule, check_streams, schedule_report,
};
