//! The engine `core`, which makes the gathers of a picture: a core's emitted Verilog, simulated in Verilator, or a core on a board.

use std::thread;

use anyhow::Result;
use photoncube_driver::{Driver, Transport, TransportError, Work};
use photoncube_spec::{Core, CoreAnswer, CoreCounter, CoreWords, Leaf, Spatial};
use photoncube_testbench::CoreSimulation;
use serde::Serialize;

use crate::port::{self, OnBoard};
use crate::{machines, progress};

/// "6 chains of 8 engines".
pub fn chains_said(chains: u32, engines: usize) -> String {
    match chains {
        1 => format!("one chain of {engines} engines"),
        chains => format!("{chains} chains of {engines} engines"),
    }
}

/// A way to a core.
pub enum Way {
    /// A simulation of its Verilog.
    Simulated(CoreSimulation),
    /// The serial port of a board.
    OnBoard(Box<OnBoard>),
}

impl Transport for Way {
    fn exchange(&mut self, words: &CoreWords) -> Result<CoreAnswer, TransportError> {
        match self {
            Self::Simulated(simulation) => Ok(simulation.exchange(words)?),
            Self::OnBoard(on_board) => on_board.exchange(words),
        }
    }

    fn has_rounds(&self) -> bool {
        match self {
            Self::Simulated(simulation) => simulation.core().has_radii(),
            Self::OnBoard(on_board) => on_board.has_rounds(),
        }
    }
}

/// Builds the simulation of a core, and starts one for each processor of this computer. The frames of a picture are shared
/// out among them.
pub fn driver(core: &Core) -> Result<Driver<Way>> {
    machines::prepare(core.machine)?;
    // The first builds the program, which the others then find in the cache.
    let count = thread::available_parallelism().map_or(1, usize::from);
    let simulations = (0..count).map(|_| Ok(Way::Simulated(CoreSimulation::new(core)?)));
    with_bar(
        core,
        simulations.collect::<Result<_>>()?,
        "simulating frames",
    )
}

/// Opens the serial port of a board, and checks that it has this core.
pub fn driver_on_board(core: &Core, path: &str, baud: u32) -> Result<Driver<Way>> {
    let on_board = port::open(core, path, baud)?;
    with_bar(
        core,
        vec![Way::OnBoard(Box::new(on_board))],
        "gathering frames",
    )
}

fn with_bar(core: &Core, ways: Vec<Way>, what: &'static str) -> Result<Driver<Way>> {
    let bar = progress::bar(what, 0);
    let show = move |done: usize, all: usize| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
        if done == all {
            bar.finish_and_clear();
        }
    };
    Ok(Driver::new(core, ways)?.with_progress(show))
}

/// The work of the cores in reports.
#[derive(Debug, Serialize)]
pub struct CoreReport {
    core: String,
    chains: u32,
    engines: usize,
    sets: u64,
    query_words: u64,
    clocks: u64,
    clocks_forecast: u64,
    leaves_loaded: u64,
    boxes_compared: u64,
    leaves_wanted: u64,
    groups_played: u64,
    photon_stalls: u64,
    query_stalls: u64,
    tests_per_photon_in_range: f64,
    queries_per_clock: f64,
    estimates_per_clock: f64,
    engines_fed: f64,
}

impl CoreReport {
    /// That of the work of cores of this kind for that many estimates.
    pub fn of(core: &Core, work: &Work, estimates: u64) -> Self {
        use CoreCounter as C;
        let over = |part: u64, whole: u64| part as f64 / whole.max(1) as f64;
        let engines = core.engines();
        let (clocks, played) = (work.counter(C::Clocks), work.counter(C::GroupsPlayed));
        let tests = played * (Spatial::LANES * engines) as u64;
        Self {
            core: core.name(),
            chains: core.chains,
            engines,
            sets: work.sets,
            query_words: work.query_words,
            clocks,
            clocks_forecast: work.clocks_forecast,
            leaves_loaded: work.counter(C::LeavesRead),
            boxes_compared: work.counter(C::LeavesCompared),
            leaves_wanted: work.counter(C::LeavesWanted),
            groups_played: played,
            photon_stalls: work.counter(C::PhotonStalls),
            query_stalls: work.counter(C::QueryStalls),
            tests_per_photon_in_range: over(tests, work.counter(C::PhotonsInRange)),
            queries_per_clock: over(work.queries, clocks),
            estimates_per_clock: over(estimates, clocks),
            engines_fed: over(played, clocks * u64::from(core.chains)),
        }
    }

    /// The report in words.
    pub fn text(&self) -> String {
        let groups_read = self.leaves_loaded * Leaf::GROUPS as u64;
        format!(
            "core: {}, {} clocks ({} forecast); {} sets of photons, {groups_read} groups read in, {} played (engines fed in {:.0} % of the \
             clocks); {:.2} photon tests for each in range, {:.4} queries a clock, {:.4} estimates a clock\n",
            chains_said(self.chains, self.engines),
            self.clocks,
            self.clocks_forecast,
            self.sets,
            self.groups_played,
            100.0 * self.engines_fed,
            self.tests_per_photon_in_range,
            self.queries_per_clock,
            self.estimates_per_clock,
        )
    }
}
