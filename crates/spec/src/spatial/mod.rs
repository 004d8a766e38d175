//! The spatial machines, `stream` and `tile`: every cell keeps its instruction, and data flows
//! through registers.
//!
//! # Engines
//! An *engine* is the 4-D cube of 16 cells that holds one query: cell (photon g, role R) of engine
//! e is node `16 e + 4 R + g`. A machine has `2^query_axes` engines in a chain; `stream` has one.
//! Each clock an engine tests the four photons of a group.
//!
//! # The pipeline
//! A group enters at the *head*, waits a clock in the *entry*, a row of registers before engine 0, and passes
//! from engine to engine, one a clock, through *hop* registers. So every net is short and every photon is
//! read once. The positions of a group go first. Its powers follow [`Spatial::latency`] clocks later, when an
//! engine has decided which of the photons are in range. The powers therefore need one delay line, in the
//! head, and none in the engines. The head also decodes powers and clears the powers of absent photons.
//!
//! A query on its way along the chain is called a *token*. It travels in the direction of the photons. An
//! engine without a next query keeps the first token that arrives and passes the later ones on. When the
//! first group of a batch arrives at an engine, the engine makes its next query the current one in that
//! clock, so a new batch takes no extra clock. With the last group, the sums are complete; each engine then
//! puts them on the result chain, which runs back to the head. Results of one batch never collide there,
//! because engine e's result leaves 2 e clocks after the first. The head keeps batches far enough apart that
//! results of two batches do not collide.
//!
//! Reset also passes from engine to engine. Each engine clears its flags when the reset arrives. It clears
//! its place on the result chain in the following clock too, so that no result of the engine behind it gets
//! past the reset.
//!
//! # Batches
//! A *batch* is `2^query_axes` queries, the first for engine 0, and the groups of photons that all of them
//! are tested against. The machine takes queries of the next batch from the clock on in which it takes the
//! first group of the current batch. Results leave in the order of the queries.

mod check;
mod cuts;
mod flow;
mod head;
mod memory;
mod pins;
pub(crate) mod pipelines;
mod registers;
mod widths;

pub use check::SpatialError;
pub use cuts::{Cut, Cuts};
pub use flow::{EngineUnits, FlowRow};
pub use head::HeadSizes;
pub use memory::MemoryRegister;
pub(crate) use pins::SpatialPins;
pub use registers::{ENGINE_REGISTERS, EngineRegister, EngineRow, HeadRegister, Instances};

use crate::formats::Squarer;

/// The parameters of a spatial machine beside its numbers.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Spatial {
    /// Axes above the engine's four, which select the query: `2^query_axes` engines.
    pub query_axes: u32,
    /// The source of the search radius.
    pub radius: Radius,
    /// The pipeline registers of an engine with the machine's own kind of squarer.
    pub cuts: Cuts,
    /// Engines with squarers of other kinds, with the number of each. They are spread evenly over the chain:
    /// a device has tables (block RAMs), products (DSP blocks) and LUTs to make squares of, each in columns
    /// all over the chip, so engines of all kinds are placed side by side.
    pub others: &'static [(EngineKind, usize)],
    /// Groups that each of the two banks of the photon memory holds, a power of two. With 0 there is no
    /// memory, and the group stream goes straight to the head. See [`MemoryRegister`].
    pub memory_groups: u32,
    /// Whether the groups come from a leaf memory, which gives each one only when the head can take it. The head then takes every group, and
    /// has no registers to decide whether it may.
    pub paced: bool,
}

/// A kind of engine: the implementation of its squares and its pipeline registers. Kinds may differ in the
/// registers that process positions, since a block RAM and a DSP block need registers around them that an
/// adder does not need. An engine that decides sooner than the slowest kind delays its in-range flags. From
/// [`Cut::RangeDelay`] on, all engines have the machine's own pipeline registers.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct EngineKind {
    /// The implementation of the squares.
    pub squarer: Squarer,
    /// The pipeline registers of the engine.
    pub cuts: Cuts,
}

/// The source of the search radius.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum Radius {
    /// Each query has its own radius, up to the format's.
    Query,
    /// Every query has the format's radius, which is a constant; there is no pin for it.
    Format,
}

impl Spatial {
    /// Cells of an engine.
    pub const ENGINE_CELLS: usize = 16;
    /// Photons that an engine tests in a clock, one in each quad: the lanes of a group.
    pub const LANES: usize = 4;
    /// Clocks from an engine's result to that of the next engine, where nothing waits.
    pub const RESULT_CLOCKS: u32 = 2;

    /// Whether the engines have a fine pipeline for a full chip, beside which the head's paths must be as short.
    pub fn is_fine(&self) -> bool {
        self.cuts == pipelines::FINE_DECISIONS
    }

    /// The number of engines, which is the number of queries in a batch.
    pub fn engines(&self) -> usize {
        1 << self.query_axes
    }

    /// Clocks from the one in which a batch's last group is taken to the first in which its first result can
    /// be taken. The group passes the entry, the hop register, the stages of positions and of powers, the
    /// result chain, the queue's memory and the pins. Each further engine's result comes
    /// [`Self::RESULT_CLOCKS`] later.
    pub fn latency_clocks(&self) -> u32 {
        self.latency() + self.cuts.power_latency() + 5
    }

    /// Clocks between the last group of a batch and the first of the next in which no group is played. A
    /// photon memory needs two clocks to detect the end of the batch, and a third to decide whether the next
    /// may start. A set that is longer than the one played before it may cause a further wait.
    pub fn batch_gap_clocks(&self) -> u32 {
        if self.memory_groups > 0 { 3 } else { 0 }
    }

    /// The fewest clocks from a batch to the next, however few its groups. It keeps the results of two
    /// batches from colliding on the result chain.
    pub fn least_batch_clocks(&self) -> u32 {
        HeadSizes::of(self).spacing + self.batch_gap_clocks()
    }

    /// Clocks from a position in an engine's hop register to the in-range flag, equal for all engines: the
    /// clocks of the slowest kind. Powers enter the hop register that many clocks after positions.
    pub fn latency(&self) -> u32 {
        let others = self.others.iter().map(|(kind, _)| kind.cuts.latency());
        others.fold(self.cuts.latency(), u32::max)
    }

    /// Clocks that the in-range flags of an engine of that kind are delayed, to arrive with those of the
    /// slowest kind.
    pub fn range_waits(&self, kind: EngineKind) -> u32 {
        self.latency() - kind.cuts.latency()
    }

    /// The kind of an engine of a machine whose own squarers are `own`. It is the kind whose number of
    /// engines, up to and including this one, lags most behind its share; of equal kinds the first.
    pub fn kind(&self, own: Squarer, engine: usize) -> EngineKind {
        let others: usize = self.others.iter().map(|&(_, engines)| engines).sum();
        let own = EngineKind {
            squarer: own,
            cuts: self.cuts,
        };
        let own = (own, self.engines().saturating_sub(others));
        let kinds: Vec<_> = self.others.iter().copied().chain([own]).collect();
        let mut given = vec![0; kinds.len()];
        let mut latest = 0;
        for count in 1..=engine + 1 {
            let behind = |&kind: &usize| {
                let (share, given) = (count * kinds[kind].1, given[kind] * self.engines());
                share as i64 - given as i64
            };
            // `max_by_key` takes the last of several.
            latest = (0..kinds.len()).rev().max_by_key(behind).unwrap_or(latest);
            given[latest] += 1;
        }
        kinds[latest].0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machines::{MACHINES, find_machine};

    fn squarers(name: &str) -> Vec<Squarer> {
        let machine = find_machine(name).unwrap();
        let spatial = machine.spatial().unwrap();
        let squarer = |engine| spatial.kind(machine.squarer, engine).squarer;
        (0..spatial.engines()).map(squarer).collect()
    }

    #[test]
    fn every_kind_of_squarer_has_its_engines() {
        let mut checked = 0;
        for machine in MACHINES {
            let Some(spatial) = machine.spatial() else {
                continue;
            };
            let all = squarers(machine.name);
            for &(kind, engines) in spatial.others {
                let found = all.iter().filter(|&&squarer| squarer == kind.squarer);
                assert_eq!(found.count(), engines);
                checked += 1;
            }
        }
        assert!(checked > 0);
    }

    #[test]
    fn engines_decide_with_the_slowest_kind() {
        let machine = find_machine("tile-6-mixed").unwrap();
        let spatial = machine.spatial().unwrap();
        for engine in 0..spatial.engines() {
            let kind = spatial.kind(machine.squarer, engine);
            let waits = spatial.range_waits(kind);
            assert_eq!(kind.cuts.latency() + waits, spatial.latency());
            assert_eq!(waits == 0, kind.squarer == Squarer::Product);
        }
    }

    #[test]
    fn kinds_of_squarers_are_mixed() {
        use Squarer::{Digits, Product, Table};
        assert_eq!(squarers("tile-6-mixed"), [Table, Product, Digits, Table]);
        let longest = squarers("chip-mixed")
            .chunk_by(|a, b| a == b)
            .map(<[_]>::len)
            .max();
        assert!(longest <= Some(2), "{longest:?}");
    }
}
