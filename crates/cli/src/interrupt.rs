//! A signal that asks to stop, for work that has something to keep.

use std::process;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use anyhow::{Context, Result};

/// What a shell shows of a process that Ctrl-C ended.
const ENDED_BY_SIGNAL: i32 = 130;

/// Whether the user asked to stop: Ctrl-C, or SIGTERM.
#[derive(Clone, Debug)]
pub struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// Waits for the signals from now on. The first asks, a second one ends the process at once.
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

    /// Whether it was asked to stop.
    pub fn is_asked(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}
