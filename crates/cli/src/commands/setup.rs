//! The command `setup`: installs the tools of pinned versions by `scripts/setup.sh`, which this program has in it.

use std::process::{Command, Stdio};

use anyhow::{Context, Result};
use photoncube_testbench::setup_script;
use serde::Serialize;

use crate::args::SetupArgs;
use crate::failure::CheckFailed;
use crate::output;

#[derive(Serialize)]
struct Report {
    /// The folder of the programs from PyPI.
    tools: String,
}

/// Installs what is missing, unless only its place is asked for, and prints the folder of the programs from PyPI.
pub fn execute(args: &SetupArgs, json: bool) -> Result<()> {
    if !args.place {
        let mut script = setup_script()?;
        let options = [
            (args.synthesis, "--synthesis"),
            (args.asic, "--asic"),
            (args.ccache, "--ccache"),
            (args.book, "--book"),
        ];
        script.args(
            options
                .iter()
                .filter(|(is_asked, _)| *is_asked)
                .map(|(_, option)| option),
        );
        // The script says on standard error what it does.
        let status = script.stdout(Stdio::null()).status();
        let status = status.with_context(|| cannot_start(&script))?;
        if !status.success() {
            return Err(CheckFailed("the tools are not all installed".to_owned()).into());
        }
    }
    let mut script = setup_script()?;
    script.arg(if args.book { "--where-book" } else { "--where" });
    let output = script.stderr(Stdio::inherit()).output();
    let output = output.with_context(|| cannot_start(&script))?;
    if !output.status.success() {
        return Err(
            CheckFailed("the tools are not installed; leave out --where".to_owned()).into(),
        );
    }
    let said = String::from_utf8_lossy(&output.stdout);
    let tools = said.trim().to_owned();
    let report = Report { tools };
    output::print(json, &report, || format!("{}\n", report.tools))
}

fn cannot_start(script: &Command) -> String {
    format!("cannot start {}", script.get_program().display())
}
