//! A sequential machine with a microprogram of the user's, from a listing (docs/microprograms.md).

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, anyhow, bail};
use clap::Args;
use photoncube_hdl::most_steps;
use photoncube_spec::{
    MACHINES, Machine, Microprogram, OwnProgram, check_schedule, find_machine, parse_listing,
};

use crate::failure::CheckFailed;
use crate::machines;

/// Whose program a machine runs.
#[derive(Args, Clone, Debug)]
pub struct ProgramArgs {
    /// The sequential machine with the microprogram of this listing instead of its own (see docs/microprograms.md)
    #[arg(long, value_name = "FILE")]
    pub program: Option<PathBuf>,
}

impl ProgramArgs {
    /// The machine, with the program of the listing if one is asked for. Its Verilog can be emitted.
    ///
    /// # Errors
    /// The listing cannot be read, the schedule checker rejects it, or the machine cannot be built with it.
    pub fn apply(&self, machine: &'static Machine) -> Result<&'static Machine> {
        match &self.program {
            None => {
                machines::prepare(machine)?;
                Ok(machine)
            }
            Some(path) => programmed(machine, path),
        }
    }

    /// The options that choose the machine of that name with the program, for a command that repeats a run.
    pub fn options(&self, machine: &str) -> String {
        match &self.program {
            None => format!("--machine {machine}"),
            Some(path) => format!("--machine {machine} --program {}", path.display()),
        }
    }
}

/// Reads a listing.
///
/// # Errors
/// The file cannot be read, or is no listing.
pub fn read(path: &Path) -> Result<Microprogram> {
    let text = fs::read_to_string(path)
        .with_context(|| format!("cannot read the listing {}", path.display()))?;
    parse_listing(&text).map_err(|error| anyhow!("{}: {error}", path.display()))
}

fn programmed(machine: &'static Machine, path: &Path) -> Result<&'static Machine> {
    let most = most_steps(machine);
    if most == 0 {
        bail!(
            "--program: machine `{}` is not built with other programs; expected one of {}",
            machine.name,
            programmable().join(", ")
        );
    }
    let program = read(path)?;
    if let Err(error) = check_schedule(&program, machine.hypercube()) {
        let rejected = format!("{} is rejected: {error}", path.display());
        bail!(CheckFailed(rejected));
    }
    let clocks = program.steps().len();
    let own = OwnProgram::new(&program).filter(|_| clocks <= most);
    let own = own.with_context(|| {
        format!(
            "--program: {} takes {clocks} clocks in both phases, and the control store of machine `{}` holds {most}",
            path.display(),
            machine.name
        )
    })?;
    let label = label(path);
    let name = format!("{}{}{label}", machine.name, Machine::WITH_PROGRAM);
    if find_machine(&name).is_ok() {
        bail!(
            "--program: there is a machine `{name}` already; rename {}",
            path.display()
        );
    }
    let summary = format!("{}; the microprogram is `{label}`", machine.summary);
    // The parts of a machine are 'static, and a command makes one such machine.
    let named = Machine {
        name: name.leak(),
        summary: summary.leak(),
        ..machine.with_program(own)
    };
    Ok(Box::leak(Box::new(named)))
}

/// The machines that are built with any program.
fn programmable() -> Vec<&'static str> {
    let built = MACHINES.iter().filter(|machine| most_steps(machine) > 0);
    built.map(|machine| machine.name).collect()
}

/// The name of a program in the names of machines and modules: that of the file, in small letters, digits and `-`.
fn label(path: &Path) -> String {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let stem = stem.to_ascii_lowercase();
    let words = stem.split(|c: char| !c.is_ascii_alphanumeric());
    let words: Vec<_> = words.filter(|word| !word.is_empty()).collect();
    match words.is_empty() {
        true => "own".to_owned(),
        false => words.join("-"),
    }
}

#[cfg(test)]
mod tests {
    use std::process::ExitCode;

    use photoncube_hdl::{Level, emit};

    use super::*;
    use crate::failure::exit_code;

    fn apply(machine: &str, file: &str, listing: &str) -> Result<&'static Machine> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(file);
        fs::write(&path, listing).unwrap();
        let program = Some(path);
        ProgramArgs { program }.apply(find_machine(machine).unwrap())
    }

    /// The Verilog without comments, under the module names of the machine `name`.
    fn modules(machine: &Machine, name: &str) -> String {
        let text = emit(machine, Level::Machine).unwrap().text;
        let of_code = text
            .lines()
            .filter(|line| !line.trim_start().starts_with("//"));
        let code: Vec<_> = of_code.collect();
        let own = machine.module_prefix();
        code.join("\n")
            .replace(&own, &photoncube_spec::module_prefix(name))
    }

    #[test]
    fn a_machine_with_its_own_listing_is_the_machine() {
        for name in programmable() {
            let machine = find_machine(name).unwrap();
            let listing = machine.microprogram().unwrap().to_string();
            let own = apply(name, "own.txt", &listing).unwrap();
            assert_eq!(own.name, format!("{name}-program-own"));
            assert_eq!(modules(own, name), modules(machine, name));
        }
        let listing = find_machine("paper").unwrap().microprogram().unwrap();
        let longer = listing.to_string().replace("   8  acc", "   9  acc");
        let longer = apply("paper", "Longer one.txt", &longer).unwrap();
        assert_eq!(longer.name, "paper-program-longer-one");
        let paper = find_machine("paper").unwrap();
        assert_ne!(modules(longer, "paper"), modules(paper, "paper"));
    }

    #[test]
    fn what_cannot_be_built_is_refused_with_the_reason() {
        let listing = |name: &str| {
            let machine = find_machine(name).unwrap();
            machine.microprogram().unwrap().to_string()
        };
        let (paper, local) = (listing("paper"), listing("local"));
        let too_late = local.replace("   8  acc", "  15  acc");
        let no_gate = paper.replace("   5  gate", "   5  nop");
        let (usage, failed) = (ExitCode::from(2), ExitCode::from(1));
        for (machine, listing, code, expected) in [
            (
                "stream",
                &paper,
                usage,
                "machine `stream` is not built with other programs; expected one of paper, ",
            ),
            (
                "sequential-local6x2-rgb4d-n4096",
                &paper,
                usage,
                "is not built with other programs",
            ),
            (
                "local",
                &too_late,
                usage,
                "own.txt takes 17 clocks in both phases, and the control store of machine `local` holds 16",
            ),
            (
                "paper",
                &no_gate,
                failed,
                "own.txt is rejected: iteration clock 6",
            ),
            (
                "paper-5d",
                &paper,
                failed,
                "own.txt is rejected: iteration clock",
            ),
            (
                "paper",
                &paper.replace("gate", "gaet"),
                usage,
                "own.txt: line 9: found `gaet`",
            ),
        ] {
            let error = apply(machine, "own.txt", listing).unwrap_err();
            let said = crate::failure::message(&error);
            assert!(said.contains(expected), "{machine}: {said}");
            assert_eq!(exit_code(&error), code, "{machine}: {said}");
        }
    }

    #[test]
    fn the_page_about_listings_has_todays_control_stores() {
        let row = |name| {
            format!(
                "| `{name}` | {} |\n",
                most_steps(find_machine(name).unwrap())
            )
        };
        let rows: String = programmable().into_iter().map(row).collect();
        let table = format!("| machine | words |\n|---|---|\n{rows}\n");
        let page = include_str!("../../../docs/microprograms.md");
        assert!(
            page.contains(&table),
            "docs/microprograms.md lacks:\n{table}"
        );
    }

    #[test]
    fn a_name_is_made_of_any_file_name() {
        for (file, expected) in [
            ("fast.txt", "fast"),
            ("a/My Program_2.txt", "my-program-2"),
            ("-.txt", "own"),
            ("", "own"),
        ] {
            assert_eq!(label(Path::new(file)), expected);
        }
    }
}
