//! Verifies waiting streams, resets, unknown words and power-up, by class, on one machine of each
//! organisation; and requires that each class finds a planted fault in each machine.

mod planted;
mod support;

use libtest_mimic::{Arguments, Failed};
use photoncube_hdl::{Level, emit};
use photoncube_spec::find_machine;
use photoncube_testbench::{DeviceKind, FaultClass, VerifyError, verify_fault, verify_fault_text};
use planted::edit;

const MACHINES: [&str; 3] = ["paper", "overlap", "stream"];

/// Edits of one module's text, each of a text that occurs once.
struct Fault {
    class: FaultClass,
    machine: &'static str,
    what: &'static str,
    /// The module, without the machine's prefix.
    module: &'static str,
    edits: &'static [(&'static str, &'static str)],
    /// The first signal that must differ, which shows that this fault was found and not another.
    signal: &'static str,
}

const FAULTS: &[Fault] = &[
    Fault {
        class: FaultClass::Stalls,
        machine: "paper",
        what: "a step does not wait for its group",
        module: "control",
        edits: &[("runs = group_valid", "runs = 1'b1")],
        signal: "control_address",
    },
    Fault {
        class: FaultClass::Stalls,
        machine: "overlap",
        what: "a result does not wait until it is taken",
        module: "control",
        edits: &[("taken = done_q & result_ready", "taken = done_q")],
        signal: "control_occupied",
    },
    Fault {
        class: FaultClass::Stalls,
        machine: "stream",
        what: "the next result takes the place of one that waits",
        module: "queue",
        edits: &[("has_waiting & (~has_result | result_ready)", "has_waiting")],
        signal: "head_promised_0",
    },
    Fault {
        class: FaultClass::Holds,
        machine: "paper",
        what: "a result that waits for 200 clocks is dropped",
        module: "control",
        edits: &[
            (
                "    // Local signals",
                "    reg [7:0] waited = 8'd0;\n    always @(posedge clock) begin\n        \
                 waited <= done_q ? waited + 8'd1 : 8'd0;\n    end",
            ),
            (
                "taken = done_q & result_ready",
                "taken = done_q & (result_ready | (waited == 8'd200))",
            ),
        ],
        signal: "control_done",
    },
    Fault {
        class: FaultClass::Holds,
        machine: "overlap",
        what: "a query that is awaited for 200 clocks comes by itself",
        module: "control",
        edits: &[
            (
                "    // Local signals",
                "    reg [7:0] waited = 8'd0;\n    always @(posedge clock) begin\n        \
                 waited <= occupied_q ? 8'd0 : waited + 8'd1;\n    end",
            ),
            (
                "takes_query = accepts & query_valid",
                "takes_query = accepts & (query_valid | (waited == 8'd200))",
            ),
        ],
        signal: "control_address",
    },
    Fault {
        class: FaultClass::Holds,
        machine: "stream",
        what: "groups are taken though the queue has no room for their result",
        module: "admission",
        edits: &[("room = ~promised[15]", "room = 1'b1")],
        signal: "query_ready",
    },
    Fault {
        class: FaultClass::Patterns,
        machine: "paper",
        what: "the query is not waited for",
        module: "control",
        edits: &[("runs = query_valid", "runs = 1'b1")],
        signal: "control_address",
    },
    Fault {
        class: FaultClass::Patterns,
        machine: "overlap",
        what: "a group is taken that is not valid",
        module: "control",
        edits: &[("accepts_group & group_valid", "accepts_group")],
        signal: "control_last",
    },
    Fault {
        class: FaultClass::Patterns,
        machine: "stream",
        what: "a query is taken that is not valid",
        module: "admission",
        edits: &[("query_valid & admits_query", "admits_query")],
        signal: "head_entry_token_valid_0",
    },
    Fault {
        class: FaultClass::Resets,
        machine: "paper",
        what: "a reset forgets that the last group was taken",
        module: "control",
        edits: &[(
            "address_d = 32'h0;\n            last_d = 1'b0;",
            "address_d = 32'h0;",
        )],
        signal: "control_last",
    },
    Fault {
        class: FaultClass::Resets,
        machine: "overlap",
        what: "a reset forgets the clocks since the last group",
        module: "control",
        edits: &[(
            "last_d = 1'b0;\n            drain_d = 32'h0;",
            "last_d = 1'b0;",
        )],
        signal: "control_drain",
    },
    Fault {
        class: FaultClass::Resets,
        machine: "stream",
        what: "a reset forgets that a result waits in the queue",
        module: "queue",
        edits: &[("        has_waiting <= 1'd0;\n", "")],
        signal: "head_has_waiting_0",
    },
    Fault {
        class: FaultClass::IdleUnknown,
        machine: "paper",
        what: "cells load a query that is not valid",
        module: "control",
        edits: &[("decoder_write_query & runs", "decoder_write_query")],
        signal: "cell_0_query",
    },
    Fault {
        class: FaultClass::IdleUnknown,
        machine: "overlap",
        // Verilog's `if (x)` takes the else branch, so only all ones find the fault.
        what: "a group that is not valid may be the last",
        module: "control",
        edits: &[("takes_group & group_last", "accepts_group & group_last")],
        signal: "group_ready",
    },
    Fault {
        class: FaultClass::IdleUnknown,
        machine: "stream",
        what: "a group that is not valid may be the last",
        module: "admission",
        edits: &[(
            "group_valid & has_batch & group_last & fits",
            "has_batch & group_last & fits",
        )],
        signal: "group_ready",
    },
    Fault {
        class: FaultClass::NoReset,
        machine: "paper",
        what: "the address has no initial value",
        module: "register_4",
        edits: &[("initial begin\n       q = 4'h0;\n    end", "")],
        signal: "control_address",
    },
    Fault {
        class: FaultClass::NoReset,
        machine: "overlap",
        what: "flags have no initial value",
        module: "register_1",
        edits: &[("initial begin\n       q = 1'h0;\n    end", "")],
        signal: "control_occupied",
    },
    Fault {
        class: FaultClass::NoReset,
        machine: "stream",
        what: "whether a result waits has no initial value",
        module: "queue",
        edits: &[("reg has_waiting = 1'd0;", "reg has_waiting;")],
        signal: "head_has_waiting_0",
    },
    Fault {
        class: FaultClass::UnknownPowerUp,
        machine: "paper",
        what: "a reset forgets the address",
        module: "control",
        edits: &[(
            "address_d = 32'h0;\n            last_d = 1'b0;",
            "last_d = 1'b0;",
        )],
        signal: "query_ready",
    },
    Fault {
        class: FaultClass::UnknownPowerUp,
        machine: "overlap",
        what: "a reset forgets that a query is in the machine",
        module: "control",
        edits: &[(
            "address_d = 32'h0;\n            occupied_d = 1'b0;",
            "address_d = 32'h0;",
        )],
        signal: "query_ready",
    },
    Fault {
        class: FaultClass::UnknownPowerUp,
        machine: "stream",
        what: "a reset forgets how many batches are promised",
        module: "admission",
        edits: &[("        promised <= 16'd0;\n", "")],
        signal: "query_ready",
    },
    // A photon memory. The command line runs all classes on it; the test runs the quick ones.
    Fault {
        class: FaultClass::Stalls,
        machine: "tile-6-mixed",
        what: "a batch begins before its queries are there",
        module: "memory",
        edits: &[("play_full & is_full & has_room", "play_full & has_room")],
        signal: "memory_may_start_0",
    },
    Fault {
        class: FaultClass::Holds,
        machine: "tile-6-mixed",
        what: "a batch begins though the queue has no room for its results",
        module: "memory",
        edits: &[("is_full & has_room & in_time", "is_full & in_time")],
        signal: "memory_may_start_0",
    },
    Fault {
        class: FaultClass::Patterns,
        machine: "tile-6-mixed",
        what: "a group that is not valid is written",
        module: "memory",
        edits: &[(
            "takes_group = group_valid & fill_ready",
            "takes_group = fill_ready",
        )],
        signal: "memory_fill_bank_0",
    },
    Fault {
        class: FaultClass::Resets,
        machine: "tile-6-mixed",
        what: "a reset forgets a bank that has a whole set",
        module: "memory",
        edits: &[("        full_0 <= 1'd0;\n        full_1", "        full_1")],
        signal: "memory_full_0",
    },
];

fn main() {
    let mut trials = Vec::new();
    for machine in MACHINES {
        for class in FaultClass::ALL {
            let title = format!("{machine}::{class:?}");
            trials.push(support::trial(title, device(class), move || {
                sound(machine, class)
            }));
            let planted = |f: &&Fault| f.class == class && f.machine == machine;
            assert!(FAULTS.iter().any(|f| planted(&f)), "{machine} {class:?}");
        }
    }
    for fault in FAULTS {
        let title = format!("{}::{:?}: {}", fault.machine, fault.class, fault.what);
        let kind = device(fault.class);
        trials.push(support::trial(title, kind, || caught(fault)));
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

/// The device for a class: the evaluator of the emitted text, where it can show the fault.
fn device(class: FaultClass) -> DeviceKind {
    match class.is_four_state() {
        true => DeviceKind::Icarus,
        false => DeviceKind::Text,
    }
}

fn sound(machine: &str, class: FaultClass) -> Result<(), Failed> {
    let verdict = verify_fault(find_machine(machine)?, class, device(class), 1)?;
    assert!(verdict.injections > 0 && verdict.results_compared > 0);
    assert!(verdict.vectors_compared > 100);
    Ok(())
}

fn caught(fault: &Fault) -> Result<(), Failed> {
    let machine = find_machine(fault.machine)?;
    let mut design = emit(machine, Level::Machine)?;
    let module = format!("module {}_{}(", machine.module_prefix(), fault.module);
    for (from, to) in fault.edits {
        design.text = edit(&design.text, &module, from, to);
    }
    match verify_fault_text(machine, fault.class, device(fault.class), &design, 1) {
        Err(VerifyError::Diverged(found)) => same_signal(&found.signal, fault),
        Err(VerifyError::Unknown(found)) => same_signal(&found.signal, fault),
        other => Err(format!("the fault was not found: {other:?}").into()),
    }
}

fn same_signal(found: &str, fault: &Fault) -> Result<(), Failed> {
    match found == fault.signal {
        true => Ok(()),
        false => Err(format!("`{found}` differs first, expected `{}`", fault.signal).into()),
    }
}
