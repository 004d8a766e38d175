//! Stimulus that is hard on the protocol: streams that wait long or in patterns, a reset at every clock, no reset.

use std::ops::ControlFlow;

use photoncube_spec::Machine;

use super::case::Case;
use super::cases::Cases;
use super::drive::{Driver, Sink};
use super::traffic::{Pace, Traffic};
use super::{MAX_RANDOM_BATCH, StimulusError};

/// What is hard on the protocol.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Protocol {
    /// Each side of each stream waits at random.
    Stalls,
    /// Each stream alone is withheld for long.
    Holds,
    /// Each stream alone, and all, move in a pattern: one clock in two, one in three, two in three, eight in
    /// sixteen, one in twenty; and two streams only in turn.
    Patterns,
    /// A reset in every clock of a query, its waiting included, and a whole query after each.
    Resets,
    /// As `Stalls`, but short, for devices that are slow.
    FewStalls,
    /// The same from power-up on, without any reset.
    NoReset,
}

/// Batches of [`Protocol::Stalls`].
const STALLED_BATCHES: usize = 300;
/// Batches of stimulus for slow devices.
const FEW_BATCHES: usize = 8;
/// Clocks that a stream is withheld in [`Protocol::Holds`] before each word: far longer than any latency, and
/// than any queue takes to fill or to run empty.
const HOLD: u64 = 300;
/// Cases that are held: more than the queue of results of any machine but the largest holds.
const HELD_CASES: usize = MAX_RANDOM_BATCH;
/// Cases of each pattern.
const PATTERN_CASES: usize = 40;
/// Clocks that a stream moves and does not, and again. The last is longer than an iteration of any machine.
const PATTERNS: [(u64, u64); 5] = [(1, 1), (1, 2), (2, 1), (8, 8), (1, 19)];
/// Queries that are reset in each of their clocks.
const RESET_QUERIES: usize = 4;
/// Groups of the query that is reset: a first one, one between, and a last one.
const RESET_GROUPS: usize = 3;

/// Generates it all.
pub(super) fn protocol(
    machine: &Machine,
    protocol: Protocol,
    seed: u64,
    sink: &mut Sink<'_>,
) -> Result<ControlFlow<()>, StimulusError> {
    let driver = &mut Driver::new(machine, sink);
    match protocol {
        Protocol::NoReset => driver.begin_at_power_up(seed),
        _ if driver.begin_chunk(0, seed)?.is_break() => return Ok(ControlFlow::Break(())),
        _ => {}
    }
    let flow = match protocol {
        Protocol::Stalls => stalls(driver, machine, STALLED_BATCHES),
        Protocol::FewStalls | Protocol::NoReset => stalls(driver, machine, FEW_BATCHES),
        Protocol::Holds => paces(driver, machine, &holds(), HELD_CASES),
        Protocol::Patterns => paces(driver, machine, &patterns(), PATTERN_CASES),
        Protocol::Resets => resets(driver, machine),
    };
    Ok(match flow? {
        ControlFlow::Continue(()) => driver.flush(),
        flow => flow,
    })
}

fn stalls(
    driver: &mut Driver<'_>,
    machine: &Machine,
    batches: usize,
) -> Result<ControlFlow<()>, StimulusError> {
    for _ in 0..batches {
        let traffic = Traffic::any(driver.rng(), false);
        let cases = Cases::new(machine, driver.rng()).cases(4, machine.has_memory());
        if driver.run(&cases, traffic)?.is_break() || driver.idle(2).is_break() {
            return Ok(ControlFlow::Break(()));
        }
    }
    Ok(ControlFlow::Continue(()))
}

/// The paces of query, group and result.
type Paces = [Pace; 3];

fn paces(
    driver: &mut Driver<'_>,
    machine: &Machine,
    all: &[Paces],
    count: usize,
) -> Result<ControlFlow<()>, StimulusError> {
    for &paces in all {
        let cases = Cases::new(machine, driver.rng()).cases(count, machine.has_memory());
        if driver.run(&cases, traffic(paces))?.is_break() {
            return Ok(ControlFlow::Break(()));
        }
    }
    Ok(ControlFlow::Continue(()))
}

fn traffic([query, group, result]: Paces) -> Traffic {
    Traffic {
        query,
        group,
        result,
        garbage: true,
        ..Traffic::STREAMING
    }
}

/// One clock, then none for long, on each stream alone.
fn holds() -> Vec<Paces> {
    alone(Pace::Pattern {
        high: 1,
        low: HOLD,
        phase: 0,
    })
}

fn alone(pace: Pace) -> Vec<Paces> {
    (0..3)
        .map(|stream| {
            let mut paces = [Pace::Always; 3];
            paces[stream] = pace;
            paces
        })
        .collect()
}

fn patterns() -> Vec<Paces> {
    let pattern = |high, low, phase| Pace::Pattern { high, low, phase };
    let mut all = Vec::new();
    for (high, low) in PATTERNS {
        all.extend(alone(pattern(high, low, 0)));
        all.push([pattern(high, low, 0); 3]);
    }
    // Two streams in turn.
    let (even, odd) = (pattern(1, 1, 0), pattern(1, 1, 1));
    all.extend([[even, even, odd], [even, odd, even], [odd, even, even]]);
    all
}

/// For each clock of a query, as it flows and as it waits: the query up to there, a reset, and a whole query.
fn resets(driver: &mut Driver<'_>, machine: &Machine) -> Result<ControlFlow<()>, StimulusError> {
    let pattern = |high, low| Pace::Pattern {
        high,
        low,
        phase: 0,
    };
    let flowing = [Pace::Always; 3];
    // Each stream is waited for, and the result waits.
    let waiting = [pattern(1, 2), pattern(2, 3), pattern(1, 4)];
    for paces in [flowing, waiting] {
        for _ in 0..RESET_QUERIES {
            let query = of_groups(machine, driver, RESET_GROUPS);
            for behind in 1..=sets_behind(machine) {
                if reset_in_each_clock(driver, machine, &query, paces, behind)?.is_break() {
                    return Ok(ControlFlow::Break(()));
                }
            }
        }
    }
    Ok(ControlFlow::Continue(()))
}

/// Up to so many sets are given behind a reset. A photon memory begins with the same bank after each, so with one set
/// behind it the next reset finds the other bank in use, with two the same.
pub(super) fn sets_behind(machine: &Machine) -> usize {
    1 + usize::from(machine.has_memory())
}

/// With so many sets behind each reset.
fn reset_in_each_clock(
    driver: &mut Driver<'_>,
    machine: &Machine,
    query: &[Case],
    paces: Paces,
    behind: usize,
) -> Result<ControlFlow<()>, StimulusError> {
    for clock in 0.. {
        let before = driver.clocks();
        let reset = Traffic {
            reset_at: Some(clock),
            ..traffic(paces)
        };
        if driver.run(query, reset)?.is_break() {
            return Ok(ControlFlow::Break(()));
        }
        let ended_before = driver.clocks() - before <= clock;
        // The machine has nothing to do when that reset comes.
        if ended_before && driver.reset().is_break() {
            return Ok(ControlFlow::Break(()));
        }
        let whole = Cases::new(machine, driver.rng()).cases(behind, false);
        if driver.run(&whole, traffic(paces))?.is_break() {
            return Ok(ControlFlow::Break(()));
        }
        if ended_before {
            break;
        }
    }
    Ok(ControlFlow::Continue(()))
}

/// A case of so many groups.
fn of_groups(machine: &Machine, driver: &mut Driver<'_>, groups: usize) -> Vec<Case> {
    loop {
        let cases = Cases::new(machine, driver.rng()).cases(1, false);
        if cases[0].groups.len() == groups {
            return cases;
        }
    }
}
