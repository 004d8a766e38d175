//! The engine `core`: a leaf machine's emitted Verilog, simulated in Verilator, that makes the gathers of a picture.

use std::thread;

use anyhow::Result;
use photoncube_driver::{Driver, Transport, TransportError, Work};
use photoncube_spec::{LeafAnswer, LeafWords, Machine};
use photoncube_testbench::StreamSimulation;
use serde::Serialize;

use crate::{machines, progress};

/// A simulation of a machine's Verilog as a way to the machine.
pub struct Simulated(StreamSimulation);

impl Transport for Simulated {
    fn exchange(&mut self, words: &LeafWords) -> Result<LeafAnswer, TransportError> {
        Ok(self.0.exchange(words)?)
    }
}

/// Builds the simulation of a leaf machine, and starts one for each core of this computer. The frames of a picture are shared
/// out among them.
pub fn driver(machine: &'static Machine) -> Result<Driver<Simulated>> {
    machines::prepare(machine)?;
    // The first builds the program, which the others then find in the cache.
    let count = thread::available_parallelism().map_or(1, usize::from);
    let simulations = (0..count).map(|_| Ok(Simulated(StreamSimulation::new(machine)?)));
    let simulations: Result<Vec<_>> = simulations.collect();
    let bar = progress::bar("simulating frames", 0);
    let show = move |done: usize, all: usize| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
        if done == all {
            bar.finish_and_clear();
        }
    };
    Ok(Driver::new(machine, simulations?)?.with_progress(show))
}

/// The work of the simulated machines in reports.
#[derive(Debug, Serialize)]
pub struct CoreReport {
    frames: u64,
    query_words: u64,
    groups_loaded: u64,
    groups_played: u64,
    chain_clocks: u64,
    tests_per_photon_in_range: f64,
    queries_per_clock: f64,
    engines_fed: f64,
}

impl CoreReport {
    /// That of work.
    pub fn of(work: Work) -> Self {
        let over = |part: u64, whole: u64| part as f64 / whole.max(1) as f64;
        Self {
            frames: work.frames,
            query_words: work.query_words,
            groups_loaded: work.groups_loaded,
            groups_played: work.groups_played,
            chain_clocks: work.clocks,
            tests_per_photon_in_range: over(work.photon_tests, work.in_range),
            queries_per_clock: over(work.queries, work.clocks),
            engines_fed: over(work.groups_played, work.clocks),
        }
    }

    /// The report in words.
    pub fn text(&self) -> String {
        format!(
            "core: {} frames, {} groups read in, {} played in {} clocks of a chain ({:.0} % of the clocks); {:.2} photon tests for \
             each in range, {:.4} queries a clock and chain\n",
            self.frames,
            self.groups_loaded,
            self.groups_played,
            self.chain_clocks,
            100.0 * self.engines_fed,
            self.tests_per_photon_in_range,
            self.queries_per_clock,
        )
    }
}
