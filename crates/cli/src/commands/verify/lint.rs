//! `verify --lint`: every statement of a machine that rust-hdl generates means in Verilog what it means in Rust.

use anyhow::Result;
use photoncube_hdl::{Linted, lint_control, lint_machine};
use photoncube_spec::Machine;
use serde::Serialize;

use crate::args::VerifyArgs;
use crate::failure::CheckFailed;
use crate::output;
use crate::verified::{Line, record};

#[derive(Serialize)]
struct Report {
    machine: &'static str,
    /// Blocks whose statements are generated, and so were read.
    generated_blocks: usize,
    library_registers: usize,
    hand_written_blocks: usize,
    findings: Vec<String>,
    /// Whether the lint found the mistake in a block with a planted one, and nothing else there.
    control_found: bool,
}

impl Report {
    fn of(machine: &Machine) -> Result<Self> {
        let Linted {
            generated,
            registers,
            hand_written,
            findings,
        } = lint_machine(machine)?;
        Ok(Self {
            machine: machine.name,
            generated_blocks: generated,
            library_registers: registers,
            hand_written_blocks: hand_written,
            findings,
            control_found: lint_control(),
        })
    }
}

/// Lints a machine, and a block with a planted mistake beside it.
pub fn execute(args: &VerifyArgs, json: bool) -> Result<()> {
    let report = Report::of(args.machine.find()?)?;
    output::print(json, &report, || text(&report))?;
    verdict(&report)?;
    match &args.record {
        Some(path) => record(path, &[line(&report)?]),
        None => Ok(()),
    }
}

/// Nothing read is no pass, nor is a control that is not found.
fn verdict(report: &Report) -> Result<()> {
    let wrong = if !report.findings.is_empty() {
        format!("the lint found {}", report.findings.join("\n"))
    } else if report.generated_blocks == 0 {
        "the lint read no block".to_owned()
    } else if !report.control_found {
        "the lint is wrong: it did not find the planted mistake, and that alone, in the control"
            .to_owned()
    } else {
        return Ok(());
    };
    Err(CheckFailed(wrong).into())
}

fn line(report: &Report) -> Result<Line> {
    Ok(Line {
        method: "lint".to_owned(),
        by: format!("photoncube {}", env!("CARGO_PKG_VERSION")),
        volume: report.generated_blocks as u64,
        unit: "generated blocks".to_owned(),
        result: format!(
            "{} findings; the planted mistake found",
            report.findings.len()
        ),
        command: format!("photoncube verify --lint --machine {}", report.machine),
        ..Line::of_machine(report.machine)?
    })
}

fn text(report: &Report) -> String {
    let mut text = format!(
        "{}: {} blocks with generated statements, {} registers of the library, {} blocks written by hand\n",
        report.machine,
        report.generated_blocks,
        report.library_registers,
        report.hand_written_blocks
    );
    for finding in &report.findings {
        text += &format!("{finding}\n");
    }
    let control = if report.control_found {
        "found"
    } else {
        "not found"
    };
    text + &format!(
        "{} findings; the planted mistake {control}\n",
        report.findings.len()
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use photoncube_spec::MACHINES;

    #[test]
    fn a_finding_a_missed_control_and_nothing_read_fail() {
        let report = || Report::of(&MACHINES[0]).unwrap();
        verdict(&report()).unwrap();
        let failed = |report: Report| verdict(&report).unwrap_err().to_string();
        let mut found = report();
        found.findings.push("top$cell: CastOfExpression".to_owned());
        assert!(failed(found).contains("top$cell"));
        let mut missed = report();
        missed.control_found = false;
        assert!(failed(missed).contains("did not find the planted mistake"));
        let mut empty = report();
        empty.generated_blocks = 0;
        assert!(failed(empty).contains("no block"));
    }
}
