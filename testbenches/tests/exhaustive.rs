//! Compares every pair of inputs of every unit; and tests this comparison: one wrong pair is found.

mod support;

use libtest_mimic::{Arguments, Failed, Trial};
use photoncube_hdl::{Emitted, Level, Unit, emit, emit_unit, has_unit};
use photoncube_spec::find_machine;
use photoncube_testbench::{
    DeviceKind, Radii, Text, VerifyError, exhaustive_lane, exhaustive_lane_device, exhaustive_unit,
    exhaustive_unit_device,
};

/// An edit of a unit's text, with the number of mismatches that it causes; `None` where that was not computed
/// by hand.
struct Fault {
    name: &'static str,
    unit: Unit,
    bits: u32,
    from: &'static str,
    to: &'static str,
    mismatches: Option<u64>,
}

const FAULTS: &[Fault] = &[
    Fault {
        name: "one_sum_is_off_by_one",
        unit: Unit::Add,
        bits: 8,
        from: "a + b",
        to: "(a + b) ^ ((a == 8'd171) && (b == 8'd205))",
        mismatches: Some(1),
    },
    Fault {
        name: "the_adder_loses_its_carries",
        unit: Unit::Add,
        bits: 6,
        from: "a + b",
        to: "a ^ b",
        // All pairs, except those without a common bit below the top, whose carry is lost in any case.
        mismatches: Some(4096 - 4 * 3_u64.pow(5)),
    },
    Fault {
        name: "the_difference_is_never_turned_round",
        unit: Unit::SquareDigits,
        bits: 6,
        from: "below ?",
        to: "1'b0 ?",
        mismatches: None,
    },
    Fault {
        name: "one_square_of_a_digit_is_off_by_one",
        unit: Unit::SquareDigits,
        bits: 8,
        from: "8'd196",
        to: "8'd197",
        mismatches: None,
    },
    Fault {
        name: "the_product_is_a_sum",
        unit: Unit::SquareProduct,
        bits: 8,
        from: "root * root",
        to: "root + root",
        // All pairs, except those with the differences 0 and 2: 256 pairs and twice 254.
        mismatches: Some(65_536 - 256 - 2 * 254),
    },
    Fault {
        name: "the_boundary_is_out_of_range",
        unit: Unit::Gate,
        bits: 6,
        from: "a > wide_b",
        to: "a >= wide_b",
        // Each tie, with every power but 0.
        mismatches: Some(64 * 63),
    },
    Fault {
        name: "one_word_of_the_table_is_off_by_one",
        unit: Unit::PairTable,
        bits: 8,
        from: "squares[5] = 15'd25",
        to: "squares[5] = 15'd24",
        mismatches: None,
    },
    Fault {
        name: "a_far_product_is_near",
        unit: Unit::PairProduct,
        bits: 6,
        from: "far = |product",
        to: "far = &product",
        mismatches: None,
    },
    Fault {
        name: "the_magnitude_is_one_less",
        unit: Unit::PairDigits,
        bits: 8,
        from: ", negative}",
        to: ", 1'b0}",
        mismatches: None,
    },
];

fn main() {
    let mut trials = Vec::new();
    for unit in Unit::ALL {
        for bits in Unit::BITS.into_iter().filter(|&bits| has_unit(unit, bits)) {
            for kind in [DeviceKind::Text, DeviceKind::RustHdl] {
                // rust-hdl's own simulation is slow, and verifies no text.
                if kind == DeviceKind::Text || bits == 6 {
                    let name = format!("{unit}::{bits}::{kind}");
                    trials.push(support::trial(name, kind, move || all(unit, bits, kind)));
                }
            }
        }
    }
    for fault in FAULTS {
        let name = format!("fault::{}", fault.name);
        trials.push(Trial::test(name, || caught(fault)));
    }
    let kind = DeviceKind::Verilator;
    trials.push(support::trial("lane::verilator".into(), kind, lane));
    let name = "lane::a_difference_on_the_boundary_is_missed".to_owned();
    trials.push(Trial::test(name, lane_caught));
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

fn all(unit: Unit, bits: u32, kind: DeviceKind) -> Result<(), Failed> {
    let verdict = exhaustive_unit(unit, bits, kind)?;
    assert_eq!(verdict.mismatches, 0, "{verdict:?}");
    assert_eq!(verdict.pairs_compared, 1 << (2 * bits));
    assert!(verdict.vectors_compared >= verdict.pairs_compared);
    Ok(())
}

/// Replaces a text that occurs once in the design.
fn edit(mut design: Emitted, from: &str, to: &str) -> Emitted {
    assert_eq!(
        design.text.matches(from).count(),
        1,
        "`{from}` in {}",
        design.text
    );
    design.text = design.text.replace(from, to);
    design
}

fn caught(fault: &Fault) -> Result<(), Failed> {
    let design = edit(emit_unit(fault.unit, fault.bits)?, fault.from, fault.to);
    let mut device = Text::new(&design)?;
    let verdict = exhaustive_unit_device(fault.unit, fault.bits, &mut device)?;
    assert!(verdict.mismatches > 0, "the fault was not found");
    if let Some(expected) = fault.mismatches {
        assert_eq!(verdict.mismatches, expected, "{:?}", verdict.first_mismatch);
    }
    let first = verdict.first_mismatch.ok_or("the first mismatch is told")?;
    assert!(
        first.contains("expected") && first.contains("found"),
        "{first}"
    );
    Ok(())
}

fn lane() -> Result<(), Failed> {
    let verdict = exhaustive_lane(DeviceKind::Verilator, Radii::Squares, &|_| ())?;
    assert_eq!(verdict.pairs_compared, 256 * verdict.radii);
    assert!(verdict.vectors_compared * 4 >= verdict.photon_tests);
    Ok(())
}

/// The comparison of one lane counts the boundary as out of range, which must be found.
fn lane_caught() -> Result<(), Failed> {
    let machine = find_machine("stream")?;
    let design = emit(machine, Level::Machine)?;
    let design = edit(design, "distance <= limit", "distance < limit");
    let mut open = || Ok(Box::new(Text::new(&design)?) as Box<_>);
    match exhaustive_lane_device(&mut open, Radii::Squares, &|_| ()) {
        Err(VerifyError::Diverged(divergence)) => {
            assert!(divergence.signal.contains("in_range"), "{divergence}");
            Ok(())
        }
        other => Err(format!("the fault was not found: {other:?}").into()),
    }
}
