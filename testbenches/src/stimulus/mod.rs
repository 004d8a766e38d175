//! Stimulus: rows of input pins, clock by clock, with the row of every signal that the golden model shows in
//! that clock.
//!
//! The model runs first and decides the handshakes; its rows are then replayed into a device. A device that
//! waits in another clock differs in its ready or valid pins, so replaying without feedback cannot hide a
//! difference. Rows come in blocks, so that millions of iterations need little memory.
//!
//! A *chunk* has its own seed and begins with every register at its power-up value. A failure in chunk 70 of
//! a long run occurs again in a run of that chunk alone.

mod aim;
mod bank;
mod batch;
mod case;
mod cases;
mod corners;
mod drive;
mod garbage;
mod protocol;
mod radius;
#[cfg(test)]
mod tests;
mod traffic;

use std::ops::ControlFlow;

use photoncube_model::{GatherError, golden_machine};
use photoncube_spec::{Machine, Photon, Pins, Query, Sums};
use rand::RngExt;
use thiserror::Error;

use case::Case;
use cases::Cases;
pub(crate) use cases::corner;
use drive::Driver;
pub use protocol::Protocol;
pub use traffic::Pressure;
use traffic::Traffic;

/// The source of the queries.
#[derive(Copy, Clone, Debug)]
pub enum Source<'a> {
    /// Random queries, weighted towards the corners, with waiting, garbage and resets. The seed decides all
    /// of it.
    Random,
    /// Given queries with their photons, each at most once, one after another without waiting. Neighbouring
    /// queries with equal photons are tested at once where the machine can.
    Workload {
        /// The queries.
        queries: &'a [(Query, Vec<Photon>)],
        /// The command that repeats the run. Only the caller knows the origin of the queries.
        repeat: &'a str,
    },
    /// Stimulus that is hard on the protocol. Its length is fixed.
    Protocol(Protocol),
    /// Two queries with as many photons of full power as the machine declares, all in range, each followed by
    /// a group without photons, which is added to the largest sum. Where these groups exceed a bank of the
    /// photon memory, there is one group fewer before the empty one, and further queries have the most
    /// photons.
    FullThenEmpty,
    /// For each lane, queries with as many photons of full power as the machine declares, and with some
    /// fewer, all in range and all in that lane. The sum of one lane is then as large as a whole sum. A
    /// photon memory's bank has as many photons in a lane as it holds groups.
    LaneAlone,
    /// For a machine that keeps sets: banks filled to their last place with and without a last group
    /// there, and to one place less. Each is played, released and kept. Then a reset comes at each clock
    /// around the end of filling and of playing such a bank.
    FullBank,
}

impl Source<'_> {
    /// The corners that random stimulus reaches too rarely, as far as the machine has them.
    pub fn corners(machine: &Machine) -> Vec<Self> {
        let bank = machine.keeps_sets().then_some(Self::FullBank);
        let corners = bank.into_iter();
        corners
            .chain([Self::FullThenEmpty, Self::LaneAlone])
            .collect()
    }
}

/// Consecutive clocks: the inputs of the machine, and the signals that it must show.
#[derive(Clone, Debug, Default)]
pub struct Block {
    /// The index of the chunk of the clocks.
    pub chunk: u64,
    /// The seed of the chunk.
    pub seed: u64,
    /// The first clock, counted from the chunk's start.
    pub first_clock: u64,
    /// The iterations of the chunk before the first clock.
    pub iterations_before: u64,
    /// Rows of inputs in the order of [`photoncube_spec::Pins::inputs`].
    pub inputs: Vec<u64>,
    /// Rows of signals in the order of [`photoncube_spec::Pins::observed`], before the clock's rising edge.
    pub expected: Vec<u64>,
    /// The number of clocks, which is the number of rows.
    pub clocks: usize,
    /// The number of groups whose sums were taken.
    pub iterations: u64,
    /// The number of results taken.
    pub results: u64,
    /// Statistics of the streams up to the last of these clocks.
    pub pressure: Pressure,
}

/// The reason why there is no stimulus. All but `Gather` and `NoBank` mean that the golden model or the spec
/// is wrong.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum StimulusError {
    /// A query or a photon does not fit the machine, or there are too many.
    #[error(transparent)]
    Gather(#[from] GatherError),
    /// The two readings of the golden model differ.
    #[error(
        "the golden model of `{machine}` is wrong: seed {seed}, clock {clock}: the step-exact \
         machine gave {:?} in {machine_clocks} clocks, the direct gather {:?}, the program \
         {program_clocks} clocks",
        .sums[0],
        .sums[1]
    )]
    ModelsDiffer {
        /// The name of the machine.
        machine: &'static str,
        /// The seed of the chunk.
        seed: u64,
        /// The clock, counted from the chunk's start.
        clock: u64,
        /// The sums of the step-exact machine, and those of the direct gather.
        sums: Box<[Sums; 2]>,
        /// The clocks that the machine worked on the query.
        machine_clocks: u64,
        /// The clocks that the program should take.
        program_clocks: u64,
    },
    /// A result has not the tag of its query.
    #[error(
        "the golden model of `{machine}` is wrong: seed {seed}, clock {clock}: the result has the tag {found}, its query {expected}"
    )]
    Tag {
        /// The name of the machine.
        machine: &'static str,
        /// The seed of the chunk.
        seed: u64,
        /// The clock, counted from the chunk's start.
        clock: u64,
        /// The tag of the result.
        found: u32,
        /// The tag of the query.
        expected: u32,
    },
    /// A bank is to be filled, and the machine has no photon memory.
    #[error(
        "machine `{machine}` keeps no sets of photons, so it has no bank to fill; `photoncube list` says which machines have a \
         photon memory"
    )]
    NoBank {
        /// The name of the machine.
        machine: &'static str,
    },
    /// After a reset and a query of zeros, some register is not at its power-up value.
    #[error("machine `{machine}` has a register that a reset and a query of zeros do not set")]
    NotScrubbed {
        /// The name of the machine.
        machine: &'static str,
    },
}

/// The approximate iterations of a chunk of random stimulus before its fullest query.
const CHUNK_ITERATIONS: u64 = 8192;

/// The most queries of a batch. Within a batch, streams run ahead of each other.
const MAX_BATCH: usize = 16;
/// The most random cases of a batch: more than the queue of results of any machine holds.
const MAX_RANDOM_BATCH: usize = 24;

/// The number of queries with many photons at the end of a chunk.
const LONG_CASES: usize = 4;

/// The seed of a chunk. The first chunk has the run's seed, so that any chunk can be run alone as the first
/// chunk of another run. A longer run only adds chunks.
pub fn chunk_seed(seed: u64, chunk: u64) -> u64 {
    // The finaliser of splitmix64: a bijection that leaves 0 as it is.
    let mut mixed = chunk;
    mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    seed ^ (mixed ^ (mixed >> 31))
}

/// Generates at least `iterations` iterations in whole queries (a workload may have fewer), and passes every
/// block to `sink` until that answers `Break`.
///
/// # Errors
/// The machine cannot hold the workload, or the two readings of the golden model differ.
pub fn generate(
    machine: &Machine,
    source: Source<'_>,
    seed: u64,
    iterations: u64,
    sink: &mut dyn FnMut(Block) -> ControlFlow<()>,
) -> Result<(), StimulusError> {
    let flow = match source {
        Source::Random => random(machine, seed, iterations, sink),
        Source::Workload { queries, .. } => workload(machine, queries, seed, iterations, sink),
        Source::Protocol(protocol) => protocol::protocol(machine, protocol, seed, sink),
        Source::FullThenEmpty => {
            let cases = corners::full_then_empty(machine);
            batches(machine, [cases], seed, sink)
        }
        Source::LaneAlone => batches(machine, corners::lane_alone(machine), seed, sink),
        Source::FullBank => bank::full_bank(machine, seed, sink),
    };
    // `Break` and the end of the stimulus are both a success.
    flow.map(drop)
}

fn random(
    machine: &Machine,
    seed: u64,
    iterations: u64,
    sink: &mut dyn FnMut(Block) -> ControlFlow<()>,
) -> Result<ControlFlow<()>, StimulusError> {
    let mut driver = Driver::new(machine, sink);
    let mut done = 0;
    for chunk in 0.. {
        if done >= iterations {
            break;
        }
        let wanted = iterations - done;
        let flow = random_chunk(&mut driver, machine, chunk, chunk_seed(seed, chunk), wanted)?;
        if flow.is_break() {
            return Ok(flow);
        }
        done += driver.iterations();
    }
    Ok(driver.flush())
}

/// The rows of inputs with which every chunk begins. They set each register to a value that does not depend
/// on its past.
pub(crate) fn scrub_rows(machine: &Machine) -> Vec<u64> {
    let mut rows = Vec::new();
    let mut sink = |block: Block| {
        rows.extend(block.inputs);
        ControlFlow::Continue(())
    };
    let mut driver = Driver::new(machine, &mut sink);
    let begun = driver.begin_chunk(0, 0);
    assert!(begun.is_ok(), "{begun:?}");
    let _ = driver.flush();
    rows
}

/// The golden model's signals on these rows of inputs, which follow those of [`scrub_rows`].
pub(crate) fn modelled(machine: &Machine, rows: &[u64]) -> Block {
    let columns = Pins::of(machine).inputs.len();
    let mut model = golden_machine(machine);
    for row in scrub_rows(machine).chunks_exact(columns) {
        model.clock(&Pins::inputs_of(machine, row));
    }
    let mut block = Block {
        inputs: rows.to_vec(),
        clocks: rows.len() / columns,
        ..Block::default()
    };
    for row in rows.chunks_exact(columns) {
        let inputs = Pins::inputs_of(machine, row);
        model.observe(&inputs, &mut block.expected);
        model.clock(&inputs);
    }
    block
}

/// Generates a chunk. Its contents depend only on its seed; `wanted` may end it early.
fn random_chunk(
    driver: &mut Driver<'_>,
    machine: &Machine,
    chunk: u64,
    seed: u64,
    wanted: u64,
) -> Result<ControlFlow<()>, StimulusError> {
    if driver.begin_chunk(chunk, seed)?.is_break() {
        return Ok(ControlFlow::Break(()));
    }
    while driver.iterations() < wanted.min(CHUNK_ITERATIONS) {
        // The first batch is not reset, so it ends with a result, however short the run.
        let may_reset = driver.iterations() > 0;
        let rng = driver.rng();
        let traffic = Traffic::any(rng, may_reset);
        let count = rng.random_range(1..=MAX_RANDOM_BATCH);
        let idle = rng.random_range(0..4);
        let mut cases = Cases::new(machine, rng);
        let batch = cases.cases(count, machine.keeps_sets());
        if driver.run(&batch, traffic)?.is_break() || driver.idle(idle).is_break() {
            return Ok(ControlFlow::Break(()));
        }
    }
    if wanted <= CHUNK_ITERATIONS {
        return Ok(ControlFlow::Continue(()));
    }
    // Sums of every size follow; the cases above have only a few groups.
    let most = machine.max_photons();
    let mut long: Vec<_> = (0..LONG_CASES)
        .map(|_| {
            let shift = driver.rng().random_range(3..=8);
            let photons = driver.rng().random_range(1..=(most >> shift).max(1));
            Case::full_scale(machine, photons)
        })
        .collect();
    long.extend(match driver.rng().random_range(0..4) {
        0 => Some(Case::fullest(machine)),
        1 | 2 => Some(Case::full_scale(
            machine,
            driver.rng().random_range(1..=most),
        )),
        _ => None,
    });
    driver.run(&long, Traffic::STREAMING)
}

fn workload(
    machine: &Machine,
    queries: &[(Query, Vec<Photon>)],
    seed: u64,
    iterations: u64,
    sink: &mut dyn FnMut(Block) -> ControlFlow<()>,
) -> Result<ControlFlow<()>, StimulusError> {
    let mut driver = Driver::new(machine, sink);
    if queries.is_empty() || driver.begin_chunk(0, seed)?.is_break() {
        return Ok(ControlFlow::Break(()));
    }
    for batch in queries.chunks(MAX_BATCH * machine.queries_at_once()) {
        if driver.iterations() >= iterations {
            break;
        }
        let mut cases = Vec::new();
        for shared in batch.chunk_by(|(_, photons), (_, next)| photons == next) {
            let first = cases.len();
            for together in shared.chunks(machine.queries_at_once()) {
                cases.push(packed(machine, together)?);
            }
            for case in cases[first..].iter_mut().rev().skip(1) {
                case.keeps_photons = machine.keeps_sets();
            }
        }
        if driver.run(&cases, Traffic::STREAMING)?.is_break() {
            return Ok(ControlFlow::Break(()));
        }
    }
    Ok(driver.flush())
}

/// Runs batches of cases, one after another, without waiting.
fn batches(
    machine: &Machine,
    batches: impl IntoIterator<Item = Vec<Case>>,
    seed: u64,
    sink: &mut dyn FnMut(Block) -> ControlFlow<()>,
) -> Result<ControlFlow<()>, StimulusError> {
    let mut driver = Driver::new(machine, sink);
    if driver.begin_chunk(0, seed)?.is_break() {
        return Ok(ControlFlow::Break(()));
    }
    for batch in batches {
        if driver.run(&batch, Traffic::STREAMING)?.is_break() {
            return Ok(ControlFlow::Break(()));
        }
    }
    Ok(driver.flush())
}

/// Packs a case, and refuses values that the pins cannot hold.
fn packed(machine: &Machine, together: &[(Query, Vec<Photon>)]) -> Result<Case, GatherError> {
    for (query, photons) in together {
        photoncube_model::gather(machine, query, photons.iter().copied())?;
    }
    let queries: Vec<_> = together.iter().map(|(query, _)| *query).collect();
    Ok(Case::pack(machine, &queries, &together[0].1))
}
