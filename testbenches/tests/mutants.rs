//! Requires that each mutant of the emitted Verilog is killed by the stimulus, or proven equal to the design.

mod support;

use libtest_mimic::{Arguments, Failed};
use photoncube_spec::find_machine;
use photoncube_testbench::{
    DeviceKind, Fate, Judged, MutantOptions, MutantPart, is_equal_alone, mutants, record_mutant,
};

/// The number of mutants. `photoncube verify mutants` judges more, and those of other machines.
const MUTANTS: u64 = 12;

fn main() {
    let subjects = [
        ("paper", MutantPart::Machine),
        ("tile-6-mixed", MutantPart::Memory),
    ];
    let trials = subjects.map(|(machine, part)| {
        let name = format!("none_survives::{machine}::{}", part.name());
        let run = move || none_survives(machine, part);
        // The test needs Yosys and Verilator, which are the tools of these two devices.
        match DeviceKind::Netlist.missing_tool() {
            Some(_) => support::trial(name, DeviceKind::Netlist, run),
            None => support::trial(name, DeviceKind::Verilator, run),
        }
    });
    let alone = support::trial(
        "a_module_alone_shows_what_its_outputs_show".to_owned(),
        DeviceKind::Netlist,
        a_module_alone_shows_what_its_outputs_show,
    );
    let trials = trials.into_iter().chain([alone]).collect();
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

fn none_survives(machine: &str, part: MutantPart) -> Result<(), Failed> {
    let options = MutantOptions {
        part,
        mutants: MUTANTS,
        seed: 2,
        iterations: 3_000,
        more_iterations: 200_000,
    };
    let report = mutants(find_machine(machine)?, &options, &|_| ())?;
    let survived = report.mutants.iter().filter(|m| m.fate == Fate::Survived);
    let survived: Vec<_> = survived.collect();
    assert!(survived.is_empty(), "{survived:#?}");
    let killed = report.count(Fate::Killed);
    assert!(killed > report.mutants.len() / 2, "{killed} killed");
    assert!(report.mutants.len() as u64 >= MUTANTS / 2);
    // The proofs fail on designs that are known to differ.
    let controls = &report.controls;
    assert!(!controls.is_empty() && controls.iter().all(|control| control.found));
    assert!(report.vectors_compared > 0);
    let killed = report.mutants.iter().find(|m| m.fate == Fate::Killed);
    recorded(machine, &options, killed.ok_or("none was killed")?)
}

/// Two squares of the comparison of boxes have a sum of 15 bits. Where bit 14 is set, no radius is large enough, so bit 10 may then be
/// another. Where bit 13 is set, it may not. An engine's registers are observed, so no module of an engine is proven alone.
fn a_module_alone_shows_what_its_outputs_show() -> Result<(), Failed> {
    let machine = find_machine("leaf-5-radii-local7-rgb6d-n64")?;
    let is_equal = |module: &str, control: u32| {
        let options = format!(
            "-mode cnot1 -module {{prefix}}_{module} -cell pair_square -port d -portbit 10 -ctrlbit {control} \
             -wire pair_sum_sum -wirebit 10"
        );
        is_equal_alone(machine, &options)
    };
    assert!(is_equal("lane_3", 14)?);
    assert!(!is_equal("lane_3", 13)?);
    assert!(!is_equal("lane_2", 14)?);
    let clock = "-mode const0 -module {prefix}_lane_3 -cell pair_square -port clock -portbit 0";
    assert!(!is_equal_alone(machine, clock)?);
    Ok(())
}

/// A killed mutant's waveform shows the first difference. A part of a machine has no golden model beside it.
fn recorded(machine: &str, options: &MutantOptions, killed: &Judged) -> Result<(), Failed> {
    let machine = find_machine(machine)?;
    let recorded = record_mutant(machine, options, killed.mutation.mutant, 100)?;
    let recorded = recorded.ok_or("a mutant of the report has a number")?;
    assert!(recorded.killed && recorded.mutation == killed.mutation);
    let has_model = options.part == MutantPart::Machine;
    assert_eq!(recorded.waves.difference().is_some(), has_model);
    assert!(!recorded.waves.clocks().is_empty());
    assert!(record_mutant(machine, options, u64::MAX, 1)?.is_none());
    Ok(())
}
