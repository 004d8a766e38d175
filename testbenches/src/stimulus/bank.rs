//! Stimulus for a photon memory: its banks filled to the last place, with a last group there and without.

use std::ops::ControlFlow;

use photoncube_spec::Machine;

use super::StimulusError;
use super::case::Case;
use super::cases::Cases;
use super::drive::{Driver, Sink};
use super::protocol::sets_behind;
use super::traffic::{Pace, Traffic};

/// A set of groups.
#[derive(Copy, Clone)]
struct Set {
    groups: Groups,
    /// Batches that it is played to; it is kept for all but the last, which releases it.
    batches: usize,
}

/// How many groups a set has, and how it ends.
#[derive(Copy, Clone)]
enum Groups {
    /// All that a bank holds, none of them a last one: the last place ends the set.
    FullUnmarked,
    /// All that a bank holds, the last a last one.
    Full,
    /// One fewer than a bank holds.
    OneLess,
    /// One.
    One,
}

/// Banks take sets in turn, so each way of ending comes to each bank, and each is followed by each of
/// the others or by a set of one group: the word behind it begins a new set.
const SETS: [Set; 12] = [
    of(Groups::FullUnmarked, 1),
    of(Groups::FullUnmarked, 2),
    of(Groups::One, 1),
    of(Groups::OneLess, 1),
    of(Groups::FullUnmarked, 2),
    of(Groups::Full, 2),
    of(Groups::Full, 1),
    of(Groups::FullUnmarked, 1),
    of(Groups::OneLess, 2),
    of(Groups::One, 2),
    of(Groups::FullUnmarked, 1),
    of(Groups::One, 1),
];

const fn of(groups: Groups, batches: usize) -> Set {
    Set { groups, batches }
}

/// Clocks around an end in each of which a reset comes: in the last places, whose numbers are nearly all ones, and
/// while a batch begins or ends, which takes less than the rest.
const AROUND: std::ops::Range<u64> = 0..16;
/// Clocks before the end with the first of these resets.
const BEFORE: u64 = 6;

/// Generates it all; how much it is does not depend on the seed.
///
/// # Errors
/// The machine has no photon memory, or its golden model is at odds with itself.
pub(super) fn full_bank(
    machine: &Machine,
    seed: u64,
    sink: &mut Sink<'_>,
) -> Result<ControlFlow<()>, StimulusError> {
    let spatial = machine.spatial().filter(|_| machine.has_memory());
    let spatial = spatial.ok_or(StimulusError::NoBank {
        machine: machine.name,
    })?;
    let held = spatial.memory_groups as usize;
    let driver = &mut Driver::new(machine, sink);
    if driver.begin_chunk(0, seed)?.is_break() {
        return Ok(ControlFlow::Break(()));
    }
    let waiting = Traffic {
        group: Pace::Mostly,
        query: Pace::Half,
        result: Pace::Mostly,
        garbage: true,
        ..Traffic::STREAMING
    };
    for traffic in [Traffic::STREAMING, waiting] {
        let cases = sets(machine, driver, held);
        if driver.run(&cases, traffic)?.is_break() {
            return Ok(ControlFlow::Break(()));
        }
    }
    if resets(machine, driver, held)?.is_break() {
        return Ok(ControlFlow::Break(()));
    }
    Ok(driver.flush())
}

/// All sets, each batch with queries of its own.
fn sets(machine: &Machine, driver: &mut Driver<'_>, held: usize) -> Vec<Case> {
    let mut all = Vec::new();
    for set in SETS {
        let mut cases = Cases::new(machine, driver.rng());
        let count = match set.groups {
            Groups::FullUnmarked | Groups::Full => held,
            Groups::OneLess => held - 1,
            Groups::One => 1,
        };
        let mut first = cases.of_groups(count);
        if let (Groups::FullUnmarked, Some(group)) = (set.groups, first.groups.last_mut()) {
            group.last = false;
        }
        for batch in 1..=set.batches {
            let queries = cases.case().queries;
            all.push(Case {
                queries,
                groups: first.groups.clone(),
                keeps_photons: batch < set.batches,
            });
        }
    }
    all
}

/// A full bank, each of the two, up to each clock around its end and around the end of its playing, a reset, and sets
/// behind.
fn resets(
    machine: &Machine,
    driver: &mut Driver<'_>,
    held: usize,
) -> Result<ControlFlow<()>, StimulusError> {
    for ends in 1..=2 {
        let all =
            AROUND.flat_map(|clock| (1..=sets_behind(machine)).map(move |sets| (clock, sets)));
        for (clock, sets) in all {
            let mut cases = Cases::new(machine, driver.rng());
            let mut full = cases.of_groups(held);
            full.groups[held - 1].last = clock % 2 == 0;
            let behind = (0..sets).map(|_| cases.of_groups(2));
            let all: Vec<_> = [full].into_iter().chain(behind).collect();
            let traffic = Traffic {
                reset_at: Some(ends * held as u64 + clock - BEFORE),
                ..Traffic::STREAMING
            };
            if driver.run(&all, traffic)?.is_break() {
                return Ok(ControlFlow::Break(()));
            }
        }
    }
    Ok(ControlFlow::Continue(()))
}
