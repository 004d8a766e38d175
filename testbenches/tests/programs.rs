//! Random legal microprograms, on one cell, 16 and 32; and the shortest program that shows a planted fault.

mod planted;
mod support;

use libtest_mimic::{Arguments, Failed, Trial};
use photoncube_hdl::{Level, emit};
use photoncube_spec::{Machine, Op, Step, find_machine};
use photoncube_testbench::{
    Device, DeviceError, DeviceKind, ProgramOptions, ProgramsError, Text, verify_programs,
};

use planted::edit;

/// Programs for a machine in a device; `photoncube verify --programs` is for more.
const RUNS: [(&str, DeviceKind, u64); 4] = [
    ("paper", DeviceKind::Text, 24),
    ("paper-5d", DeviceKind::Text, 12),
    ("paper", DeviceKind::Icarus, 6),
    ("paper-5d", DeviceKind::Icarus, 4),
];

fn main() {
    let mut trials = Vec::new();
    for (machine, kind, programs) in RUNS {
        let run = move || equal(machine, kind, programs);
        trials.push(support::trial(
            format!("equal::{machine}::{kind}"),
            kind,
            run,
        ));
    }
    trials.push(Trial::test("shrunk::a_nop_that_is_skipped", skipped_nop));
    trials.push(Trial::test("refused::a_machine_without_program", refused));
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

fn options(programs: u64) -> ProgramOptions {
    ProgramOptions {
        programs,
        seed: 3,
        iterations: 50,
    }
}

fn equal(machine: &str, kind: DeviceKind, programs: u64) -> Result<(), Failed> {
    let machine = find_machine(machine)?;
    let open = |machine: &Machine, level| kind.open(machine, level);
    let verdict = verify_programs(machine, &options(programs), &open, &|| ())?;
    assert_eq!(verdict.programs as u64, programs);
    // A program has at least the query's step and nine more, and each iteration takes a clock for each of these.
    assert!(verdict.steps >= 10 * programs);
    assert!(verdict.vectors_compared >= 9 * 50 * programs);
    assert!(verdict.cell_vectors > 0 && verdict.results_compared >= programs);
    Ok(())
}

/// A sequencer that jumps over a step after a nop in the store: the all-reduce has none, so only other programs show
/// it, and the shortest of these is the all-reduce with one nop.
fn skipped_nop() -> Result<(), Failed> {
    let open = |machine: &Machine, level| -> Result<Box<dyn Device>, DeviceError> {
        let mut design = emit(machine, level).expect("the machine is emitted");
        if level == Level::Machine {
            let module = format!("module {}_control(", machine.module_prefix());
            let from = "address_d = address_q + 32'h1;";
            let to = "address_d = address_q + ((store_word == 15'h0) ? 32'h2 : 32'h1);";
            design.text = edit(&design.text, &module, from, to);
        }
        Ok(Box::new(Text::new(&design)?))
    };
    let machine = find_machine("paper")?;
    let found = verify_programs(machine, &options(12), &open, &|| ());
    let Err(ProgramsError::Failed(failure)) = found else {
        return Err(format!("the fault was not found: {found:?}").into());
    };
    let steps = failure.program.steps();
    assert_eq!(steps.len(), 11, "{failure}");
    let nops = steps.iter().filter(|&&step| step == Step::new(Op::Nop));
    assert_eq!(nops.count(), 1, "{failure}");
    assert!(failure.drawn.steps().len() >= steps.len());
    let account = failure.to_string();
    assert!(
        account.contains("nop") && account.contains("control_address"),
        "{account}"
    );
    Ok(())
}

fn refused() -> Result<(), Failed> {
    let open = |machine: &Machine, level| DeviceKind::Text.open(machine, level);
    let found = verify_programs(find_machine("stream")?, &options(1), &open, &|| ());
    assert!(matches!(found, Err(ProgramsError::NoProgram("stream"))));
    Ok(())
}
