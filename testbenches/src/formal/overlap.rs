//! The properties of overlapped machines, whose units work at the same time.

use photoncube_spec::overlap::{Program, control_word_bits, drain_bits};
use photoncube_spec::{Field, Machine, OVERLAPPED, Role, Widths};

use super::property::{Fault, Method, Open, Property, at, covers, of_logic};
use super::sequential::{difference, fields, width_macros};
use super::wires::Wires;

/// All properties, the cheapest first.
pub(super) fn properties(machine: &Machine) -> Vec<Property> {
    let widths = Widths::of(machine);
    let program = machine.overlap_program().expect("its units overlap");
    vec![
        difference(&widths),
        digits(),
        chosen_sum(&widths),
        cell(machine, &widths),
        control(machine, &program),
        links(machine, &widths),
    ]
}

fn digits() -> Property {
    Property {
        faults: vec![Fault::new("digits", "rows_2 + rows_3", "rows_2 | rows_3")],
        covers: covers(["cover_largest"]),
        ..of_logic(
            "units::digits",
            "digits",
            "squares + 32 low_product + 128 high_product = root * root, for every root",
            include_str!("harness/digits.sv"),
            &[],
        )
    }
}

fn chosen_sum(widths: &Widths) -> Property {
    Property {
        faults: vec![Fault::new(
            "chosen_sum",
            "low = sum_low",
            "low = sum_low & 18'h1ffff",
        )],
        covers: covers(["cover_sum", "cover_work"]),
        ..of_logic(
            "units::add",
            "chosen_sum",
            "total = sum + operand, or addend + operand modulo the work register; assumed: sum_low is the sum's",
            include_str!("harness/chosen_sum.sv"),
            &[
                ("SUM", widths.sum),
                ("WORK", widths.work),
                ("SQUARE", widths.square),
            ],
        )
    }
}

fn cell(machine: &Machine, widths: &Widths) -> Property {
    let largest = u128::from(machine.max_photons()) * machine.full_scale();
    let mut macros = width_macros(widths);
    macros.extend([
        ("WORD", control_word_bits().to_string()),
        ("LARGEST", format!("{}'d{largest}", widths.sum + 1)),
    ]);
    macros.extend(fields(&OVERLAPPED, machine.dimension));
    Property {
        macros,
        open: Open::Signals(&[
            "sum_q",
            "sum_d",
            "operand_q",
            "operand_d",
            "work_q",
            "distance_q",
            "radius_sq_q",
            "power_7_q",
            "present_7_q",
            "in_range_q",
            "in_range_d",
            "square_q",
            "square_d",
            "digit_squares_q",
            "low_product_q",
            "high_product_q",
            "addend_d",
        ]),
        method: Method::Induction(1),
        faults: vec![
            Fault::new(
                "cell",
                "wide_radius_sq >= distance_q",
                "wide_radius_sq > distance_q",
            ),
            Fault::new(
                "cell",
                "in_range_q & present_7_q",
                "in_range_q | present_7_q",
            ),
            Fault::new("cell", "wide_high << 32'h7", "wide_high << 32'h6"),
            Fault::new("chosen_sum", "32'hfffc0000", "32'hfff80000"),
        ],
        fault_clocks: 9,
        covers: at([("cover_gate", 14), ("cover_sum", 5)]),
        ..of_logic(
            "cell::ops",
            "cell",
            "gate, operand, square and sum are their formulas, and the sum is exact for the declared photons of a \
             query at full scale; assumed: one operand at most, as control::program shows, and no more photons",
            include_str!("harness/cell_overlap.sv"),
            &[],
        )
    }
}

/// The control words of a role, as branches of a `case`.
fn steps(program: &Program, role: Role, name: &str) -> String {
    let bits = control_word_bits();
    let words = program.control_words(role).into_iter().enumerate();
    words
        .map(|(address, word)| format!("{address}: {name} = {bits}'h{word:x}; "))
        .collect()
}

/// A condition: the current control word is 0 or one of the program's.
fn one_of(program: &Program, role: Role, name: &str) -> String {
    let words = program.control_words(role).into_iter();
    let words: Vec<_> = words
        .chain([0])
        .map(|word| format!("at_{name} == {word}"))
        .collect();
    format!("assert ({}); ", words.join(" || "))
}

fn control(machine: &Machine, program: &Program) -> Property {
    let address = program.end_address().ilog2() + 1;
    let roles = ["x", "y", "z", "d"];
    let one = |role| {
        let lsb = |field| OVERLAPPED.lsb(field, machine.dimension);
        let (axis, gate) = (lsb(Field::Axis), lsb(Field::Gate));
        format!(
            "assert ((to_{role}[{axis}+:4] & (to_{role}[{axis}+:4] - 4'd1)) == 0 && \
             !(to_{role}[{gate}] && to_{role}[{axis}+:4] != 0)); "
        )
    };
    let words = [
        (Role::X, "x"),
        (Role::Y, "y"),
        (Role::Z, "z"),
        (Role::D, "d"),
    ];
    let words = words.map(|(role, name)| one_of(program, role, name));
    // The clocks include some clocks of waiting.
    let whole = program.latency_clocks(1) as u32 + 6;
    let mut macros: Vec<_> = fields(&OVERLAPPED, machine.dimension).collect();
    macros.extend([
        ("WORD", control_word_bits().to_string()),
        ("ADDRESS", address.to_string()),
        ("DRAIN", drain_bits(program).to_string()),
        ("DRAIN_CLOCKS", program.drain_clocks.to_string()),
        ("INTERVAL", program.interval.to_string()),
        ("END", program.end_address().to_string()),
        ("STEPS_X", steps(program, Role::X, "x")),
        ("STEPS_Y", steps(program, Role::Y, "y")),
        ("STEPS_Z", steps(program, Role::Z, "z")),
        ("STEPS_D", steps(program, Role::D, "d")),
        ("WORDS", words.concat()),
        ("ONE_OPERAND", roles.map(one).concat()),
    ]);
    Property {
        macros,
        open: Open::Signals(&["address_q", "occupied_q", "last_q", "drain_q", "done_q"]),
        method: Method::Induction(4),
        faults: vec![
            Fault::new("control", "kernel_end = 3'b10", "kernel_end = 3'b11"),
            Fault::new(
                "control",
                "takes_group & group_last",
                "accepts_group & group_last",
            ),
            Fault::new("control", "taken = done_q & result_ready", "taken = done_q"),
            Fault::new("store_z", "23'h835fc", "23'h8b5fc"),
        ],
        fault_clocks: whole,
        covers: at([
            ("cover_result", whole),
            ("cover_stalled", whole),
            ("cover_second", 2 * whole),
        ]),
        ..of_logic(
            "control::program",
            "control",
            "kernel and epilogue of the spec's program in their order, one query at a time, groups taken where a word \
             asks for one and none after the last, the result once and stable; one operand at most for each adder",
            include_str!("harness/control_overlap.sv"),
            &[],
        )
    }
}

/// The property of the wires between cells, and from the control block.
fn links(machine: &Machine, widths: &Widths) -> Property {
    let mut wires = Wires::default();
    let axes = [
        ("x", "sum_out", widths.sum),
        ("y", "sum_out", widths.sum),
        ("z", "z_out", widths.work),
        ("w", "w_out", widths.work),
    ];
    for node in 0..machine.hypercube().nodes() {
        for (bit, (axis, sent, width)) in axes.iter().enumerate() {
            let neighbour = node ^ (1 << bit);
            wires.equal(
                &format!("cell_{node}.link_{axis}"),
                &[(&format!("cell_{neighbour}.{sent}"), *width)],
            );
        }
        let role = ["x", "y", "z", "d"][node >> 2];
        wires.equal(
            &format!("cell_{node}.word"),
            &[(&format!("control.to_{role}"), control_word_bits())],
        );
        wires.equal(
            &format!("cell_{node}.write_query"),
            &[("control.write_query", 1)],
        );
    }
    wires.property(
        "links::top",
        "each cell's link on an axis is the one output of the neighbour there, its word that of its role",
        vec![
            Fault::new("", "cell_5_link_z = cell_1_z_out", "cell_5_link_z = cell_1_w_out"),
            Fault::new("", "cell_9_word = control_to_z", "cell_9_word = control_to_y"),
        ],
    )
}
