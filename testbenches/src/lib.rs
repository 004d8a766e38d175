//! Verification of the HDL against the golden model: stimulus, runners and comparison.
//!
//! Every verification replays a trace, in *rows* of [`photoncube_spec::Pins`]. The golden model runs on
//! random queries or on those of a scene and decides every handshake. Its input rows are replayed into a
//! [`Device`]. Every signal that the device shows must have the model's value, in every clock. [`verify`]
//! does all of this. It fails on the first difference and describes it, and it fails if it has compared
//! nothing.
//!
//! ```
//! use photoncube_spec::find_machine;
//! use photoncube_testbench::{DeviceKind, Source, VerifyOptions, verify};
//!
//! let options = VerifyOptions { iterations: 100, seed: 1, source: Source::Random };
//! // `Text` runs the emitted Verilog in an evaluator of our own, and needs no tool.
//! let verdict = verify(find_machine("paper")?, DeviceKind::Text, &options, &|_| ())?;
//! assert!(verdict.registers_compared && verdict.vectors_compared >= 900);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod board;
mod campaign;
mod compare;
mod controls;
mod core;
mod coverage;
mod device;
mod exhaustive;
mod faults;
mod formal;
mod levels;
mod mutants;
mod programs;
mod setup;
mod squares;
mod stimulus;
mod tools;
mod trace;
mod verify;
mod waves;

pub use crate::core::{
    CoreError, CoreOptions, CoreVerdict, core_controls, verify_core, verify_core_recorded,
};
pub use board::{BoardError, BoardVerdict, Scenario, board_controls, verify_board};
pub use campaign::{
    Done, Failure, Keeper, NumberedJob, Pair, Regression, RegressionError, State, StateError,
    Summary, campaign, minimised, pairs,
};
pub use compare::{Activity, Actual, Divergence};
pub use controls::{
    Control, Controls, NoControl, PlantedFault, comparison_controls, plant,
    program_comparison_controls,
};
pub use coverage::{Coverage, CoverageKind, Gap, ModuleCoverage, Share, corners, coverage};
pub use device::{
    BoardSimulation, CoreSimulation, Device, DeviceError, DeviceKind, Icarus, Mutant, Observed,
    RustHdl, Symbol, Text, Unknown, UnknownDevice, Verilator, netlist, with_outputs_alone,
};
pub use exhaustive::{
    LaneVerdict, Radii, UnitVerdict, exhaustive_controls, exhaustive_lane, exhaustive_lane_device,
    exhaustive_unit, exhaustive_unit_device,
};
pub use faults::{
    FaultClass, FaultOfClass, FaultVerdict, PLANTED_FAULTS, UnknownDifference, fault_controls,
    verify_fault, verify_fault_text, without_initial_values,
};
pub use formal::{Formal, FormalError, Proof, formal};
pub use levels::{PartVerdict, verify_part, verify_part_device};
pub use mutants::{
    Fate, Judged, MutantOptions, MutantPart, MutantReport, Mutation, RecordedMutant,
    is_equal_alone, mutants, record_mutant,
};
pub use programs::{
    DrawnProgram, MOST_PROGRAM_ITERATIONS, Open, ProgramClass, ProgramFailure, ProgramOptions,
    ProgramVerdict, ProgramsError, draw_program, program_control, programmed, verify_programs,
};
pub use setup::{pinned_tools, setup_script};
pub use stimulus::{Block, Pressure, Protocol, Source, StimulusError, chunk_seed, generate};
pub use tools::{MissingTool, Tool, ToolError};
pub use verify::{Verdict, VerifyError, VerifyOptions, verify, verify_device, verify_recorded};
pub use waves::{NS_PER_CLOCK, Recorder, WaveFiles, Waves};
