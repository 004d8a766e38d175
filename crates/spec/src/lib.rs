//! The specification of the machines as data: formats, ops, control words, microprograms, topology, streams
//! and the named machines.
//!
//! The golden model and the HDL both read this crate, and neither reads the other. The crate describes
//! meaning in prose and formulas and computes nothing on photon values. The difference `a - b` of two
//! coordinates, for example, is written once in `photoncube-model` and once in `photoncube-hdl`, so the
//! comparison of the two is a real check.

mod control;
mod format;
mod format_widths;
mod hypercube;
mod interface;
mod listing;
mod machine;
mod machines;
mod microprogram;
mod nearest;
mod op;
mod organisation;
mod own_program;
mod pace;
mod photon_format;
mod photon_formats;
mod photon_record;
mod pins;
mod register;
mod schedule;
mod spatial;
mod stream;

pub mod overlap;

pub use control::{ControlWord, FIELDS, Field, FieldRow, WorkSource, control_word_bits, encode};
pub use format::{Squarer, Widths};
pub use format_widths::FormatWidths;
pub use hypercube::{Axis, Hypercube, Role};
pub use interface::{Direction, Fact, Interface, Port};
pub use listing::{ListingError, parse_listing};
pub use machine::{Machine, Numbers, PlainFormat};
pub use machines::{MACHINES, UnknownMachine, find_machine};
pub use microprogram::{Microprogram, ScheduledStep, Step};
pub use nearest::did_you_mean;
pub use op::{OPS, Op, OpRow, Unit};
pub use organisation::{Organisation, Rate};
pub use own_program::{MOST_OWN_STEPS, OwnProgram};
pub use pace::{Pace, SharedGroups};
pub use photon_format::{Channels, Exponent, FormatError, PhotonFormat, PowerFormat, Rounding};
pub use photon_formats::{PHOTON_FORMATS, UnknownFormat, find_photon_format};
pub use photon_record::{LocalQuery, LocalSums, PhotonBlock, PhotonRecord};
pub use pins::{CONTROL_REGISTERS, Pin, Pins, SignalPlace};
pub use register::{REGISTERS, Register, RegisterRow};
pub use schedule::{
    Content, ScheduleError, ScheduleReport, UnitUse, check_schedule, check_streams, schedule_report,
};
pub use spatial::{
    Cut, Cuts, ENGINE_REGISTERS, EngineKind, EngineRegister, EngineRow, EngineUnits, FlowRow,
    HeadRegister, HeadSizes, Instances, MemoryRegister, Radius, Spatial, SpatialError,
    SpatialWidths,
};
pub use stream::{Group, Inputs, Lane, Outputs, Photon, Query, Sums};
