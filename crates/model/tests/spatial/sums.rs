//! Tests that results are those of the direct gather, in the order of the queries.

use photoncube_spec::{Group, Machine, find_machine};
use proptest::prelude::*;

use crate::driver::{Batch, Driver, Waits, expected};
use crate::machines::{SQUARERS, all_cuts, all_named, machine, with_cuts};
use crate::words::{Noise, Random, batch};

fn case() -> impl Strategy<Value = (Machine, Vec<Batch>)> {
    machine().prop_flat_map(|machine| {
        let batches = prop::collection::vec(batch(&machine, 20), 1..4);
        (Just(machine), batches)
    })
}

/// For each stream, the number of clocks in 10 that it waits.
fn waits() -> impl Strategy<Value = [u32; 3]> {
    prop::array::uniform3(prop::sample::select(vec![0, 0, 3, 9]))
}

/// The results of batches, without waiting.
fn results(machine: &Machine, batches: &[Batch]) -> Vec<photoncube_spec::Sums> {
    let mut driver = Driver::new(machine);
    driver.give(batches);
    driver.finish(batches.len() * machine.queries_at_once());
    driver.results
}

proptest! {
    #[test]
    fn results_are_the_direct_gathers_whatever_waits(
        (machine, batches) in case(),
        tenths in waits(),
        seed in any::<u64>(),
    ) {
        let mut random = Random::new(seed);
        let mut driver = Driver::new(&machine);
        driver.give(&batches);
        driver.finish_with(batches.len() * machine.queries_at_once(), |_| {
            let [query, group, result] = tenths.map(|tenths| random.below(10) < tenths);
            Waits { query, group, result }
        });
        prop_assert_eq!(driver.results, expected(&machine, &batches));
    }

    #[test]
    fn the_order_of_the_photons_does_not_matter(
        (machine, batches) in case(),
        rotation in 0_usize..20,
    ) {
        let mut shuffled = batches.clone();
        for batch in &mut shuffled {
            let mut lanes: Vec<_> = batch.groups.iter().flat_map(|g| g.lanes.clone()).collect();
            lanes.reverse();
            let length = lanes.len();
            lanes.rotate_left(rotation % length);
            for (group, lanes) in batch.groups.iter_mut().zip(lanes.chunks(4)) {
                group.lanes = lanes.to_vec();
            }
        }
        prop_assert_eq!(results(&machine, &batches), results(&machine, &shuffled));
    }

    #[test]
    fn empty_groups_count_nothing((machine, batches) in case(), seed in any::<u64>()) {
        let mut random = Random::new(seed);
        let mut noise = Noise::seeded(&machine, seed);
        let mut with_empty = batches.clone();
        for batch in &mut with_empty {
            let mut groups = Vec::new();
            for group in batch.groups.drain(..) {
                while random.below(2) == 0 {
                    groups.push(empty(&mut noise));
                }
                groups.push(group);
            }
            if random.below(2) == 0 {
                groups.push(empty(&mut noise));
            }
            let count = groups.len();
            for (index, group) in groups.iter_mut().enumerate() {
                group.last = index + 1 == count;
            }
            batch.groups = groups;
        }
        prop_assert_eq!(results(&machine, &with_empty), expected(&machine, &batches));
    }
}

/// A group without photons, but with noise on its lanes.
fn empty(noise: &mut Noise) -> Group {
    let mut group = noise.group();
    for lane in &mut group.lanes {
        lane.present = false;
    }
    group
}

#[test]
fn every_named_machine_sums_what_the_direct_gather_does() {
    for machine in all_named() {
        let mut noise = Noise::seeded(machine, 7);
        let batches = noise.batches(3, 2 * machine.queries_at_once() + 50);
        let expected = expected(machine, &batches);
        assert!(
            expected.iter().any(|sums| sums.count > 0),
            "{}",
            machine.name
        );
        assert_eq!(results(machine, &batches), expected, "{}", machine.name);
    }
}

/// Tests all 2^10 sets of pipeline registers, and 2^9 for tables.
#[test]
fn every_legal_set_of_cuts_gives_the_same_sums_with_every_squarer() {
    for name in ["stream", "tile-5"] {
        let named = find_machine(name).unwrap();
        let batches = Noise::seeded(named, 3).batches(2, 6);
        let expected = expected(named, &batches);
        for squarer in SQUARERS {
            for cuts in all_cuts(squarer) {
                let machine = with_cuts(&Machine { squarer, ..*named }, cuts);
                assert_eq!(
                    results(&machine, &batches),
                    expected,
                    "{squarer:?}, {cuts:?}"
                );
            }
        }
    }
}
