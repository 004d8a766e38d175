//! The emitted Verilog of cores equals the golden model, pin by pin, in every clock.

use photoncube_spec::{Core, find_machine};
use photoncube_testbench::{CoreOptions, DeviceKind, core_controls, verify_core};

fn core(chains: u32, machine: &str) -> Core {
    Core::new(find_machine(machine).unwrap(), chains).unwrap()
}

#[test]
fn a_core_of_three_chains_equals_its_model_and_every_event_occurs() {
    for machine in ["leaf-5-local7-rgb6d-n64", "leaf-5-radii-local7-rgb6d-n64"] {
        let core = core(3, machine);
        let options = CoreOptions::new(CoreOptions::CLOCKS, 1);
        let verdict = verify_core(&core, DeviceKind::Text, &options, &|_| ()).unwrap();
        assert_eq!(verdict.vectors_compared, CoreOptions::CLOCKS);
        assert_eq!(verdict.events.len(), 7);
        println!("{verdict:?}");
    }
}

/// One engine, whose queries are batches of their own, and half steps.
#[test]
fn the_rounds_of_single_queries_equal_their_model() {
    let core = core(2, "leaf-4-radii-local6x2-rgb4d-n64");
    let options = CoreOptions::new(CoreOptions::CLOCKS, 1);
    let verdict = verify_core(&core, DeviceKind::Text, &options, &|_| ()).unwrap();
    assert!(
        verdict.results_compared > verdict.query_beats / 2,
        "{verdict:?}"
    );
}

#[test]
fn faults_in_each_module_of_a_core_are_found() {
    for (machine, faults) in [
        ("leaf-5-local7-rgb6d-n64", 13),
        ("leaf-5-radii-local7-rgb6d-n64", 22),
    ] {
        let controls = core_controls(&core(3, machine), DeviceKind::Text, 1).unwrap();
        assert_eq!(controls.len(), faults);
        for control in controls {
            assert!(control.found, "{}", control.planted);
        }
    }
}
