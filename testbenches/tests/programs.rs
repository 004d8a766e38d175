//! Verifies random microprograms, on one cell, 16 and 32; finds the shortest program that shows a planted
//! fault; and requires that programs which differ from the model are found.

mod support;

use libtest_mimic::{Arguments, Failed, Trial};
use photoncube_hdl::{Level, emit};
use photoncube_spec::{Machine, Microprogram, Op, Step, check_streams, find_machine};
use photoncube_testbench::{
    Device, DeviceError, DeviceKind, Mutant, Open, ProgramFailure, ProgramOptions, ProgramsError,
    Source, Text, VerifyError, VerifyOptions, draw_program, plant, program_control, programmed,
    verify_device, verify_programs,
};
use verilog_eval::modules;

/// The number of programs for a machine in a device. `photoncube verify programs` runs more.
const RUNS: [(&str, DeviceKind, u64); 6] = [
    ("paper", DeviceKind::Text, 32),
    ("paper-5d", DeviceKind::Text, 16),
    // Other numbers, and a store of 16 words.
    ("local", DeviceKind::Text, 8),
    ("paper", DeviceKind::RustHdl, 4),
    ("paper", DeviceKind::Icarus, 6),
    ("paper-5d", DeviceKind::Icarus, 4),
];

/// A trial that needs no tool.
type Run = fn() -> Result<(), Failed>;

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
    let plain: [(&str, Run); 7] = [
        ("shrunk::a_nop_that_is_skipped", skipped_nop),
        ("shrunk::a_gate_that_squares", gate_that_squares),
        ("shrunk::an_adder_of_the_cell", adder_of_the_cell),
        ("repeated::a_failure_fails_by_its_command", repeated),
        ("control::of_every_run", control),
        ("control::one_other_step", one_other_step),
        ("refused::nothing_and_a_machine_without_program", refused),
    ];
    for (name, run) in plain {
        trials.push(Trial::test(name, run));
    }
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
    assert!(verdict.drawn >= programs && verdict.steps >= 3 * programs);
    assert!(verdict.vectors_compared >= 2 * 50 * programs);
    let gathers = verdict.gather_programs as u64;
    assert!(gathers > 0 && gathers < programs, "{verdict:?}");
    assert!(verdict.cell_vectors > 0 && verdict.results_compared >= gathers);
    Ok(())
}

/// Opens the emitted text of programmed machines with `from` replaced by `to` in one module.
fn edited(module: &'static str, from: &'static str, to: &'static str) -> Box<Open<'static>> {
    Box::new(move |machine, level| {
        let mut design = emit(machine, level).expect("the machine is emitted");
        let module = format!("{}_{module}", design.top);
        let place = modules(&design.text)
            .into_iter()
            .find(|of| of.name == module);
        if let Some(place) = place.map(|module| module.place) {
            let body = design.text[place.clone()].replace(from, to);
            design.text.replace_range(place, &body);
        }
        Ok(Box::new(Text::new(&design)?))
    })
}

fn failure(open: &Open<'_>, options: &ProgramOptions) -> Result<ProgramFailure, Failed> {
    match verify_programs(find_machine("paper")?, options, open, &|| ()) {
        Err(ProgramsError::Failed(failure)) => Ok(*failure),
        Err(other) => Err(other.into()),
        Ok(found) => Err(format!("the fault was not found: {found:?}").into()),
    }
}

fn ops(failure: &ProgramFailure) -> Vec<Op> {
    let steps = failure.program.steps();
    steps.iter().map(|step| step.op).collect()
}

/// A sequencer that skips the step after a nop. The all-reduce has no nop, so only other programs show the
/// fault. The shortest has the two streams and a nop.
fn skipped_nop() -> Result<(), Failed> {
    let open = |machine: &Machine, level| -> Result<Box<dyn Device>, DeviceError> {
        let mut design = emit(machine, level).expect("the machine is emitted");
        if level == Level::Machine {
            let module = format!("{}_control", machine.module_prefix());
            let from = "address_d = address_q + 32'h1;";
            let to = "address_d = address_q + ((store_word == 15'h0) ? 32'h2 : 32'h1);";
            design.text = plant(&design.text, &module, from, to)?;
        }
        Ok(Box::new(Text::new(&design)?))
    };
    let failure = failure(&open, &options(12))?;
    let ops = ops(&failure);
    assert!(ops.contains(&Op::Nop) && ops.len() <= 4, "{failure}");
    assert!(failure.drawn.program.steps().len() >= ops.len());
    let account = failure.to_string();
    assert!(
        account.contains("nop") && account.contains("control_address"),
        "{account}"
    );
    Ok(())
}

/// A control store with the word of `sqd` in place of each `gate`. A query, a group and the gate show the
/// fault; these are the fewest steps of any program.
fn gate_that_squares() -> Result<(), Failed> {
    let open = edited("store", "15'b1001000;", "15'b1000;");
    let failure = failure(&*open, &options(24))?;
    let ops = ops(&failure);
    assert_eq!(ops.len(), 3, "{failure}");
    assert_eq!((ops[0], ops[2]), (Op::LoadQuery, Op::Gate), "{failure}");
    assert!(failure.iterations < 50, "{failure}");
    let account = failure.to_string();
    assert!(account.contains("step      gate"), "{account}");
    assert!(account.contains("iteration:\n   0  ld"), "{account}");
    Ok(())
}

/// An adder without its carries. One cell shows it, with a load, a word to add, and the add.
fn adder_of_the_cell() -> Result<(), Failed> {
    let open = |machine: &Machine, level| -> Result<Box<dyn Device>, DeviceError> {
        let mut design = emit(machine, level).expect("the machine is emitted");
        design.text = design.text.replace("a + b", "a ^ b");
        Ok(Box::new(Text::new(&design)?))
    };
    let failure = failure(&open, &options(24))?;
    let ops = ops(&failure);
    assert!(ops.len() <= 4, "{failure}");
    let adds = |op: &Op| matches!(op, Op::Add | Op::Accumulate);
    assert!(ops.iter().any(adds), "{failure}");
    Ok(())
}

/// The failure of a program occurs again in a run of one program with its seed.
fn repeated() -> Result<(), Failed> {
    // The store lacks `add x`, which not all programs have.
    let open = edited("store", "15'b100000101000;", "15'b0;");
    let first = failure(&*open, &options(24))?;
    let seed = first.drawn.seed;
    let again = failure(&*open, &ProgramOptions { seed, ..options(1) })?;
    assert_eq!(first.to_string(), again.to_string());
    let command =
        format!("photoncube verify programs 1 --machine paper --against text --seed {seed}");
    assert!(first.to_string().contains(&command), "{first}");
    Ok(())
}

/// The fault that every run of `photoncube verify programs` plants.
fn control() -> Result<(), Failed> {
    assert!(program_control()?.found);
    Ok(())
}

/// The text of a program with one step changed, compared with the model of the original program. The
/// difference is found exactly where the golden model of the changed program differs too.
fn one_other_step() -> Result<(), Failed> {
    let paper = find_machine("paper")?;
    let (mut seen, mut alike) = (0, 0);
    for seed in 0..40 {
        let drawn = draw_program(paper, seed);
        let Some(other) = with_another_step(paper, &drawn.program, seed as usize) else {
            continue;
        };
        let machine = programmed(paper, &drawn.program);
        let text = differs(&machine, &mut Text::new(&emit(&other, Level::Machine)?)?)?;
        let model = differs(&machine, &mut Mutant::sound(&other))?;
        assert_eq!(text, model, "{}", drawn.program);
        *(if text { &mut seen } else { &mut alike }) += 1;
    }
    // A value that no later step reads may differ.
    assert!(seen >= 25 && alike <= 10, "{seen} seen, {alike} alike");
    Ok(())
}

fn differs(machine: &Machine, device: &mut dyn Device) -> Result<bool, Failed> {
    let options = VerifyOptions {
        iterations: 40,
        seed: 1,
        source: Source::Random,
    };
    match verify_device(machine, device, &options, &|_| {}) {
        Ok(_) => Ok(false),
        Err(VerifyError::Diverged(_)) => Ok(true),
        Err(other) => Err(other.into()),
    }
}

/// The program with one computing step replaced by another op; `None` where there is no such step.
fn with_another_step(machine: &Machine, program: &Microprogram, seed: usize) -> Option<Machine> {
    let mut steps = program.steps();
    let query = program.query_clocks() as usize;
    let computes =
        |step: &Step| matches!(step.op, Op::SquareDifference | Op::Gate | Op::Accumulate);
    let places: Vec<_> = (query..steps.len())
        .filter(|&place| computes(&steps[place]))
        .collect();
    let place = *places.get(seed % places.len().max(1))?;
    steps[place] = Step::new(match steps[place].op {
        Op::Gate => Op::SquareDifference,
        _ => Op::Nop,
    });
    let (query, iteration) = steps.split_at(query);
    let other = Microprogram::of_phases(query, iteration);
    assert_eq!(check_streams(&other, machine.hypercube()), Ok(()));
    Some(programmed(machine, &other))
}

fn refused() -> Result<(), Failed> {
    let open = |machine: &Machine, level| DeviceKind::Text.open(machine, level);
    let found = verify_programs(find_machine("stream")?, &options(1), &open, &|| ());
    assert!(matches!(found, Err(ProgramsError::NoProgram("stream"))));
    let none = verify_programs(find_machine("paper")?, &options(0), &open, &|| ());
    let message = none.unwrap_err().to_string();
    assert!(message.contains("nothing was compared"), "{message}");
    Ok(())
}
