//! The specification of the machines as data: formats, ops, control words, microprograms, topology, streams
//! and the named machines.
//!
//! The golden model and the HDL both read this crate, and neither reads the other. The crate describes
//! meaning in prose and formulas and computes nothing on photon values. The difference `a - b` of two
//! coordinates, for example, is written once in `photoncube-model` and once in `photoncube-hdl`, so the
//! comparison of the two is a real check.
//!
//! ```
//! use photoncube_spec::{Microprogram, check_schedule, find_machine};
//!
//! let machine = find_machine("paper")?;
//! assert_eq!(machine.hypercube().nodes(), 16);
//!
//! // The paper's program takes a group of 4 photons every 9 clocks.
//! let program = Microprogram::all_reduce(machine.hypercube());
//! check_schedule(&program, machine.hypercube())?;
//! assert_eq!(program.initiation_interval(), 9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod cell;
mod core;
mod custom;
mod formats;
mod hypercube;
mod interface;
mod leaf;
mod machine;
mod machines;
mod nearest;
mod organisation;
mod pace;
mod pins;
mod sequential;
mod spatial;
mod stream;

pub mod overlap;

pub use crate::core::{
    Access, Beat, CORES, Core, CoreAnswer, CoreCounter, CoreError, CoreEvent, CoreField,
    CoreInputs, CoreOutputs, CorePins, CoreRegister, CoreRegisterRow, CoreStreams, CoreWords,
    CounterRow, EventRow, LiteAnswer, LiteIn, QueryResult, QueryRounds, RECORDED_CORES, ResultWord,
    Rounds, Serial, SerialFault, SerialFaultRow, SerialKind, SerialRow, SerialSizes, StreamField,
    StreamIn, StreamRow, StreamWord, port_columns,
};
pub use cell::{
    CellTables, ControlWord, Field, FieldRow, OVERLAPPED, Op, OpRow, POWER_WORDS, Place, Read,
    Register, RegisterRow, SEQUENTIAL, ScheduleError, ScheduledStep, Step, Stream, Unit, UnitUse,
    unit_utilisation,
};
pub use custom::{CustomError, CustomOrganisation, Pipeline, custom_machine};
pub use formats::{
    Channels, Exponent, FormatError, Numbers, PHOTON_FORMATS, PhotonBlock, PhotonFormat,
    PhotonRecord, PlainFormat, PowerFormat, Rounding, Squarer, UnknownFormat, Widths,
    find_photon_format,
};
pub use hypercube::{Axis, Hypercube, Role};
pub use interface::{Direction, Fact, Interface, Limitation, Port};
pub use leaf::{Leaf, LeafRegister, LeafRow, LeafSizes, QueryWord};
pub use machine::{Machine, module_prefix};
pub use machines::{MACHINES, UnknownMachine, find_machine, parts_of_core};
pub use nearest::{did_you_mean, nearest};
pub use organisation::{Organisation, Rate};
pub use pace::{Pace, SharedGroups};
pub use pins::{Pin, Pins, SignalPlace};
pub use sequential::{
    Content, Contents, ListingError, MOST_OWN_STEPS, Microprogram, OwnProgram, ScheduleReport,
    Unreadable, check_schedule, check_streams, encode, parse_listing, schedule_report,
};
pub use spatial::{
    Cut, Cuts, ENGINE_REGISTERS, EngineKind, EngineRegister, EngineRow, EngineUnits, FlowRow,
    HeadRegister, HeadSizes, Instances, MemoryRegister, Radius, Spatial, SpatialError,
};
pub use stream::{BatchPins, Group, Inputs, Lane, LeafEvents, Outputs, Photon, Query, Sums};
