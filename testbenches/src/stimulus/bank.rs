//! Stimulus for a photon memory: banks filled to the last place, with and without a last group there. In a memory of leaves also
//! queues filled to the last place, and sets of every length.

use std::ops::ControlFlow;

use photoncube_spec::{Leaf, LeafSizes, Machine};

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
    /// The batches that the set is played to. All but the last keep the set; the last releases it.
    batches: usize,
}

/// The number of groups of a set, and its end.
#[derive(Copy, Clone)]
enum Groups {
    /// As many groups as a bank holds, none marked as last: the last place ends the set.
    FullUnmarked,
    /// As many groups as a bank holds, the last one marked as last.
    Full,
    /// One group fewer than a bank holds.
    OneLess,
    /// A single group.
    One,
}

/// The sets. Banks take sets in turn, so each way of ending occurs in each bank. Each way is followed by each
/// of the others or by a set of one group, whose word begins a new set.
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

/// The clocks around an end in each of which a reset comes. They cover the last places, whose numbers are
/// nearly all ones, and the start or end of a batch, which takes fewer clocks.
const AROUND: std::ops::Range<u64> = 0..16;
/// The clocks from the first of these resets to the end.
const BEFORE: u64 = 6;

/// The most groups of sets of every length. Longer ones would take more clocks than all else here.
const MOST_GROUPS: usize = 64;

/// Generates all of this stimulus. Its amount does not depend on the seed.
///
/// # Errors
/// The machine has no photon memory, or the two readings of its golden model differ.
pub(super) fn full_bank(
    machine: &Machine,
    seed: u64,
    sink: &mut Sink<'_>,
) -> Result<ControlFlow<()>, StimulusError> {
    let groups = machine.bank_groups().ok_or(StimulusError::NoBank {
        machine: machine.name,
    })?;
    let held = groups as usize;
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
    if let Some(leaf) = machine.leaf()
        && (full_queues(machine, leaf, driver)?.is_break()
            || every_length(machine, driver, held)?.is_break())
    {
        return Ok(ControlFlow::Break(()));
    }
    Ok(driver.flush())
}

/// The fullest set, every leaf of which is wanted, for many batches of a query each. Four batches are played while one result is taken,
/// so as many batches as possible come to be under way. The player then waits, and the pairs of the batch behind fill the
/// queue of pairs.
fn full_queues(
    machine: &Machine,
    leaf: &Leaf,
    driver: &mut Driver<'_>,
) -> Result<ControlFlow<()>, StimulusError> {
    // Three in four batches that are played remain under way.
    let batches = 2 * LeafSizes::of(leaf).most_outstanding;
    let all: Vec<_> = (1..=batches)
        .map(|batch| Case {
            keeps_photons: batch < batches,
            ..Case::fullest(machine)
        })
        .collect();
    let traffic = Traffic {
        result: Pace::Pattern {
            high: 1,
            low: 4 * u64::from(leaf.bank_groups),
            phase: 0,
        },
        ..Traffic::STREAMING
    };
    driver.run(&all, traffic)
}

/// Sets of each number of groups, up to [`MOST_GROUPS`], each twice in a row, so that each bank takes it. Thus the last leaf of a set has one
/// group, and then two, at each place of each bank.
fn every_length(
    machine: &Machine,
    driver: &mut Driver<'_>,
    held: usize,
) -> Result<ControlFlow<()>, StimulusError> {
    let mut cases = Cases::new(machine, driver.rng());
    let lengths = (1..=held.min(MOST_GROUPS)).flat_map(|groups| [groups; 2]);
    let all: Vec<_> = lengths.map(|groups| cases.of_groups(groups)).collect();
    driver.run(&all, Traffic::STREAMING)
}

/// The cases of all sets, with separate queries for each batch.
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
            all.push(Case {
                groups: first.groups.clone(),
                keeps_photons: batch < set.batches,
                ..cases.case()
            });
        }
    }
    all
}

/// For each bank and each clock around the end of its filling and of its playing: a full bank up to that
/// clock, a reset, and sets after it.
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
