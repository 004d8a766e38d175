//! Waiting streams, resets, unknown words and power-up, by class, on one machine of each organisation; and a planted
//! fault for each class, which it must find.

mod support;

use libtest_mimic::{Arguments, Failed};
use photoncube_hdl::{Emitted, Level, emit};
use photoncube_spec::{Machine, find_machine};
use photoncube_testbench::{
    DeviceKind, FaultClass, VerifyError, verify_fault, verify_fault_text, without_initial_values,
};

const MACHINES: [&str; 3] = ["paper", "overlap", "stream"];

fn main() {
    let mut trials = Vec::new();
    for name in MACHINES {
        for class in FaultClass::ALL {
            let title = format!("{name}::{class:?}");
            trials.push(support::trial(title, device(class), move || sound(name, class)));
        }
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

/// The evaluator of the emitted text, where that can show the fault.
fn device(class: FaultClass) -> DeviceKind {
    match class.is_four_state() {
        true => DeviceKind::Icarus,
        false => DeviceKind::Text,
    }
}

fn sound(name: &str, class: FaultClass) -> Result<(), Failed> {
    let machine = find_machine(name)?;
    let verdict = verify_fault(machine, class, device(class), 1)?;
    eprintln!("{verdict:?}");
    assert_eq!(verdict.mismatches, 0);
    assert!(verdict.injections > 0 && verdict.results_compared > 0);
    assert!(verdict.vectors_compared > 100);
    Ok(())
}
