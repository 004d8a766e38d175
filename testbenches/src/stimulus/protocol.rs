//! Stimulus that is hard on the protocol: streams that wait long or in patterns, a reset at every clock, no
//! reset.

use std::ops::ControlFlow;

use photoncube_spec::Machine;

use super::case::Case;
use super::cases::Cases;
use super::drive::{Driver, Sink};
use super::traffic::{Pace, Traffic};
use super::{MAX_RANDOM_BATCH, StimulusError};

/// The kinds of stimulus that are hard on the protocol.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Protocol {
    /// Each side of each stream waits at random.
    Stalls,
    /// Each stream alone is withheld for many clocks.
    Holds,
    /// Each stream alone, and all streams, move in a pattern: one clock in two, one in three, two in three,
    /// eight in sixteen, one in twenty. Also two streams that move alternately.
    Patterns,
    /// A reset in every clock of a query, clocks of waiting included, with a whole query after each.
    Resets,
    /// `Stalls` with fewer batches, for devices that are slow.
    FewStalls,
    /// `FewStalls` from power-up on, without any reset.
    NoReset,
}

/// The number of batches of [`Protocol::Stalls`].
const STALLED_BATCHES: usize = 300;
/// The number of batches of stimulus for slow devices.
const FEW_BATCHES: usize = 8;
/// The clocks that a stream is withheld in [`Protocol::Holds`] before each word. They are far more than any
/// latency, and more than any queue takes to fill or to empty.
const HOLD: u64 = 300;
/// The number of cases that are withheld: more than the queue of results of any machine but the largest
/// holds.
const HELD_CASES: usize = MAX_RANDOM_BATCH;
/// The number of cases of each pattern.
const PATTERN_CASES: usize = 40;
/// The patterns: clocks in which a stream moves, then clocks in which it does not. The last pattern is longer
/// than an iteration of any machine.
const PATTERNS: [(u64, u64); 5] = [(1, 1), (1, 2), (2, 1), (8, 8), (1, 19)];
/// The number of queries that are reset in each of their clocks.
const RESET_QUERIES: usize = 4;
/// The groups of the query that is reset: a first, a middle and a last one.
const RESET_GROUPS: usize = 3;

/// Generates the stimulus of a kind.
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
        let cases = Cases::new(machine, driver.rng()).cases(4, machine.keeps_sets());
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
        let cases = Cases::new(machine, driver.rng()).cases(count, machine.keeps_sets());
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

/// For each stream alone: one clock in which it moves, then many in which it does not.
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
    // Two streams move in alternate clocks.
    let (even, odd) = (pattern(1, 1, 0), pattern(1, 1, 1));
    all.extend([[even, even, odd], [even, odd, even], [odd, even, even]]);
    all
}

/// For each clock of a query, without and with waiting: the query up to that clock, a reset, and a whole
/// query.
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

/// The most sets that are given after a reset. A photon memory starts with one bank after each reset. With
/// one set after a reset, the next reset finds the other bank in use; with two sets, the first bank.
pub(super) fn sets_behind(machine: &Machine) -> usize {
    1 + usize::from(machine.keeps_sets())
}

/// Generates the resets with `sets` sets after each.
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
        // The query has ended before that reset, so the machine has nothing to do.
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

/// A case of `groups` groups.
fn of_groups(machine: &Machine, driver: &mut Driver<'_>, groups: usize) -> Vec<Case> {
    loop {
        let cases = Cases::new(machine, driver.rng()).cases(1, false);
        if cases[0].groups.len() == groups {
            return cases;
        }
    }
}
