//! The spatial machines, `stream` and `tile`: every cell keeps its instruction, and data flows
//! through registers.
//!
//! # Engines
//! An *engine* is the 4-D cube of 16 cells that holds one query: cell (photon g, role R) of engine
//! e is node `16 e + 4 R + g`. A machine has `2^query_axes` engines in a chain; `stream` has one.
//! Each clock an engine tests the four photons of a group.
//!
//! # Waves
//! A group enters at the *head*, waits a clock in the *entry*, a row of registers before engine 0,
//! and passes from engine to engine, one a clock, through *hop* registers, so that every net is
//! short and every photon is read once. Positions go first. Powers follow as a second wave,
//! [`Spatial::latency`] clocks later, which is when an engine has decided which of the photons are in
//! range; so only the head delays them, once for all engines. The head also decodes powers and
//! clears those of absent photons.
//!
//! Queries travel as *tokens* in the same direction: an engine without a next query keeps the first
//! token that comes and passes on the later ones. The first group of a batch makes each engine take
//! its next query as its query in the clock in which the group arrives, so a change costs none.
//! With the last group, sums are complete; each engine then puts them on the result chain, which
//! runs back to the head. Results of one batch never meet there, as engine e's leave 2 e clocks
//! after the first; the head keeps batches far enough apart that no two do.
//!
//! Reset travels as a wave as well: each engine clears its flags when the wave arrives, and its
//! place on the result chain in the clock after too, so that no result slips past the wave.
//!
//! # Batches
//! A *batch* is `2^query_axes` queries, the first for engine 0, and the groups of photons that all
//! of them are tested against. Queries of the next batch are taken from the clock on in which the
//! first group of this one is. Results come in the order of the queries.

mod check;
mod cuts;
mod flow;
mod head;
mod memory;
mod pins;
mod registers;
mod widths;

pub use check::SpatialError;
pub use cuts::{Cut, Cuts};
pub use flow::{EngineUnits, FlowRow};
pub use head::HeadSizes;
pub use memory::MemoryRegister;
pub(crate) use pins::SpatialPins;
pub use registers::{ENGINE_REGISTERS, EngineRegister, EngineRow, HeadRegister, Instances};
pub use widths::SpatialWidths;

use crate::format::Squarer;

/// What a spatial machine has beside its numbers.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Spatial {
    /// Axes above the engine's four, which join queries: `2^query_axes` engines.
    pub query_axes: u32,
    /// Where the search radius comes from.
    pub radius: Radius,
    /// Where the pipeline of an engine with the machine's own kind of squarer has registers.
    pub cuts: Cuts,
    /// Engines with squarers of other kinds: so many of each, spread evenly over the chain. A device
    /// has tables (block RAMs), products (DSP blocks) and LUTs to make squares of, each in columns
    /// all over it, so engines of all kinds stand side by side.
    pub others: &'static [(EngineKind, usize)],
    /// Groups that each of the two banks of the photon memory holds, a power of two; 0: no memory,
    /// the group stream goes straight to the head. See [`MemoryRegister`].
    pub memory_groups: u32,
}

/// What an engine's squares are made of, and where its pipeline has registers. Kinds may differ in
/// the cuts of the flow of positions, since a block RAM and a DSP block want registers around them that
/// an adder does not need; where an engine decides sooner than the slowest kind, its decisions wait.
/// From [`Cut::RangeDelay`] on, where all engines share the clocks, the cuts of all kinds are the machine's.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct EngineKind {
    /// What squares are made of.
    pub squarer: Squarer,
    /// Where registers are.
    pub cuts: Cuts,
}

/// Where the search radius comes from.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum Radius {
    /// Each query has its own, up to the format's.
    Query,
    /// It is always the format's: a constant, and no pin.
    Format,
}

impl Spatial {
    /// Cells of an engine.
    pub const ENGINE_CELLS: usize = 16;
    /// Photons that an engine tests in a clock, one in each quad: the lanes of a group.
    pub const LANES: usize = 4;

    /// Engines, so queries of a batch.
    pub fn engines(&self) -> usize {
        1 << self.query_axes
    }

    /// Clocks from that in which a batch's last group is taken to the first in which its first
    /// result can be: the entry, the hop register, the two flows, the result chain, the queue's memory
    /// and the pins.
    /// Each further engine's result comes two clocks later.
    pub fn latency_clocks(&self) -> u32 {
        self.latency() + self.cuts.power_latency() + 5
    }

    /// Clocks between the last group of a batch and the first of the next in which no group is played: with a photon
    /// memory, in two of them it learns that the batch is over, in the third whether the next may start. A set that is
    /// longer than the one played before it may be waited for besides.
    pub fn batch_gap_clocks(&self) -> u32 {
        if self.memory_groups > 0 { 3 } else { 0 }
    }

    /// The fewest clocks from a batch to the next, however few its groups: the results of two batches must not meet on
    /// their way back.
    pub fn least_batch_clocks(&self) -> u32 {
        HeadSizes::of(self).spacing + self.batch_gap_clocks()
    }

    /// Clocks from a position in an engine's hop register to the decision whether it is in range, in
    /// every engine: those of the slowest kind. Powers enter their hop register so much later.
    pub fn latency(&self) -> u32 {
        let others = self.others.iter().map(|(kind, _)| kind.cuts.latency());
        others.fold(self.cuts.latency(), u32::max)
    }

    /// Clocks that the decisions of an engine of that kind wait for those of the slowest.
    pub fn range_waits(&self, kind: EngineKind) -> u32 {
        self.latency() - kind.cuts.latency()
    }

    /// The kind of an engine of a machine whose own squarers are `own`: that which is furthest behind
    /// its share of the engines up to this one, the first of several.
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
