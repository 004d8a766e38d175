//! Tests the comparison itself on golden models with faults: each difference is found and named, and a
//! comparison of nothing fails.

use std::cell::RefCell;

use photoncube_spec::{MACHINES, Machine, Photon, Pins, Query};
use photoncube_testbench::{
    Activity, Actual, Device, DeviceError, Divergence, Mutant, Observed, Source, Verdict,
    VerifyError, VerifyOptions, verify_device,
};

const PAPER: &Machine = &MACHINES[0];

fn random(iterations: u64, seed: u64) -> VerifyOptions<'static> {
    VerifyOptions {
        iterations,
        seed,
        source: Source::Random,
    }
}

fn run(mut device: impl Device, options: &VerifyOptions<'_>) -> Result<Verdict, VerifyError> {
    verify_device(PAPER, &mut device, options, &|_| {})
}

fn divergence(device: impl Device, options: &VerifyOptions<'_>) -> Divergence {
    match run(device, options) {
        Err(VerifyError::Diverged(divergence)) => *divergence,
        other => panic!("expected a divergence, found {other:?}"),
    }
}

#[test]
fn a_sound_device_passes_and_all_is_counted() {
    let told = RefCell::new(Vec::new());
    let mut device = Mutant::sound(PAPER);
    let progress = |iterations| told.borrow_mut().push(iterations);
    let verdict = verify_device(PAPER, &mut device, &random(500, 1), &progress).unwrap();
    assert!(verdict.iterations >= 500);
    assert!(verdict.vectors_compared > 9 * verdict.iterations);
    assert_eq!(verdict.signals_per_vector, Pins::of(PAPER).observed.len());
    assert!(verdict.registers_compared && verdict.results_compared > 100);
    let told = told.into_inner();
    assert!(told.is_sorted() && told.last() == Some(&verdict.iterations));
}

#[test]
fn one_wrong_bit_in_one_clock_is_found_in_every_signal() {
    const CLOCK: u64 = 150;
    for (column, pin) in Pins::of(PAPER).observed.into_iter().enumerate() {
        let bit = (column as u32 * 7) % pin.width;
        let device = Mutant::sound(PAPER).with_row_fault(move |clock, row| {
            if clock == CLOCK {
                row[column] ^= 1 << bit;
            }
        });
        let found = divergence(device, &random(20, 1));
        assert_eq!((&found.signal, found.clock), (&pin.name, CLOCK));
        assert_eq!((found.place, found.differing), (pin.place, 1));
        assert_eq!(found.vectors_compared, CLOCK);
        assert_eq!(found.actual, Actual::Known(found.expected ^ (1 << bit)));
        assert_ne!(found.activity, Activity::PowerUp);
    }
}

#[test]
fn the_state_before_the_first_clock_is_compared() {
    let device = Mutant::sound(PAPER).with_row_fault(|clock, row| {
        if clock == 0 {
            row[20] = 1;
        }
    });
    let found = divergence(device, &random(1, 1));
    assert_eq!((found.clock, found.activity), (0, Activity::PowerUp));
}

#[test]
fn a_machine_that_looks_at_words_that_are_not_valid_is_found() {
    let device = Mutant::sound(PAPER).with_input_fault(|_, inputs| inputs.query_valid = true);
    assert_eq!(
        divergence(device, &random(200, 1)).signal,
        "control_address"
    );
    let device = Mutant::sound(PAPER).with_input_fault(|_, inputs| {
        for lane in &mut inputs.group.lanes {
            lane.present = true;
        }
    });
    assert!(
        divergence(device, &random(200, 1))
            .signal
            .ends_with("power")
    );
}

#[test]
fn a_machine_without_reset_is_found() {
    let device = Mutant::sound(PAPER).with_input_fault(|_, inputs| inputs.reset = false);
    let found = divergence(device, &random(1_000, 1));
    assert!(found.signal.starts_with("control_"), "{found}");
}

/// The sum reaches bit 31 only in the fullest query, which is at the end of some chunks.
#[test]
fn a_late_divergence_is_repeated_as_the_first_chunk_of_a_run() {
    let faulty = || {
        Mutant::sound(PAPER).with_row_fault(|_, row| {
            if row[3] >> 31 == 1 {
                row[3] -= 1;
            }
        })
    };
    let runs = (1..).map(|seed| divergence(faulty(), &random(200_000, seed)));
    let late = runs.take(20).find(|found| found.chunk > 0).unwrap();
    let words: Vec<_> = late.repeat.split(' ').collect();
    let after = |flag: &str| {
        let at = words.iter().position(|&word| word == flag).unwrap();
        words[at + 1].parse::<u64>().unwrap()
    };
    assert!(
        late.repeat
            .starts_with("photoncube verify --machine paper --against mutant")
    );
    let again = divergence(faulty(), &random(after("--iterations"), after("--seed")));
    assert_eq!(again.chunk, 0);
    assert_eq!((again.clock, &again.signal), (late.clock, &late.signal));
    assert_eq!(
        (again.expected, &again.actual),
        (late.expected, &late.actual)
    );
    assert_eq!(again.operands, late.operands);
}

#[test]
fn a_device_that_shows_its_outputs_alone_is_compared_in_them() {
    let outputs = Pins::of(PAPER).outputs;
    let verdict = run(Mutant::sound(PAPER).showing(outputs), &random(50, 1)).unwrap();
    assert_eq!(verdict.signals_per_vector, outputs);
    assert!(!verdict.registers_compared);
    let faulty = Mutant::sound(PAPER).with_row_fault(|_, row| row[6] ^= row[2]);
    let found = divergence(faulty.showing(outputs), &random(50, 1));
    assert_eq!(found.signal, "result_count");
}

#[test]
fn nothing_is_never_a_pass() {
    let none = |result| matches!(result, Err(VerifyError::NothingCompared { .. }));
    assert!(none(run(Mutant::sound(PAPER), &random(0, 1))));
    let empty = VerifyOptions {
        source: Source::Workload {
            queries: &[],
            repeat: "",
        },
        ..random(100, 1)
    };
    assert!(none(run(Mutant::sound(PAPER), &empty)));
    assert!(none(run(Mutant::sound(PAPER).showing(0), &random(1, 1))));
}

#[test]
fn a_device_that_leaves_rows_out_is_broken() {
    struct Mute;
    impl Device for Mute {
        fn name(&self) -> &str {
            "mute"
        }
        fn tool_version(&self) -> &str {
            ""
        }
        fn visible(&self) -> usize {
            106
        }
        fn replay(&mut self, _: &[u64], _: &mut Observed) -> Result<(), DeviceError> {
            Ok(())
        }
    }
    let message = run(Mute, &random(10, 1)).unwrap_err().to_string();
    assert!(message.contains("answered 0 values"), "{message}");
}

#[test]
fn a_workload_is_repeated_by_the_command_of_its_caller() {
    let photon = Photon {
        position: [1; 3],
        power: [3; 3],
        exponent: 0,
    };
    let queries = vec![(Query::default(), vec![photon; 6]); 20];
    let source = Source::Workload {
        queries: &queries,
        repeat: "photoncube run cornell",
    };
    let options = VerifyOptions {
        source,
        ..random(1_000, 1)
    };
    let verdict = run(Mutant::sound(PAPER), &options).unwrap();
    assert_eq!((verdict.iterations, verdict.results_compared), (40, 20));
    let faulty = Mutant::sound(PAPER).with_row_fault(|clock, row| row[60] ^= clock / 99);
    assert_eq!(
        divergence(faulty, &options).repeat,
        "photoncube run cornell"
    );
}
