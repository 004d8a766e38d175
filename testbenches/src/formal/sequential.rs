//! The properties of the machine that does one op a clock.

use photoncube_spec::{Machine, Widths};

use super::property::{Cover, Fault, Method, Open, Property};

/// All, the cheapest first.
pub(super) fn properties(machine: &Machine) -> Vec<Property> {
    let widths = Widths::of(machine);
    vec![
        difference(&widths),
        squarer(&widths),
        add(&widths),
        gate(&widths),
    ]
}

/// A property of logic without registers.
pub(super) fn of_logic(
    name: &'static str,
    module: &'static str,
    claim: &'static str,
    harness: &'static str,
    macros: &[(&'static str, u32)],
) -> Property {
    Property {
        name,
        module,
        claim,
        harness,
        macros: macros
            .iter()
            .map(|(name, value)| (*name, value.to_string()))
            .collect(),
        open: Open::Ports,
        method: Method::Sat,
        faults: Vec::new(),
        fault_clocks: 1,
        covers: Vec::new(),
    }
}

/// Outputs that must be 1 for some input.
pub(super) fn covers<const N: usize>(outputs: [&'static str; N]) -> Vec<Cover> {
    outputs.map(|output| Cover { output, clock: 1 }).to_vec()
}

/// `|A-B|`, the first half of `(A-B)^2`; of every machine in plain numbers.
pub(super) fn difference(widths: &Widths) -> Property {
    Property {
        faults: vec![Fault::new("difference", "a < b", "a <= b + 1'b1")],
        covers: covers(["cover_below", "cover_above"]),
        ..of_logic(
            "units::difference",
            "difference",
            "magnitude = |a - b|, without wrapping",
            include_str!("harness/difference.sv"),
            &[("COORDINATE", widths.coordinate)],
        )
    }
}

/// The second half: a square.
fn squarer(widths: &Widths) -> Property {
    Property {
        faults: vec![Fault::new("squarer", "8'd121", "8'd120")],
        covers: covers(["cover_largest"]),
        ..of_logic(
            "units::squarer",
            "squarer",
            "square = root * root, for every root",
            include_str!("harness/squarer.sv"),
            &[("DIFFERENCE", widths.difference)],
        )
    }
}

fn add(widths: &Widths) -> Property {
    Property {
        faults: vec![Fault::new("add_unit", "a + b", "a | b")],
        covers: covers(["cover_wraps"]),
        ..of_logic(
            "units::add",
            "add_unit",
            "sum = a + b, modulo its width",
            include_str!("harness/add.sv"),
            &[("SUM", widths.sum)],
        )
    }
}

fn gate(widths: &Widths) -> Property {
    Property {
        faults: vec![Fault::new("gate_unit", "a > wide_b", "a >= wide_b")],
        covers: covers(["cover_edge", "cover_out"]),
        ..of_logic(
            "units::gate",
            "gate_unit",
            "gated = a > b ? 0 : power",
            include_str!("harness/gate.sv"),
            &[
                ("WORK", widths.work),
                ("RADIUS_SQ", widths.radius_sq),
                ("POWER", widths.power),
            ],
        )
    }
}
