//! The method `--formal`: proofs about the emitted Verilog, for all inputs.

use anyhow::Result;
use photoncube_testbench::{Formal, Proof, formal};

use crate::args::VerifyArgs;
use crate::failure::CheckFailed;
use crate::verified::{Line, record};
use crate::{output, progress, table};

/// Proves the properties of one machine.
pub fn execute(args: &VerifyArgs, json: bool) -> Result<()> {
    let machine = args.machine.find()?;
    let prefix = args.property.as_deref().unwrap_or_default();
    let bar = progress::bar("formal", 0);
    let found = formal(machine, &|name| name.starts_with(prefix), &|done, of| {
        bar.set_length(of as u64);
        bar.set_position(done as u64);
    })?;
    bar.finish_and_clear();
    output::print(json, &found, || text(&found))?;
    verdict(&found)?;
    match &args.record {
        Some(path) => record(path, &lines(&found)?),
        None => Ok(()),
    }
}

fn verdict(found: &Formal) -> Result<()> {
    let failed: Vec<_> = found.failed().map(said).collect();
    if failed.is_empty() && !found.proofs.is_empty() {
        return Ok(());
    }
    let message = format!(
        "{} of {} properties of {} do not hold, or their checks do not:\n{}",
        failed.len(),
        found.proofs.len(),
        found.machine,
        failed.join("\n")
    );
    Err(CheckFailed(message).into())
}

fn said(proof: &Proof) -> String {
    let why = proof
        .not_proven_because
        .as_deref()
        .unwrap_or("nothing was said");
    format!("{}: {why}", proof.property)
}

/// One line for each method of proof.
fn lines(found: &Formal) -> Result<Vec<Line>> {
    let machine = Line::of_machine(found.machine)?;
    let mut methods: Vec<_> = found.proofs.iter().map(|proof| proof.method).collect();
    methods.sort_unstable();
    methods.dedup();
    let line = |method: &str| {
        let of_method: Vec<_> = found
            .proofs
            .iter()
            .filter(|proof| proof.method == method)
            .collect();
        let proven = of_method.iter().filter(|proof| proof.holds()).count();
        Line {
            method: format!("formal, by {method}"),
            by: match method {
                // Run in the testbench's evaluator of the emitted text.
                "exhaustive" => format!("photoncube {}", env!("CARGO_PKG_VERSION")),
                _ => found.tool_version.clone(),
            },
            volume: of_method.len() as u64,
            unit: match method {
                "equivalence" => "modules against their netlists".to_owned(),
                _ => "properties".to_owned(),
            },
            result: format!("{proven} proven, their planted faults refuted"),
            command: format!("photoncube verify --formal --machine {}", found.machine),
            ..machine.clone()
        }
    };
    Ok(methods.into_iter().map(line).collect())
}

fn text(found: &Formal) -> String {
    let header = [
        "property", "module", "method", "depth", "proven", "cover", "faults", "seconds",
    ];
    let yes = |holds, yes: &str, no: &str| if holds { yes } else { no }.to_owned();
    let row = |proof: &Proof| {
        vec![
            proof.property.clone(),
            proof.module.clone(),
            proof.method.to_owned(),
            proof.depth.to_string(),
            yes(proof.proven, "proven", "NOT PROVEN"),
            match proof.cover_reached {
                Some(reached) => yes(reached, "reached", "NOT REACHED"),
                None => "nothing assumed".to_owned(),
            },
            yes(proof.control_refuted, "refuted", "NOT REFUTED"),
            format!("{:.1}", proof.seconds),
        ]
    };
    let rows: Vec<_> = found.proofs.iter().map(row).collect();
    let holds = found.proofs.iter().filter(|proof| proof.holds()).count();
    table::markdown(&header, &rows)
        + &format!(
            "{}: {holds} of {} properties hold\n",
            found.machine,
            found.proofs.len()
        )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(proofs: Vec<Proof>) -> Formal {
        Formal {
            machine: "paper",
            tool_version: "yosys".to_owned(),
            proofs,
        }
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
        assert!(verdict(&found(vec![sound.clone()])).is_ok());
        assert!(verdict(&found(vec![])).is_err());
        let wrong: [fn(&mut Proof); 3] = [
            |proof| proof.proven = false,
            |proof| proof.cover_reached = Some(false),
            |proof| proof.control_refuted = false,
        ];
        for make_wrong in wrong {
            let mut proof = sound.clone();
            make_wrong(&mut proof);
            let error = verdict(&found(vec![proof])).unwrap_err().to_string();
            assert!(error.contains("units::add"), "{error}");
        }
    }
}
