//! The method `fuzz`: gives nearly correct inputs to everything that reads user input. A reader must accept
//! or refuse each, and must never panic, hang or take unbounded memory.
//!
//! Input number I of a reader depends only on the seed and I, so each input can be reproduced.

mod memory;
mod mutate;
mod readers;
mod watch;

use std::any::Any;
use std::panic::{self, AssertUnwindSafe};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use anyhow::{Context, Result, bail};
use clap::Args;
use photoncube_spec::did_you_mean;
use photoncube_testbench::{Control, Controls, Tool};
use rand::SeedableRng;
use rand_pcg::Pcg64;
use serde::Serialize;
use serde_json::json;

use self::readers::{Input, Open, PLANTED, READERS, Reader};
use self::watch::Watch;
use super::method::Method;
use super::options::SeedArgs;
use super::outcome::Outcome;
use crate::args::count;
use crate::progress;
use crate::verified::Line;

/// The number of inputs that a thread takes at a time.
const BATCH: u64 = 100;

/// The most MiB by which memory may grow while a reader runs. The readers' own inputs and results are far
/// below it; a size that an input states without having the data is far above.
const MEMORY_BOUND_MIB: u64 = 512;

/// The most failures that are reported for a reader, because many may have one cause.
const TOLD: usize = 5;

/// The results for a reader's inputs.
#[derive(Debug, Serialize)]
struct Fuzzed {
    reader: &'static str,
    reads: &'static str,
    inputs: u64,
    inputs_read: u64,
    inputs_refused: u64,
    /// The growth of memory in MiB, where the system reports it.
    memory_mib: Option<u64>,
    failures: Vec<Failure>,
}

/// An input that broke a reader.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
struct Failure {
    /// The number of the input.
    index: u64,
    /// The message of the failure.
    message: String,
    /// The command that repeats the failure and prints the input.
    command: String,
}

/// See [`Method::ABOUT`].
#[derive(Args, Clone, Debug)]
pub struct Fuzz {
    /// How many inputs for each reader
    #[arg(value_name = "N", value_parser = count(1..=(1_u64 << 39) - 1))]
    inputs: u64,
    /// Only the reader of that name
    #[arg(long, value_name = "NAME")]
    reader: Option<String>,
    /// Begin with that input
    #[arg(long, default_value_t = 0, value_name = "I", value_parser = count(0..=(1_u64 << 39) - 1))]
    from: u64,
    #[command(flatten)]
    seed: SeedArgs,
}

impl Method for Fuzz {
    const NAME: &'static str = "fuzz";
    const ABOUT: &'static str = "Give everything that reads scenes, meshes, listings, pictures, tables and command lines N \
        inputs that are nearly right: it must read or refuse them, and never panic, hang or take memory without bound";
    const EXAMPLES: &'static [&'static str] = &[
        "photoncube verify fuzz 100000",
        "photoncube verify fuzz 1 --reader listing --from 7",
    ];

    fn tools(&self) -> Vec<Tool> {
        Vec::new()
    }

    fn run(&self) -> Result<Outcome> {
        let chosen = chosen(self.reader.as_deref())?;
        let controls = Controls::new(control()?, []);
        let readers = chosen.into_iter().map(|reader| fuzz(reader, self));
        let readers: Vec<_> = readers.collect::<Result<_>>()?;
        let details = json!({ "seed": self.seed.seed, "readers": readers });
        let failures = readers.iter().flat_map(|fuzzed| &fuzzed.failures);
        Ok(Outcome::new::<Self>(controls, &details)?
            .rows("readers", COLUMNS)
            .lines(readers.iter().map(|fuzzed| self.line(fuzzed)))
            .findings(failures.map(|f| format!("{}\n  repeat    {}", f.message, f.command))))
    }
}

/// The columns of the table.
const COLUMNS: &str = "reader reads inputs inputs_read inputs_refused memory_mib";

/// The number of inputs of the planted reader.
const CONTROL_INPUTS: u64 = BATCH;

/// Gives inputs to a reader that panics where a bracket is missing.
fn control() -> Result<Control> {
    let options = Fuzz {
        inputs: CONTROL_INPUTS,
        reader: None,
        from: 0,
        seed: SeedArgs { seed: 1 },
    };
    let fuzzed = fuzz(&PLANTED, &options)?;
    Ok(Control {
        planted: format!("a reader of {}", PLANTED.reads),
        found: !fuzzed.failures.is_empty(),
    })
}

fn chosen(name: Option<&str>) -> Result<Vec<&'static Reader>> {
    let chosen: Vec<_> = READERS
        .iter()
        .filter(|reader| name.is_none_or(|name| name == reader.name))
        .collect();
    if chosen.is_empty() {
        let names = READERS.each_ref().map(|reader| reader.name);
        let name = name.unwrap_or_default();
        bail!(
            "there is no reader `{name}`{}; the readers are {}",
            did_you_mean(name, names),
            names.join(", ")
        );
    }
    Ok(chosen)
}

/// Runs one reader, on all cores.
fn fuzz(reader: &'static Reader, options: &Fuzz) -> Result<Fuzzed> {
    let inputs = options.inputs;
    let folders = (0..thread::available_parallelism()?.get())
        .map(|_| tempfile::tempdir())
        .collect::<std::io::Result<Vec<_>>>()
        .context("the fuzzer's own folder")?;
    let before = memory::peak_mib();
    let bar = progress::bar(reader.name, inputs);
    let (next, done) = (AtomicU64::new(0), AtomicU64::new(0));
    let count = Mutex::new(Fuzzed {
        reader: reader.name,
        reads: reader.reads,
        inputs,
        inputs_read: 0,
        inputs_refused: 0,
        memory_mib: None,
        failures: Vec::new(),
    });
    // A single input is run for inspection, so its panic is printed at once.
    let quiet = (inputs > 1).then(Quiet::new);
    thread::scope(|scope| {
        let workers: Vec<_> = folders
            .iter()
            .map(|folder| {
                let (next, done, count, bar) = (&next, &done, &count, &bar);
                scope.spawn(move || -> Result<()> {
                    let open = reader.open(folder.path())?;
                    let watch = Watch::new(reader.name);
                    loop {
                        let first = next.fetch_add(BATCH, Ordering::Relaxed);
                        if first >= inputs {
                            return Ok(());
                        }
                        for number in first..inputs.min(first + BATCH) {
                            let index = options.from + number;
                            let found = watch.during(index, || one(&open, options, index));
                            let mut count = count.lock().expect("no worker panics");
                            match found {
                                Ok(true) => count.inputs_read += 1,
                                Ok(false) => count.inputs_refused += 1,
                                Err(failure) => count.failures.push(failure),
                            }
                            done.fetch_add(1, Ordering::Relaxed);
                        }
                        bar.set_position(done.load(Ordering::Relaxed));
                    }
                })
            })
            .collect();
        workers
            .into_iter()
            .try_for_each(|worker| worker.join().expect("a worker catches what it reads"))
    })?;
    drop(quiet);
    bar.finish_and_clear();
    let mut fuzzed = count.into_inner().expect("no worker panics");
    fuzzed.failures.sort();
    fuzzed.failures.truncate(TOLD);
    fuzzed.check_memory(before, options)?;
    Ok(fuzzed)
}

/// Whether the reader accepts input number `index`; a failure where it panics.
fn one(open: &Open<'_>, options: &Fuzz, index: u64) -> Result<bool, Failure> {
    let input = input(open, options.seed.seed, index);
    if options.inputs == 1 {
        eprintln!("{}: input {index}: {input:?}", open.name());
    }
    let read = panic::catch_unwind(AssertUnwindSafe(|| open.read(&input)));
    read.map(|read| read.is_ok()).map_err(|panicked| Failure {
        index,
        message: format!(
            "{}: input {index} panics: {}",
            open.name(),
            said(panicked.as_ref())
        ),
        command: repeat(options.seed.seed, open.name(), index),
    })
}

fn input(open: &Open<'_>, seed: u64, index: u64) -> Input {
    // The two numbers do not overlap: seeds are small, and indices are below 2^40.
    open.input(&mut Pcg64::seed_from_u64(seed << 40 ^ index))
}

fn repeat(seed: u64, reader: &str, index: u64) -> String {
    format!("photoncube verify fuzz 1 --reader {reader} --from {index} --seed {seed}")
}

impl Fuzzed {
    fn check_memory(&mut self, before: Option<u64>, options: &Fuzz) -> Result<()> {
        let (Some(before), Some(after)) = (before, memory::peak_mib()) else {
            return Ok(());
        };
        let grown = after - before;
        self.memory_mib = Some(grown);
        if grown > MEMORY_BOUND_MIB {
            self.failures.push(Failure {
                index: options.from,
                message: format!(
                    "{}: memory grew by {grown} MiB, expected at most {MEMORY_BOUND_MIB}",
                    self.reader
                ),
                command: format!(
                    "photoncube verify fuzz {} --reader {} --from {} --seed {}",
                    self.inputs, self.reader, options.from, options.seed.seed
                ),
            });
        }
        Ok(())
    }
}

/// Suppresses the output of panics on standard error during its life, since each panic becomes a failure.
struct Quiet(Option<PanicHook>);

type PanicHook = Box<dyn Fn(&panic::PanicHookInfo<'_>) + Send + Sync>;

impl Quiet {
    fn new() -> Self {
        let loud = panic::take_hook();
        panic::set_hook(Box::new(|_| ()));
        Self(Some(loud))
    }
}

impl Drop for Quiet {
    fn drop(&mut self) {
        if let Some(loud) = self.0.take() {
            panic::set_hook(loud);
        }
    }
}

/// The message of a panic.
fn said(panicked: &(dyn Any + Send)) -> String {
    let text = panicked.downcast_ref::<&str>().map(ToString::to_string);
    let text = text.or_else(|| panicked.downcast_ref::<String>().cloned());
    text.unwrap_or_else(|| "a panic without words".to_owned())
}

impl Fuzz {
    fn line(&self, fuzzed: &Fuzzed) -> Line {
        Line {
            by: format!("photoncube {}", env!("CARGO_PKG_VERSION")),
            volume: fuzzed.inputs,
            unit: "inputs".to_owned(),
            result: format!(
                "{} read, {} refused, {} failures",
                fuzzed.inputs_read,
                fuzzed.inputs_refused,
                fuzzed.failures.len()
            ),
            command: format!(
                "photoncube verify fuzz {} --reader {} --seed {}",
                fuzzed.inputs, fuzzed.reader, self.seed.seed
            ),
            ..Line::of_no_verilog(format!("reader {}", fuzzed.reader))
        }
    }
}
