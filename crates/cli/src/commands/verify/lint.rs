//! The method `lint`: every statement of a machine that rust-hdl generates means in Verilog what it means in Rust.

use anyhow::Result;
use clap::Args;
use photoncube_hdl::{Linted, lint_control, lint_machine};
use photoncube_testbench::{Control, Controls, Tool};
use serde_json::json;

use super::method::Method;
use super::outcome::Outcome;
use crate::machines::MachineArgs;
use crate::verified::Line;

/// See [`Method::ABOUT`].
#[derive(Args, Debug)]
pub struct Lint {
    #[command(flatten)]
    machine: MachineArgs,
}

impl Method for Lint {
    const NAME: &'static str = "lint";
    const ABOUT: &'static str = "Check that every statement of the machine which rust-hdl generates means in Verilog \
        what it means in Rust";
    const EXAMPLES: &'static [&'static str] = &["photoncube verify lint --machine stream"];

    fn tools(&self) -> Vec<Tool> {
        Vec::new()
    }

    fn run(&self) -> Result<Outcome> {
        let machine = self.machine.find_to_emit()?;
        let Linted {
            generated,
            registers,
            hand_written,
            findings,
        } = lint_machine(machine)?;
        let control = Control {
            planted: "a sum whose carry rust-hdl loses and Verilog keeps".to_owned(),
            found: lint_control(),
        };
        let details = json!({
            "machine": machine.name,
            "generated_blocks": generated,
            "library_registers": registers,
            "hand_written_blocks": hand_written,
        });
        let line = Line {
            by: format!("photoncube {}", env!("CARGO_PKG_VERSION")),
            volume: generated as u64,
            unit: "generated blocks".to_owned(),
            result: format!("{} findings; the planted mistake found", findings.len()),
            command: format!("photoncube verify lint --machine {}", machine.name),
            ..Line::of_machine(machine.name)?
        };
        let counts = format!(
            "{}: {generated} blocks with generated statements, {registers} registers of the library, {hand_written} \
             blocks written by hand",
            machine.name
        );
        Ok(Outcome::new::<Self>(Controls::new(control, []), &details)?
            .note(counts)
            .lines([line])
            .findings(findings))
    }
}
