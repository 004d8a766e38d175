//! The method `formal`: proofs about the emitted Verilog, for all inputs.

use anyhow::Result;
use clap::Args;
use photoncube_testbench::{Control, Controls, Formal as Found, Proof, Tool, formal};

use super::method::Method;
use super::outcome::Outcome;
use crate::machines::MachineArgs;
use crate::progress;
use crate::verified::Line;

/// The columns of the table.
const COLUMNS: &str = "property module method depth proven cover_reached control_refuted seconds";

/// See [`Method::ABOUT`].
#[derive(Args, Debug)]
pub struct Formal {
    #[command(flatten)]
    machine: MachineArgs,
    /// Only the properties whose names begin so; the result of some is not recorded
    #[arg(long, conflicts_with = "record", value_name = "NAME")]
    property: Option<String>,
}

impl Method for Formal {
    const NAME: &'static str = "formal";
    const ABOUT: &'static str = "Prove properties of the emitted text for all inputs, by Yosys: units, control block, \
        streams, sums, and each module against its netlist";
    const EXAMPLES: &'static [&'static str] = &[
        "photoncube verify formal --machine paper",
        "photoncube verify formal --property units::",
    ];

    fn tools(&self) -> Vec<Tool> {
        vec![Tool::Yosys]
    }

    fn run(&self) -> Result<Outcome> {
        let machine = self.machine.find_to_emit()?;
        let prefix = self.property.as_deref().unwrap_or_default();
        let bar = progress::bar("formal", 0);
        let found = formal(machine, &|name| name.starts_with(prefix), &|done, of| {
            bar.set_length(of as u64);
            bar.set_position(done as u64);
        })?;
        bar.finish_and_clear();
        outcome(&found)
    }
}

fn outcome(found: &Found) -> Result<Outcome> {
    let controls = Controls::gathered(found.proofs.iter().map(control))?;
    let holds = found.proofs.iter().filter(|proof| proof.holds()).count();
    let of = found.proofs.len();
    Ok(Outcome::new::<Formal>(controls, found)?
        .rows("proofs", COLUMNS)
        .note(format!(
            "{}: {holds} of {of} properties hold",
            found.machine
        ))
        .lines(lines(found)?)
        .findings(found.failed().map(finding)))
}

fn control(proof: &Proof) -> Control {
    Control {
        planted: format!("the faults of {}", proof.property),
        found: proof.control_refuted,
    }
}

fn finding(proof: &Proof) -> String {
    let why = proof.not_proven_because.as_deref();
    let why = why.unwrap_or("nothing was said");
    format!(
        "{} does not hold, or its checks do not: {why}",
        proof.property
    )
}

/// One line for each method of proof.
fn lines(found: &Found) -> Result<Vec<Line>> {
    let machine = Line::of_machine(found.machine)?;
    let mut methods: Vec<_> = found.proofs.iter().map(|proof| proof.method).collect();
    methods.sort_unstable();
    methods.dedup();
    let line = |method: &str| {
        let of_method = found.proofs.iter().filter(|proof| proof.method == method);
        let proven = of_method.clone().filter(|proof| proof.holds()).count();
        Line {
            aspect: format!("by {method}"),
            by: match method {
                // Run in the testbench's evaluator of the emitted text.
                "exhaustive" => format!("photoncube {}", env!("CARGO_PKG_VERSION")),
                _ => found.tool_version.clone(),
            },
            volume: of_method.count() as u64,
            unit: match method {
                "equivalence" => "modules against their netlists".to_owned(),
                _ => "properties".to_owned(),
            },
            result: format!("{proven} proven, their planted faults refuted"),
            command: format!("photoncube verify formal --machine {}", found.machine),
            ..machine.clone()
        }
    };
    Ok(methods.into_iter().map(line).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn concluded(proofs: Vec<Proof>) -> Result<()> {
        outcome(&Found {
            machine: "paper",
            tool_version: "yosys".to_owned(),
            proofs,
        })?
        .conclusion()
    }

    #[test]
    fn a_proof_without_cover_or_control_or_no_proof_at_all_fails() {
        let sound = Proof {
            property: "units::add".to_owned(),
            module: "add".to_owned(),
            claim: String::new(),
            method: "sat",
            depth: 0,
            proven: true,
            cover_reached: Some(true),
            control_refuted: true,
            seconds: 0.1,
            not_proven_because: None,
        };
        assert!(concluded(vec![sound.clone()]).is_ok());
        assert!(concluded(vec![]).is_err());
        let wrong: [fn(&mut Proof); 3] = [
            |proof| proof.proven = false,
            |proof| proof.cover_reached = Some(false),
            |proof| proof.control_refuted = false,
        ];
        for make_wrong in wrong {
            let mut proof = sound.clone();
            make_wrong(&mut proof);
            let error = concluded(vec![proof]).unwrap_err().to_string();
            assert!(error.contains("units::add"), "{error}");
        }
    }
}
