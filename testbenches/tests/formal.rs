//! The quick formal proofs, each with its covers and its planted faults. `photoncube verify formal` runs
//! all proofs.

mod support;

use libtest_mimic::{Arguments, Failed};
use photoncube_spec::find_machine;
use photoncube_testbench::{DeviceKind, formal};

/// By machine, the prefixes of the names of the properties that are proven here.
const QUICK: &[(&str, &[&str])] = &[
    (
        "paper",
        &[
            "units::",
            "control::",
            "streams::",
            "links::",
            "sums::",
            "netlist::cell",
            "netlist::control",
        ],
    ),
    (
        "overlap",
        &["units::", "control::", "links::", "netlist::cell"],
    ),
    (
        "stream",
        &[
            "units::",
            "sums::",
            "streams::admission",
            "netlist::lane",
            "netlist::square_pair",
        ],
    ),
    // Other sizes: a hypercube's fifth axis, the clamped difference and half square of a photon format, a
    // square of fewer digits, several engines, a product in place of digits.
    ("paper-5d", &["cell::", "control::", "network::", "links::"]),
    ("paper-dsp", &["units::"]),
    ("local-half", &["units::", "cell::", "sums::"]),
    ("fit-ring", &["units::", "cell::", "sums::"]),
    ("fit-range", &["units::"]),
    ("tile-4", &["units::", "sums::"]),
    (
        "tile-6-mixed",
        &["units::", "memory::sets", "netlist::memory"],
    ),
    (
        "leaf-5-local7-rgb6d-n64",
        &[
            "leaves::",
            "units::unless_blank",
            "units::token_place",
            "netlist::box_words",
        ],
    ),
];

fn main() {
    let mut trials = Vec::new();
    for &(machine, names) in QUICK {
        for &name in names {
            let run = move || all_hold(machine, name);
            let trial = format!("{machine}::{}", name.trim_end_matches(':'));
            trials.push(support::trial(trial, DeviceKind::Netlist, run));
        }
    }
    let name = "nothing::is_no_proof".to_owned();
    trials.push(support::trial(
        name,
        DeviceKind::Netlist,
        nothing_is_an_error,
    ));
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

fn all_hold(machine: &str, begins: &str) -> Result<(), Failed> {
    let machine = find_machine(machine)?;
    let found = formal(machine, &|name| name.starts_with(begins), &|_, _| ())?;
    let failed: Vec<_> = found.failed().collect();
    assert!(failed.is_empty(), "{failed:#?}");
    assert!(!found.proofs.is_empty());
    Ok(())
}

fn nothing_is_an_error() -> Result<(), Failed> {
    let error = formal(find_machine("paper")?, &|_| false, &|_, _| ()).unwrap_err();
    assert!(error.to_string().contains("units::difference"), "{error}");
    Ok(())
}
