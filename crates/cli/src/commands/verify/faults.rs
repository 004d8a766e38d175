//! The method `faults`: external faults by class: waiting streams, resets, unknown words, power-up.

use anyhow::Result;
use clap::Args;
use photoncube_testbench::{
    Controls, DeviceKind, FaultClass, FaultVerdict, Tool, fault_controls, verify_fault,
};
use serde_json::json;

use super::method::Method;
use super::options::{AGAINST, Devices, SeedArgs, devices, tools};
use super::outcome::{Outcome, UpToDifference};
use crate::machines::MachineArgs;
use crate::progress;
use crate::table::grouped;
use crate::verified::Line;

/// See [`Method::ABOUT`].
#[derive(Args, Debug)]
pub struct Faults {
    #[command(flatten)]
    machine: MachineArgs,
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "fastest", help = AGAINST)]
    against: Vec<Devices>,
    #[command(flatten)]
    seed: SeedArgs,
}

/// The columns of the table.
const COLUMNS: &str =
    "fault injections injected results_compared vectors_compared signals_per_vector device";

/// The difference; without one, each class that is missing or whose fault never occurred.
fn findings(all: &UpToDifference<FaultVerdict>) -> Vec<String> {
    if let Some(difference) = &all.difference {
        return vec![difference.clone()];
    }
    let is_done = |class: &FaultClass| {
        let mut of_class = all.verdicts.iter().filter(|f| f.fault == class.name());
        of_class.any(|fault| fault.injections > 0 && fault.vectors_compared > 0)
    };
    let missing = FaultClass::ALL.iter().filter(|class| !is_done(class));
    missing
        .map(|class| format!("nothing was done of: {}", class.name()))
        .collect()
}

impl Faults {
    fn line(&self, verdict: &FaultVerdict, about: &Line) -> Line {
        let mut four_state = FaultClass::ALL.iter().filter(|class| class.is_four_state());
        let against = match four_state.any(|class| class.name() == verdict.fault) {
            true => String::new(),
            false => format!(" --against {}", verdict.device),
        };
        Line {
            aspect: verdict.fault.to_owned(),
            by: format!("{}: {}", verdict.device, verdict.tool_version),
            volume: verdict.vectors_compared,
            unit: format!("vectors of {} signals", verdict.signals_per_vector),
            result: format!(
                "0 mismatches; {} {}",
                grouped(verdict.injections),
                verdict.injected
            ),
            command: format!(
                "photoncube verify faults --machine {}{against} --seed {}",
                verdict.machine, self.seed.seed
            ),
            ..about.clone()
        }
    }
}

impl Method for Faults {
    const NAME: &'static str = "faults";
    const ABOUT: &'static str = "Apply faults from outside, by class: streams that wait at random, long and in patterns, a \
        reset in every clock of a query; and in Icarus, whatever --against says, unknown words on idle pins and power-up \
        without reset";
    const EXAMPLES: &'static [&'static str] = &["photoncube verify faults --machine overlap"];

    fn tools(&self) -> Vec<Tool> {
        [tools(&self.against), DeviceKind::Icarus.tools().to_vec()].concat()
    }

    /// Verifies the machine under each class: in each device, or in Icarus where only that can show the fault.
    fn run(&self) -> Result<Outcome> {
        let machine = self.machine.find_to_emit()?;
        let controls = Controls::gathered(fault_controls()?)?;
        let kinds = devices(&self.against);
        let mut all = UpToDifference::new(|verdict: &FaultVerdict| verdict.vectors_compared);
        let of_class = |&class: &FaultClass| match class.is_four_state() {
            true => vec![(class, DeviceKind::Icarus)],
            false => kinds.iter().map(|&kind| (class, kind)).collect(),
        };
        let jobs: Vec<_> = FaultClass::ALL.iter().flat_map(of_class).collect();
        let bar = progress::bar("faults", jobs.len() as u64);
        for (class, kind) in jobs {
            let ended = verify_fault(machine, class, kind, self.seed.seed);
            if !all.add(class.name(), ended)? {
                break;
            }
            bar.inc(1);
        }
        bar.finish_and_clear();
        let about = Line::of_machine(machine.name)?;
        let details = json!({
            "machine": machine.name,
            "seed": self.seed.seed,
            "vectors_compared": all.vectors_compared,
            "mismatches": all.mismatches(),
            "faults": all.verdicts,
        });
        let outcome = Outcome::new::<Self>(controls, &details)?
            .rows("faults", COLUMNS)
            .lines(
                all.verdicts
                    .iter()
                    .map(|verdict| self.line(verdict, &about)),
            )
            .findings(findings(&all));
        let known = all.verdicts.iter().filter_map(known_after_reset);
        Ok(known.fold(outcome, |outcome, known| outcome.note(known)))
    }
}

fn known_after_reset(verdict: &FaultVerdict) -> Option<String> {
    let known = &verdict.known_after_reset;
    (!known.is_empty()).then(|| {
        format!(
            "known a clock after the reset, by it or from the pins: {}",
            known.join(", ")
        )
    })
}

#[cfg(test)]
mod tests {
    use photoncube_testbench::{UnknownDifference, VerifyError};

    use super::*;

    fn verdict(class: FaultClass, injections: u64) -> FaultVerdict {
        FaultVerdict {
            machine: "paper",
            fault: class.name(),
            device: "text".into(),
            tool_version: "1".into(),
            injections,
            injected: "resets".into(),
            results_compared: 1,
            vectors_compared: 1,
            signals_per_vector: 1,
            known_after_reset: Vec::new(),
        }
    }

    fn all(verdicts: Vec<FaultVerdict>) -> UpToDifference<FaultVerdict> {
        let mut all = UpToDifference::new(|verdict: &FaultVerdict| verdict.vectors_compared);
        all.verdicts = verdicts;
        all
    }

    #[test]
    fn a_class_that_is_left_out_or_was_never_there_is_a_finding() {
        let each = FaultClass::ALL.map(|class| verdict(class, 1)).to_vec();
        assert_eq!(findings(&all(each.clone())), [""; 0]);
        assert_eq!(findings(&all(each[1..].to_vec())).len(), 1);
        let mut never = each;
        never[2].injections = 0;
        let [finding] = &findings(&all(never))[..] else {
            panic!("expected one");
        };
        assert!(finding.contains(FaultClass::ALL[2].name()), "{finding}");
        assert_eq!(findings(&all(Vec::new())).len(), FaultClass::ALL.len());
    }

    #[test]
    fn a_difference_is_told_with_its_class() {
        let mut all = all(Vec::new());
        let unknown = UnknownDifference {
            machine: "paper",
            device: "icarus".into(),
            clock: 7,
            signal: "cell_0_query".into(),
            expected: 1,
            found: "xx".into(),
            repeat: "photoncube".into(),
        };
        let ended = Err(VerifyError::Unknown(Box::new(unknown)));
        assert!(!all.add(FaultClass::IdleUnknown.name(), ended).unwrap());
        let finding = &findings(&all)[0];
        assert!(
            finding.contains("X on idle inputs") && finding.contains("cell_0_query"),
            "{finding}"
        );
    }
}
