//! Stimulus: rows of input pins, clock by clock, with the row of every signal that the golden
//! model shows in that clock.
//!
//! The model runs first and decides the handshakes; its rows are then replayed into a device. A
//! device that waits in another clock differs in its ready or valid pins, so nothing is lost by
//! replaying blindly. Rows come in blocks, so that millions of iterations need little memory.
//!
//! A *chunk* has a seed of its own and begins with every register at its power-up value: what
//! fails in chunk 70 of a long run fails again in a run of that chunk alone.

mod aim;
mod case;
mod cases;
mod drive;
mod protocol;
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

/// Where the queries come from.
#[derive(Copy, Clone, Debug)]
pub enum Source<'a> {
    /// Random, weighted towards the corners, with waiting, garbage and resets; the seed decides.
    Random,
    /// Queries with their photons, one after the other without waiting, once each at most. Neighbours
    /// with the same photons are tested at once where the machine can.
    Workload {
        /// The queries.
        queries: &'a [(Query, Vec<Photon>)],
        /// The command that repeats the run; only the caller knows where the queries came from.
        repeat: &'a str,
    },
    /// What is hard on the protocol; it says itself how long it is.
    Protocol(Protocol),
    /// For each lane queries with as many photons of full power as the machine declares, and with some fewer, all in
    /// range, and all in that lane: what is summed of one lane is as large as a whole sum.
    LaneAlone,
}

/// Some clocks in a row: what went into the machine, and all that it must show.
#[derive(Clone, Debug, Default)]
pub struct Block {
    /// The chunk that the clocks belong to.
    pub chunk: u64,
    /// The chunk's seed.
    pub seed: u64,
    /// The first clock, counted from the chunk's start.
    pub first_clock: u64,
    /// Iterations of the chunk before the first clock.
    pub iterations_before: u64,
    /// Rows of [`photoncube_spec::Pins::inputs`].
    pub inputs: Vec<u64>,
    /// Rows of [`photoncube_spec::Pins::observed`]: as they stand before the clock's rising edge.
    pub expected: Vec<u64>,
    /// Clocks, so rows.
    pub clocks: usize,
    /// Groups whose sums were taken.
    pub iterations: u64,
    /// Results taken.
    pub results: u64,
    /// What was done to the streams up to the last of these clocks.
    pub pressure: Pressure,
}

/// Why there is no stimulus. All but `Gather` mean that the golden model or the spec is wrong.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum StimulusError {
    /// A query or a photon does not fit the machine, or there are too many.
    #[error(transparent)]
    Gather(#[from] GatherError),
    /// The two readings of the golden model differ.
    #[error(
        "the golden model of `{machine}` is wrong: seed {seed}, clock {clock}: the step-exact \
         machine gave {machine_sums:?} in {machine_clocks} clocks, the direct gather {gathered:?}, \
         the program {program_clocks} clocks"
    )]
    ModelsDiffer {
        /// The machine.
        machine: &'static str,
        /// The chunk's seed.
        seed: u64,
        /// The clock in the chunk.
        clock: u64,
        /// What the step-exact machine summed.
        machine_sums: Sums,
        /// What the direct gather summed.
        gathered: Sums,
        /// Clocks that the machine worked on the query.
        machine_clocks: u64,
        /// Clocks that the program says it takes.
        program_clocks: u64,
    },
    /// A reset and a query of zeros leave something behind.
    #[error("machine `{machine}` has a register that a reset and a query of zeros do not set")]
    NotScrubbed {
        /// The machine.
        machine: &'static str,
    },
}

/// A chunk of random stimulus has about this many iterations before its fullest query.
const CHUNK_ITERATIONS: u64 = 8192;

/// Most queries in a batch; within a batch, streams run ahead of each other.
const MAX_BATCH: usize = 16;
/// Most random cases in a batch: more than the queue of results of any machine holds.
const MAX_RANDOM_BATCH: usize = 24;

/// Queries with many photons at the end of a chunk.
const LONG_CASES: usize = 4;

/// The seed of a chunk. The first chunk has the run's seed, so that any chunk can be run alone
/// as the first of another run; a longer run only adds chunks.
pub fn chunk_seed(seed: u64, chunk: u64) -> u64 {
    // The finaliser of splitmix64: a bijection that leaves 0 as it is.
    let mut mixed = chunk;
    mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    seed ^ (mixed ^ (mixed >> 31))
}

/// Generates at least `iterations` iterations (of a workload: no more than it has), in whole
/// queries, and hands every block to `sink` until that answers `Break`.
///
/// # Errors
/// A workload that the machine cannot hold, or a golden model at odds with itself.
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
        Source::LaneAlone => lane_alone(machine, seed, sink),
    };
    // Whether the sink has all or wants no more, this is the end.
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

/// The rows of inputs with which every chunk begins: they bring each register to a value that depends on nothing
/// before.
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

/// What the golden model shows on these rows of inputs, where they follow those of [`scrub_rows`].
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

/// What a chunk holds depends on its seed alone; `wanted` only cuts it short.
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
        // The first batch ends with a result, however short the run.
        let may_reset = driver.iterations() > 0;
        let rng = driver.rng();
        let traffic = Traffic::any(rng, may_reset);
        let count = rng.random_range(1..=MAX_RANDOM_BATCH);
        let idle = rng.random_range(0..4);
        let mut cases = Cases::new(machine, rng);
        let batch = cases.cases(count, machine.has_memory());
        if driver.run(&batch, traffic)?.is_break() || driver.idle(idle).is_break() {
            return Ok(ControlFlow::Break(()));
        }
    }
    if wanted <= CHUNK_ITERATIONS {
        return Ok(ControlFlow::Continue(()));
    }
    // Sums of every size: what is above is of a few groups only.
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
                case.keeps_photons = machine.has_memory();
            }
        }
        if driver.run(&cases, Traffic::STREAMING)?.is_break() {
            return Ok(ControlFlow::Break(()));
        }
    }
    Ok(driver.flush())
}

fn lane_alone(
    machine: &Machine,
    seed: u64,
    sink: &mut dyn FnMut(Block) -> ControlFlow<()>,
) -> Result<ControlFlow<()>, StimulusError> {
    let mut driver = Driver::new(machine, sink);
    if driver.begin_chunk(0, seed)?.is_break() {
        return Ok(ControlFlow::Break(()));
    }
    let most = machine.max_photons();
    for lane in 0..machine.photons_per_iteration() {
        // The largest count, and the one whose bits are all ones: between them all bits of a count are used.
        for photons in [most, (1 << most.ilog2()) - 1] {
            let case = Case::full_scale_in(machine, lane, photons);
            if driver.run(&[case], Traffic::STREAMING)?.is_break() {
                return Ok(ControlFlow::Break(()));
            }
        }
    }
    Ok(driver.flush())
}

/// Refuses what the pins cannot hold, before it is put on them.
fn packed(machine: &Machine, together: &[(Query, Vec<Photon>)]) -> Result<Case, GatherError> {
    for (query, photons) in together {
        photoncube_model::gather(machine, query, photons.iter().copied())?;
    }
    let queries: Vec<_> = together.iter().map(|(query, _)| *query).collect();
    Ok(Case::pack(machine, &queries, &together[0].1))
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{Group, MACHINES, Register, Role, SignalPlace};

    use super::*;

    /// On `paper`, a chunk begins with two resets and a query of one group between them.
    const SCRUB_CLOCKS: usize = 1 + (1 + 9 + 1) + 1;

    fn blocks(machine: &Machine, source: Source<'_>, seed: u64, iterations: u64) -> Vec<Block> {
        let mut blocks = Vec::new();
        let mut sink = |block| {
            blocks.push(block);
            ControlFlow::Continue(())
        };
        generate(machine, source, seed, iterations, &mut sink).unwrap();
        blocks
    }

    #[test]
    fn a_block_has_a_row_for_each_clock_and_a_run_has_what_was_asked_for() {
        for machine in MACHINES {
            let pins = Pins::of(machine);
            let blocks = blocks(machine, Source::Random, 3, 1_000);
            for block in &blocks {
                assert_eq!(block.inputs.len(), block.clocks * pins.inputs.len());
                assert_eq!(block.expected.len(), block.clocks * pins.observed.len());
            }
            let iterations: u64 = blocks.iter().map(|block| block.iterations).sum();
            // A batch is done to its end: 16 cases of at most so many groups.
            let most = 40.max(4 * machine.queries_at_once() as u64);
            assert!((1_000..1_000 + 16 * most).contains(&iterations));
            assert!(blocks.iter().map(|block| block.results).sum::<u64>() > 100);
        }
    }

    #[test]
    fn every_input_is_within_its_pin_and_every_observed_bit_is_used() {
        let machine = &MACHINES[0];
        let pins = Pins::of(machine);
        let mut seen = vec![0; pins.observed.len()];
        for block in blocks(machine, Source::Random, 1, 8 * CHUNK_ITERATIONS) {
            for row in block.inputs.chunks(pins.inputs.len()) {
                for (value, pin) in row.iter().zip(&pins.inputs) {
                    assert_eq!(value >> pin.width, 0, "{}", pin.name);
                }
            }
            for row in block.expected.chunks(pins.observed.len()) {
                for (seen, value) in seen.iter_mut().zip(row) {
                    *seen |= value;
                }
            }
        }
        for (seen, pin) in seen.iter().zip(&pins.observed) {
            let all = u64::MAX >> (u64::BITS - pin.width);
            let wanted = reachable_bits(machine, &pin.name, all);
            assert_eq!(seen & wanted, wanted, "{}: {seen:#x}", pin.name);
        }
    }

    /// The bits of a signal that some run can set: a distance cell has no coordinate, and its
    /// power is a photon's count of one.
    fn reachable_bits(machine: &Machine, name: &str, all: u64) -> u64 {
        let pins = Pins::of(machine);
        let pin = pins.observed.iter().find(|pin| pin.name == name).unwrap();
        let SignalPlace::Cell { node, register } = pin.place else {
            // The count is as wide as the powers, and stops at `max_photons`, 2^16 + 1.
            return if name == "result_count" {
                0x1_ffff & all
            } else {
                all
            };
        };
        let distance_cell = machine.hypercube().role(node) == Role::D;
        match register {
            Register::Query | Register::Photon if distance_cell => 0,
            Register::Power if distance_cell => 1,
            Register::Sum if distance_cell => 0x1_ffff,
            _ => all,
        }
    }

    #[test]
    fn a_group_stays_until_it_is_taken_and_every_way_of_waiting_is_met() {
        let machine = &MACHINES[0];
        let (inputs, observed) = (
            Pins::of(machine).inputs.len(),
            Pins::of(machine).observed.len(),
        );
        let address = address_column(machine);
        let steps = machine.microprogram().unwrap().steps();
        let mut offered: Option<Group> = None;
        let mut met = [0; 7];
        for block in blocks(machine, Source::Random, 2, 5_000) {
            let rows = block.inputs.chunks(inputs);
            for (row, shown) in rows.zip(block.expected.chunks(observed)) {
                let inputs = Pins::inputs_of(machine, row);
                let outputs = Pins::outputs_of(machine, shown);
                if let Some(group) = offered.take() {
                    assert!(inputs.group_valid && inputs.group == group);
                }
                let taken = inputs.reset || outputs.group_ready;
                if inputs.group_valid && !taken {
                    offered = Some(inputs.group.clone());
                }
                let step = steps[shown[address] as usize].op.row();
                let garbage = !inputs.group_valid && inputs.group != Group::default();
                let events = [
                    inputs.reset && shown[address] > 1,
                    inputs.reset && outputs.result_valid,
                    outputs.query_ready && !inputs.query_valid,
                    !outputs.query_ready && inputs.query_valid,
                    step.reads_group && !inputs.group_valid,
                    outputs.result_valid && !inputs.result_ready,
                    garbage,
                ];
                for (met, event) in met.iter_mut().zip(events) {
                    *met += u32::from(event);
                }
            }
        }
        // Thousands of clocks: an event that is met less often than this tests next to nothing.
        assert!(met.iter().all(|&count| count >= 3), "{met:?}");
    }

    /// The column of the program counter.
    fn address_column(machine: &Machine) -> usize {
        let places = Pins::of(machine).observed;
        let mut places = places.iter().map(|pin| pin.place);
        let address = places.position(|place| place == SignalPlace::Control(0));
        address.expect("the program counter is observed")
    }

    #[test]
    fn any_chunk_can_be_run_alone() {
        let machine = &MACHINES[0];
        let long = blocks(machine, Source::Random, 5, 3 * CHUNK_ITERATIONS);
        let chunk = long.iter().map(|block| block.chunk).max().unwrap();
        assert!(chunk > 0, "the run has more than one chunk");
        let wanted: Vec<_> = long.iter().filter(|block| block.chunk == chunk).collect();
        let alone = blocks(
            machine,
            Source::Random,
            chunk_seed(5, chunk),
            CHUNK_ITERATIONS,
        );
        // While the chunk begins, registers still hold what the chunk before left there.
        let begun = SCRUB_CLOCKS * Pins::of(machine).observed.len();
        for (index, (alone, wanted)) in alone.iter().zip(&wanted).enumerate() {
            let from = if index == 0 { begun } else { 0 };
            // The last block may be cut short by another limit.
            let inputs = alone.inputs.len().min(wanted.inputs.len());
            let expected = alone.expected.len().min(wanted.expected.len());
            assert!(alone.inputs[..inputs] == wanted.inputs[..inputs], "{index}");
            assert!(
                alone.expected[from..expected] == wanted.expected[from..expected],
                "{index}"
            );
        }
    }

    #[test]
    fn a_workload_streams_at_the_machines_own_pace() {
        let machine = &MACHINES[0];
        let queries = vec![(Query::default(), vec![Photon::default(); 9]); 50];
        let source = Source::Workload {
            queries: &queries,
            repeat: "",
        };
        let blocks = blocks(machine, source, 0, u64::MAX);
        let clocks: usize = blocks.iter().map(|block| block.clocks).sum();
        let occupied = machine.microprogram().unwrap().occupied_clocks(3);
        assert_eq!(clocks as u64, SCRUB_CLOCKS as u64 + 50 * occupied);
        assert_eq!(
            blocks.iter().map(|block| block.iterations).sum::<u64>(),
            150
        );
        assert_eq!(blocks.iter().map(|block| block.results).sum::<u64>(), 50);
    }

    #[test]
    fn a_workload_that_does_not_fit_is_refused() {
        let query = Query {
            position: [256, 0, 0],
            radius_sq: 0,
        };
        let source = Source::Workload {
            queries: &[(query, Vec::new())],
            repeat: "",
        };
        let refused = generate(&MACHINES[0], source, 0, 1, &mut |_| {
            ControlFlow::Continue(())
        });
        assert!(matches!(refused, Err(StimulusError::Gather(_))));
    }
}
