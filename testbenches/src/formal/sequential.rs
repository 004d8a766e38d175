//! The properties of sequential machines, which do one op a clock.

use photoncube_spec::{
    CellTables, Field, Machine, Microprogram, OpRow, Register, SEQUENTIAL, Squarer, Widths,
};

use super::property::{Fault, Method, Open, Property, at, covers, of_logic};
use super::wires::Wires;

/// All properties, the cheapest first.
pub(super) fn properties(machine: &Machine) -> Vec<Property> {
    let widths = Widths::of(machine);
    let program = machine
        .microprogram()
        .expect("a sequential machine has a program");
    vec![
        difference(&widths),
        squarer(machine, &widths),
        add(&widths),
        gate(&widths),
        cell(machine, &widths),
        control(machine, &program),
        streams(machine, &program),
        network(machine, &widths),
        links(machine, &widths),
        sum(machine, &widths),
    ]
}

/// The property of `|A-B|`, the first half of `(A-B)^2`, for every machine with a program.
pub(super) fn difference(widths: &Widths) -> Property {
    Property {
        faults: vec![Fault::new(
            "difference",
            "below = a < ",
            "below = a <= 1'b1 + ",
        )],
        covers: covers(["cover_below", "cover_largest"]),
        ..of_logic(
            "units::difference",
            "difference",
            "magnitude = |a - b|, from middle to middle, without wrapping, clamped",
            include_str!("harness/difference.sv"),
            &[
                ("COORDINATE", widths.coordinate),
                ("PHOTON", widths.photon),
                ("EXTRA", widths.coordinate - widths.photon),
                ("DIFFERENCE", widths.difference),
            ],
        )
    }
}

/// The property of the second half: a square, or half square.
fn squarer(machine: &Machine, widths: &Widths) -> Property {
    let half = machine.format().is_some_and(|format| format.half_steps());
    let (right, wrong) = match machine.squarer {
        Squarer::Digits => ("digit_square = 8'd4;", "digit_square = 8'd5;"),
        _ => ("square = root", "square = 1'b1 + root"),
    };
    Property {
        faults: vec![Fault::new("squarer", right, wrong)],
        covers: covers(["cover_largest"]),
        ..of_logic(
            "units::squarer",
            "squarer",
            "square = root * root, or root * (root + 1) of a half square, for every root",
            include_str!("harness/squarer.sv"),
            &[("DIFFERENCE", widths.difference), ("HALF", u32::from(half))],
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

/// The widths of a cell's words as macros, for every machine with a program.
pub(super) fn width_macros(widths: &Widths) -> Vec<(&'static str, String)> {
    let words = [
        ("COORDINATE", widths.coordinate),
        ("PHOTON", widths.photon),
        ("DIFFERENCE", widths.difference),
        ("RADIUS_SQ", widths.radius_sq),
        ("POWER", widths.power),
        ("WORK", widths.work),
        ("SUM", widths.sum),
    ];
    words.map(|(name, bits)| (name, bits.to_string())).to_vec()
}

/// Conditions: exchanging the sums of some photons gives the sum of twice as many, for each exchange of an
/// iteration.
fn exchanges(machine: &Machine, widths: &Widths) -> String {
    let photons = machine.photons_per_iteration().ilog2();
    let sum = |axis| format!("{}'d{}", widths.work, machine.full_scale() << axis);
    let exchange = |axis| {
        let (one, both) = (sum(axis), sum(axis + 1));
        format!("assert (!(work_q <= {one} && link_in <= {one}) || work_d <= {both}); ")
    };
    (0..photons).map(exchange).collect()
}

/// Conditions: each op that writes the work register or the sum is its formula, from the values of the registers
/// and of the link. A square is that of the square unit, which has properties of its own.
fn formulas() -> String {
    let formula = |row: &OpRow| {
        let source = SEQUENTIAL.work_source(row);
        let writes_sum = row.writes.contains(&Register::Sum) && !row.reads_query();
        let when = match (source, writes_sum) {
            (Some(source), _) => format!("write_work && work_source == {source}"),
            (None, true) => "write_sum".to_owned(),
            (None, false) => return String::new(),
        };
        let written = SEQUENTIAL.register(row.writes[0]).name;
        format!(
            "if ({when}) assert ({written}_d == ({})); ",
            expression(row)
        )
    };
    SEQUENTIAL.ops.iter().map(formula).collect()
}

/// The right-hand side of an op's formula in Verilog. A call of a unit's function is the output of that unit.
fn expression(row: &OpRow) -> String {
    let (_, right) = row.formula.split_once(" := ").expect("a formula");
    let right = right.split_once(" (mod").map_or(right, |(sum, _)| sum);
    if let Some(unit) = row
        .unit
        .filter(|unit| right.starts_with(&format!("{unit}(")))
    {
        return format!("{}_{unit}", unit.module());
    }
    let registers = SEQUENTIAL.registers.iter();
    let named = |word: &str| match word {
        "n" => "link_in".to_owned(),
        _ => match registers.clone().find(|row| row.mnemonic == word) {
            Some(row) => format!("{}_q", row.name),
            None => word.to_owned(),
        },
    };
    let words: Vec<_> = right.split(' ').map(named).collect();
    words.join(" ")
}

/// A fault: a sum loses a bit.
fn sum_fault() -> Fault {
    Fault::new("cell", "link_in | sum_low", "link_in | sum_low >> 1")
}

fn cell(machine: &Machine, widths: &Widths) -> Property {
    let mut macros = width_macros(widths);
    macros.push(("EXCHANGES", exchanges(machine, widths)));
    macros.push(("OPS", formulas()));
    Property {
        macros,
        open: Open::Signals(&[
            "work_q",
            "work_d",
            "sum_q",
            "sum_d",
            "query_q",
            "query_d",
            "photon_q",
            "photon_d",
            "radius_sq_q",
            "radius_sq_d",
            "power_q",
            "power_d",
            "square_unit_a",
            "square_unit_b",
            "square_unit_square",
        ]),
        method: Method::Induction(1),
        faults: vec![
            Fault::new(
                "cell",
                "gate_unit_b = radius_sq_q",
                "gate_unit_b = radius_sq_q + 1'b1",
            ),
            sum_fault(),
            Fault::new("cell", "if (~present_in)", "if (1'b0)"),
        ],
        fault_clocks: 9,
        covers: at([("cover_gate", 5), ("cover_sum", 3)]),
        ..of_logic(
            "cell::ops",
            "cell",
            "each op is its formula, and what it does not write stays; assumed: an op writes by one field, adds on \
             a link where it does not add to the sum, and hears nothing where it does",
            include_str!("harness/cell_sequential.sv"),
            &[],
        )
    }
}

/// The lowest bit of each field of a control word, as macros.
pub(super) fn fields(
    tables: &CellTables,
    dimension: u32,
) -> impl Iterator<Item = (&'static str, String)> {
    let fields = tables.fields.iter();
    fields.map(move |row| (row.name, tables.lsb(row.field, dimension).to_string()))
}

/// The program and its fields, as macros.
fn program_macros(machine: &Machine, program: &Microprogram) -> Vec<(&'static str, String)> {
    let words = program.control_words();
    let bits = SEQUENTIAL.word_bits(machine.dimension);
    let last = words.len() - 1;
    let step = |(address, word): (usize, &u32)| format!("{address}: word = {bits}'h{word:x};");
    let steps: Vec<_> = words.iter().enumerate().map(step).collect();
    let takes = |word: &u32| SEQUENTIAL.field(Field::TakesGroup, *word, machine.dimension) == 1;
    let taking = words.iter().position(takes).expect("a group is taken");
    let mut macros = vec![
        ("DIMENSION", machine.dimension.to_string()),
        ("ADDRESS", (last.ilog2() + 1).to_string()),
        ("WORD", bits.to_string()),
        ("STEPS", steps.join(" ")),
        ("LAST_STEP", last.to_string()),
        ("FIRST_OF_ITERATION", program.query_clocks().to_string()),
        ("TAKING_STEP", taking.to_string()),
    ];
    macros.extend(fields(&SEQUENTIAL, machine.dimension));
    macros
}

fn control(machine: &Machine, program: &Microprogram) -> Property {
    let steps = program.initiation_interval();
    Property {
        macros: program_macros(machine, program),
        open: Open::Signals(&["address_q", "last_q", "done_q"]),
        method: Method::Induction(1),
        faults: vec![
            Fault::new(
                "control",
                "iteration_address = 4'h1",
                "iteration_address = 4'h2",
            ),
            Fault::new("control", "runs = group_valid", "runs = 1'b1"),
            Fault::new("store", "4'd4:", "4'd15:"),
        ],
        fault_clocks: 2 * steps + 4,
        covers: at([
            ("cover_result", 2 * steps + 2),
            ("cover_waits", steps + 2),
            ("cover_again", steps + 4),
        ]),
        ..of_logic(
            "control::microprogram",
            "control",
            "the steps of the spec's listing in their order, each with its fields, waiting only where a stream is \
             awaited; one axis at most",
            include_str!("harness/control_sequential.sv"),
            &[],
        )
    }
}

fn streams(machine: &Machine, program: &Microprogram) -> Property {
    let steps = program.initiation_interval();
    Property {
        macros: program_macros(machine, program),
        open: Open::Signals(&["address_q", "last_q", "done_q"]),
        method: Method::Induction(2),
        faults: vec![
            Fault::new("control", "taken = done_q & result_ready", "taken = done_q"),
            Fault::new("control", "group_ready = 1'b0", "group_ready = query_valid"),
            Fault::new(
                "control",
                "address_d = 32'h0;\n                    done_d",
                "address_d = 32'h1;\n                    done_d",
            ),
        ],
        fault_clocks: 2 * steps + 6,
        covers: at([
            ("cover_second", 2 * steps + 4),
            ("cover_stalled", steps + 3),
        ]),
        ..of_logic(
            "streams::control",
            "control",
            "one query at most is in the machine, its groups are taken once an iteration, its result comes once, \
             after the last, and while it waits nothing is written",
            include_str!("harness/streams_sequential.sv"),
            &[],
        )
    }
}

fn network(machine: &Machine, widths: &Widths) -> Property {
    let nodes = machine.hypercube().nodes();
    let work = widths.work;
    let port = |node| {
        format!(
            ", .work_{node}(work[{node}*{work}+:{work}]), .link_{node}(link[{node}*{work}+:{work}])"
        )
    };
    Property {
        macros: vec![
            ("DIMENSION", machine.dimension.to_string()),
            ("NODES", nodes.to_string()),
            ("WORK", work.to_string()),
            ("PORTS", (0..nodes).map(port).collect()),
        ],
        faults: vec![
            Fault::new(
                "network",
                "link_14 = link_14 | work_10",
                "link_14 = link_14 | work_11",
            ),
            Fault::new(
                "network",
                "begin\n        link_0 = ",
                "begin\n        link_0 = work_1 | ",
            ),
        ],
        covers: covers(["cover_none", "cover_last"]),
        ..of_logic(
            "network::one_driver",
            "network",
            "each link has the word of the neighbour on the selected axis, or 0; assumed: one axis at most, as \
             control::microprogram shows",
            include_str!("harness/network.sv"),
            &[],
        )
    }
}

/// Whether a field goes to the cells, and not to the network or the sequencer.
fn is_of_cell(field: Field) -> bool {
    use Field::{Axis, ReadsGroup, TakesGroup, TakesQuery};
    !matches!(field, Axis | ReadsGroup | TakesGroup | TakesQuery)
}

/// The property of the wires between network, control and cells.
fn links(machine: &Machine, widths: &Widths) -> Property {
    let mut wires = Wires::default();
    wires.equal("network.axis", &[("control.axis", machine.dimension)]);
    for node in 0..machine.hypercube().nodes() {
        let received = format!("cell_{node}.link_in");
        wires.equal(&received, &[(&format!("network.link_{node}"), widths.work)]);
        let sent = format!("network.work_{node}");
        wires.equal(&sent, &[(&format!("cell_{node}.work_out"), widths.work)]);
        for row in SEQUENTIAL.fields.iter().filter(|row| is_of_cell(row.field)) {
            let (taken, sent) = (
                format!("cell_{node}.{}", row.name),
                format!("control.{}", row.name),
            );
            wires.equal(&taken, &[(&sent, (row.width)(machine.dimension))]);
        }
    }
    wires.property(
        "links::top",
        "each cell's link and control fields come from one output of network and control, and from no other",
        vec![
            Fault::new("", "cell_5_link_in = network_link_5", "cell_5_link_in = network_link_4"),
            Fault::new("", "cell_3_write_sum = control_write_sum", "cell_3_write_sum = control_write_work"),
        ],
    )
}

fn sum(machine: &Machine, widths: &Widths) -> Property {
    let sum_of = |photons| format!("{}'d{}", widths.sum, photons * machine.full_scale());
    let count = |photons: u128| format!("photons_full_scale == {}", sum_of(photons));
    let photons = machine.photons_per_iteration() as u128;
    let counts: Vec<_> = (0..=photons).map(count).collect();
    let largest = u128::from(machine.max_photons()) * machine.full_scale();
    let mut macros = width_macros(widths);
    macros.extend([
        ("ONE_OF_THE_COUNTS", counts.join(" || ")),
        ("LARGEST", format!("{}'d{largest}", widths.sum + 1)),
        ("COVERED", sum_of(2 * photons)),
    ]);
    Property {
        macros,
        open: Open::Signals(&["work_q", "sum_q", "sum_d"]),
        method: Method::Induction(1),
        faults: vec![sum_fault()],
        fault_clocks: 7,
        covers: at([("cover_full", 4)]),
        ..of_logic(
            "sums::cell",
            "cell",
            "the sum is exact for the declared photons of a query at full scale; assumed: no more are given, and the \
             work register holds no more than the photons of its iteration",
            include_str!("harness/sum_sequential.sv"),
            &[],
        )
    }
}
