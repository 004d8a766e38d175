//! The command `generate`: writes the Verilog of the machines, or checks the committed Verilog.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Result, bail};
use photoncube_hdl::{Level, emit};
use photoncube_spec::{
    CORES, Core, MACHINES, Machine, RECORDED_CORES, custom_machine, find_machine,
    find_photon_format,
};
use rayon::prelude::*;
use serde::Serialize;

use crate::args::GenerateArgs;
use crate::digests::{self, ByMachine, Digests};
use crate::failure::CheckFailed;
use crate::machines::{self, MachineArgs};
use crate::narrow::narrow;
use crate::project::{self, ProjectFile};
use crate::{files, output, outputs};

/// One machine of each organisation, one of more than one engine, one with photon memory, and a core: their Verilog is
/// committed in full, to be reviewed as a change of text. The others are committed as [`SUMS`].
const IN_FULL: [&str; 6] = [
    "paper",
    "overlap",
    "stream",
    "tile-5",
    "tile-6-mixed",
    "core-3-leaf-5-local7-rgb6d-n64",
];

/// The SHA-256 digests of the files of all machines, in the form that `sha256sum --check` reads.
const SUMS: &str = "SHA256SUMS";

#[derive(Serialize)]
struct Report {
    machines: Vec<String>,
    out: String,
    checked: bool,
    files: Vec<String>,
    by_digest: Vec<&'static str>,
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
    if let Some(chains) = args.chains {
        return core(args, &machines, chains, json);
    }
    let mut projects: Vec<_> = machines
        .par_iter()
        .map(|machine| project::project(machine))
        .collect::<Result<_>>()?;
    let is_all = args.machine.is_none() && args.format.is_none() && args.program.program.is_none();
    let mut designs: Vec<_> = machines.iter().map(|m| m.name.to_owned()).collect();
    if is_all {
        for core in cores(&CORES)? {
            designs.push(core.name());
            projects.push(project::core_project(&core)?);
        }
    }
    let digests = designs.iter().cloned().zip(&projects);
    let digests = digests.map(|(design, project)| (design, project.digests.clone()));
    let mut digests: ByMachine = digests.collect();
    let mut project_files: Vec<_> = projects.into_iter().flat_map(|p| p.files).collect();
    let mut by_digest = Vec::new();
    if is_all {
        let sums = sums(&project_files);
        if args.check {
            by_digest = absent(&args.out);
            let is_there = |file: &ProjectFile| !by_digest.iter().any(|m| file.path.starts_with(m));
            project_files.retain(is_there);
        }
        project_files.push(sums);
        for core in cores(&RECORDED_CORES)? {
            digests.insert(core.name(), project::core_project(&core)?.digests);
        }
        for &(_, machine) in CORES.iter().chain(&RECORDED_CORES) {
            let design = emit(find_machine(machine)?, Level::Machine)?;
            digests.insert(machine.to_owned(), Digests::of(&design));
        }
        project_files.push(ProjectFile {
            path: digests::FILE.into(),
            text: digests::text(&digests)?,
        });
    }
    finish(args, designs, &project_files, by_digest, json)
}

/// The cores of these chains and machines. Their machines' generators are built.
fn cores(of: &[(u32, &str)]) -> Result<Vec<Core>> {
    let core = |&(chains, machine): &(u32, &str)| {
        let core = Core::new(find_machine(machine)?, chains)?;
        machines::prepare(core.machine)?;
        Ok(core)
    };
    of.iter().map(core).collect()
}

/// Writes, or checks, the files of a core.
fn core(args: &GenerateArgs, machines: &[&'static Machine], chains: u32, json: bool) -> Result<()> {
    let &[machine] = machines else {
        bail!("--chains needs one machine: --machine, or --format and --organisation");
    };
    let core = Core::new(machine, chains)?;
    let files = project::core_project(&core)?.files;
    finish(args, vec![core.name()], &files, Vec::new(), json)
}

/// Writes or checks the files of the designs of these names, and reports them.
fn finish(
    args: &GenerateArgs,
    designs: Vec<String>,
    project_files: &[ProjectFile],
    by_digest: Vec<&'static str>,
    json: bool,
) -> Result<()> {
    let stale = if args.check {
        Stale::of(&args.out, &designs, project_files)
    } else {
        let texts = project_files.iter();
        files::write_all(texts.map(|file| (args.out.join(&file.path), file.text.as_bytes())))?;
        Stale::default()
    };
    let report = Report {
        machines: designs,
        out: args.out.display().to_string(),
        checked: args.check,
        files: paths(project_files),
        by_digest,
        stale: stale.lines(),
    };
    output::print(json, &report, || narrow(&text(&report)))?;
    match stale.message(&args.out, report.files.len()) {
        None => Ok(()),
        Some(message) => Err(CheckFailed(message).into()),
    }
}

fn machines(args: &GenerateArgs) -> Result<Vec<&'static Machine>> {
    if let (Some(organisation), Some(format)) = (args.organisation, &args.format) {
        let machine = custom_machine(organisation, &find_photon_format(format)?)?;
        machines::prepare(machine)?;
        return Ok(vec![machine]);
    }
    let default = args.program.program.as_ref().map(|_| MACHINES[0].name);
    let Some(name) = args.machine.as_deref().or(default) else {
        return Ok(MACHINES.iter().collect());
    };
    let selection = MachineArgs {
        machine: name.to_owned(),
        coordinate_bits: args.coordinate_bits,
        dimension: args.dimension,
    };
    Ok(vec![args.program.apply(selection.find()?)?])
}

/// The machines that have no folder and need none, because the digests of their files are checked.
fn absent(out: &Path) -> Vec<&'static str> {
    let names = MACHINES.iter().map(|machine| machine.name);
    let others = names.filter(|name| !IN_FULL.contains(name));
    others.filter(|name| !out.join(name).exists()).collect()
}

/// The file of digests, in the order of the paths.
fn sums(files: &[ProjectFile]) -> ProjectFile {
    let line =
        |file: &ProjectFile| format!("{}  {}\n", digests::of_file(&file.text), path_text(file));
    let mut sorted: Vec<_> = files.iter().collect();
    sorted.sort_by(|a, b| a.path.cmp(&b.path));
    ProjectFile {
        path: PathBuf::from(SUMS),
        text: sorted.into_iter().map(line).collect(),
    }
}

/// What a check finds in the folder.
#[derive(Default)]
struct Stale {
    /// The files that differ or are missing.
    differ: Vec<String>,
    /// The files in a machine's folder that neither the generator nor the machine's Yosys script writes.
    foreign: Vec<String>,
}

impl Stale {
    fn of(out: &Path, designs: &[String], expected: &[ProjectFile]) -> Self {
        let differs = |file: &&ProjectFile| {
            let found = fs::read(out.join(&file.path)).ok();
            found.as_deref() != Some(file.text.as_bytes())
        };
        let mut found = Self {
            differ: expected.iter().filter(differs).map(path_text).collect(),
            foreign: Vec::new(),
        };
        for design in designs {
            let Ok(entries) = fs::read_dir(out.join(design)) else {
                continue;
            };
            let of_yosys = project::written_by_yosys(design);
            for entry in entries.flatten() {
                let path = Path::new(design).join(entry.file_name());
                if !expected.iter().any(|file| file.path == path) && !of_yosys.contains(&path) {
                    found.foreign.push(format!("{} (not ours)", path.display()));
                }
            }
        }
        found
    }

    fn lines(&self) -> Vec<String> {
        self.differ.iter().chain(&self.foreign).cloned().collect()
    }

    /// What is wrong and what to do; `None` where nothing is. `files` is the number of files expected.
    fn message(&self, out: &Path, files: usize) -> Option<String> {
        let differ = (!self.differ.is_empty()).then(|| {
            format!(
                "{} of {files} files are not what `photoncube generate` writes: {}; run it and review the change",
                self.differ.len(),
                self.differ.join(", ")
            )
        });
        let foreign = (!self.foreign.is_empty()).then(|| {
            format!(
                "{} holds what `photoncube generate` does not write: {}; delete it",
                out.display(),
                self.foreign.join(", ")
            )
        });
        let parts: Vec<_> = differ.into_iter().chain(foreign).collect();
        (!parts.is_empty()).then(|| parts.join("\n"))
    }
}

fn paths(files: &[ProjectFile]) -> Vec<String> {
    files.iter().map(path_text).collect()
}

fn path_text(file: &ProjectFile) -> String {
    file.path.display().to_string()
}

fn text(report: &Report) -> String {
    let done = if report.checked { "checked" } else { "wrote" };
    let machines = match report.machines.len() {
        1 => "1 machine".to_owned(),
        several => format!("{several} machines"),
    };
    let mut text = format!(
        "{done} {} files of {machines} in {}: {}\n",
        report.files.len(),
        report.out,
        report.machines.join(", ")
    );
    if !report.by_digest.is_empty() {
        text += &format!(
            "by {SUMS} alone, {} machines without a folder: {}\n",
            report.by_digest.len(),
            report.by_digest.join(", ")
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(path: &str, text: &str) -> ProjectFile {
        ProjectFile {
            path: path.into(),
            text: text.to_owned(),
        }
    }

    #[test]
    fn the_sums_are_lines_of_sha256sum_by_path() {
        let files = [file("b/x.v", "photon\n"), file("a/y.v", "")];
        let lines: Vec<_> = files
            .iter()
            .map(|file| format!("{}  {}\n", digests::of_file(&file.text), path_text(file)))
            .collect();
        assert_eq!(sums(&files).text, format!("{}{}", lines[1], lines[0]));
    }

    #[test]
    fn what_yosys_left_behind_is_no_finding_and_a_foreign_file_is_to_be_deleted() {
        let out = tempfile::tempdir().unwrap();
        let folder = out.path().join("paper");
        fs::create_dir(&folder).unwrap();
        for ending in ["v", "json", "stat"] {
            fs::write(folder.join(format!("photoncube_paper.{ending}")), "x").unwrap();
        }
        let expected = [file("paper/photoncube_paper.v", "x")];
        let check = || Stale::of(out.path(), &["paper".to_owned()], &expected);
        assert_eq!(check().message(out.path(), 1), None);
        fs::write(folder.join("photoncube_paper.v"), "y").unwrap();
        fs::write(folder.join("notes.json"), "").unwrap();
        let message = check().message(out.path(), 1).unwrap();
        let lines: Vec<_> = message.lines().collect();
        assert!(lines[0].ends_with("photoncube_paper.v; run it and review the change"));
        assert!(
            lines[1].ends_with("paper/notes.json (not ours); delete it"),
            "{message}"
        );
        assert_eq!(
            check().lines(),
            ["paper/photoncube_paper.v", "paper/notes.json (not ours)"]
        );
    }

    #[test]
    fn only_a_machine_that_is_not_reviewed_in_full_may_lack_its_folder() {
        let out = tempfile::tempdir().unwrap();
        let others = MACHINES.len() + CORES.len() - IN_FULL.len();
        assert_eq!(absent(out.path()).len(), others);
        fs::create_dir(out.path().join("tile-10")).unwrap();
        let absent = absent(out.path());
        assert_eq!(absent.len(), others - 1);
        assert!(!absent.contains(&"tile-10") && !absent.contains(&"paper"));
    }

    #[test]
    fn the_machines_in_full_are_those_that_git_keeps() {
        let ignored = include_str!("../../../../hdl-out/.gitignore");
        for name in IN_FULL {
            assert!(
                ignored.lines().any(|line| line == format!("!/{name}/")),
                "{name}"
            );
        }
        let kept = ignored.lines().filter(|line| line.starts_with("!/"));
        assert_eq!(kept.count(), IN_FULL.len());
    }
}
