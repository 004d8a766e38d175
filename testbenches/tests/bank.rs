//! Tests of full banks of a photon memory: faults in its emitted text that only show there, each found by the
//! stimulus for banks. Random stimulus misses the faults that need a full bank without a last group, or a
//! reset late in a set.

use libtest_mimic::{Arguments, Failed, Trial};
use photoncube_hdl::{Level, emit};
use photoncube_spec::{Machine, find_machine};
use photoncube_testbench::{
    DeviceError, DeviceKind, Source, StimulusError, Text, Verdict, VerifyError, VerifyOptions,
    plant, verify, verify_device,
};

const MACHINE: &str = "tile-6-mixed";

/// An edit of one module's text.
struct Fault {
    name: &'static str,
    module: &'static str,
    /// The text in the module, which occurs once.
    from: &'static str,
    /// The text that replaces it.
    to: &'static str,
    /// The signals of which one must differ first.
    names: &'static [&'static str],
    /// The iterations of random stimulus that miss the fault. In these, a full bank always ends with a last
    /// group, and no reset comes to it.
    missed_in: Option<u64>,
}

const FAULTS: &[Fault] = &[
    Fault {
        name: "the_last_place_does_not_end_a_set",
        module: "memory",
        from: "set_ends = group_last | (&fill_place)",
        to: "set_ends = group_last",
        names: &["full_0", "fill_bank", "fill_ready"],
        missed_in: Some(RANDOM),
    },
    Fault {
        name: "a_full_bank_is_never_at_its_end",
        module: "memory",
        from: "play_place == before_end",
        to: "play_place == before_end & ~&before_end[9:1]",
        names: &["at_end"],
        missed_in: None,
    },
    Fault {
        name: "the_upper_half_of_a_bank_is_the_lower_one",
        module: "memory",
        from: "write_address = {write_bank, write_place}",
        to: "write_address = {write_bank, 1'b0, write_place[8:0]}",
        names: &["read_"],
        missed_in: None,
    },
    Fault {
        name: "a_reset_forgets_the_place_that_is_filled",
        module: "memory",
        from: "if (reset) begin\n        fill_bank <= 1'd0;\n        fill_place <= 10'd0;",
        to: "if (reset) begin\n        fill_bank <= 1'd0;\n        fill_place <= fill_place & 10'h200;",
        names: &["fill_place"],
        missed_in: Some(RANDOM),
    },
];

/// Many times the iterations of the test of all machines.
const RANDOM: u64 = 20_000;

fn main() {
    let mut trials = Vec::new();
    for fault in FAULTS {
        let found = || found(fault);
        trials.push(Trial::test(format!("found::{}", fault.name), found));
        if let Some(iterations) = fault.missed_in {
            let missed = move || missed(fault, iterations);
            trials.push(Trial::test(format!("random::{}", fault.name), missed));
        }
    }
    trials.push(Trial::test(
        "found::the_highest_bit_of_a_count_is_lost",
        count,
    ));
    trials.push(Trial::test("none::the_text_as_it_is_passes", sound));
    trials.push(Trial::test("none::a_machine_without_a_memory", no_memory));
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

fn run(
    machine: &Machine,
    text: Option<&Fault>,
    source: Source<'_>,
    iterations: u64,
) -> Result<Verdict, VerifyError> {
    let mut design = emit(machine, Level::Machine).expect("a named machine is emitted");
    if let Some(fault) = text {
        let module = format!("{}_{}", machine.module_prefix(), fault.module);
        design.text = plant(&design.text, &module, fault.from, fault.to)?;
    }
    let options = VerifyOptions {
        iterations,
        seed: 1,
        source,
    };
    let mut device = Text::new(&design).map_err(DeviceError::from)?;
    verify_device(machine, &mut device, &options, &|_| ())
}

fn found(fault: &Fault) -> Result<(), Failed> {
    match run(find_machine(MACHINE)?, Some(fault), Source::FullBank, 1) {
        Err(VerifyError::Diverged(divergence)) => {
            let signal = &divergence.signal;
            let is_named = fault.names.iter().any(|name| signal.contains(name));
            assert!(is_named, "{divergence}");
            assert!(divergence.repeat.contains("full_bank::tile-6-mixed"));
            Ok(())
        }
        other => Err(format!("the fault was not found: {other:?}").into()),
    }
}

fn missed(fault: &Fault, iterations: u64) -> Result<(), Failed> {
    let verdict = run(
        find_machine(MACHINE)?,
        Some(fault),
        Source::Random,
        iterations,
    )?;
    assert!(verdict.iterations >= iterations && verdict.vectors_compared > 0);
    Ok(())
}

/// Faults that need a bank of the most photons, whose count alone has its highest bit set.
fn count() -> Result<(), Failed> {
    let fault = Fault {
        name: "",
        module: "accumulate_2",
        from: "next_sum = kept + wide_group",
        to: "next_sum = (kept + wide_group) & 13'hfff",
        names: &[],
        missed_in: None,
    };
    for source in [Source::FullThenEmpty, Source::FullBank] {
        let outcome = run(find_machine(MACHINE)?, Some(&fault), source, 1);
        let is_found = matches!(outcome, Err(VerifyError::Diverged(_)));
        let is_expected = matches!(source, Source::FullThenEmpty);
        assert_eq!(is_found, is_expected, "{source:?}: {outcome:?}");
    }
    Ok(())
}

/// Every corner is legal for a machine with a memory, and its results are those of the direct gather.
fn sound() -> Result<(), Failed> {
    let machine = find_machine(MACHINE)?;
    let corners = Source::corners(machine);
    assert_eq!(corners.len(), 3);
    for source in corners {
        let verdict = run(machine, None, source, 1)?;
        assert!(verdict.registers_compared && verdict.results_compared > 0);
    }
    Ok(())
}

fn no_memory() -> Result<(), Failed> {
    let machine = find_machine("stream")?;
    let options = VerifyOptions {
        iterations: 1,
        seed: 1,
        source: Source::FullBank,
    };
    match verify(machine, DeviceKind::Text, &options, &|_| ()) {
        Err(VerifyError::Stimulus(error @ StimulusError::NoBank { .. })) => {
            assert!(
                error
                    .to_string()
                    .contains("`stream` keeps no sets of photons")
            );
        }
        other => return Err(format!("expected that there is no bank, found {other:?}").into()),
    }
    assert!(
        !Source::corners(machine)
            .iter()
            .any(|source| matches!(source, Source::FullBank))
    );
    Ok(())
}
