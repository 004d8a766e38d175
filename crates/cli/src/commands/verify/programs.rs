//! The method `programs`: random microprograms in a machine.

use anyhow::{Result, bail};
use clap::Args;
use photoncube_testbench::{
    Controls, ProgramOptions, ProgramVerdict, ProgramsError, Tool, program_control, verify_programs,
};
use serde_json::json;

use super::method::Method;
use super::options::{AGAINST, Devices, SeedArgs, devices, tools};
use super::outcome::Outcome;
use crate::args::count;
use crate::failure::CheckFailed;
use crate::machines::MachineArgs;
use crate::progress;
use crate::table::grouped;
use crate::verified::Line;

/// The iterations of the whole machine for each program.
const ITERATIONS: u64 = 100;

/// The columns of the table.
const COLUMNS: &str = "device programs gather_programs drawn program_steps cell_vectors vectors_compared results_compared tool_version";

/// See [`Method::ABOUT`].
#[derive(Args, Debug)]
pub struct Programs {
    /// How many programs
    #[arg(value_name = "N", value_parser = count(1..=(1_u64 << 20) - 1))]
    programs: u64,
    #[command(flatten)]
    machine: MachineArgs,
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "text", help = AGAINST)]
    against: Vec<Devices>,
    #[command(flatten)]
    seed: SeedArgs,
}

impl Method for Programs {
    const NAME: &'static str = "programs";
    const ABOUT: &'static str = "Draw N different microprograms, gathers and any others that end, and compare each in one \
        cell and in the machine; one that differs is made as short as it can be";
    const EXAMPLES: &'static [&'static str] =
        &["photoncube verify programs 1000 --machine paper-5d --against text"];

    fn tools(&self) -> Vec<Tool> {
        tools(&self.against)
    }

    fn run(&self) -> Result<Outcome> {
        let machine = self.machine.find_to_emit()?;
        let controls = Controls::new(program_control()?, []);
        let options = ProgramOptions {
            programs: self.programs,
            seed: self.seed.seed,
            iterations: ITERATIONS,
        };
        let mut verdicts = Vec::new();
        for device in devices(&self.against) {
            let bar = progress::bar(device.name(), self.programs);
            let open = |machine: &_, level| device.open(machine, level);
            let verdict = verify_programs(machine, &options, &open, &|| bar.inc(1));
            bar.finish_and_clear();
            match verdict {
                Ok(verdict) => verdicts.push(verdict),
                Err(ProgramsError::Failed(failure)) => bail!(CheckFailed(failure.to_string())),
                Err(error) => return Err(error.into()),
            }
        }
        let lines: Vec<_> = verdicts.iter().map(line).collect::<Result<_>>()?;
        let details = json!({ "verdicts": verdicts });
        Ok(Outcome::new::<Self>(controls, &details)?
            .rows("verdicts", COLUMNS)
            .lines(lines))
    }
}

fn line(verdict: &ProgramVerdict) -> Result<Line> {
    let vectors = verdict.cell_vectors + verdict.vectors_compared;
    Ok(Line {
        by: format!("{}: {}", verdict.device, verdict.tool_version),
        volume: verdict.programs as u64,
        unit: "programs, each in one cell and in all".to_owned(),
        result: format!(
            "equal in {} vectors; {} programs are gathers",
            grouped(vectors),
            verdict.gather_programs
        ),
        command: format!(
            "photoncube verify programs {} --machine {} --against {} --seed {}",
            verdict.programs, verdict.machine, verdict.device, verdict.seed
        ),
        ..Line::of_machine(verdict.machine)?
    })
}
