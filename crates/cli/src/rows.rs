//! The golden model of a machine on given queries, clock by clock.

use std::ops::ControlFlow;

use anyhow::{Context, Result};
use photoncube_spec::{Machine, Photon, Pin, Pins, Query};
use photoncube_testbench::{Source, generate};

/// The golden model's signals, clock by clock.
pub struct Rows {
    pins: Pins,
    inputs: Vec<Vec<u64>>,
    /// For each clock, all pins and registers.
    pub observed: Vec<Vec<u64>>,
}

impl Rows {
    /// Runs the golden model on these queries, each with its photons.
    ///
    /// # Errors
    /// The golden model refuses a query or a photon.
    pub fn of(machine: &Machine, queries: &[(Query, Vec<Photon>)]) -> Result<Self> {
        let source = Source::Workload {
            queries,
            repeat: "",
        };
        let pins = Pins::of(machine);
        let (mut inputs, mut observed) = (Vec::new(), Vec::new());
        let mut sink = |block: photoncube_testbench::Block| {
            let rows = block.inputs.chunks_exact(pins.inputs.len());
            inputs.extend(rows.map(<[u64]>::to_vec));
            let rows = block.expected.chunks_exact(pins.observed.len());
            observed.extend(rows.map(<[u64]>::to_vec));
            ControlFlow::Continue(())
        };
        generate(machine, source, 1, 1, &mut sink)?;
        Ok(Self {
            pins,
            inputs,
            observed,
        })
    }

    /// The values of a pin, clock by clock; `None` where the machine has no such pin.
    pub fn pin(&self, name: &str) -> Option<Vec<u64>> {
        let column = |pins: &[Pin]| pins.iter().position(|pin| pin.name == name);
        let values =
            |rows: &[Vec<u64>], column: usize| rows.iter().map(|row| row[column]).collect();
        match column(&self.pins.inputs) {
            Some(column) => Some(values(&self.inputs, column)),
            None => column(&self.pins.observed).map(|column| values(&self.observed, column)),
        }
    }

    /// The clocks in which an input pin and an output pin are both set.
    ///
    /// # Errors
    /// The machine has no such pins.
    pub fn clocks_with(&self, input: &str, output: &str) -> Result<Vec<usize>> {
        let values = |name: &str| self.pin(name).with_context(|| format!("no pin {name}"));
        let (input, output) = (values(input)?, values(output)?);
        let both = input.into_iter().zip(output).enumerate();
        let both = both.filter(|(_, values)| *values == (1, 1));
        Ok(both.map(|(clock, _)| clock).collect())
    }
}
