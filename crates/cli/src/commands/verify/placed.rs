//! The method `--placed`: the netlist that is placed on an ECP5. It is simulated against the golden model as
//! Yosys maps it and after each pass, and each pass is proven.

use anyhow::{Result, bail};
use fpga_flow::PassProof;
use photoncube_testbench::{Source, Verdict, VerifyError, VerifyOptions};
use serde::Serialize;

use super::equivalence::devices;
use crate::args::VerifyArgs;
use crate::failure::CheckFailed;
use crate::synth::placed::{Placed, SIMULATORS};
use crate::synth::{self, Subject};
use crate::verified::{Line, grouped, record};
use crate::{output, progress, table};

#[derive(Debug, Serialize)]
struct Report {
    machine: &'static str,
    seed: u64,
    iterations: u64,
    /// The digest of the netlist that is placed.
    netlist_sha256: String,
    /// The version of Yosys.
    tool_version: String,
    vectors_compared: u64,
    mismatches: u64,
    netlist_passes: Vec<PassProof>,
    netlists: Vec<StageVerdict>,
    divergence: Option<String>,
    #[serde(skip)]
    verilog_sha256: String,
}

/// The comparison of a netlist with the golden model.
#[derive(Debug, Serialize)]
struct StageVerdict {
    /// The name of the netlist: Yosys's mapping, or the pass that made it.
    netlist: &'static str,
    #[serde(flatten)]
    verdict: Verdict,
}

impl Report {
    /// Records the verdict of a simulation, or the error that prevented one.
    fn record(&mut self, stage: &'static str, found: Result<Verdict, VerifyError>) -> Result<()> {
        match found {
            Ok(verdict) => {
                self.vectors_compared += verdict.vectors_compared;
                let verilog_sha256 = Some(self.verilog_sha256.clone());
                let verdict = Verdict {
                    verilog_sha256,
                    ..verdict
                };
                self.netlists.push(StageVerdict {
                    netlist: stage,
                    verdict,
                });
            }
            Err(VerifyError::Diverged(divergence)) => {
                self.vectors_compared += divergence.vectors_compared + 1;
                self.mismatches += 1;
                self.divergence = Some(format!("netlist, {stage}: {divergence}"));
            }
            Err(error) => return Err(error.into()),
        }
        Ok(())
    }

    fn conclusion(&self) -> Result<()> {
        let holds = |pass: &&PassProof| pass.proven && pass.control_refuted;
        let failed: Vec<_> = self
            .netlist_passes
            .iter()
            .filter(|pass| !holds(pass))
            .map(said)
            .collect();
        match &self.divergence {
            Some(divergence) => Err(CheckFailed(divergence.clone()).into()),
            None if !failed.is_empty() => Err(CheckFailed(failed.join("\n")).into()),
            None if self.netlists.is_empty() => {
                Err(CheckFailed("no netlist was simulated".to_owned()).into())
            }
            None => Ok(()),
        }
    }

    /// The lines of this report for the table of results: one for the simulations, one for the proofs.
    fn lines(&self) -> Vec<Line> {
        let about = Line::about(self.machine.to_owned(), Some(self.verilog_sha256.clone()));
        let yosys = format!("Yosys {}", self.tool_version);
        let command = format!(
            "photoncube verify --placed --machine {} --iterations {} --seed {}",
            self.machine, self.iterations, self.seed
        );
        let names: Vec<_> = self.netlists.iter().map(|stage| stage.netlist).collect();
        let mut simulators: Vec<_> = self
            .netlists
            .iter()
            .map(|StageVerdict { verdict, .. }| {
                format!("{}: {}", verdict.device, verdict.tool_version)
            })
            .collect();
        simulators.dedup();
        let signals = self
            .netlists
            .first()
            .map_or(0, |stage| stage.verdict.signals_per_vector);
        let simulated = Line {
            method: "placed, simulated".to_owned(),
            by: format!("{yosys}; {}", simulators.join(", ")),
            volume: self.vectors_compared,
            unit: format!("vectors of {signals} signals"),
            result: format!(
                "{} mismatches; netlists: {}; placed is {}",
                self.mismatches,
                names.join(", "),
                self.netlist_sha256
            ),
            command: command.clone(),
            ..about.clone()
        };
        let of =
            |count: fn(&PassProof) -> usize| self.netlist_passes.iter().map(count).sum::<usize>();
        let proven = Line {
            method: "placed, passes proven".to_owned(),
            by: yosys,
            volume: of(|pass| pass.cells_changed) as u64,
            unit: "changed cells".to_owned(),
            result: format!(
                "{} different changes proven, their planted faults refuted",
                of(|pass| pass.different_changes)
            ),
            command,
            ..about
        };
        vec![simulated, proven]
    }
}

fn said(pass: &PassProof) -> String {
    let why = pass.not_proven_because.as_deref();
    format!(
        "the pass `{}`: {}",
        pass.pass,
        why.unwrap_or("nothing was said")
    )
}

/// Maps one machine as `synth` does, proves the passes, and simulates the netlist after each.
pub fn execute(args: &VerifyArgs, json: bool) -> Result<()> {
    let machine = args.machine.find()?;
    let simulators = devices(args, &SIMULATORS[..1])?;
    if let Some(other) = simulators.iter().find(|kind| !SIMULATORS.contains(kind)) {
        bail!(
            "`--placed` runs models of cells, so found --against {other}, expected verilator or icarus"
        );
    }
    if let Some(missing) = simulators.iter().find_map(|kind| kind.missing_tool()) {
        return Err(missing.into());
    }
    let tools = synth::tools(None, None)?;
    let subject = Subject::of(machine)?;
    let spinner = progress::spinner("mapping");
    let placed = Placed::map(&tools, &subject)?;
    let mut report = Report {
        machine: machine.name,
        seed: args.seed,
        iterations: args.iterations,
        netlist_sha256: placed.netlist_sha256()?,
        tool_version: placed.yosys_version()?,
        vectors_compared: 0,
        mismatches: 0,
        netlist_passes: placed.prove()?,
        netlists: Vec::new(),
        divergence: None,
        verilog_sha256: photoncube_hdl::emit(machine, photoncube_hdl::Level::Machine)?
            .verilog_sha256(),
    };
    spinner.finish_and_clear();
    simulate(&placed, args, &simulators, &mut report)?;
    output::print(json, &report, || text(&report))?;
    report.conclusion()?;
    match &args.record {
        Some(path) => record(path, &report.lines()),
        None => Ok(()),
    }
}

/// Simulates each netlist that differs from the one before, in each simulator, up to the first difference.
fn simulate(
    placed: &Placed<'_>,
    args: &VerifyArgs,
    simulators: &[photoncube_testbench::DeviceKind],
    report: &mut Report,
) -> Result<()> {
    let options = VerifyOptions {
        iterations: args.iterations,
        seed: args.seed,
        source: Source::Random,
    };
    let mut before = None;
    for stage in placed.stages() {
        if before == Some(&stage.netlist) {
            continue;
        }
        before = Some(&stage.netlist);
        for &simulator in simulators {
            let bar = progress::bar(stage.name, options.iterations);
            let found = placed.verify(&stage.netlist, simulator, &options, &|done| {
                bar.set_position(done)
            });
            bar.finish_and_clear();
            report.record(stage.name, found?)?;
            if report.divergence.is_some() {
                return Ok(());
            }
        }
    }
    Ok(())
}

fn text(report: &Report) -> String {
    let yes = |holds, yes: &str, no: &str| if holds { yes } else { no }.to_owned();
    let pass = |pass: &PassProof| {
        vec![
            pass.pass.to_owned(),
            pass.cells_changed.to_string(),
            pass.different_changes.to_string(),
            yes(pass.proven, "proven", "NOT PROVEN"),
            yes(pass.control_refuted, "refuted", "NOT REFUTED"),
        ]
    };
    let passes: Vec<_> = report.netlist_passes.iter().map(pass).collect();
    let stage = |StageVerdict { netlist, verdict }: &StageVerdict| {
        vec![
            (*netlist).to_owned(),
            verdict.device.clone(),
            verdict.results_compared.to_string(),
            verdict.vectors_compared.to_string(),
            verdict.signals_per_vector.to_string(),
            grouped(verdict.clocks_per_second),
        ]
    };
    let stages: Vec<_> = report.netlists.iter().map(stage).collect();
    table::markdown(
        &["pass", "cells changed", "different", "the same", "faults"],
        &passes,
    ) + "\n"
        + &table::markdown(
            &["netlist", "in", "results", "vectors", "outputs", "clocks/s"],
            &stages,
        )
        + &format!(
            "{}: mapped by Yosys {}; the netlist that is placed is {}\n",
            report.machine, report.tool_version, report.netlist_sha256
        )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pass() -> PassProof {
        PassProof {
            pass: "open carry ends",
            cells_changed: 7,
            different_changes: 2,
            proven: true,
            control_refuted: true,
            not_proven_because: None,
        }
    }

    fn verdict() -> Verdict {
        Verdict {
            machine: "paper",
            verilog_sha256: None,
            device: "verilator".to_owned(),
            tool_version: "5".to_owned(),
            seed: 1,
            iterations: 9,
            results_compared: 3,
            vectors_compared: 100,
            signals_per_vector: 7,
            registers_compared: false,
            clocks_per_second: 5,
            pressure: photoncube_testbench::Pressure::default(),
        }
    }

    /// A report of two netlists.
    fn report(netlist_passes: Vec<PassProof>) -> Report {
        let mut report = Report {
            machine: "paper",
            seed: 1,
            iterations: 9,
            netlist_sha256: "00".to_owned(),
            tool_version: "0.70".to_owned(),
            vectors_compared: 0,
            mismatches: 0,
            netlist_passes,
            netlists: Vec::new(),
            divergence: None,
            verilog_sha256: "11".to_owned(),
        };
        for netlist in ["mapped", "open carry ends"] {
            report.record(netlist, Ok(verdict())).unwrap();
        }
        report
    }

    #[test]
    fn a_pass_without_proof_or_control_and_nothing_simulated_fail() {
        assert!(report(vec![pass()]).conclusion().is_ok());
        let wrong: [fn(&mut PassProof); 2] = [
            |pass| pass.proven = false,
            |pass| pass.control_refuted = false,
        ];
        for make_wrong in wrong {
            let mut pass = pass();
            make_wrong(&mut pass);
            pass.not_proven_because = Some("CCU2C sum".to_owned());
            let error = report(vec![pass]).conclusion().unwrap_err().to_string();
            assert!(error.contains("`open carry ends`: CCU2C sum"), "{error}");
        }
        let nothing = Report {
            netlists: Vec::new(),
            ..report(vec![pass()])
        };
        assert!(nothing.conclusion().is_err());
    }

    #[test]
    fn every_key_is_documented() {
        let report = serde_json::to_value(report(vec![pass()])).unwrap();
        let rows = ["netlist_passes", "netlists"].map(|rows| &report[rows][0]);
        let objects = rows
            .into_iter()
            .chain([&report])
            .filter_map(|row| row.as_object());
        let keys: Vec<_> = objects.flat_map(|object| object.keys()).collect();
        assert!(keys.len() > 20, "{keys:?}");
        let documented = include_str!("../../../../../docs/json.md");
        let is_documented = |key: &&&String| documented.contains(&format!("`{key}`"));
        let missing: Vec<_> = keys.iter().filter(|key| !is_documented(key)).collect();
        assert!(
            missing.is_empty(),
            "docs/json.md does not explain {missing:?}"
        );
    }

    #[test]
    fn the_lines_say_what_was_simulated_and_what_proven() {
        let [simulated, proven] = &report(vec![pass()]).lines()[..] else {
            panic!("expected two lines");
        };
        assert_eq!((simulated.volume, proven.volume), (200, 7));
        assert_eq!(simulated.by, "Yosys 0.70; verilator: 5");
        assert_eq!(
            simulated.result,
            "0 mismatches; netlists: mapped, open carry ends; placed is 00"
        );
        assert_eq!(simulated.verilog_sha256.as_deref(), Some("11"));
        assert!(proven.result.starts_with("2 different changes proven"));
    }
}
