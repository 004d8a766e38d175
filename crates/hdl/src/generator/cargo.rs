//! Builds a crate with cargo.

use std::ffi::OsString;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;

use serde::Deserialize;

use super::{GeneratorError, Step};

/// A line of cargo's standard output.
#[derive(Deserialize)]
struct Message {
    target: Option<Target>,
    executable: Option<PathBuf>,
}

#[derive(Deserialize)]
struct Target {
    name: String,
}

/// Builds the crate in `folder` and returns the path of its program. Everything that cargo compiles goes into `target`,
/// which all generators share.
pub(super) fn build(
    machine: &'static str,
    folder: &Path,
    target: &Path,
    progress: &mut dyn FnMut(&Step),
) -> Result<PathBuf, GeneratorError> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo"));
    let mut command = Command::new(&cargo);
    command
        .args([
            "build",
            "--release",
            "--message-format=json-render-diagnostics",
        ])
        .arg("--target-dir")
        .arg(target)
        .current_dir(folder)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    let mut child = command.spawn().map_err(|error| GeneratorError::NoCargo {
        machine,
        cargo: cargo.display().to_string(),
        reason: error.to_string(),
    })?;
    let (stdout, mut stderr) = (child.stdout.take(), child.stderr.take());
    let said = thread::spawn(move || {
        let mut said = String::new();
        stderr
            .as_mut()
            .map(|stderr| stderr.read_to_string(&mut said));
        said
    });
    let mut program = None;
    let lines = stdout
        .into_iter()
        .flat_map(|stdout| BufReader::new(stdout).lines());
    for line in lines.map_while(Result::ok) {
        let Ok(message) = serde_json::from_str::<Message>(&line) else {
            continue;
        };
        if let Some(target) = message.target {
            progress(&Step::Compiles(target.name));
        }
        program = message.executable.or(program);
    }
    let ended = child.wait();
    let said = said.join().unwrap_or_default();
    let not_built = |said: &str| GeneratorError::NotBuilt {
        machine,
        folder: folder.display().to_string(),
        said: last_lines(said),
    };
    match ended {
        Ok(status) if status.success() => program.ok_or_else(|| not_built("cargo made no program")),
        _ => Err(not_built(&said)),
    }
}

/// The last lines of cargo's output, where its errors are.
fn last_lines(said: &str) -> String {
    const MOST: usize = 30;
    let lines: Vec<_> = said.lines().collect();
    lines[lines.len().saturating_sub(MOST)..].join("\n")
}
