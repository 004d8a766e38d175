//! A simulator that runs as a process of its own: frames go to its standard input, answers come
//! from its standard output.

use std::io::{BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::thread;

use super::DeviceError;
use crate::tools::{ToolError, program_of, tail};

/// What the system's pipes hold is small; this much is read at once.
const READ_BUFFER: usize = 1 << 18;

/// A running simulator. It ends with the value.
pub(crate) struct Process {
    device: &'static str,
    child: Child,
    stdin: Option<ChildStdin>,
    stdout: BufReader<ChildStdout>,
    stderr: std::path::PathBuf,
}

impl Process {
    /// Starts it; what it says on standard error is kept in `folder`.
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

    /// Writes in a thread of its own while `read` reads, so that neither side waits for the other
    /// with full pipes.
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
                // Nobody reads on, so the process may never take the rest: its end frees the
                // writer.
                let _ = child.kill();
            }
            (writer.join().expect("the writer does not panic"), read)
        });
        // A process that broke off fails both ways; what it said last is in neither.
        read.and(written).map_err(|error| self.broke_off(&error))
    }

    /// Ends its input and waits for its own end.
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
        // It may be in the middle of an answer that nobody wants; its end is all that counts.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
