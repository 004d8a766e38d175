//! A Verilog evaluator in Rust: it parses the emitted text, flattens it, and compiles it to a flat program.
//!
//! It knows the subset of Verilog that `generate` emits and refuses everything else by name and line. Four
//! modules decide the meaning of a text: widths and signs are in [`expression`] and [`shape`], statements in
//! [`statement`], unknown values in [`four_state`], and blocks that never run in [`waits`]. The tests in
//! `testbenches/tests/text/` compare all of them with Icarus.

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
mod node;
mod program;
mod read;
mod run;
mod shape;
mod statement;
mod syntax;
mod waits;

use photoncube_hdl::Emitted;
use photoncube_spec::Pin;
use thiserror::Error;

use super::{Device, DeviceError, Observed, Unknown};
use circuit::Question;
use flat::Flat;
use graph::SignalId;
use program::Program;
use run::Running;
use syntax::Line;

/// The error of Verilog that is outside the subset, or that is wrong.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "line {line} of the Verilog: {found}; the device `text` knows the subset that `generate` emits"
)]
pub struct Refusal {
    line: Line,
    found: String,
}

impl Refusal {
    fn new(line: Line, found: String) -> Self {
        Self { line, found }
    }
}

fn refuse<T>(line: Line, found: String) -> Result<T, Refusal> {
    Err(Refusal::new(line, found))
}

/// A design in the evaluator.
pub struct Text {
    running: Running,
    columns: usize,
}

impl Text {
    /// Compiles the design.
    ///
    /// # Errors
    /// Some construct of the text is outside the subset.
    pub fn new(design: &Emitted) -> Result<Self, Refusal> {
        let modules = read::read(&design.text)?;
        let mut flat = elaborate::elaborate(&modules, &design.top)?;
        for ram in &design.block_rams {
            flat.fill_with_zeros(&ram.path)?;
        }
        waits::leave_out_what_never_runs(&mut flat);
        let pins = &design.pins;
        let outputs = names(&pins.observed[..pins.outputs]);
        let registers = design.register_paths.iter().map(String::as_str);
        let observed = find_all(&flat, outputs.chain(registers), &pins.observed)?;
        let inputs = find_all(&flat, names(&pins.inputs), &pins.inputs)?;
        let question = Question {
            clock: match design.clocked {
                true => Some(find(&flat, "clock", 1)?),
                false => None,
            },
            inputs: &inputs,
            observed: &observed,
        };
        let circuit = circuit::circuit(&flat, &question)?;
        if circuit::reads_clock(&circuit, &program::reached(&circuit)) {
            return refuse(1, "the clock is read as a value".to_owned());
        }
        Ok(Self {
            running: Running::new(Program::new(&circuit)),
            columns: pins.inputs.len(),
        })
    }
}

fn names(pins: &[Pin]) -> impl Iterator<Item = &str> {
    pins.iter().map(|pin| pin.name.as_str())
}

fn find_all<'n>(
    flat: &Flat<'_>,
    names: impl Iterator<Item = &'n str>,
    pins: &[Pin],
) -> Result<Vec<SignalId>, Refusal> {
    let named = names.zip(pins);
    named
        .map(|(name, pin)| find(flat, name, pin.width))
        .collect()
}

fn find(flat: &Flat<'_>, name: &str, width: u32) -> Result<SignalId, Refusal> {
    let Some(id) = flat.find(name) else {
        return refuse(1, format!("there is no signal `{name}`"));
    };
    let signal = flat.signal(id);
    match signal.width == width {
        true => Ok(id),
        false => {
            let found = format!("`{name}` has {} bits; expected {width}", signal.width);
            refuse(signal.line, found)
        }
    }
}

impl Device for Text {
    fn name(&self) -> &str {
        "text"
    }

    fn tool_version(&self) -> &str {
        concat!("photoncube ", env!("CARGO_PKG_VERSION"))
    }

    fn visible(&self) -> usize {
        self.running.program().observed.len()
    }

    fn replay(&mut self, inputs: &[u64], observed: &mut Observed) -> Result<(), DeviceError> {
        for row in inputs.chunks_exact(self.columns) {
            self.running.settle(row);
            for signal in &self.running.program().observed {
                let value = self.running.word(signal.value);
                let unknown = signal.unknown.map_or(0, |place| self.running.word(place));
                if unknown != 0 {
                    observed.unknown.push(Unknown {
                        index: observed.values.len(),
                        text: hexadecimal(value, unknown, signal.width),
                    });
                }
                // An unknown value is recorded as 0, as for every device.
                observed.values.push(if unknown == 0 { value } else { 0 });
            }
            self.running.clock();
        }
        Ok(())
    }
}

/// Formats a value as Verilog's `%h` does: `x` for a digit of unknown bits, `X` for a digit with some.
fn hexadecimal(value: u64, unknown: u64, width: u32) -> String {
    let digit = |index: u32| {
        let of_digit = |word: u64| word >> (4 * index) & 0xf;
        let there = 0xf >> (4 * (index + 1)).saturating_sub(width);
        match of_digit(unknown) {
            0 => char::from_digit(of_digit(value) as u32, 16).unwrap_or('?'),
            all if all == there => 'x',
            _ => 'X',
        }
    };
    (0..width.div_ceil(4)).rev().map(digit).collect()
}
