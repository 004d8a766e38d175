//! The method `placed`: the netlist that is placed on an ECP5. It is simulated against the golden model as Yosys maps
//! it and after each pass, and each pass is proven.

use anyhow::Result;
use clap::Args;
use photoncube_testbench::{Control, DeviceKind, Tool, Verdict, VerifyError, comparison_controls};
use serde::Serialize;
use serde_json::json;

use super::method::Method;
use super::options::{Devices, StimulusArgs, devices, tools};
use super::outcome::{Outcome, UpToDifference};
use crate::machines::MachineArgs;
use crate::progress;
use crate::synth::placed::{Placed as Netlists, SIMULATORS};
use crate::synth::{self, Subject};
use crate::verified::Line;
use fpga_flow::PassProof;

/// See [`Method::ABOUT`].
#[derive(Args, Debug)]
pub struct Placed {
    #[command(flatten)]
    machine: MachineArgs,
    /// What simulates the netlists: verilator, icarus
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "verilator", value_parser = simulator)]
    against: Vec<Devices>,
    #[command(flatten)]
    stimulus: StimulusArgs,
}

/// Reads the name of a simulator that can run the models of the cells.
fn simulator(name: &str) -> Result<Devices, String> {
    let named: Devices = name.parse().map_err(|error| format!("{error}"))?;
    let known = devices(std::slice::from_ref(&named));
    match known.iter().all(|kind| SIMULATORS.contains(kind)) {
        true => Ok(named),
        false => Err("the netlist has models of cells, so expected verilator or icarus".to_owned()),
    }
}

/// The columns of the tables.
const PASS_COLUMNS: &str = "pass cells_changed different_changes proven control_refuted";
const NETLIST_COLUMNS: &str =
    "netlist device results_compared vectors_compared signals_per_vector clocks_per_second";

struct Report {
    machine: &'static str,
    seed: u64,
    iterations: u64,
    /// The digest of the netlist that is placed.
    netlist_sha256: String,
    /// The version of Yosys.
    tool_version: String,
    passes: Vec<PassProof>,
    netlists: UpToDifference<StageVerdict>,
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

impl Method for Placed {
    const NAME: &'static str = "placed";
    const ABOUT: &'static str = "Map the machine as `synth` does for an ECP5, prove the passes over its netlist, and simulate \
        the netlist as Yosys makes it and after each pass, with models of its cells; the last is what is placed. Needs \
        Yosys of `photoncube setup`";
    const EXAMPLES: &'static [&'static str] = &["photoncube verify placed --machine stream"];

    fn tools(&self) -> Vec<Tool> {
        tools(&self.against)
    }

    fn run(&self) -> Result<Outcome> {
        let machine = self.machine.find_to_emit()?;
        let yosys = synth::tools(None, None)?;
        let subject = Subject::of(machine)?;
        let spinner = progress::spinner("mapping");
        let placed = Netlists::map(&yosys, &subject)?;
        let emitted = photoncube_hdl::emit(machine, photoncube_hdl::Level::Machine)?;
        let mut report = Report {
            machine: machine.name,
            seed: self.stimulus.seed.seed,
            iterations: self.stimulus.iterations,
            netlist_sha256: placed.netlist_sha256()?,
            tool_version: placed.yosys_version()?,
            passes: placed.prove()?,
            netlists: UpToDifference::new(|stage| stage.verdict.vectors_compared),
            verilog_sha256: emitted.verilog_sha256(),
        };
        spinner.finish_and_clear();
        let simulators = devices(&self.against);
        self.simulate(&placed, &simulators, &mut report)?;
        report.outcome(simulators)
    }
}

impl Placed {
    /// Simulates each netlist that differs from the one before, in each simulator, up to the first difference.
    fn simulate(
        &self,
        placed: &Netlists<'_>,
        simulators: &[DeviceKind],
        report: &mut Report,
    ) -> Result<()> {
        let options = self.stimulus.random();
        let mut before = None;
        for stage in placed.stages() {
            if before == Some(&stage.netlist) {
                continue;
            }
            before = Some(&stage.netlist);
            for &simulator in simulators {
                let bar = progress::bar(stage.name, options.iterations);
                let position = |done| bar.set_position(done);
                let ended = placed.verify(&stage.netlist, simulator, &options, &position);
                bar.finish_and_clear();
                if !report.add(stage.name, ended?)? {
                    return Ok(());
                }
            }
        }
        Ok(())
    }
}

impl Report {
    /// Adds the verdict of a simulation, or the difference. Returns whether there was none.
    fn add(&mut self, netlist: &'static str, ended: Result<Verdict, VerifyError>) -> Result<bool> {
        let verilog_sha256 = Some(self.verilog_sha256.clone());
        let ended = ended.map(|verdict| StageVerdict {
            netlist,
            verdict: Verdict {
                verilog_sha256,
                ..verdict
            },
        });
        self.netlists.add(&format!("netlist, {netlist}"), ended)
    }

    fn outcome(self, simulators: Vec<DeviceKind>) -> Result<Outcome> {
        let details = json!({
            "machine": self.machine,
            "seed": self.seed,
            "iterations": self.iterations,
            "netlist_sha256": self.netlist_sha256,
            "tool_version": self.tool_version,
            "vectors_compared": self.netlists.vectors_compared,
            "mismatches": self.netlists.mismatches(),
            "netlist_passes": self.passes,
            "netlists": self.netlists.verdicts,
        });
        let unproven = self.passes.iter().filter(|pass| !pass.proven);
        // A pass that changes nothing has no place for a fault.
        let changed = self.passes.iter();
        let changed = changed.filter(|pass| pass.different_changes > 0);
        let controls = comparison_controls(simulators)?.with(changed.map(control));
        let placed = format!(
            "{}: mapped by Yosys {}; the netlist that is placed is {}",
            self.machine, self.tool_version, self.netlist_sha256
        );
        Ok(Outcome::new::<Placed>(controls, &details)?
            .rows("netlist_passes", PASS_COLUMNS)
            .rows("netlists", NETLIST_COLUMNS)
            .note(placed)
            .lines(self.lines())
            .findings(unproven.map(told))
            .findings(self.netlists.difference.clone()))
    }

    /// The lines of this report for the table of results: one for the simulations, one for the proofs.
    fn lines(&self) -> Vec<Line> {
        let about = Line::about(self.machine.to_owned(), Some(self.verilog_sha256.clone()));
        let yosys = format!("Yosys {}", self.tool_version);
        let command = format!(
            "photoncube verify placed --machine {} --iterations {} --seed {}",
            self.machine, self.iterations, self.seed
        );
        let stages = &self.netlists.verdicts;
        let names: Vec<_> = stages.iter().map(|stage| stage.netlist).collect();
        let simulator = |StageVerdict { verdict, .. }: &StageVerdict| {
            format!("{}: {}", verdict.device, verdict.tool_version)
        };
        let mut simulators: Vec<_> = stages.iter().map(simulator).collect();
        simulators.dedup();
        let first = stages.first();
        let signals = first.map_or(0, |stage| stage.verdict.signals_per_vector);
        let simulated = Line {
            aspect: "simulated".to_owned(),
            by: format!("{yosys}; {}", simulators.join(", ")),
            volume: self.netlists.vectors_compared,
            unit: format!("vectors of {signals} signals"),
            result: format!(
                "{} mismatches; netlists: {}; placed is {}",
                self.netlists.mismatches(),
                names.join(", "),
                self.netlist_sha256
            ),
            command: command.clone(),
            ..about.clone()
        };
        let of = |count: fn(&PassProof) -> usize| self.passes.iter().map(count).sum::<usize>();
        let proven = Line {
            aspect: "passes proven".to_owned(),
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
        let changed = (proven.volume > 0).then_some(proven);
        [simulated].into_iter().chain(changed).collect()
    }
}

fn control(pass: &PassProof) -> Control {
    Control {
        planted: match pass.control_refuted {
            true => format!("a fault in each change of {}", pass.pass),
            false => told(pass),
        },
        found: pass.control_refuted,
    }
}

fn told(pass: &PassProof) -> String {
    let why = pass.not_proven_because.as_deref();
    format!(
        "the pass `{}`: {}",
        pass.pass,
        why.unwrap_or("nothing was said")
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
    fn report(passes: Vec<PassProof>) -> Report {
        let mut report = Report {
            machine: "paper",
            seed: 1,
            iterations: 9,
            netlist_sha256: "00".to_owned(),
            tool_version: "0.70".to_owned(),
            passes,
            netlists: UpToDifference::new(|stage| stage.verdict.vectors_compared),
            verilog_sha256: "11".to_owned(),
        };
        for netlist in ["mapped", "open carry ends"] {
            assert!(report.add(netlist, Ok(verdict())).unwrap());
        }
        report
    }

    #[test]
    fn a_pass_without_proof_or_control_and_nothing_simulated_fail() {
        let concluded = |report: Report| report.outcome(Vec::new()).unwrap().conclusion();
        assert!(concluded(report(vec![pass()])).is_ok());
        let wrong: [fn(&mut PassProof); 2] = [
            |pass| pass.proven = false,
            |pass| pass.control_refuted = false,
        ];
        for make_wrong in wrong {
            let mut pass = pass();
            make_wrong(&mut pass);
            pass.not_proven_because = Some("CCU2C sum".to_owned());
            let error = concluded(report(vec![pass])).unwrap_err().to_string();
            assert!(error.contains("`open carry ends`: CCU2C sum"), "{error}");
        }
        let nothing = Report {
            netlists: UpToDifference::new(|stage| stage.verdict.vectors_compared),
            ..report(vec![pass()])
        };
        assert!(concluded(nothing).is_err());
    }

    #[test]
    fn every_key_is_documented() {
        let report =
            serde_json::to_value(report(vec![pass()]).outcome(Vec::new()).unwrap()).unwrap();
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
