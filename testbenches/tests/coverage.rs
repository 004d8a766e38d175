//! Requires that a verification uses all of the emitted Verilog, except the parts with a recorded reason.

mod support;

use libtest_mimic::{Arguments, Failed};
use photoncube_spec::{Machine, find_machine};
use photoncube_testbench::{
    Coverage, CoverageKind, DeviceKind, Source, VerifyOptions, corners, coverage,
};

/// The sequential machine and the spatial machine that is built fastest, each with iterations that use all bits of its sums.
const MACHINES: [(&str, u64); 2] = [("paper", 50_000), ("stream", 100_000)];

fn main() {
    let mut trials = Vec::new();
    let kind = DeviceKind::Verilator;
    for (machine, iterations) in MACHINES {
        let run = move || all_is_used_or_explained(machine, iterations);
        trials.push(support::trial(format!("all::{machine}"), kind, run));
    }
    let name = "few::what_is_not_used_has_no_reason".to_owned();
    trials.push(support::trial(name, kind, few_iterations_leave_gaps));
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

fn covered(machine: &Machine, iterations: u64, corners: &[Source]) -> Result<Coverage, Failed> {
    let options = VerifyOptions {
        iterations,
        seed: 1,
        source: Source::Random,
    };
    Ok(coverage(machine, &options, corners, &|_| ())?)
}

fn all_is_used_or_explained(machine: &str, iterations: u64) -> Result<(), Failed> {
    let machine = find_machine(machine)?;
    let found = covered(machine, iterations, &corners(machine))?;
    let unexplained: Vec<_> = found.unexplained().collect();
    assert!(unexplained.is_empty(), "{unexplained:#?}");
    assert!(
        found.contradictions.is_empty(),
        "{:#?}",
        found.contradictions
    );
    for kind in CoverageKind::ALL {
        assert!(found.total(kind).covered > 0, "{kind:?}");
    }
    assert!(found.verdict.vectors_compared >= iterations);
    let controls = &found.controls;
    assert!(!controls.is_empty() && controls.iter().all(|control| control.found));
    Ok(())
}

fn few_iterations_leave_gaps() -> Result<(), Failed> {
    let found = covered(find_machine("paper")?, 3, &[])?;
    assert!(found.unexplained().count() > 0);
    let sums = found
        .unexplained()
        .find(|gap| gap.what.starts_with("result_red["));
    assert!(sums.is_some(), "three groups do not fill a sum");
    Ok(())
}
