//! The named machines: that each is compiled in, linted without a finding, and emitted with the pins of the spec.

use std::collections::BTreeSet;
use std::sync::LazyLock;
use std::thread;

use photoncube_hdl::{
    Emitted, Level, Simulator, Unit, emit, emit_unit, has_unit, lint_control, lint_machine,
    most_steps,
};
use photoncube_spec::{
    Axis, MACHINES, Machine, Microprogram, Numbers, Op, Organisation, OwnProgram, Pins,
    PlainFormat, Squarer, Step, find_machine,
};

#[test]
fn every_named_machine_is_built_in() {
    for machine in MACHINES {
        for level in Level::of(machine) {
            assert!(
                Simulator::new(machine, level).is_ok(),
                "{} {level:?}",
                machine.name
            );
        }
    }
}

#[test]
fn a_machine_is_built_with_any_program_that_fits_its_store() {
    let longest = |name| {
        let machine = MACHINES.iter().find(|m| m.name == name).unwrap();
        let most = most_steps(machine);
        for steps in [2, most] {
            let iteration = vec![Step::exchange_add(Axis::X); steps - 1];
            let program = Microprogram::of_phases(&[Step::new(Op::LoadQuery)], &iteration);
            let own = OwnProgram::new(&program).unwrap();
            let machine = Machine {
                organisation: Organisation::Programmed(own),
                ..*machine
            };
            assert!(
                Simulator::new(&machine, Level::Machine).is_ok(),
                "{name}, {steps}"
            );
        }
        most
    };
    assert_eq!(["paper", "paper-5d", "local"].map(longest), [32, 32, 16]);
    let stream = MACHINES.iter().find(|m| m.name == "stream").unwrap();
    assert_eq!(most_steps(stream), 0);
}

#[test]
fn a_cell_has_no_place_for_a_table_of_squares() {
    let machine = Machine {
        squarer: Squarer::Table,
        ..MACHINES[0]
    };
    assert!(Simulator::new(&machine, Level::Machine).is_err());
}

#[test]
fn a_width_that_is_not_built_in_is_refused_with_those_that_are() {
    let numbers = Numbers::Plain(PlainFormat {
        coordinate_bits: 9,
        power_bits: 16,
        max_photons: 65_537,
    });
    let machine = Machine {
        numbers,
        ..MACHINES[0]
    };
    let error = Simulator::new(&machine, Level::Machine)
        .err()
        .unwrap()
        .to_string();
    assert!(
        error.contains("coordinate: 9") && error.contains("coordinate: 8"),
        "{error}"
    );
}

#[test]
fn the_lint_finds_nothing_in_a_machine_and_the_planted_mistake() {
    for machine in MACHINES {
        let linted = lint_machine(machine).unwrap();
        assert_eq!(linted.findings, Vec::<String>::new(), "{}", machine.name);
        assert!(linted.generated > 0 && linted.registers > 0, "{linted:?}");
    }
    assert!(lint_control());
}

/// The most engines of a chain whose whole text is made twice here. The text of longer chains takes seconds;
/// `generate --check` compares it with what was emitted when it was committed.
const LONGEST_CHAIN: usize = 8;

/// The whole machines in the order of [`MACHINES`], emitted once for all tests.
static DESIGNS: LazyLock<Vec<Emitted>> = LazyLock::new(|| {
    let whole = |machine: &'static Machine| emit(machine, Level::Machine).unwrap();
    thread::scope(|scope| {
        let threads = MACHINES.iter().map(|m| scope.spawn(move || whole(m)));
        let threads: Vec<_> = threads.collect();
        threads.into_iter().map(|t| t.join().unwrap()).collect()
    })
});

#[test]
fn every_level_of_every_machine_is_emitted_alike_twice() {
    for (machine, whole) in MACHINES.iter().zip(&*DESIGNS) {
        for level in Level::of(machine) {
            let emitted = match level {
                Level::Machine => whole.clone(),
                part => emit(machine, part).unwrap(),
            };
            if level != Level::Machine || machine.queries_at_once() <= LONGEST_CHAIN {
                assert_eq!(emitted, emit(machine, level).unwrap());
            }
            assert!(emitted.text.contains(&format!("module {}(", emitted.top)));
            assert!(!emitted.text.contains('$'), "{}", emitted.text);
        }
    }
}

#[test]
fn every_unit_at_every_width_is_emitted_alike_twice() {
    let mut emitted = 0;
    for unit in Unit::ALL {
        for bits in Unit::BITS.into_iter().filter(|&bits| has_unit(unit, bits)) {
            let design = emit_unit(unit, bits).unwrap();
            assert_eq!(design, emit_unit(unit, bits).unwrap());
            assert!(design.text.contains(&format!("module {}(", design.top)));
            emitted += 1;
        }
    }
    assert_eq!(emitted, 2 * Unit::ALL.len() - 1);
    let error = emit_unit(Unit::Add, 7).unwrap_err().to_string();
    assert!(
        error.contains("add of 7 bits") && error.contains("[6, 8]"),
        "{error}"
    );
}

/// The ports that the first module declares, with their widths.
fn declared_ports(text: &str) -> BTreeSet<(String, u32)> {
    let top = verilog_eval::modules(text)[0].text;
    let declaration = |line: &str| {
        let line = line.trim().trim_end_matches(';');
        let port = ["input wire ", "output reg ", "output wire "]
            .iter()
            .find_map(|kind| line.strip_prefix(kind))?;
        match port
            .strip_prefix('[')
            .and_then(|port| port.split_once(":0] "))
        {
            None => Some((port.to_owned(), 1)),
            Some((high, name)) => Some((name.to_owned(), high.parse::<u32>().ok()? + 1)),
        }
    };
    top.lines().filter_map(declaration).collect()
}

#[test]
fn every_machine_has_exactly_the_pins_of_the_spec() {
    for (machine, whole) in MACHINES.iter().zip(&*DESIGNS) {
        let pins = Pins::of(machine);
        let clock = ("clock".to_owned(), 1);
        let expected = pins.inputs.iter().chain(&pins.observed[..pins.outputs]);
        let expected = expected.map(|pin| (pin.name.clone(), pin.width));
        assert_eq!(
            declared_ports(&whole.text),
            expected.chain([clock]).collect(),
            "{}",
            machine.name
        );
    }
}

#[test]
fn equal_modules_are_merged() {
    let text = emit(&MACHINES[0], Level::Machine).unwrap().text;
    let modules = verilog_eval::modules(&text).len();
    // processor, control, store, decoder, ports, network, cell, square unit, difference,
    // squarer, gate unit, add unit, and registers of 1, 4, 8, 16, 18 and 32 bits.
    assert_eq!(modules, 18);
}

#[test]
fn a_machine_of_all_kinds_has_one_text_of_each_block() {
    let blocks = |machine: &str| {
        let emitted = emit(find_machine(machine).unwrap(), Level::Machine).unwrap();
        let text = emitted.ecp5_text.unwrap();
        ["MULT18X18D #", "DP16KD #"].map(|block| text.matches(block).count())
    };
    assert_eq!(blocks("tile-6-mixed"), [1, 1]);
    assert_eq!(blocks("tile-6"), [0, 0]);
}
