//! Watches for work that does not end.

use std::process;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::Duration;

/// The time limit, a thousand times that of the slowest input, so that a busy computer is not mistaken for a
/// hang.
const LIMIT: Duration = Duration::from_secs(60);

/// Watches the work of one thread.
pub struct Watch {
    tell: Sender<Event>,
}

enum Event {
    Begins(u64),
    Ends,
}

impl Watch {
    /// A watch that reports a hang of `what`. A thread cannot be stopped, so the process then ends with the
    /// exit code of a failed check.
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

    /// Does the work of index `index` under the watch.
    pub fn during<T>(&self, index: u64, work: impl FnOnce() -> T) -> T {
        // The watching thread ends when this value is dropped, not before.
        let _ = self.tell.send(Event::Begins(index));
        let done = work();
        let _ = self.tell.send(Event::Ends);
        done
    }
}
