//! Random microprograms, drawn from the op table, each in a machine of its own.
//!
//! A program is a function of the machine and a seed, so that any can be had again. Those that the schedule checker
//! accepts compute a gather, and their results are held against the direct one; the others are any steps that take
//! queries and groups as streams ask for, whatever they compute.

mod draw;
mod shrink;
mod walk;

use std::collections::HashSet;
use std::fmt;

use photoncube_hdl::{Level, most_steps};
use photoncube_spec::{Machine, Microprogram, Organisation, OwnProgram};
use rayon::prelude::*;
use serde::Serialize;

use crate::compare::Divergence;
use crate::device::{Device, DeviceError};
use crate::levels::verify_part_device;
use crate::stimulus::{Source, chunk_seed};
use crate::verify::{VerifyError, VerifyOptions, nothing_compared, verify_device};

pub use draw::{DrawnProgram, ProgramClass, draw_program};

/// How many programs are drawn, and what each is run on.
#[derive(Copy, Clone, Debug)]
pub struct ProgramOptions {
    /// Programs.
    pub programs: u64,
    /// The seed of the programs and of the stimulus.
    pub seed: u64,
    /// Iterations of the whole machine for each program, at most [`MOST_PROGRAM_ITERATIONS`].
    pub iterations: u64,
}

/// Clocks of one cell for each program: many passes through any of them.
const CELL_CLOCKS: usize = 400;

/// More iterations of a program would begin a chunk of stimulus anew, which supposes that a query sets every register.
pub const MOST_PROGRAM_ITERATIONS: u64 = 4096;

/// What was compared and found equal.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ProgramVerdict {
    /// The machine whose cells and network ran the programs.
    pub machine: &'static str,
    /// The device.
    pub device: String,
    /// The tool behind it, with its version.
    pub tool_version: String,
    /// The seed.
    pub seed: u64,
    /// Programs, all different.
    pub programs: usize,
    /// Those of them that compute a gather.
    pub gather_programs: usize,
    /// Programs drawn for them; of the others some were drawn before, and some would lose a query or not end it.
    pub drawn: u64,
    /// Steps of all programs.
    #[serde(rename = "program_steps")]
    pub steps: u64,
    /// Clocks of one cell, in each of which every register was compared.
    pub cell_vectors: u64,
    /// Clocks of the whole machine, in each of which every register was compared.
    pub vectors_compared: u64,
    /// Results of gathers, each also held against the direct one.
    pub results_compared: u64,
}

/// A program whose Verilog is not what the model does, made as short as it can be.
#[derive(Clone, Debug)]
pub struct ProgramFailure {
    /// The shortest program that still fails: no step and no two can be left out, none made simpler.
    pub program: Microprogram,
    /// Iterations that it still fails in; it does not in half as many.
    pub iterations: u64,
    /// The one that was drawn.
    pub drawn: DrawnProgram,
    /// How the shortest one differs.
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

/// Why programs were not all found right.
#[derive(Debug, thiserror::Error)]
pub enum ProgramsError {
    /// One differs.
    #[error("{0}")]
    Failed(Box<ProgramFailure>),
    /// No verdict was reached.
    #[error(transparent)]
    Verify(#[from] VerifyError),
    /// Only machines that run one op a clock have programs to draw.
    #[error(
        "machine `{0}` runs no microprogram of one op a clock; `photoncube list` says which do: \
         paper and paper-5d, for example"
    )]
    NoProgram(&'static str),
}

/// Opens a device with a machine, or its cell, in it.
pub type Open<'a> = dyn Fn(&Machine, Level) -> Result<Box<dyn Device>, DeviceError> + Sync + 'a;

/// Draws programs and compares each in one cell and in the whole machine; `progress` is told of each.
///
/// # Errors
/// A program that differs, as short as it can be; or no verdict at all.
///
/// # Panics
/// With more than [`MOST_PROGRAM_ITERATIONS`].
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

/// So many programs, no two the same, each by a seed of its own, and how many were drawn for them.
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

/// What was compared of one program.
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
/// The program is longer than [`photoncube_spec::MOST_OWN_STEPS`].
pub fn programmed(machine: &Machine, program: &Microprogram) -> Machine {
    let own = OwnProgram::new(program).expect("programs are drawn short enough");
    Machine {
        organisation: Organisation::Programmed(own),
        ..*machine
    }
}

/// One program, with the stimulus of its seed.
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

/// The failure of the shortest program that fails, and of the least stimulus, if a difference it was.
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
    // The program's seed is that of the first program of a run.
    divergence.repeat = format!(
        "photoncube verify --programs 1 --machine {} --against {} --seed {}",
        machine.name, divergence.device, drawn.seed
    );
    Ok(ProgramFailure {
        program,
        iterations,
        drawn: drawn.clone(),
        divergence,
    })
}
