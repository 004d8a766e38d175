//! The device `text`: the emitted Verilog in the evaluator of the crate `verilog-eval`, with nothing but Rust.
//!
//! `testbenches/tests/text/` compares the evaluator with Icarus.

use photoncube_hdl::Emitted;
use photoncube_spec::Pin;
use verilog_eval::{Design, Evaluator, Refusal, Signal};

use super::{Device, DeviceError, Observed, Unknown};

/// A design in the evaluator.
pub struct Text {
    evaluator: Evaluator,
    columns: usize,
}

impl Text {
    /// Compiles the design.
    ///
    /// # Errors
    /// The text is outside the evaluator's subset.
    pub fn new(design: &Emitted) -> Result<Self, Refusal> {
        let pins = &design.pins;
        let outputs = names(&pins.observed[..pins.outputs]);
        let registers = design.register_paths.iter().map(String::as_str);
        let evaluator = Evaluator::new(&Design {
            text: &design.text,
            top: &design.top,
            clock: design.clocked.then_some("clock"),
            inputs: signals(names(&pins.inputs), &pins.inputs),
            observed: signals(outputs.chain(registers), &pins.observed),
            zeroed_memories: design.block_rams.iter().map(|ram| &*ram.path).collect(),
        })?;
        Ok(Self {
            evaluator,
            columns: pins.inputs.len(),
        })
    }
}

fn names(pins: &[Pin]) -> impl Iterator<Item = &str> {
    pins.iter().map(|pin| pin.name.as_str())
}

fn signals<'n>(names: impl Iterator<Item = &'n str>, pins: &[Pin]) -> Vec<Signal<'n>> {
    let named = names.zip(pins);
    named
        .map(|(name, pin)| Signal::new(name, pin.width))
        .collect()
}

impl Device for Text {
    fn name(&self) -> &str {
        "text"
    }

    fn tool_version(&self) -> &str {
        concat!("photoncube ", env!("CARGO_PKG_VERSION"))
    }

    fn visible(&self) -> usize {
        self.evaluator.observed().len()
    }

    fn replay(&mut self, inputs: &[u64], observed: &mut Observed) -> Result<(), DeviceError> {
        for row in inputs.chunks_exact(self.columns) {
            self.evaluator.settle(row);
            for value in self.evaluator.observed() {
                if value.known().is_none() {
                    observed.unknown.push(Unknown {
                        index: observed.values.len(),
                        text: value.to_string(),
                    });
                }
                // 0 where a bit is unknown, as of every device.
                observed.values.push(value.known().unwrap_or(0));
            }
            self.evaluator.clock();
        }
        Ok(())
    }
}
