//! Compares the step-exact machine with the direct gather, two independent readings of one spec.

use photoncube_model::{gather, golden_machine};
use photoncube_spec::{Group, Inputs, Lane, MACHINES, Machine, Photon, Query, Sums, Widths};
use proptest::prelude::*;

/// Runs one query through the machine, group by group, with streams that wait as long as needed. A machine
/// that tests several queries at once gets the query several times and must return equal results. Also
/// returns the clocks until the first result.
fn run(machine: &Machine, query: Query, groups: &[Group]) -> (Sums, u64) {
    let mut dut = golden_machine(machine);
    let mut next_group = 0;
    let mut results = Vec::new();
    let mut first_clock = 0;
    // The query's valid stays set, as it may with queries of a next batch. These wait, since no group
    // follows.
    let mut inputs = Inputs {
        query_valid: true,
        query,
        group_valid: true,
        group: groups[0].clone(),
        result_ready: true,
        ..Inputs::default()
    };
    let limit = 100 * (groups.len() + machine.queries_at_once()) as u64;
    for clock in 0..limit {
        let outputs = dut.outputs(&inputs);
        if outputs.result_valid {
            if results.is_empty() {
                first_clock = clock;
            }
            results.push(outputs.result);
        }
        if results.len() == machine.queries_at_once() {
            assert!(results.iter().all(|sums| *sums == results[0]));
            return (results[0], first_clock);
        }
        dut.clock(&inputs);
        if outputs.group_ready {
            next_group += 1;
            inputs.group_valid = next_group < groups.len();
            inputs.group = groups.get(next_group).cloned().unwrap_or_default();
        }
    }
    panic!("the machine hangs")
}

fn photon(machine: &Machine) -> impl Strategy<Value = Photon> + use<> {
    let widths = Widths::of(machine);
    let channels = machine.channels().names().len();
    let exponents = machine.numbers.power().exponent_range();
    (
        prop::array::uniform3(0..1_u32 << widths.photon),
        prop::array::uniform3(0..1_u32 << widths.mantissa),
        0..=exponents,
    )
        .prop_map(move |(position, mut power, exponent)| {
            power[channels..].fill(0);
            Photon {
                position,
                power,
                exponent,
            }
        })
}

/// Any radius that the machine accepts, its largest radius, or its only one.
fn query(machine: &Machine) -> impl Strategy<Value = Query> + use<> {
    let widths = Widths::of(machine);
    let largest = machine.numbers.largest_radius_word();
    let radius_sq = match machine.fixed_radius_sq() {
        Some(radius_sq) => Just(radius_sq).boxed(),
        None => prop_oneof![0..=largest, Just(largest)].boxed(),
    };
    (
        prop::array::uniform3(0..1_u32 << widths.coordinate),
        radius_sq,
    )
        .prop_map(|(position, radius_sq)| Query {
            position,
            radius_sq,
        })
}

fn groups(machine: &Machine) -> impl Strategy<Value = Vec<Group>> {
    let lanes = machine.photons_per_iteration();
    let lane = (prop::bool::weighted(0.8), photon(machine))
        .prop_map(|(present, photon)| Lane { present, photon });
    prop::collection::vec(prop::collection::vec(lane, lanes), 1..6).prop_map(|groups| {
        let count = groups.len();
        let with_last = |(index, lanes)| Group {
            lanes,
            last: index + 1 == count,
            facing: 0,
        };
        groups.into_iter().enumerate().map(with_last).collect()
    })
}

fn case() -> impl Strategy<Value = (&'static Machine, Query, Vec<Group>)> {
    prop::sample::select(MACHINES).prop_flat_map(|machine| {
        let machine: &'static Machine = MACHINES.iter().find(|m| **m == machine).unwrap();
        (Just(machine), query(machine), groups(machine))
    })
}

proptest! {
    #[test]
    fn step_machine_and_direct_gather_agree((machine, query, groups) in case()) {
        let photons = groups.iter().flat_map(Group::photons);
        let expected = gather(machine, &query, photons).unwrap();
        let (sums, clocks) = run(machine, query, &groups);
        prop_assert_eq!(sums, expected);
        if let Some(program) = machine.overlap_program() {
            prop_assert_eq!(clocks, program.latency_clocks(groups.len() as u64));
        }
        if let Some(program) = machine.microprogram() {
            prop_assert_eq!(clocks, program.latency_clocks(groups.len() as u64));
        }
    }

    #[test]
    fn the_order_of_the_photons_does_not_matter(
        (machine, query, groups) in case(),
        rotation in 0_usize..20,
    ) {
        let mut photons: Vec<_> = groups.iter().flat_map(Group::photons).collect();
        let before = gather(machine, &query, photons.iter().copied()).unwrap();
        photons.reverse();
        let length = photons.len().max(1);
        photons.rotate_left(rotation % length);
        prop_assert_eq!(gather(machine, &query, photons).unwrap(), before);
    }
}
