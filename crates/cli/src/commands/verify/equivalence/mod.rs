//! The method `equivalence`: compares a machine with the golden model in every visible signal and every clock.

mod case;

use std::path::PathBuf;

use anyhow::Result;
use clap::Args;
use photoncube_spec::Machine;
use photoncube_testbench::{
    Controls, DeviceKind, Tool, Verdict, VerifyError, VerifyOptions, Waves, comparison_controls,
    program_comparison_controls, verify, verify_recorded,
};
use serde_json::json;

use super::method::Method;
use super::options::{AGAINST, Devices, StimulusArgs, devices, tools};
use super::outcome::{Outcome, UpToDifference};
use super::waves::WavesArgs;
use crate::machines::MachineArgs;
use crate::own_program::ProgramArgs;
use crate::verified::Line;
use crate::{progress, table};

/// See [`Method::ABOUT`].
#[derive(Args, Debug)]
pub struct Equivalence {
    #[command(flatten)]
    machine: MachineArgs,
    #[command(flatten)]
    program: ProgramArgs,
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "rust-hdl,text", help = AGAINST)]
    against: Vec<Devices>,
    #[command(flatten)]
    stimulus: StimulusArgs,
    /// Replay a case that `verify campaign` wrote, instead of random stimulus; the case names the machine
    #[arg(long, value_name = "FILE", conflicts_with_all = ["machine", "program", "iterations", "seed"])]
    case: Option<PathBuf>,
    #[command(flatten)]
    waves: WavesArgs,
}

impl Equivalence {
    /// The controls: with a program of the user's, the fault is in the machine that runs it.
    fn controls(&self, machine: &Machine) -> Result<Controls> {
        let devices = devices(&self.against);
        Ok(match self.program.program {
            Some(_) => program_comparison_controls(devices, machine)?,
            None => comparison_controls(devices)?,
        })
    }

    /// The verdict, whose difference names the options that choose the machine. Its name alone does not choose one that
    /// runs a program of the user's.
    fn with_options<V>(
        &self,
        base: &Machine,
        ended: Result<V, VerifyError>,
    ) -> Result<V, VerifyError> {
        ended.map_err(|error| match error {
            VerifyError::Diverged(mut difference) => {
                let named = format!("--machine {}", difference.machine);
                let options = self.program.options(base.name);
                difference.repeat = difference.repeat.replace(&named, &options);
                VerifyError::Diverged(difference)
            }
            other => other,
        })
    }

    fn line(&self, base: &Machine, verdict: &Verdict) -> Line {
        Line {
            by: format!("{}: {}", verdict.device, verdict.tool_version),
            volume: verdict.vectors_compared,
            unit: format!("vectors of {} signals", verdict.signals_per_vector),
            result: "0 mismatches".to_owned(),
            command: format!(
                "photoncube verify equivalence {} --against {} --iterations {} --seed {}",
                self.program.options(base.name),
                verdict.device,
                self.stimulus.iterations,
                self.stimulus.seed.seed
            ),
            ..Line::about(verdict.machine.to_owned(), verdict.verilog_sha256.clone())
        }
    }
}

impl Method for Equivalence {
    const NAME: &'static str = "equivalence";
    const ABOUT: &'static str =
        "Compare a machine with the golden model, bit for bit, every register, every clock";
    const EXAMPLES: &'static [&'static str] = &[
        "photoncube verify equivalence --against icarus,verilator --iterations 2000",
        "photoncube verify --against verilator --iterations 1000000 --json",
        "photoncube verify --machine paper-5d --against all --seed 7",
        "photoncube verify --machine paper-5d --program mine.txt",
        "photoncube verify --against icarus --iterations 50 --waves paper.vcd",
    ];

    fn tools(&self) -> Vec<Tool> {
        tools(&self.against)
    }

    fn run(&self) -> Result<Outcome> {
        self.waves.check(self.case.as_slice())?;
        if let Some(path) = &self.case {
            return case::replay(path, &devices(&self.against), &self.waves);
        }
        let base = self.machine.find()?;
        let machine = self.program.apply(base)?;
        let mut written = None;
        let mut all = UpToDifference::new(|verdict: &Verdict| verdict.vectors_compared);
        for device in devices(&self.against) {
            let (options, clocks) = (self.stimulus.random(), self.waves.clocks());
            let (ended, recorded) = verify_with_bar(machine, device, &options, clocks);
            written = self.waves.write(recorded.as_ref())?;
            if !all.add(device.name(), self.with_options(base, ended))? {
                break;
            }
        }
        let details = json!({
            "machine": machine.name,
            "program": self.program.program.as_ref().map(|path| path.display().to_string()),
            "seed": self.stimulus.seed.seed,
            "iterations": self.stimulus.iterations,
            "vectors_compared": all.vectors_compared,
            "mismatches": all.mismatches(),
            "devices": all.verdicts,
            "waves": written,
        });
        Ok(Outcome::new::<Self>(self.controls(machine)?, &details)?
            .rows("devices", COLUMNS)
            .waves(written.as_ref())
            .lines(all.verdicts.iter().map(|verdict| self.line(base, verdict)))
            .findings(all.difference))
    }
}

/// Verifies with a progress bar. Records the last `clocks` clocks where this is given.
pub fn verify_with_bar(
    machine: &Machine,
    device: DeviceKind,
    options: &VerifyOptions<'_>,
    clocks: Option<usize>,
) -> (Result<Verdict, VerifyError>, Option<Waves>) {
    let bar = progress::bar(device.name(), options.iterations);
    let progress = |done| bar.set_position(done);
    let ended = match clocks {
        None => (verify(machine, device, options, &progress), None),
        Some(clocks) => verify_recorded(machine, device, options, clocks, &progress),
    };
    bar.finish_and_clear();
    ended
}

/// The columns of a table of comparisons.
const COLUMNS: &str = "device iterations results_compared vectors_compared signals_per_vector registers_compared clocks_per_second tool_version";

/// A table of comparisons, for people.
pub fn verdict_table(verdicts: &[Verdict]) -> String {
    let rows = json!(verdicts);
    table::of_rows(rows.as_array().into_iter().flatten(), COLUMNS)
}

#[cfg(test)]
mod tests {
    use clap::FromArgMatches;
    use photoncube_spec::find_machine;
    use photoncube_testbench::{Mutant, Source, verify_device};

    use super::*;

    #[test]
    fn a_divergence_names_the_register_and_the_command_that_repeats_it() {
        let machine = find_machine("paper").unwrap();
        let options = VerifyOptions {
            iterations: 10,
            seed: 1,
            source: Source::Random,
        };
        // A device that is the golden model, except for the first register of the last cell.
        let flip = |_clock, row: &mut [u64]| {
            if let Some(register) = row.iter_mut().rev().nth(5) {
                *register ^= 1;
            }
        };
        let mut mutant = Mutant::sound(machine).with_row_fault(flip);
        let ended = verify_device(machine, &mut mutant, &options, &|_| {});
        let mut all = UpToDifference::new(|verdict: &Verdict| verdict.vectors_compared);
        let line = "photoncube verify equivalence --program own.txt";
        let args = Equivalence::augment_args(clap::Command::new("equivalence"));
        let matches = args.get_matches_from(line.split(' ').skip(2));
        let chosen = Equivalence::from_arg_matches(&matches).unwrap();
        let ended = chosen.with_options(machine, ended);
        assert!(!all.add("mutant", ended).unwrap());
        assert_eq!(all.mismatches(), 1);
        let found = all.difference.unwrap();
        assert!(found.contains("node 15, register q"), "{found}");
        let repeat = "repeat    photoncube verify --machine paper --program own.txt --against";
        assert!(found.contains(repeat), "{found}");
    }
}
