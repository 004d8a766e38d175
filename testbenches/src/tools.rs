//! Finds the external tools and their versions; names the command that installs a missing tool.

use std::env;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::OnceLock;

use fpga_flow::Yosys;
use thiserror::Error;

use crate::setup::pinned_tools;

/// An external program that some device needs.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Tool {
    /// Icarus Verilog's compiler.
    Iverilog,
    /// Icarus Verilog's runtime.
    Vvp,
    /// Verilator, which translates Verilog to C++.
    Verilator,
    /// The C++ compiler for Verilator's output.
    Gxx,
    /// Make, which runs Verilator's build.
    Make,
    /// Yosys, for netlists, formal proofs and mutations.
    Yosys,
}

/// The error of a tool that is not on the PATH.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("`{program}` is not on the PATH; install it with `{}`", self.install())]
pub struct MissingTool {
    /// The name of the program.
    pub program: &'static str,
    /// The Debian package that contains the program.
    pub package: &'static str,
}

impl MissingTool {
    /// The command that installs the tool.
    pub fn install(&self) -> String {
        format!("sudo apt-get install -y {}", self.package)
    }
}

/// The error of a tool that is missing or failed.
#[derive(Debug, Error)]
pub enum ToolError {
    /// The tool is not on the PATH.
    #[error(transparent)]
    Missing(#[from] MissingTool),
    /// The tool could not be started.
    #[error("`{program}` did not start")]
    NotStarted {
        /// The name of the program.
        program: String,
        /// The error of the operating system.
        source: std::io::Error,
    },
    /// The tool ended with an error.
    #[error("`{program}` failed ({status}):\n{message}")]
    Failed {
        /// The name of the program.
        program: String,
        /// The exit status of the program.
        status: std::process::ExitStatus,
        /// The end of the tool's output.
        message: String,
    },
    /// The tool's output has no version.
    #[error("found no version in what `{program}` says: {said}")]
    NoVersion {
        /// The name of the program.
        program: String,
        /// Its output.
        said: String,
    },
}

impl Tool {
    /// The name of the tool's program.
    pub fn program(self) -> &'static str {
        match self {
            Self::Iverilog => "iverilog",
            Self::Vvp => "vvp",
            Self::Verilator => "verilator",
            Self::Gxx => "g++",
            Self::Make => "make",
            Self::Yosys => "yosys",
        }
    }

    fn package(self) -> &'static str {
        match self {
            Self::Iverilog | Self::Vvp => "iverilog",
            Self::Verilator => "verilator",
            Self::Gxx => "g++",
            Self::Make => "make",
            Self::Yosys => "yosys",
        }
    }

    /// The path of the tool's program.
    ///
    /// # Errors
    /// The tool is not on the PATH. The error has the command that installs it.
    pub fn find(self) -> Result<PathBuf, MissingTool> {
        let path = match self {
            Self::Yosys => find_yosys().ok().map(|yosys| yosys.path().to_owned()),
            _ => on_path(self.program()),
        };
        path.ok_or_else(|| self.missing())
    }

    fn missing(self) -> MissingTool {
        MissingTool {
            program: self.program(),
            package: self.package(),
        }
    }

    /// The first line of the tool's own version text; of Yosys the name and the version.
    ///
    /// # Errors
    /// The tool is missing or does not run.
    pub fn version(self) -> Result<String, ToolError> {
        let argument = match self {
            Self::Yosys => return Ok(format!("Yosys {}", yosys()?.version()?)),
            Self::Iverilog | Self::Vvp => "-V",
            Self::Verilator | Self::Gxx | Self::Make => "--version",
        };
        let output = output(Command::new(self.find()?).arg(argument))?;
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        Ok(text.lines().next().unwrap_or_default().trim().to_owned())
    }
}

/// The Yosys that every proof and every netlist is made with: the one of pinned version, or, where that is not
/// installed, one on the PATH.
///
/// # Errors
/// There is neither. The error has the command that installs one.
pub(crate) fn yosys() -> Result<Yosys, ToolError> {
    Ok(find_yosys()?)
}

/// The line of a script that makes plain assertions and assumptions of Yosys's `$check` cells, which its solver
/// does not take.
pub(crate) const LOWER: &str = "chformal -lower\n";

/// A script, one command a line, for this Yosys: without [`LOWER`] where it is older than the `$check` cells.
///
/// # Errors
/// Yosys does not start.
pub(crate) fn script_for(yosys: &Yosys, script: &str) -> Result<String, ToolError> {
    static KNOWN: OnceLock<bool> = OnceLock::new();
    let is_known = match KNOWN.get() {
        Some(known) => *known,
        None => {
            let help = yosys.help("chformal")?;
            *KNOWN.get_or_init(|| help.contains("-lower"))
        }
    };
    Ok(match is_known {
        true => script.to_owned(),
        false => script.replace(LOWER, ""),
    })
}

fn find_yosys() -> Result<Yosys, fpga_flow::ToolError> {
    Yosys::find(pinned_tools()).or_else(|_| Yosys::find(None))
}

impl From<fpga_flow::ToolError> for ToolError {
    fn from(error: fpga_flow::ToolError) -> Self {
        let name = |program: PathBuf| program.display().to_string();
        match error {
            fpga_flow::ToolError::Missing { .. } => Tool::Yosys.missing().into(),
            fpga_flow::ToolError::NotStarted { program, source } => Self::NotStarted {
                program: name(program),
                source,
            },
            fpga_flow::ToolError::Failed {
                program,
                status,
                said,
            } => Self::Failed {
                program: name(program),
                status,
                message: said,
            },
            fpga_flow::ToolError::NoVersion { program, said } => Self::NoVersion {
                program: name(program),
                said,
            },
        }
    }
}

/// The path of a program on the PATH; `None` where it is missing.
pub(crate) fn on_path(program: &str) -> Option<PathBuf> {
    let path = env::var_os("PATH")?;
    env::split_paths(&path)
        .map(|folder| folder.join(program))
        .find(|file| file.is_file())
}

/// Runs a command to its end and captures its output.
pub(crate) fn run(command: &mut Command) -> Result<(), ToolError> {
    let output = output(command)?;
    if output.status.success() {
        return Ok(());
    }
    let said = [output.stdout, output.stderr].concat();
    Err(ToolError::Failed {
        program: program_of(command),
        status: output.status,
        message: tail(&said),
    })
}

fn output(command: &mut Command) -> Result<Output, ToolError> {
    let output = command.stdin(Stdio::null()).output();
    output.map_err(|source| ToolError::NotStarted {
        program: program_of(command),
        source,
    })
}

pub(crate) fn program_of(command: &Command) -> String {
    let name = Path::new(command.get_program()).file_name();
    name.unwrap_or(OsStr::new("?")).to_string_lossy().into()
}

/// The end of a tool's output, which has the error message.
pub(crate) fn tail(said: &[u8]) -> String {
    const MOST: usize = 2_000;
    let text = String::from_utf8_lossy(said);
    let text = text.trim();
    let from = text.len().saturating_sub(MOST);
    let from = (from..=text.len()).find(|&at| text.is_char_boundary(at));
    text[from.unwrap_or(0)..].to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_tool_is_named_with_its_install_command() {
        let missing = MissingTool {
            program: Tool::Vvp.program(),
            package: Tool::Vvp.package(),
        };
        assert_eq!(
            missing.to_string(),
            "`vvp` is not on the PATH; install it with `sudo apt-get install -y iverilog`"
        );
        assert_eq!(on_path("no-such-tool-anywhere"), None);
    }

    #[test]
    fn the_tail_is_what_a_tool_said_last() {
        assert_eq!(tail(b" error: here \n"), "error: here");
        let long = [b"first".as_slice(), &[b'x'; 5_000], b"last"].concat();
        assert!(tail(&long).ends_with("last") && !tail(&long).contains("first"));
    }

    /// The pinned Yosys is a library; scripts/yosys.py is its command line.
    #[test]
    #[ignore = "needs Yosys: scripts/setup.sh installs it"]
    fn a_quiet_yosys_prints_its_warnings_and_errors_alone() {
        let folder = tempfile::tempdir().unwrap();
        let wrong = "module top(output a); assign a = b; endmodule\n";
        std::fs::write(folder.path().join("top.v"), wrong).unwrap();
        let yosys = yosys().unwrap();
        let warned = "top.v:1: Warning: Identifier `\\b' is implicitly declared.";
        let said = yosys.run(folder.path(), "read_verilog top.v").unwrap();
        assert_eq!(said.trim(), warned);
        let failed = yosys.run(folder.path(), "read_verilog top.v; no_command");
        let failed = failed.unwrap_err().to_string();
        for expected in [warned, "No such command: no_command"] {
            assert!(failed.contains(expected), "{failed}");
        }
    }
}
