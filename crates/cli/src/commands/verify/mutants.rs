//! The method `mutants`: mutants of a machine's emitted Verilog are killed, equivalent or survive.

use anyhow::{Result, bail};
use clap::Args;
use photoncube_spec::Machine;
use photoncube_testbench::{
    DeviceKind, Fate, MutantOptions, MutantPart, MutantReport, Tool, comparison_controls, mutants,
    record_mutant,
};
use serde_json::json;

use super::method::Method;
use super::options::StimulusArgs;
use super::outcome::{Outcome, equal};
use super::waves::WavesArgs;
use crate::args::count;
use crate::machines::MachineArgs;
use crate::progress;
use crate::table::{grouped, markdown};
use crate::verified::Line;

/// The iterations for each mutant before proofs are tried.
const ITERATIONS: u64 = 3_000;

/// See [`Method::ABOUT`].
#[derive(Args, Debug)]
pub struct Mutants {
    /// About how many mutants
    #[arg(value_name = "N", value_parser = count(1..=(1_u64 << 15) - 1))]
    mutants: u64,
    #[command(flatten)]
    machine: MachineArgs,
    /// Only that part of the machine, for itself: memory, whose --iterations are clocks
    #[arg(long, value_name = "NAME")]
    part: Option<String>,
    #[command(flatten)]
    stimulus: StimulusArgs,
    /// Only mutant K of the list, to record it with --waves
    #[arg(long, value_name = "K", requires = "waves")]
    mutant: Option<u64>,
    #[command(flatten)]
    waves: WavesArgs,
}

impl Method for Mutants {
    const NAME: &'static str = "mutants";
    const ABOUT: &'static str = "Plant about N mutations in the emitted Verilog, one at a time, and see whether the stimulus \
        finds each; a mutant that is not found in --iterations must be proven equivalent";
    const EXAMPLES: &'static [&'static str] = &[
        "photoncube verify mutants 700 --machine overlap",
        "photoncube verify mutants 100 --machine paper --mutant 7 --waves mutant.vcd",
    ];

    fn check(&self) -> Result<()> {
        if self.mutant.is_none() && self.waves.clocks().is_some() {
            bail!("--waves: found no --mutant, expected the number of the mutant that is recorded");
        }
        Ok(())
    }

    fn tools(&self) -> Vec<Tool> {
        [&[Tool::Yosys], DeviceKind::Verilator.tools()].concat()
    }

    fn run(&self) -> Result<Outcome> {
        let machine = self.machine.find_to_emit()?;
        let options = MutantOptions {
            part: part(machine, self.part.as_deref())?,
            mutants: self.mutants,
            seed: self.stimulus.seed.seed,
            iterations: ITERATIONS,
            more_iterations: self.stimulus.iterations,
        };
        if let Some(mutant) = self.mutant {
            return self.record(machine, &options, mutant);
        }
        let bar = progress::bar("mutants", self.mutants);
        let report = equal(mutants(machine, &options, &|done| bar.set_position(done)))?;
        bar.finish_and_clear();
        let controls = comparison_controls([DeviceKind::Verilator])?.with(report.controls.clone());
        let header = ["module", "killed", "equivalent", "survived"];
        let columns = "mutant module fate reason mutation";
        let counts = format!(
            "{}: {} mutants, {} vectors compared",
            report.machine,
            report.mutants.len(),
            grouped(report.vectors_compared)
        );
        let survived = report.count(Fate::Survived);
        let finding = format!(
            "{survived} mutants survived: the stimulus has a hole where none is equivalent"
        );
        Ok(Outcome::new::<Self>(controls, &report)?
            .table(&markdown(&header, &fates(&report)))
            .rows_where("mutants", columns, |mutant| mutant["fate"] != "killed")
            .note(counts)
            .lines([self.line(&report)?])
            .findings((survived > 0).then_some(finding)))
    }
}

impl Mutants {
    /// Records one of the mutants and says whether the stimulus finds it.
    fn record(&self, machine: &Machine, options: &MutantOptions, mutant: u64) -> Result<Outcome> {
        self.waves.check(&[])?;
        let clocks = self.waves.clocks().unwrap_or_default();
        let Some(recorded) = equal(record_mutant(machine, options, mutant, clocks))? else {
            bail!(
                "--mutant: found {mutant}, which none of these mutants is; `photoncube verify mutants {}` with the same \
                   options and --json lists their numbers",
                self.mutants
            );
        };
        let written = self.waves.write(Some(&recorded.waves))?;
        let found = match recorded.killed {
            true => "killed",
            false => "not killed by the stimulus: it is equivalent, or it survives",
        };
        let details = json!({
            "machine": machine.name,
            "part": options.part.name(),
            "mutant": mutant,
            "module": recorded.mutation.module,
            "mutation": recorded.mutation.options,
            "killed": recorded.killed,
            "vectors_compared": recorded.vectors_compared,
            "waves": written,
        });
        let line = Line {
            aspect: format!("mutant {mutant}"),
            by: Tool::Verilator.version()?,
            volume: 1,
            unit: "mutants".to_owned(),
            result: found.to_owned(),
            command: format!(
                "{} --mutant {mutant} --waves FILE.vcd",
                self.command(machine.name, options.part.name())
            ),
            ..Line::of_machine(machine.name)?
        };
        let outcome =
            Outcome::new::<Self>(comparison_controls([DeviceKind::Verilator])?, &details)?;
        let outcome = outcome.note(format!(
            "{}: mutant {mutant} is {found}: {}",
            machine.name, recorded.mutation.options
        ));
        Ok(outcome.waves(written.as_ref()).lines([line]))
    }

    /// The command of these mutants.
    fn command(&self, machine: &str, part: &str) -> String {
        let part = match aspect(part) {
            "" => String::new(),
            part => format!(" --part {part}"),
        };
        format!(
            "photoncube verify mutants {} --machine {machine}{part} --iterations {} --seed {}",
            self.mutants, self.stimulus.iterations, self.stimulus.seed.seed
        )
    }

    fn line(&self, report: &MutantReport) -> Result<Line> {
        Ok(Line {
            aspect: aspect(report.part).to_owned(),
            by: report.tool_version.clone(),
            volume: report.mutants.len() as u64,
            unit: "mutants".to_owned(),
            result: format!(
                "{} killed, {} proven equivalent, {} survived",
                report.count(Fate::Killed),
                report.count(Fate::Equivalent),
                report.count(Fate::Survived)
            ),
            command: self.command(report.machine, report.part),
            ..Line::of_machine(report.machine)?
        })
    }
}

/// The part as an aspect of the machine, which the whole machine is not.
fn aspect(part: &str) -> &str {
    match part == MutantPart::Machine.name() {
        true => "",
        false => part,
    }
}

/// The part of that name; the whole machine without a name.
fn part(machine: &Machine, name: Option<&str>) -> Result<MutantPart> {
    let parts = MutantPart::of(machine);
    let named = |part: &&MutantPart| name.is_none_or(|name| part.name() == name);
    match parts.iter().find(named) {
        Some(part) => Ok(*part),
        None => bail!(
            "--part: machine `{}` has no part `{}` that is mutated for itself; it has: {}",
            machine.name,
            name.unwrap_or_default(),
            parts
                .iter()
                .map(|part| part.name())
                .collect::<Vec<_>>()
                .join(", ")
        ),
    }
}

/// The number of mutants of each fate, by module and in all.
fn fates(report: &MutantReport) -> Vec<Vec<String>> {
    let row = |(module, counts): (&str, [usize; 3])| {
        let mut row = vec![module.to_owned()];
        row.extend(counts.map(|count| count.to_string()));
        row
    };
    let fates = [Fate::Killed, Fate::Equivalent, Fate::Survived];
    let all = row(("all", fates.map(|fate| report.count(fate))));
    report.counts().into_iter().map(row).chain([all]).collect()
}
