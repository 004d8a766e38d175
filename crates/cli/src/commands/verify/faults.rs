//! The method `--faults`: external faults by class: waiting streams, resets, unknown words, power-up.

use anyhow::Result;
use photoncube_testbench::{DeviceKind, FaultClass, FaultVerdict, VerifyError, verify_fault};
use serde::Serialize;

use super::equivalence::devices;
use crate::args::VerifyArgs;
use crate::failure::CheckFailed;
use crate::verified::{Line, grouped, record};
use crate::{output, progress, table};

/// The results of a machine under each class.
#[derive(Debug, Serialize)]
struct Report {
    machine: &'static str,
    seed: u64,
    faults: Vec<FaultVerdict>,
    vectors_compared: u64,
    mismatches: u64,
    divergence: Option<String>,
}

impl Report {
    /// Records the verdict of a class, or the error that prevented one.
    fn record(
        &mut self,
        class: FaultClass,
        found: Result<FaultVerdict, VerifyError>,
    ) -> Result<()> {
        match found {
            Ok(verdict) => {
                self.vectors_compared += verdict.vectors_compared;
                self.faults.push(verdict);
            }
            Err(error @ (VerifyError::Diverged(_) | VerifyError::Unknown(_))) => {
                self.mismatches += 1;
                self.divergence = Some(format!("{}: {error}", class.name()));
            }
            Err(error) => return Err(error.into()),
        }
        Ok(())
    }

    /// Fails where a class is missing or its fault never occurred.
    fn conclusion(&self) -> Result<()> {
        if let Some(divergence) = &self.divergence {
            return Err(CheckFailed(divergence.clone()).into());
        }
        let is_done = |class: &FaultClass| {
            let mut of_class = self.faults.iter().filter(|f| f.fault == class.name());
            of_class.any(|fault| fault.injections > 0 && fault.vectors_compared > 0)
        };
        match FaultClass::ALL.iter().find(|class| !is_done(class)) {
            None => Ok(()),
            Some(class) => {
                Err(CheckFailed(format!("nothing was done of: {}", class.name())).into())
            }
        }
    }
}

/// Verifies one machine under each class: in each device, or in Icarus where only that can show the fault.
pub fn execute(args: &VerifyArgs, json: bool) -> Result<()> {
    let machine = args.machine.find()?;
    let kinds = devices(args, &[DeviceKind::fastest()])?;
    let mut report = Report {
        machine: machine.name,
        seed: args.seed,
        faults: Vec::new(),
        vectors_compared: 0,
        mismatches: 0,
        divergence: None,
    };
    let of_class = |&class: &FaultClass| match class.is_four_state() {
        true => vec![(class, DeviceKind::Icarus)],
        false => kinds.iter().map(|&kind| (class, kind)).collect(),
    };
    let all: Vec<_> = FaultClass::ALL.iter().flat_map(of_class).collect();
    let bar = progress::bar("faults", all.len() as u64);
    for (class, kind) in all {
        report.record(class, verify_fault(machine, class, kind, args.seed))?;
        bar.inc(1);
        if report.divergence.is_some() {
            break;
        }
    }
    bar.finish_and_clear();
    output::print(json, &report, || text(&report))?;
    report.conclusion()?;
    match &args.record {
        Some(path) => record(path, &lines(&report)?),
        None => Ok(()),
    }
}

fn lines(report: &Report) -> Result<Vec<Line>> {
    let against = |verdict: &FaultVerdict| {
        let four_state = FaultClass::ALL.iter().filter(|class| class.is_four_state());
        let mut names = four_state.map(|class| class.name());
        match names.any(|name| name == verdict.fault) {
            true => String::new(),
            false => format!(" --against {}", verdict.device),
        }
    };
    let about = Line::of_machine(report.machine)?;
    let line = |verdict: &FaultVerdict| Line {
        method: format!("faults: {}", verdict.fault),
        by: format!("{}: {}", verdict.device, verdict.tool_version),
        volume: verdict.vectors_compared,
        unit: format!("vectors of {} signals", verdict.signals_per_vector),
        result: format!(
            "{} mismatches; {} {}",
            report.mismatches,
            grouped(verdict.injections),
            verdict.injected
        ),
        command: format!(
            "photoncube verify --faults --machine {}{} --seed {}",
            verdict.machine,
            against(verdict),
            report.seed
        ),
        ..about.clone()
    };
    Ok(report.faults.iter().map(line).collect())
}

fn text(report: &Report) -> String {
    let header = ["fault", "injections", "results", "vectors", "device"];
    let row = |verdict: &FaultVerdict| {
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
    };
    let rows: Vec<_> = report.faults.iter().map(row).collect();
    let known: Vec<_> = report
        .faults
        .iter()
        .filter(|verdict| !verdict.known_after_reset.is_empty())
        .map(|verdict| {
            format!(
                "known a clock after the reset, by it or from the pins: {}\n",
                verdict.known_after_reset.join(", ")
            )
        })
        .collect();
    table::markdown(&header, &rows) + &known.concat()
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

    fn report(faults: Vec<FaultVerdict>) -> Report {
        Report {
            machine: "paper",
            seed: 1,
            faults,
            vectors_compared: 1,
            mismatches: 0,
            divergence: None,
        }
    }

    #[test]
    fn a_class_that_is_left_out_or_was_never_there_fails() {
        let all: Vec<_> = FaultClass::ALL
            .iter()
            .map(|&class| verdict(class, 1))
            .collect();
        assert!(report(all.clone()).conclusion().is_ok());
        assert!(report(all[1..].to_vec()).conclusion().is_err());
        let mut never = all;
        never[2].injections = 0;
        let error = report(never).conclusion().unwrap_err().to_string();
        assert!(error.contains(FaultClass::ALL[2].name()), "{error}");
        assert!(report(Vec::new()).conclusion().is_err());
    }

    #[test]
    fn a_difference_is_told_with_its_class() {
        let mut report = report(Vec::new());
        let unknown = UnknownDifference {
            machine: "paper",
            device: "icarus".into(),
            clock: 7,
            signal: "cell_0_query".into(),
            expected: 1,
            found: "xx".into(),
            repeat: "photoncube".into(),
        };
        report
            .record(
                FaultClass::IdleUnknown,
                Err(VerifyError::Unknown(Box::new(unknown))),
            )
            .unwrap();
        let error = report.conclusion().unwrap_err().to_string();
        assert!(
            error.contains("X on idle inputs") && error.contains("cell_0_query"),
            "{error}"
        );
    }
}
