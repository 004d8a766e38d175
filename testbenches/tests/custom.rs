//! Verifies custom machines: the generator that cargo builds emits the text that is compared, and runs rust-hdl's
//! simulation.

use photoncube_hdl::{Level, lint_machine};
use photoncube_spec::find_machine;
use photoncube_testbench::{DeviceKind, Protocol, Source, VerifyOptions, verify, verify_part};

/// Formats that no named machine has: half steps, a radius of few bits, exponents, one channel.
const MACHINES: [&str; 3] = [
    "stream-local6x2-rgb4e2d-n4096",
    "tile-5-local5x1-mono3-n64",
    "sequential-local5x2-rgb3b2d-n4096",
];

/// Leaf machines: two engines with banks of two pairs of leaves; one engine, half steps and squares from products; exponents and
/// one channel; and queries that each have a radius, of whole and of half steps.
const LEAF_MACHINES: [&str; 5] = [
    "leaf-5-local7-rgb6d-n32",
    "leaf-4-local6x2-rgb4d-n256",
    "leaf-6-local8-mono3e4-n128",
    "leaf-5-radii-local7-rgb6d-n32",
    "leaf-4-radii-local6x2-rgb4d-n256",
];

/// Shallow pipelines: one engine with a radius for each query, a chain, and squares from products on half steps.
const SHALLOW_MACHINES: [&str; 3] = [
    "stream-shallow-local8-rgb8d-n16384",
    "tile-6-shallow-local7-rgb6d-n4096",
    "tile-5-shallow-local6x2-rgb4d-n256",
];

/// Fine pipelines: engines of all kinds of squarers, and squares from digits and products alone.
const FINE_MACHINES: [&str; 2] = [
    "tile-6-fine-local7-mono1-n256",
    "tile-7-fine-local8-rgb6d-n256",
];

fn equal(name: &str, kind: DeviceKind, iterations: u64) {
    equal_on(name, kind, Source::Random, iterations);
}

fn equal_on(name: &str, kind: DeviceKind, source: Source<'_>, iterations: u64) {
    let machine = find_machine(name).unwrap();
    let options = VerifyOptions {
        iterations,
        seed: 1,
        source,
    };
    let verdict = verify(machine, kind, &options, &|_| ()).unwrap();
    assert!(
        verdict.registers_compared && verdict.iterations >= iterations,
        "{name}"
    );
    assert!(verdict.results_compared > 0);
}

#[test]
fn the_emitted_text_of_custom_machines_equals_the_golden_model() {
    for name in MACHINES {
        equal(name, DeviceKind::Text, 1_000);
    }
}

/// Random stimulus, the largest sums, streams that wait, and a reset at every clock of a query.
fn pipelines_equal(names: &[&str]) {
    for &name in names {
        let machine = find_machine(name).unwrap();
        let largest = machine.max_photons() / machine.photons_per_iteration() as u64;
        for (source, iterations) in [
            (Source::Random, 1_000),
            (Source::FullThenEmpty, 2 * largest),
            (Source::Protocol(Protocol::FewStalls), 1),
            (Source::Protocol(Protocol::Holds), 1),
            (Source::Protocol(Protocol::Resets), 1),
        ] {
            equal_on(name, DeviceKind::Text, source, iterations);
        }
    }
}

#[test]
fn the_emitted_text_of_shallow_pipelines_equals_the_golden_model() {
    pipelines_equal(&SHALLOW_MACHINES);
}

#[test]
fn the_emitted_text_of_fine_pipelines_equals_the_golden_model() {
    pipelines_equal(&FINE_MACHINES);
}

/// Each register of the memory of leaves, of the comparison of boxes and of the chain, in every clock. Every result also equals the
/// direct gather over the photons of its set, so no photon in range is skipped.
#[test]
fn the_emitted_text_of_leaf_machines_equals_the_golden_model() {
    for name in LEAF_MACHINES {
        equal(name, DeviceKind::Text, 1_500);
    }
}

/// Banks filled to their last place, streams that wait, and a reset at every clock of a query.
#[test]
fn the_streams_of_a_leaf_machine_may_wait_and_be_reset() {
    let sources = [
        Source::FullBank,
        Source::Protocol(Protocol::FewStalls),
        Source::Protocol(Protocol::Holds),
        Source::Protocol(Protocol::Resets),
    ];
    for source in sources {
        equal_on(LEAF_MACHINES[0], DeviceKind::Text, source, 1);
    }
}

#[test]
fn the_lint_of_a_leaf_machine_finds_nothing() {
    let linted = lint_machine(find_machine(LEAF_MACHINES[0]).unwrap()).unwrap();
    assert_eq!(linted.findings, Vec::<String>::new());
    assert!(linted.generated > 100);
}

#[test]
fn rust_hdls_simulation_of_a_custom_machine_runs_in_its_generator() {
    equal(MACHINES[0], DeviceKind::RustHdl, 50);
}

/// Of a custom machine too the lint reads every generated block.
#[test]
fn the_lint_of_a_custom_machine_finds_nothing() {
    let linted = lint_machine(find_machine(MACHINES[0]).unwrap()).unwrap();
    assert_eq!(linted.findings, Vec::<String>::new());
    assert!(linted.generated > 100);
}

/// The pair of squares on half steps, for coordinates of all themes.
#[test]
fn a_part_of_a_custom_machine_equals_the_golden_model() {
    let machine = find_machine(MACHINES[0]).unwrap();
    verify_part(machine, Level::SquarePair, DeviceKind::Text, 1 << 12, 1).unwrap();
}
