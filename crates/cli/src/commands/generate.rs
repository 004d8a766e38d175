//! The command `generate`: writes the Verilog of the machines, or checks the committed Verilog.

use std::fs;
use std::path::Path;

use anyhow::{Result, bail};
use photoncube_spec::{MACHINES, Machine};
use rayon::prelude::*;
use serde::Serialize;

use crate::args::GenerateArgs;
use crate::digests::{self, ByMachine};
use crate::failure::CheckFailed;
use crate::machines::MachineArgs;
use crate::project::{self, ProjectFile};
use crate::{files, output, outputs};

#[derive(Serialize)]
struct Report {
    machines: Vec<&'static str>,
    out: String,
    checked: bool,
    files: Vec<String>,
    stale: Vec<String>,
}

/// Writes, or checks, the files of the machines.
pub fn execute(args: &GenerateArgs, json: bool) -> Result<()> {
    let machines = machines(args)?;
    // The folder is checked before the work, which takes half a minute for all machines.
    if !args.check {
        outputs::check_folder("--out", &args.out)?;
    } else if !args.out.is_dir() {
        bail!("{} is no folder: nothing to check", args.out.display());
    }
    let projects: Vec<_> = machines
        .par_iter()
        .map(|machine| project::project(machine))
        .collect::<Result<_>>()?;
    let digests = machines.iter().zip(&projects);
    let digests =
        digests.map(|(machine, project)| (machine.name.to_owned(), project.digests.clone()));
    let digests: ByMachine = digests.collect();
    let mut project_files: Vec<_> = projects.into_iter().flat_map(|p| p.files).collect();
    if args.machine.is_none() {
        project_files.push(ProjectFile {
            path: digests::FILE.into(),
            text: digests::text(&digests)?,
        });
    }
    let stale = if args.check {
        stale(&args.out, &machines, &project_files)
    } else {
        let texts = project_files.iter();
        files::write_all(texts.map(|file| (args.out.join(&file.path), file.text.as_bytes())))?;
        Vec::new()
    };
    let report = Report {
        machines: machines.iter().map(|machine| machine.name).collect(),
        out: args.out.display().to_string(),
        checked: args.check,
        files: paths(&project_files),
        stale,
    };
    output::print(json, &report, || text(&report))?;
    if report.stale.is_empty() {
        return Ok(());
    }
    Err(CheckFailed(format!(
        "{} of {} files are not what `photoncube generate` writes: {}; run it and review the change",
        report.stale.len(),
        report.files.len(),
        report.stale.join(", ")
    ))
    .into())
}

fn machines(args: &GenerateArgs) -> Result<Vec<&'static Machine>> {
    let Some(name) = &args.machine else {
        return Ok(MACHINES.iter().collect());
    };
    let selection = MachineArgs {
        machine: name.clone(),
        coordinate_bits: args.coordinate_bits,
        dimension: args.dimension,
    };
    Ok(vec![selection.find()?])
}

/// The files that differ or are missing, and the foreign files in a machine's folder.
fn stale(out: &Path, machines: &[&Machine], expected: &[ProjectFile]) -> Vec<String> {
    let differs = |file: &&ProjectFile| {
        let found = fs::read(out.join(&file.path)).ok();
        found.as_deref() != Some(file.text.as_bytes())
    };
    let mut stale: Vec<_> = expected.iter().filter(differs).map(path_text).collect();
    for machine in machines {
        let Ok(entries) = fs::read_dir(out.join(machine.name)) else {
            continue;
        };
        for entry in entries.flatten() {
            let path = Path::new(machine.name).join(entry.file_name());
            if !expected.iter().any(|file| file.path == path) {
                stale.push(format!("{} (not ours)", path.display()));
            }
        }
    }
    stale
}

fn paths(files: &[ProjectFile]) -> Vec<String> {
    files.iter().map(path_text).collect()
}

fn path_text(file: &ProjectFile) -> String {
    file.path.display().to_string()
}

fn text(report: &Report) -> String {
    let done = if report.checked { "checked" } else { "wrote" };
    format!(
        "{done} {} files of {} machines in {}: {}\n",
        report.files.len(),
        report.machines.len(),
        report.out,
        report.machines.join(", ")
    )
}
