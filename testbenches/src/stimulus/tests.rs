//! Tests that the stimulus has the stated properties and is reproducible.

use std::collections::BTreeSet;

use photoncube_spec::{
    Group, Leaf, LeafSizes, MACHINES, Register, Role, SEQUENTIAL, SignalPlace, find_machine,
};
use rand::SeedableRng;
use rand_pcg::Pcg64;

use super::aim::Aim;
use super::*;

/// The clocks that begin a chunk on `paper`: two resets with a query of one group between them.
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
        // A batch always runs to its end: 16 cases of at most this many groups.
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

/// The bits of a signal that some run can set. A distance cell has no coordinate, and its power is a photon's
/// count of 1.
fn reachable_bits(machine: &Machine, name: &str, all: u64) -> u64 {
    let pins = Pins::of(machine);
    let pin = pins.observed.iter().find(|pin| pin.name == name).unwrap();
    let SignalPlace::Cell { node, register } = pin.place else {
        // The count is as wide as the powers, and its largest value is `max_photons`, 2^16 + 1.
        return if name == "result_count" {
            0x1_ffff & all
        } else {
            all
        };
    };
    let distance_cell = machine.hypercube().role(node) == Role::D;
    match register {
        Register::Query | Register::Photon if distance_cell => 0,
        Register::Power(_) if distance_cell => 1,
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
            let step = SEQUENTIAL.op(steps[shown[address] as usize].op);
            let garbage = !inputs.group_valid && inputs.group != Group::default();
            let events = [
                inputs.reset && shown[address] > 1,
                inputs.reset && outputs.result_valid,
                outputs.query_ready && !inputs.query_valid,
                !outputs.query_ready && inputs.query_valid,
                step.reads_group() && !inputs.group_valid,
                outputs.result_valid && !inputs.result_ready,
                garbage,
            ];
            for (met, event) in met.iter_mut().zip(events) {
                *met += u32::from(event);
            }
        }
    }
    // In thousands of clocks an event must occur several times; otherwise the test checks almost nothing.
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
    // While the chunk begins, registers still hold values of the chunk before.
    let begun = SCRUB_CLOCKS * Pins::of(machine).observed.len();
    for (index, (alone, wanted)) in alone.iter().zip(&wanted).enumerate() {
        let from = if index == 0 { begun } else { 0 };
        // Another limit may end the last block early.
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

/// In `overlap` a lane's sum crosses links that are as wide as the sum of a whole query.
#[test]
fn a_lane_alone_is_given_all_of_a_querys_photons() {
    let machine = find_machine("overlap").unwrap();
    let pins = Pins::of(machine);
    let mut seen = vec![0; pins.observed.len()];
    for block in blocks(machine, Source::LaneAlone, 1, 1) {
        for row in block.inputs.chunks(pins.inputs.len()) {
            let inputs = Pins::inputs_of(machine, row);
            let present = inputs.group.lanes.iter().filter(|lane| lane.present);
            assert!(!inputs.group_valid || present.count() <= 1);
        }
        for row in block.expected.chunks(pins.observed.len()) {
            for (seen, value) in seen.iter_mut().zip(row) {
                *seen |= value;
            }
        }
    }
    for (seen, pin) in seen.iter().zip(&pins.observed) {
        let SignalPlace::Cell { node, register } = pin.place else {
            continue;
        };
        let wanted = match machine.hypercube().role(node) {
            Role::D => 0x1_ffff,
            _ => 0xffff_ffff,
        };
        if register == Register::Sum {
            assert_eq!(seen & wanted, wanted, "{}: {seen:#x}", pin.name);
        }
    }
}

/// Random stimulus fills neither the queue of pairs nor the batches under way.
#[test]
fn a_full_bank_fills_every_queue_of_a_leaf_machine() {
    for name in ["leaf-4-local6x2-rgb4d-n1024", "leaf-5-local7-rgb6d-n1024"] {
        let machine = find_machine(name).unwrap();
        let sizes = LeafSizes::of(machine.leaf().unwrap());
        let observed = Pins::of(machine).observed;
        let blocks = blocks(machine, Source::FullBank, 1, 1);
        let most = |register: &str| {
            let column = observed.iter().position(|pin| pin.name == register);
            let rows = blocks
                .iter()
                .flat_map(|block| block.expected.chunks(observed.len()));
            rows.map(|row| row[column.unwrap()]).max()
        };
        let under_way = sizes.most_outstanding.into();
        assert_eq!(most("leaf_outstanding_0"), Some(under_way), "{name}");
        assert_eq!(
            most("leaf_queue_count_0"),
            Some(sizes.queue().into()),
            "{name}"
        );
    }
}

/// The box of a leaf is a point at the search radius, or next to it, in either place of a pair. Random photons at the
/// radius are on all sides of the query, so the box around several of them overlaps the query's.
#[test]
fn leaves_are_just_wanted_and_just_not() {
    let machine = find_machine("leaf-5-local7-rgb6d-n64").unwrap();
    let (aim, limit) = (Aim::of(machine), machine.fixed_radius_sq().unwrap());
    let mut rng = Pcg64::seed_from_u64(1);
    let mut cases = Cases::new(machine, &mut rng);
    let mut met = BTreeSet::new();
    for case in (0..5_000).map(|_| cases.case()) {
        let query = case.queries[0].position;
        if case.queries.iter().any(|other| other.position != query) {
            continue;
        }
        for (number, leaf) in case.groups.chunks(Leaf::GROUPS).enumerate() {
            let photons: Vec<_> = leaf.iter().flat_map(Group::photons).collect();
            let places: BTreeSet<_> = photons.iter().map(|photon| photon.position).collect();
            if let (1, true, Some(&place)) = (places.len(), photons.len() > 2, places.first()) {
                let off = aim.distance_sq(query, place) as i64 - i64::from(limit);
                met.insert((number % Leaf::PAIR, off));
            }
        }
    }
    for leaf in 0..Leaf::PAIR {
        for off in -1..=1 {
            assert!(met.contains(&(leaf, off)), "leaf {leaf}, {off}");
        }
    }
}
