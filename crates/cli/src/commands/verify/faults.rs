//! The method `faults`: external faults by class: waiting streams, resets, unknown words, power-up.

use anyhow::Result;
use clap::Args;
use photoncube_testbench::{
    Controls, DeviceKind, FaultClass, FaultVerdict, Tool, VerifyError, fault_controls, verify_fault,
};
use serde::Serialize;

use super::method::Method;
use super::options::{AGAINST, Devices, SeedArgs, devices, tools};
use super::outcome::{Outcome, compared};
use crate::machines::MachineArgs;
use crate::progress;
use crate::verified::{Line, grouped};

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

/// The results of a machine under each class, up to the first difference.
#[derive(Debug, Serialize)]
struct Classes {
    machine: &'static str,
    seed: u64,
    faults: Vec<FaultVerdict>,
    vectors_compared: u64,
    mismatches: u64,
    #[serde(skip)]
    differences: Vec<String>,
}

impl Classes {
    /// Adds the verdict of a class, or the difference. Returns whether there was none.
    fn add(&mut self, class: FaultClass, ended: Result<FaultVerdict, VerifyError>) -> Result<bool> {
        match compared(ended)? {
            Ok(verdict) => {
                self.vectors_compared += verdict.vectors_compared;
                self.faults.push(verdict);
                Ok(true)
            }
            Err(difference) => {
                self.mismatches += 1;
                self.differences
                    .push(format!("{}: {difference}", class.name()));
                Ok(false)
            }
        }
    }

    /// The difference; without one, each class that is missing or whose fault never occurred.
    fn findings(&self) -> Vec<String> {
        if !self.differences.is_empty() {
            return self.differences.clone();
        }
        let is_done = |class: &FaultClass| {
            let mut of_class = self.faults.iter().filter(|f| f.fault == class.name());
            of_class.any(|fault| fault.injections > 0 && fault.vectors_compared > 0)
        };
        let missing = FaultClass::ALL.iter().filter(|class| !is_done(class));
        missing
            .map(|class| format!("nothing was done of: {}", class.name()))
            .collect()
    }

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
                "{} mismatches; {} {}",
                self.mismatches,
                grouped(verdict.injections),
                verdict.injected
            ),
            command: format!(
                "photoncube verify faults --machine {}{against} --seed {}",
                verdict.machine, self.seed
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
        let machine = self.machine.find()?;
        let controls = Controls::gathered(fault_controls()?)?;
        let kinds = devices(&self.against);
        let mut all = Classes {
            machine: machine.name,
            seed: self.seed.seed,
            faults: Vec::new(),
            vectors_compared: 0,
            mismatches: 0,
            differences: Vec::new(),
        };
        let of_class = |&class: &FaultClass| match class.is_four_state() {
            true => vec![(class, DeviceKind::Icarus)],
            false => kinds.iter().map(|&kind| (class, kind)).collect(),
        };
        let jobs: Vec<_> = FaultClass::ALL.iter().flat_map(of_class).collect();
        let bar = progress::bar("faults", jobs.len() as u64);
        for (class, kind) in jobs {
            if !all.add(class, verify_fault(machine, class, kind, self.seed.seed))? {
                break;
            }
            bar.inc(1);
        }
        bar.finish_and_clear();
        let about = Line::of_machine(machine.name)?;
        let header = ["fault", "injections", "results", "vectors", "device"];
        let rows: Vec<_> = all.faults.iter().map(row).collect();
        let mut outcome = Outcome::new::<Self>(controls, &all)?
            .table(&header, &rows)
            .lines(all.faults.iter().map(|verdict| all.line(verdict, &about)))
            .findings(all.findings());
        for known in all.faults.iter().filter_map(known_after_reset) {
            outcome = outcome.note(known);
        }
        Ok(outcome)
    }
}

fn row(verdict: &FaultVerdict) -> Vec<String> {
    vec![
        verdict.fault.to_owned(),
        format!("{} {}", grouped(verdict.injections), verdict.injected),
        verdict.results_compared.to_string(),
        format!(
            "{} of {} signals",
            grouped(verdict.vectors_compared),
            verdict.signals_per_vector
        ),
        verdict.device.clone(),
    ]
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
    use photoncube_testbench::UnknownDifference;

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

    fn classes(faults: Vec<FaultVerdict>) -> Classes {
        Classes {
            machine: "paper",
            seed: 1,
            faults,
            vectors_compared: 1,
            mismatches: 0,
            differences: Vec::new(),
        }
    }

    #[test]
    fn a_class_that_is_left_out_or_was_never_there_is_a_finding() {
        let all = FaultClass::ALL.map(|class| verdict(class, 1)).to_vec();
        assert_eq!(classes(all.clone()).findings(), [""; 0]);
        assert_eq!(classes(all[1..].to_vec()).findings().len(), 1);
        let mut never = all;
        never[2].injections = 0;
        let [finding] = &classes(never).findings()[..] else {
            panic!("expected one");
        };
        assert!(finding.contains(FaultClass::ALL[2].name()), "{finding}");
        assert_eq!(classes(Vec::new()).findings().len(), FaultClass::ALL.len());
    }

    #[test]
    fn a_difference_is_told_with_its_class() {
        let mut classes = classes(Vec::new());
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
        assert!(!classes.add(FaultClass::IdleUnknown, ended).unwrap());
        let finding = &classes.findings()[0];
        assert!(
            finding.contains("X on idle inputs") && finding.contains("cell_0_query"),
            "{finding}"
        );
    }
}
