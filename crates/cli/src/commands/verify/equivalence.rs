//! The method `equivalence`: compares a machine with the golden model in every visible signal and every clock.

use anyhow::Result;
use clap::Args;
use photoncube_spec::Machine;
use photoncube_testbench::{
    Controls, DeviceKind, Tool, Verdict, VerifyError, VerifyOptions, comparison_control, verify,
};
use serde::Serialize;

use super::method::Method;
use super::options::{AGAINST, Devices, StimulusArgs, devices, tools};
use super::outcome::{Outcome, compared};
use crate::machines::MachineArgs;
use crate::verified::{Line, grouped};
use crate::{progress, table};

/// See [`Method::ABOUT`].
#[derive(Args, Debug)]
pub struct Equivalence {
    #[command(flatten)]
    machine: MachineArgs,
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "rust-hdl,text", help = AGAINST)]
    against: Vec<Devices>,
    #[command(flatten)]
    stimulus: StimulusArgs,
}

/// The comparisons of a machine, up to the first difference.
#[derive(Serialize)]
struct Comparisons {
    machine: &'static str,
    seed: u64,
    iterations: u64,
    vectors_compared: u64,
    mismatches: u64,
    devices: Vec<Verdict>,
    #[serde(skip)]
    differences: Vec<String>,
}

impl Comparisons {
    /// Adds the verdict of a device, or the difference. Returns whether there was none.
    fn add(&mut self, ended: Result<Verdict, VerifyError>) -> Result<bool> {
        match compared(ended)? {
            Ok(verdict) => {
                self.vectors_compared += verdict.vectors_compared;
                self.devices.push(verdict);
                Ok(true)
            }
            Err(difference) => {
                self.mismatches += 1;
                self.differences.push(difference);
                Ok(false)
            }
        }
    }

    fn line(&self, verdict: &Verdict) -> Line {
        Line {
            by: format!("{}: {}", verdict.device, verdict.tool_version),
            volume: verdict.vectors_compared,
            unit: format!("vectors of {} signals", verdict.signals_per_vector),
            result: format!("{} mismatches", self.mismatches),
            command: format!(
                "photoncube verify equivalence --machine {} --against {} --iterations {} --seed {}",
                self.machine, verdict.device, self.iterations, self.seed
            ),
            ..Line::about(self.machine.to_owned(), verdict.verilog_sha256.clone())
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
    ];

    fn tools(&self) -> Vec<Tool> {
        tools(&self.against)
    }

    fn run(&self) -> Result<Outcome> {
        let machine = self.machine.find()?;
        let mut all = Comparisons {
            machine: machine.name,
            seed: self.stimulus.seed.seed,
            iterations: self.stimulus.iterations,
            vectors_compared: 0,
            mismatches: 0,
            devices: Vec::new(),
            differences: Vec::new(),
        };
        for device in devices(&self.against) {
            if !all.add(verify_with_bar(machine, device, &self.stimulus.random()))? {
                break;
            }
        }
        let controls = Controls::new(comparison_control()?, []);
        Ok(Outcome::new::<Self>(controls, &all)?
            .note(verdict_table(&all.devices))
            .lines(all.devices.iter().map(|verdict| all.line(verdict)))
            .findings(all.differences))
    }
}

/// Verifies with a progress bar.
pub fn verify_with_bar(
    machine: &Machine,
    device: DeviceKind,
    options: &VerifyOptions<'_>,
) -> Result<Verdict, VerifyError> {
    let bar = progress::bar(device.name(), options.iterations);
    let verdict = verify(machine, device, options, &|done| bar.set_position(done));
    bar.finish_and_clear();
    verdict
}

/// A table of the comparisons, for people.
pub fn verdict_table(verdicts: &[Verdict]) -> String {
    let header = [
        "device",
        "iterations",
        "results",
        "vectors",
        "signals each",
        "clocks/s",
        "tool",
    ];
    let row = |verdict: &Verdict| {
        let scope = match verdict.registers_compared {
            true => "all registers",
            false => "outputs only",
        };
        vec![
            verdict.device.clone(),
            verdict.iterations.to_string(),
            verdict.results_compared.to_string(),
            verdict.vectors_compared.to_string(),
            format!("{} ({scope})", verdict.signals_per_vector),
            grouped(verdict.clocks_per_second),
            verdict.tool_version.clone(),
        ]
    };
    table::markdown(&header, &verdicts.iter().map(row).collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
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
        let found = compared(ended).unwrap().unwrap_err();
        assert!(found.contains("node 15, register q"), "{found}");
        assert!(found.contains("repeat    photoncube verify"), "{found}");
    }
}
