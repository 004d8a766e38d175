//! Signals that ask the program to stop, for commands that must store their results first.

use std::process;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use anyhow::{Context, Result};

/// The exit code that a shell shows for a process that Ctrl-C ended.
const ENDED_BY_SIGNAL: i32 = 130;

/// Whether the user asked the program to stop, by Ctrl-C or SIGTERM.
#[derive(Clone, Debug)]
pub struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// Watches for the signals from now on. The first sets the flag, a second one ends the process at once.
    pub fn watch() -> Result<Self> {
        let interrupt = Self(Arc::default());
        let asked = interrupt.0.clone();
        ctrlc::set_handler(move || {
            if asked.swap(true, Ordering::Relaxed) {
                process::exit(ENDED_BY_SIGNAL);
            }
            eprintln!(
                "\nstops after this pass; a second signal ends it at once, and nothing is written"
            );
        })
        .context("cannot wait for signals")?;
        Ok(interrupt)
    }

    /// Whether the program was asked to stop.
    pub fn is_asked(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}
