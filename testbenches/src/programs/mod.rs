//! Random microprograms, drawn from the op table, each in a machine of its own.
//!
//! A program is a function of the machine and a seed, so that each can be reproduced. The results of programs
//! that the schedule checker accepts are compared with the direct gather. The other programs are random steps
//! that take queries and groups as the stream rules require, whatever they compute.

mod draw;
mod shrink;
mod walk;

use std::collections::HashSet;
use std::fmt;

use photoncube_hdl::{Level, emit, most_steps};
use photoncube_spec::{MACHINES, Machine, Microprogram, OwnProgram};
use rayon::prelude::*;
use serde::Serialize;

use crate::compare::Divergence;
use crate::controls::{Control, plant};
use crate::device::{Device, DeviceError, DeviceKind, hdl_error};
use crate::levels::verify_part_device;
use crate::stimulus::{Source, chunk_seed};
use crate::verify::{VerifyError, VerifyOptions, nothing_compared, verify_device};

pub use draw::{DrawnProgram, ProgramClass, draw_program};

/// The number of programs, and the stimulus of each.
#[derive(Copy, Clone, Debug)]
pub struct ProgramOptions {
    /// The number of programs.
    pub programs: u64,
    /// The seed of the programs and of the stimulus.
    pub seed: u64,
    /// The iterations of the whole machine for each program, at most [`MOST_PROGRAM_ITERATIONS`].
    pub iterations: u64,
}

/// The number of clocks of one cell for each program, which are many passes through any program.
const CELL_CLOCKS: usize = 400;

/// The most iterations of a program. More would begin a new chunk of stimulus, which assumes that a query
/// sets every register.
pub const MOST_PROGRAM_ITERATIONS: u64 = 4096;

/// A record of a verification of programs in which all values were equal.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ProgramVerdict {
    /// The machine whose cells and network ran the programs.
    pub machine: &'static str,
    /// The name of the device.
    pub device: String,
    /// The tool behind the device, with its version.
    pub tool_version: String,
    /// The seed of the programs and of the stimulus.
    pub seed: u64,
    /// The number of programs, all different.
    pub programs: usize,
    /// The number of programs that compute a gather.
    pub gather_programs: usize,
    /// The number of programs drawn. It includes repeated programs and programs that would lose a query or
    /// not end it.
    pub drawn: u64,
    /// The number of steps of all programs.
    #[serde(rename = "program_steps")]
    pub steps: u64,
    /// The number of clocks of one cell. Every register was compared in each.
    pub cell_vectors: u64,
    /// The number of clocks of the whole machine. Every register was compared in each.
    pub vectors_compared: u64,
    /// The number of results of gathers. Each was also compared with the direct gather.
    pub results_compared: u64,
}

/// A program on which the Verilog differs from the model, reduced as far as possible.
#[derive(Clone, Debug)]
pub struct ProgramFailure {
    /// The shortest program that still fails: it succeeds without any one or two of its steps, and with any
    /// step made simpler.
    pub program: Microprogram,
    /// The number of iterations in which the program still fails. In half as many it does not.
    pub iterations: u64,
    /// The program that was drawn.
    pub drawn: DrawnProgram,
    /// The difference of the shortest program.
    pub divergence: Divergence,
}

impl fmt::Display for ProgramFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{}\nthe shortest program that does so, of {} steps, in {} iterations:\n{}it was made of \
             that of seed {}, of {} steps:\n{}",
            self.divergence,
            self.program.steps().len(),
            self.iterations,
            self.program,
            self.drawn.seed,
            self.drawn.program.steps().len(),
            self.drawn.program
        )
    }
}

/// The reason why a verification of programs failed.
#[derive(Debug, thiserror::Error)]
pub enum ProgramsError {
    /// A program on which the device differs from the model.
    #[error("{0}")]
    Failed(Box<ProgramFailure>),
    /// The device or the stimulus fails.
    #[error(transparent)]
    Verify(#[from] VerifyError),
    /// The machine runs no microprogram of one op a clock, or is a custom machine, of which only its own program is
    /// compiled.
    #[error(
        "machine `{0}` is not built with other programs: expected a named machine that runs one op a clock, such as \
         paper or paper-5d; `photoncube list` says which do"
    )]
    NoProgram(&'static str),
}

/// Opens a device with a machine, or its cell, in it.
pub type Open<'a> = dyn Fn(&Machine, Level) -> Result<Box<dyn Device>, DeviceError> + Sync + 'a;

/// Draws programs and compares each in one cell and in the whole machine. Calls `progress` for each.
///
/// # Errors
/// A program on which the device differs, as short as possible; or the device or the stimulus fails.
///
/// # Panics
/// Where more than [`MOST_PROGRAM_ITERATIONS`] are requested.
pub fn verify_programs(
    machine: &Machine,
    options: &ProgramOptions,
    open: &Open<'_>,
    progress: &(dyn Fn() + Sync),
) -> Result<ProgramVerdict, ProgramsError> {
    assert!(options.iterations <= MOST_PROGRAM_ITERATIONS);
    if most_steps(machine) == 0 {
        return Err(ProgramsError::NoProgram(machine.name));
    }
    if options.programs == 0 {
        return Err(nothing_compared("random programs", 0, 0, 0).into());
    }
    let (programs, drawn) = different(machine, options);
    let verdicts = programs.par_iter().map(|drawn| {
        let verdict = one(machine, drawn, options.iterations, open);
        progress();
        verdict.map_err(|error| shrunk(machine, drawn, options.iterations, open, error))
    });
    let verdicts = verdicts.collect::<Result<Vec<One>, _>>()?;
    let first = verdicts.first().cloned().unwrap_or_default();
    let gathers = programs.iter().filter(|p| p.class == ProgramClass::Gather);
    Ok(ProgramVerdict {
        machine: machine.name,
        device: first.device,
        tool_version: first.tool_version,
        seed: options.seed,
        programs: programs.len(),
        gather_programs: gathers.count(),
        drawn,
        steps: programs.iter().map(DrawnProgram::steps).sum(),
        cell_vectors: verdicts.iter().map(|one| one.cell_vectors).sum(),
        vectors_compared: verdicts.iter().map(|one| one.vectors).sum(),
        results_compared: verdicts.iter().map(|one| one.results).sum(),
    })
}

/// Draws `options.programs` different programs, each from a seed of its own. Also returns the number of
/// draws.
fn different(machine: &Machine, options: &ProgramOptions) -> (Vec<DrawnProgram>, u64) {
    let mut seen = HashSet::new();
    let (mut programs, mut drawn, mut number) = (Vec::new(), 0, 0);
    while (programs.len() as u64) < options.programs {
        let program = draw_program(machine, chunk_seed(options.seed, number));
        drawn += program.drawn;
        number += 1;
        if seen.insert((program.program.query_clocks(), program.program.steps())) {
            programs.push(program);
        }
    }
    (programs, drawn)
}

/// A record of the comparison of one program.
#[derive(Clone, Default)]
struct One {
    device: String,
    tool_version: String,
    cell_vectors: u64,
    vectors: u64,
    results: u64,
}

/// The machine with another program.
///
/// # Panics
/// Where the program is longer than [`photoncube_spec::MOST_OWN_STEPS`].
pub fn programmed(machine: &Machine, program: &Microprogram) -> Machine {
    machine.with_program(OwnProgram::new(program).expect("programs are drawn short enough"))
}

/// Compares one program, with the stimulus of its seed.
fn one(
    machine: &Machine,
    drawn: &DrawnProgram,
    iterations: u64,
    open: &Open<'_>,
) -> Result<One, VerifyError> {
    let machine = programmed(machine, &drawn.program);
    let seed = drawn.seed;
    let mut cell = open(&machine, Level::Cell)?;
    let cell = verify_part_device(&machine, Level::Cell, cell.as_mut(), CELL_CLOCKS, seed)?;
    let options = VerifyOptions {
        iterations,
        seed,
        source: Source::Random,
    };
    let mut device = open(&machine, Level::Machine)?;
    let verdict = verify_device(&machine, device.as_mut(), &options, &|_| ())?;
    let results = match drawn.class {
        ProgramClass::Gather => verdict.results_compared,
        ProgramClass::Free => 0,
    };
    Ok(One {
        device: verdict.device,
        tool_version: verdict.tool_version,
        cell_vectors: cell.vectors_compared,
        vectors: verdict.vectors_compared,
        results,
    })
}

/// The programs of which one at least must show the planted fault; most do.
const CONTROL_PROGRAMS: u64 = 8;
/// The iterations of each of these programs.
const CONTROL_ITERATIONS: u64 = 50;

/// Plants an adder that loses its carries under random programs, in the built-in evaluator.
///
/// # Errors
/// The evaluator does not run.
pub fn program_control() -> Result<Control, VerifyError> {
    let machine = &MACHINES[0];
    let open = |machine: &Machine, level| {
        let mut design = emit(machine, level).map_err(hdl_error(machine))?;
        let module = format!("{}_add_unit", design.top);
        design.text = plant(&design.text, &module, "a + b", "a ^ b")?;
        DeviceKind::Text.open_text(&design)
    };
    let mut control = Control {
        planted: format!("{}: the adder loses its carries", machine.name),
        found: false,
    };
    for seed in 0..CONTROL_PROGRAMS {
        let drawn = draw_program(machine, seed);
        let ended = one(machine, &drawn, CONTROL_ITERATIONS, &open);
        control = Control::of(control.planted, ended)?;
        if control.found {
            break;
        }
    }
    Ok(control)
}

/// If the error is a difference: the failure of the shortest program that fails, with the least stimulus.
fn shrunk(
    machine: &Machine,
    drawn: &DrawnProgram,
    iterations: u64,
    open: &Open<'_>,
    error: VerifyError,
) -> ProgramsError {
    let VerifyError::Diverged(divergence) = error else {
        return error.into();
    };
    match shortest(machine, drawn, iterations, open, *divergence) {
        Ok(failure) => ProgramsError::Failed(Box::new(failure)),
        Err(error) => error.into(),
    }
}

fn shortest(
    machine: &Machine,
    drawn: &DrawnProgram,
    mut iterations: u64,
    open: &Open<'_>,
    mut divergence: Divergence,
) -> Result<ProgramFailure, VerifyError> {
    let mut differs = |program: &Microprogram, iterations| {
        let tried = DrawnProgram {
            program: program.clone(),
            ..drawn.clone()
        };
        match one(machine, &tried, iterations, open) {
            Ok(_) => Ok(false),
            Err(VerifyError::Diverged(found)) => {
                divergence = *found;
                Ok(true)
            }
            Err(other) => Err(other),
        }
    };
    let cube = machine.hypercube();
    let program = shrink::shrink(&drawn.program, cube, &mut |program| {
        differs(program, iterations)
    })?;
    while iterations > 1 && differs(&program, iterations / 2)? {
        iterations /= 2;
    }
    // A run with the program's seed begins with this program.
    divergence.repeat = format!(
        "photoncube verify programs 1 --machine {} --against {} --seed {}",
        machine.name, divergence.device, drawn.seed
    );
    Ok(ProgramFailure {
        program,
        iterations,
        drawn: drawn.clone(),
        divergence,
    })
}
