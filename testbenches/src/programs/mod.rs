//! Random microprograms: legal ones, drawn from the op table, each in a machine of its own.

mod draw;
mod shrink;

use std::fmt;

use photoncube_hdl::Level;
use photoncube_spec::{Hypercube, Machine, Microprogram, Organisation, OwnProgram};
use rand::SeedableRng;
use rand_pcg::Pcg64;
use rayon::prelude::*;
use serde::Serialize;

use crate::compare::Divergence;
use crate::device::{Device, DeviceError};
use crate::levels::verify_part_device;
use crate::stimulus::{Source, chunk_seed};
use crate::verify::{VerifyError, VerifyOptions, verify_device};

pub use draw::draw_program;

/// How many programs are drawn, and what each is run on.
#[derive(Copy, Clone, Debug)]
pub struct ProgramOptions {
    /// Legal programs.
    pub programs: u64,
    /// The seed of the programs and of the stimulus.
    pub seed: u64,
    /// Iterations of the whole machine for each program.
    pub iterations: u64,
}

/// Clocks of one cell for each program: some passes through any of them.
const CELL_CLOCKS: usize = 200;

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
    /// Legal programs, all different.
    pub programs: usize,
    /// Programs drawn for them; the others could not be made legal in the clocks that there are.
    pub drawn: u64,
    /// Steps of all programs.
    #[serde(rename = "program_steps")]
    pub steps: u64,
    /// Clocks of one cell, in each of which every register was compared.
    pub cell_vectors: u64,
    /// Clocks of the whole machine, in each of which every register was compared.
    pub vectors_compared: u64,
    /// Results taken, each also held against the direct gather.
    pub results_compared: u64,
}

/// A program whose Verilog is not what the model does, made as short as it can be.
#[derive(Clone, Debug)]
pub struct ProgramFailure {
    /// The shortest program that still fails.
    pub program: Microprogram,
    /// The one that was drawn.
    pub drawn: Microprogram,
    /// How the shortest one differs.
    pub divergence: Divergence,
}

impl fmt::Display for ProgramFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{}\nthe shortest program that does so, of {} steps:\n{}it was made of this one, of {} \
             steps:\n{}",
            self.divergence,
            self.program.steps().len(),
            self.program,
            self.drawn.steps().len(),
            self.drawn
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

/// Draws legal programs and compares each in one cell and in the whole machine; `progress` is told of each.
///
/// # Errors
/// The first program that differs, as short as it can be; or no verdict at all.
pub fn verify_programs(
    machine: &Machine,
    options: &ProgramOptions,
    open: &Open<'_>,
    progress: &(dyn Fn() + Sync),
) -> Result<ProgramVerdict, ProgramsError> {
    if machine.microprogram().is_none() {
        return Err(ProgramsError::NoProgram(machine.name));
    }
    let mut rng = Pcg64::seed_from_u64(options.seed);
    let (programs, drawn) = draw::different(&mut rng, machine.hypercube(), options.programs);
    let numbered: Vec<_> = (0..).zip(&programs).collect();
    let verdicts = numbered.par_iter().map(|&(number, program)| {
        let seed = chunk_seed(options.seed, number);
        let verdict = one(machine, program, seed, options.iterations, open);
        progress();
        verdict.map_err(|error| shrunk(machine, program, seed, options.iterations, open, error))
    });
    let verdicts: Vec<One> = verdicts.collect::<Result<_, ProgramsError>>()?;
    let first = verdicts.first().cloned().unwrap_or_default();
    Ok(ProgramVerdict {
        machine: machine.name,
        device: first.device,
        tool_version: first.tool_version,
        seed: options.seed,
        programs: programs.len(),
        drawn,
        steps: programs.iter().map(|p| p.steps().len() as u64).sum(),
        cell_vectors: verdicts.iter().map(|one| one.cell_vectors).sum(),
        vectors_compared: verdicts.iter().map(|one| one.vectors).sum(),
        results_compared: verdicts.iter().map(|one| one.results).sum(),
    })
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

fn one(
    machine: &Machine,
    program: &Microprogram,
    seed: u64,
    iterations: u64,
    open: &Open<'_>,
) -> Result<One, VerifyError> {
    let machine = programmed(machine, program);
    let mut cell = open(&machine, Level::Cell)?;
    let cell = verify_part_device(&machine, Level::Cell, cell.as_mut(), CELL_CLOCKS, seed)?;
    let options = VerifyOptions {
        iterations,
        seed,
        source: Source::Random,
    };
    let mut device = open(&machine, Level::Machine)?;
    let verdict = verify_device(&machine, device.as_mut(), &options, &|_| ())?;
    Ok(One {
        device: verdict.device,
        tool_version: verdict.tool_version,
        cell_vectors: cell.vectors_compared,
        vectors: verdict.vectors_compared,
        results: verdict.results_compared,
    })
}

/// The failure of the shortest program that fails, if a difference it was.
fn shrunk(
    machine: &Machine,
    program: &Microprogram,
    seed: u64,
    iterations: u64,
    open: &Open<'_>,
    error: VerifyError,
) -> ProgramsError {
    let VerifyError::Diverged(mut divergence) = error else {
        return error.into();
    };
    let cube: Hypercube = machine.hypercube();
    let fails = |program: &Microprogram| match one(machine, program, seed, iterations, open) {
        Err(VerifyError::Diverged(found)) => Some(found),
        _ => None,
    };
    let mut shortest = program.clone();
    while let Some((shorter, found)) = shrink::shorter(&shortest, cube, &fails) {
        (shortest, divergence) = (shorter, found);
    }
    let mut divergence = *divergence;
    divergence.repeat = format!(
        "photoncube verify --programs N --machine {} --against {} with the seed and N of this run",
        machine.name, divergence.device
    );
    ProgramsError::Failed(Box::new(ProgramFailure {
        program: shortest,
        drawn: program.clone(),
        divergence,
    }))
}
