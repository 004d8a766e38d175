//! Work that must come to an end.

use std::process;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::Duration;

/// A thousand times what the slowest input takes, so that a busy machine is not taken for a hang.
const LIMIT: Duration = Duration::from_secs(60);

/// Looks after one thread.
pub struct Watch {
    tell: Sender<Event>,
}

enum Event {
    Begins(u64),
    Ends,
}

impl Watch {
    /// A watch that names `what` hangs. As a thread cannot be stopped, the process ends then, as of a check that failed.
    pub fn new(what: &'static str) -> Self {
        let (tell, told) = channel();
        thread::spawn(move || {
            let mut running = None;
            loop {
                match told.recv_timeout(LIMIT) {
                    Ok(Event::Begins(index)) => running = Some(index),
                    Ok(Event::Ends) => running = None,
                    Err(RecvTimeoutError::Disconnected) => return,
                    Err(RecvTimeoutError::Timeout) => {
                        if let Some(index) = running {
                            eprintln!(
                                "error: {what}: input {index} takes over {} s",
                                LIMIT.as_secs()
                            );
                            process::exit(1);
                        }
                    }
                }
            }
        });
        Self { tell }
    }

    /// Does the work of an index.
    pub fn during<T>(&self, index: u64, work: impl FnOnce() -> T) -> T {
        // The watching thread ends with this value, not before.
        let _ = self.tell.send(Event::Begins(index));
        let done = work();
        let _ = self.tell.send(Event::Ends);
        done
    }
}
