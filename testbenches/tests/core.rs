//! The emitted Verilog of cores equals the golden model, pin by pin, in every clock.

use photoncube_spec::{Core, find_machine};
use photoncube_testbench::{CoreOptions, DeviceKind, core_controls, verify_core};

fn core(chains: u32, machine: &str) -> Core {
    Core::new(find_machine(machine).unwrap(), chains).unwrap()
}

#[test]
fn a_core_of_three_chains_equals_its_model_and_every_event_occurs() {
    let core = core(3, "leaf-5-local7-rgb6d-n64");
    let options = CoreOptions::new(CoreOptions::CLOCKS, 1);
    let verdict = verify_core(&core, DeviceKind::Text, &options, &|_| ()).unwrap();
    assert_eq!(verdict.vectors_compared, CoreOptions::CLOCKS);
    assert_eq!(verdict.events.len(), 7);
    println!("{verdict:?}");
}

#[test]
fn faults_in_each_module_of_a_core_are_found() {
    let core = core(3, "leaf-5-local7-rgb6d-n64");
    for control in core_controls(&core, DeviceKind::Text, 1).unwrap() {
        assert!(control.found, "{}", control.planted);
    }
}
