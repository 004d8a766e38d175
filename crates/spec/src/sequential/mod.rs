//! The sequential machine: all cells execute one op per clock, by a microprogram.

mod control;
mod listing;
mod microprogram;
mod op;
mod own_program;
mod pins;
mod register;
mod schedule;

pub use control::{ControlWord, FIELDS, Field, FieldRow, WorkSource, control_word_bits, encode};
pub use listing::{ListingError, parse_listing};
pub use microprogram::{Microprogram, ScheduledStep, Step};
pub use op::{OPS, Op, OpRow, Unit};
pub use own_program::{MOST_OWN_STEPS, OwnProgram};
pub use pins::CONTROL_REGISTERS;
pub(crate) use pins::pins;
pub use register::{REGISTERS, Register, RegisterRow};
pub use schedule::{
    Content, ScheduleError, ScheduleReport, UnitUse, check_schedule, check_streams, schedule_report,
};
