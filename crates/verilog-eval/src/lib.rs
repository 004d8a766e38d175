#![doc = include_str!("../README.md")]
//!
//! # The modules
//!
//! Four modules decide the meaning of a text: widths and signs are in `expression` and `shape`, statements in
//! `statement`, unknown values in `four_state`, and blocks that never run in `waits`.

mod bits;
mod circuit;
mod doubts;
mod elaborate;
mod environment;
mod expression;
mod flat;
mod four_state;
mod graph;
mod instance;
mod modules;
mod node;
mod program;
mod read;
mod run;
mod shape;
mod statement;
mod syntax;
mod value;
mod waits;

use thiserror::Error;

use circuit::Question;
use flat::Flat;
use graph::SignalId;
use program::Program;
use run::Running;
use syntax::Line;

pub use modules::{ModuleText, initial_values, modules};
pub use value::Value;

/// The widest signal that can be driven or observed, in bits.
pub const MAX_WIDTH: u32 = u64::BITS;

/// The error of Verilog that is outside the subset, or that is wrong.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "line {line} of the Verilog: {found}; the evaluator knows a synthesizable subset of Verilog-2001"
)]
pub struct Refusal {
    line: Line,
    found: String,
}

impl Refusal {
    fn new(line: Line, found: String) -> Self {
        Self { line, found }
    }

    /// The line of the text, from 1; also 1 where the fault is of no line, such as a signal that is not there.
    #[must_use]
    pub fn line(&self) -> u32 {
        self.line
    }
}

/// The instances of modules in the module of that name, in the order of the text: the name of each instance, and the name of
/// its module. The other modules need not be in the text.
///
/// # Errors
/// The text is outside the subset, or has no such module.
pub fn instances_in(text: &str, module: &str) -> Result<Vec<(String, String)>, Refusal> {
    let modules = read::read(text)?;
    let Some(found) = modules.into_iter().find(|found| found.name == module) else {
        return refuse(1, format!("there is no module `{module}`"));
    };
    let instance = |item| match item {
        syntax::Item::Instance(instance) => Some((instance.name, instance.module)),
        _ => None,
    };
    Ok(found.items.into_iter().filter_map(instance).collect())
}

fn refuse<T>(line: Line, found: String) -> Result<T, Refusal> {
    Err(Refusal::new(line, found))
}

/// A signal that is driven or observed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Signal<'a> {
    /// Its name in the top module, or its path from there: `instance.instance.name`.
    pub name: &'a str,
    /// Its width in bits, at most [`MAX_WIDTH`]; a signal of another width is refused.
    pub width: u32,
}

impl<'a> Signal<'a> {
    /// A signal of that name and width.
    #[must_use]
    pub fn new(name: &'a str, width: u32) -> Self {
        Self { name, width }
    }
}

/// A text with its top module, and the signals that the evaluator drives and shows.
#[derive(Clone, Debug)]
pub struct Design<'a> {
    /// The Verilog of all modules.
    pub text: &'a str,
    /// The name of the top module.
    pub top: &'a str,
    /// The clock's input port; none if the design is combinational.
    pub clock: Option<&'a str>,
    /// The signals that [`Evaluator::settle`] drives, in its order.
    pub inputs: Vec<Signal<'a>>,
    /// The signals that [`Evaluator::observed`] shows, in its order. Logic that none of them depends on is left out.
    pub observed: Vec<Signal<'a>>,
    /// Paths of memories whose words start as zero although the text does not say so, as block RAMs of FPGAs do.
    pub zeroed_memories: Vec<&'a str>,
}

/// A design that runs, as after power-up.
pub struct Evaluator {
    running: Running,
}

impl Evaluator {
    /// Compiles the design.
    ///
    /// # Errors
    /// The text is outside the subset or wrong, or a signal is not there in that width.
    pub fn new(design: &Design<'_>) -> Result<Self, Refusal> {
        let modules = read::read(design.text)?;
        let mut flat = elaborate::elaborate(&modules, design.top)?;
        for memory in &design.zeroed_memories {
            flat.fill_with_zeros(memory)?;
        }
        waits::leave_out_what_never_runs(&mut flat);
        let clock = design.clock.map(|clock| find(&flat, Signal::new(clock, 1)));
        let question = Question {
            clock: clock.transpose()?,
            inputs: &find_all(&flat, &design.inputs)?,
            observed: &find_all(&flat, &design.observed)?,
        };
        let circuit = circuit::circuit(&flat, &question)?;
        if circuit::reads_clock(&circuit, &program::reached(&circuit)) {
            return refuse(1, "the clock is read as a value".to_owned());
        }
        Ok(Self {
            running: Running::new(Program::new(&circuit)),
        })
    }

    /// Drives the inputs, one word for each of [`Design::inputs`], and lets the combinational logic settle.
    ///
    /// # Panics
    /// There are more or fewer words than inputs.
    pub fn settle(&mut self, inputs: &[u64]) {
        assert_eq!(
            inputs.len(),
            self.running.program().inputs.len(),
            "one word for each input"
        );
        self.running.settle(inputs);
    }

    /// The values of [`Design::observed`], as they are now.
    pub fn observed(&self) -> impl ExactSizeIterator<Item = Value> {
        let signals = &self.running.program().observed;
        signals.iter().map(|signal| Value {
            bits: self.running.word(signal.value),
            unknown: signal.unknown.map_or(0, |place| self.running.word(place)),
            width: signal.width,
        })
    }

    /// Makes the rising clock edge. Combinational values are those from before it until [`Self::settle`].
    pub fn clock(&mut self) {
        self.running.clock();
    }
}

fn find_all(flat: &Flat<'_>, signals: &[Signal<'_>]) -> Result<Vec<SignalId>, Refusal> {
    signals.iter().map(|&signal| find(flat, signal)).collect()
}

fn find(flat: &Flat<'_>, asked: Signal<'_>) -> Result<SignalId, Refusal> {
    let Signal { name, width } = asked;
    let Some(id) = flat.find(name) else {
        return refuse(1, format!("there is no signal `{name}`"));
    };
    let signal = flat.signal(id);
    if signal.width != width {
        let found = format!("`{name}` has {} bits; expected {width}", signal.width);
        return refuse(signal.line, found);
    }
    if width > MAX_WIDTH {
        let found = format!(
            "`{name}` has {width} bits; a signal driven or observed has at most {MAX_WIDTH}"
        );
        return refuse(signal.line, found);
    }
    Ok(id)
}
