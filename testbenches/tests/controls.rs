//! Tests the comparison: each fault planted in the emitted Verilog must be found.

mod support;

use libtest_mimic::{Arguments, Failed};
use photoncube_hdl::{Emitted, Level, emit};
use photoncube_spec::{MACHINES, Machine, Unit, find_machine};
use photoncube_testbench::{
    Actual, DeviceError, DeviceKind, Divergence, Icarus, Source, VerifyError, VerifyOptions, plant,
    verify_device, verify_part_device,
};

const PAPER: &Machine = &MACHINES[0];

/// An edit of one module's text.
struct Fault {
    name: &'static str,
    /// The machine whose text is edited.
    machine: &'static str,
    /// The module, without the machine's prefix.
    module: &'static str,
    /// The text in the module, which occurs once.
    from: &'static str,
    /// The text that replaces it.
    to: &'static str,
    /// The step or signal that the description of the difference must contain.
    names: &'static str,
}

const FAULTS: &[Fault] = &[
    Fault {
        name: "op::the_adder_loses_its_carries",
        machine: "paper",
        module: "add_unit",
        from: "a + b",
        to: "a ^ b",
        names: "step      add",
    },
    Fault {
        name: "op::the_difference_is_never_turned_round",
        machine: "paper",
        module: "difference",
        from: "below ?",
        to: "1'b0 ?",
        names: "step      sqd",
    },
    Fault {
        name: "op::one_square_of_a_digit_is_off_by_one",
        machine: "paper",
        module: "squarer",
        from: "8'd196",
        to: "8'd197",
        names: "step      sqd",
    },
    Fault {
        name: "gate::the_boundary_is_out_of_range",
        machine: "paper",
        module: "gate_unit",
        from: "a > wide_b",
        to: "a >= wide_b",
        names: "step      gate",
    },
    Fault {
        name: "network::a_link_goes_to_the_wrong_neighbour",
        machine: "paper",
        module: "network",
        from: "link_5 | work_13",
        to: "link_5 | work_12",
        names: "node 5, register v",
    },
    Fault {
        name: "control::a_word_of_the_store_names_another_axis",
        machine: "paper",
        module: "store",
        from: "15'b10000000101000",
        to: "15'b1000000101000",
        names: "step      add z",
    },
    Fault {
        name: "control::the_sequencer_forgets_the_last_group",
        machine: "paper",
        module: "control",
        from: "last_d = group_last",
        to: "last_d = last_q",
        names: "control_last",
    },
    Fault {
        name: "control::a_taken_result_stays",
        machine: "paper",
        module: "control",
        from: "taken = done_q & result_ready",
        to: "taken = done_q & query_valid",
        names: "control_done",
    },
    Fault {
        name: "control::reset_forgets_the_address",
        machine: "paper",
        module: "control",
        from: "address_d = 32'h0;\n            last_d = 1'b0;",
        to: "last_d = 1'b0;",
        names: "control_address",
    },
    Fault {
        name: "cell::an_absent_photon_has_power",
        machine: "paper",
        module: "cell",
        from: "if (~present_in)",
        to: "if (1'b0)",
        names: "step      ldw",
    },
    Fault {
        name: "format::a_far_photon_is_not_clamped",
        machine: "local",
        module: "difference",
        from: "| {8{far}}",
        to: "",
        names: "step      sqd",
    },
    Fault {
        name: "format::the_far_side_of_a_half_step_is_not_inverted",
        machine: "fit-ring",
        module: "difference",
        from: "~a_minus_line",
        to: "-a_minus_line",
        names: "step      sqd",
    },
    Fault {
        name: "format::a_photon_stands_on_the_border_of_its_cell",
        machine: "fit-ring",
        module: "difference",
        from: "{b, 1'd1}",
        to: "{b, 1'd0}",
        names: "step      sqd",
    },
    Fault {
        name: "format::one_half_square_of_a_digit_is_a_square",
        machine: "fit-ring",
        module: "squarer",
        from: "4'd3: digit_half_square = 8'd12",
        to: "4'd3: digit_half_square = 8'd9",
        names: "step      sqd",
    },
    Fault {
        name: "format::a_power_has_the_exponent_of_another_lane",
        machine: "local",
        module: "ports",
        from: "cell_power_1 = cell_power_1 << exponent_1",
        to: "cell_power_1 = cell_power_1 << exponent_0",
        names: "step      ldw",
    },
];

fn main() {
    let icarus = DeviceKind::Icarus;
    let mut trials = Vec::new();
    for fault in FAULTS {
        trials.push(support::trial(fault.name.into(), icarus, || caught(fault)));
    }
    let name = "part::the_gate_alone_shows_its_fault_too";
    trials.push(support::trial(name.into(), icarus, part_caught));
    let name = "text::a_simulation_that_stops_is_no_pass";
    trials.push(support::trial(name.into(), icarus, stops));
    let name = "text::a_syntax_error_is_shown_in_the_tools_words";
    trials.push(support::trial(name.into(), icarus, no_verilog));
    let name = "power_up::a_register_without_its_initial_value_shows_x";
    trials.push(support::trial(name.into(), icarus, unknown_at_power_up));
    let name = "none::the_text_as_it_is_passes";
    trials.push(support::trial(name.into(), icarus, sound));
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

fn run(machine: &Machine, design: &Emitted) -> Result<(), VerifyError> {
    let options = VerifyOptions {
        iterations: 1_000,
        seed: 1,
        source: Source::Random,
    };
    verify_device(machine, &mut Icarus::new(design)?, &options, &|_| {}).map(drop)
}

fn diverges(machine: &Machine, design: &Emitted) -> Result<Divergence, Failed> {
    match run(machine, design) {
        Err(VerifyError::Diverged(divergence)) => Ok(*divergence),
        Err(other) => Err(other.into()),
        Ok(()) => Err("the fault was not found".into()),
    }
}

fn caught(fault: &Fault) -> Result<(), Failed> {
    let machine = find_machine(fault.machine)?;
    let mut design = emit(machine, Level::Machine)?;
    let module = format!("{}_{}", machine.module_prefix(), fault.module);
    design.text = plant(&design.text, &module, fault.from, fault.to)?;
    let account = diverges(machine, &design)?.to_string();
    assert!(account.contains(fault.names), "{account}");
    Ok(())
}

fn part_caught() -> Result<(), Failed> {
    let mut design = emit(PAPER, Level::Unit(Unit::Gate))?;
    let verified = |design: &Emitted| {
        let mut device = Icarus::new(design)?;
        verify_part_device(PAPER, Level::Unit(Unit::Gate), &mut device, 1_000, 1)
    };
    verified(&design)?;
    design.text = plant(&design.text, &design.top, "a > wide_b", "a >= wide_b")?;
    match verified(&design) {
        Err(VerifyError::Diverged(divergence)) => {
            assert_eq!(divergence.signal, "gated");
            let operands = &divergence.operands;
            assert_eq!(operands[0].1, operands[1].1, "a tie");
            Ok(())
        }
        other => Err(format!("the fault was not found: {other:?}").into()),
    }
}

fn stops() -> Result<(), Failed> {
    let mut design = emit(PAPER, Level::Machine)?;
    let module = format!("{}_store", PAPER.module_prefix());
    let from = "    // Update code";
    let stop = "    initial #301 $finish;";
    design.text = plant(&design.text, &module, from, stop)?;
    match run(PAPER, &design) {
        Err(VerifyError::Device(DeviceError::BrokeOff { device, .. })) => {
            assert_eq!(device, "icarus");
            Ok(())
        }
        other => Err(format!("expected a simulation that broke off, found {other:?}").into()),
    }
}

fn no_verilog() -> Result<(), Failed> {
    let mut design = emit(PAPER, Level::Machine)?;
    design.text += "modul\n";
    let message = run(PAPER, &design).unwrap_err().to_string();
    assert!(
        message.contains("`iverilog` failed") && message.contains("syntax error"),
        "{message}"
    );
    Ok(())
}

fn unknown_at_power_up() -> Result<(), Failed> {
    let mut design = emit(PAPER, Level::Machine)?;
    let initial = "initial begin\n       q = 32'h0;\n    end";
    let module = format!("{}_register_32", PAPER.module_prefix());
    design.text = plant(&design.text, &module, initial, "")?;
    let divergence = diverges(PAPER, &design)?;
    assert_eq!(divergence.actual, Actual::Unknown("xxxxxxxx".into()));
    assert_eq!((divergence.clock, divergence.differing), (0, 16 + 4));
    Ok(())
}

fn sound() -> Result<(), Failed> {
    Ok(run(PAPER, &emit(PAPER, Level::Machine)?)?)
}
