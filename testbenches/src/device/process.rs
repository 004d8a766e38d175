//! Runs a simulator as a separate process: frames are written to its standard input, answers are read from
//! its standard output.

use std::io::{BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::thread;

use super::DeviceError;
use crate::tools::{ToolError, program_of, tail};

/// The size of the read buffer in bytes. The buffers of the system's pipes are small.
const READ_BUFFER: usize = 1 << 18;

/// A running simulator process. It is ended when the value is dropped.
pub(crate) struct Process {
    device: &'static str,
    child: Child,
    stdin: Option<ChildStdin>,
    stdout: BufReader<ChildStdout>,
    stderr: std::path::PathBuf,
}

impl Process {
    /// Starts the process; its standard error is written to a file in `folder`.
    pub fn start(
        device: &'static str,
        command: &mut Command,
        folder: &Path,
    ) -> Result<Self, DeviceError> {
        let stderr = folder.join("stderr");
        let said = std::fs::File::create(&stderr).map_err(|source| DeviceError::File {
            action: "write",
            path: stderr.display().to_string(),
            source,
        })?;
        let command = command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(said);
        let mut child = command.spawn().map_err(|source| ToolError::NotStarted {
            program: program_of(command),
            source,
        })?;
        let stdin = child.stdin.take();
        let stdout = child.stdout.take().expect("standard output is piped");
        Ok(Self {
            device,
            child,
            stdin,
            stdout: BufReader::with_capacity(READ_BUFFER, stdout),
            stderr,
        })
    }

    /// Writes in a separate thread while `read` reads, so that neither side blocks the other through full
    /// pipes.
    pub fn converse<W, R>(&mut self, write: W, read: R) -> Result<(), DeviceError>
    where
        W: FnOnce(&mut ChildStdin) -> std::io::Result<()> + Send,
        R: FnOnce(&mut BufReader<ChildStdout>) -> std::io::Result<()>,
    {
        let stdin = self
            .stdin
            .as_mut()
            .expect("open until the process is dropped");
        let (stdout, child) = (&mut self.stdout, &mut self.child);
        let (written, read) = thread::scope(|scope| {
            let writer = scope.spawn(move || write(stdin).and_then(|()| stdin.flush()));
            let read = read(stdout);
            if read.is_err() {
                // `read` has ended, so the process may never read the rest. Its end releases the writer.
                let _ = child.kill();
            }
            (writer.join().expect("the writer does not panic"), read)
        });
        // A process that ended fails on both sides; its last output is in neither error.
        read.and(written).map_err(|error| self.broke_off(&error))
    }

    /// Closes the process's input and waits for its end.
    pub fn finish(&mut self) -> Result<(), DeviceError> {
        drop(self.stdin.take());
        let ended = self.child.wait().and_then(|status| match status.success() {
            true => Ok(()),
            false => Err(std::io::Error::other(status.to_string())),
        });
        ended.map_err(|error| self.broke_off(&error))
    }

    fn broke_off(&self, error: &std::io::Error) -> DeviceError {
        let said = std::fs::read(&self.stderr).unwrap_or_default();
        let said = tail(&said);
        let message = if said.is_empty() {
            error.to_string()
        } else {
            format!("{error}; it said:\n{said}")
        };
        DeviceError::BrokeOff {
            device: self.device.to_owned(),
            message,
        }
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        drop(self.stdin.take());
        // The process may be in the middle of an answer that is not needed any more.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
