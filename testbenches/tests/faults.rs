//! Verifies waiting streams, resets, unknown words and power-up, by class, on one machine of each
//! organisation; and requires that each class finds a planted fault in each machine.

mod support;

use libtest_mimic::{Arguments, Failed};
use photoncube_spec::find_machine;
use photoncube_testbench::{
    DeviceKind, FaultClass, FaultOfClass, PLANTED_FAULTS, PlantedFault, VerifyError,
    fault_controls, verify_fault, verify_fault_text,
};

const MACHINES: [&str; 3] = ["paper", "overlap", "stream"];

/// Faults in other machines than the one whose faults every run plants.
const FAULTS: &[FaultOfClass] = &[
    (
        FaultClass::Stalls,
        PlantedFault {
            what: "a result does not wait until it is taken",
            machine: "overlap",
            module: "control",
            edits: &[("taken = done_q & result_ready", "taken = done_q")],
        },
        "control_occupied",
    ),
    (
        FaultClass::Stalls,
        PlantedFault {
            what: "the next result takes the place of one that waits",
            machine: "stream",
            module: "queue",
            edits: &[("has_waiting & (~has_result | result_ready)", "has_waiting")],
        },
        "head_promised_0",
    ),
    (
        FaultClass::Holds,
        PlantedFault {
            what: "a query that is awaited for 200 clocks comes by itself",
            machine: "overlap",
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
        },
        "control_address",
    ),
    (
        FaultClass::Holds,
        PlantedFault {
            what: "groups are taken though the queue has no room for their result",
            machine: "stream",
            module: "admission",
            edits: &[("room = ~promised[15]", "room = 1'b1")],
        },
        "query_ready",
    ),
    (
        FaultClass::Patterns,
        PlantedFault {
            what: "a group is taken that is not valid",
            machine: "overlap",
            module: "control",
            edits: &[("accepts_group & group_valid", "accepts_group")],
        },
        "control_last",
    ),
    (
        FaultClass::Patterns,
        PlantedFault {
            what: "a query is taken that is not valid",
            machine: "stream",
            module: "admission",
            edits: &[("query_valid & admits_query", "admits_query")],
        },
        "head_entry_token_valid_0",
    ),
    (
        FaultClass::Resets,
        PlantedFault {
            what: "a reset forgets the clocks since the last group",
            machine: "overlap",
            module: "control",
            edits: &[(
                "last_d = 1'b0;\n            drain_d = 32'h0;",
                "last_d = 1'b0;",
            )],
        },
        "control_drain",
    ),
    (
        FaultClass::Resets,
        PlantedFault {
            what: "a reset forgets that a result waits in the queue",
            machine: "stream",
            module: "queue",
            edits: &[("        has_waiting <= 1'd0;\n", "")],
        },
        "head_has_waiting_0",
    ),
    // Verilog's `if (x)` takes the else branch, so only all ones find the fault.
    (
        FaultClass::IdleUnknown,
        PlantedFault {
            what: "a group that is not valid may be the last",
            machine: "overlap",
            module: "control",
            edits: &[("takes_group & group_last", "accepts_group & group_last")],
        },
        "group_ready",
    ),
    (
        FaultClass::IdleUnknown,
        PlantedFault {
            what: "a group that is not valid may be the last",
            machine: "stream",
            module: "admission",
            edits: &[(
                "group_valid & has_batch & group_last & fits",
                "has_batch & group_last & fits",
            )],
        },
        "group_ready",
    ),
    (
        FaultClass::NoReset,
        PlantedFault {
            what: "flags have no initial value",
            machine: "overlap",
            module: "register_1",
            edits: &[("initial begin\n       q = 1'h0;\n    end", "")],
        },
        "control_occupied",
    ),
    (
        FaultClass::NoReset,
        PlantedFault {
            what: "whether a result waits has no initial value",
            machine: "stream",
            module: "queue",
            edits: &[("reg has_waiting = 1'd0;", "reg has_waiting;")],
        },
        "head_has_waiting_0",
    ),
    (
        FaultClass::UnknownPowerUp,
        PlantedFault {
            what: "a reset forgets that a query is in the machine",
            machine: "overlap",
            module: "control",
            edits: &[(
                "address_d = 32'h0;\n            occupied_d = 1'b0;",
                "address_d = 32'h0;",
            )],
        },
        "query_ready",
    ),
    (
        FaultClass::UnknownPowerUp,
        PlantedFault {
            what: "a reset forgets how many batches are promised",
            machine: "stream",
            module: "admission",
            edits: &[("        promised <= 16'd0;\n", "")],
        },
        "query_ready",
    ),
    // A photon memory. The command line runs all classes on it; the test runs the quick ones.
    (
        FaultClass::Stalls,
        PlantedFault {
            what: "a batch begins before its queries are there",
            machine: "tile-6-mixed",
            module: "memory",
            edits: &[("play_full & is_full & has_room", "play_full & has_room")],
        },
        "memory_may_start_0",
    ),
    (
        FaultClass::Holds,
        PlantedFault {
            what: "a batch begins though the queue has no room for its results",
            machine: "tile-6-mixed",
            module: "memory",
            edits: &[("is_full & has_room & in_time", "is_full & in_time")],
        },
        "memory_may_start_0",
    ),
    (
        FaultClass::Patterns,
        PlantedFault {
            what: "a group that is not valid is written",
            machine: "tile-6-mixed",
            module: "memory",
            edits: &[(
                "takes_group = group_valid & fill_ready",
                "takes_group = fill_ready",
            )],
        },
        "memory_fill_bank_0",
    ),
    (
        FaultClass::Resets,
        PlantedFault {
            what: "a reset forgets a bank that has a whole set",
            machine: "tile-6-mixed",
            module: "memory",
            edits: &[("        full_0 <= 1'd0;\n        full_1", "        full_1")],
        },
        "memory_full_0",
    ),
];

fn main() {
    let faults: Vec<_> = PLANTED_FAULTS.iter().chain(FAULTS).collect();
    let mut trials = Vec::new();
    for machine in MACHINES {
        for class in FaultClass::ALL {
            let title = format!("{machine}::{class:?}");
            trials.push(support::trial(title, device(class), move || {
                sound(machine, class)
            }));
            let planted = |(of, fault, _): &&FaultOfClass| *of == class && fault.machine == machine;
            assert!(faults.iter().any(planted), "{machine} {class:?}");
        }
    }
    for fault in faults {
        let (class, PlantedFault { machine, what, .. }, _) = fault;
        let title = format!("{machine}::{class:?}: {what}");
        trials.push(support::trial(title, device(*class), || caught(fault)));
    }
    let title = "controls::each_class_finds_its_own".to_owned();
    trials.push(support::trial(title, DeviceKind::Icarus, controls));
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

fn caught((class, fault, signal): &FaultOfClass) -> Result<(), Failed> {
    let (machine, design) = fault.plant()?;
    let found = match verify_fault_text(machine, *class, device(*class), &design, 1) {
        Err(VerifyError::Diverged(found)) => found.signal,
        Err(VerifyError::Unknown(found)) => found.signal,
        other => return Err(format!("the fault was not found: {other:?}").into()),
    };
    match found == *signal {
        true => Ok(()),
        false => Err(format!("`{found}` differs first, expected `{signal}`").into()),
    }
}

/// The faults that every run of `photoncube verify faults` plants: one for each class.
fn controls() -> Result<(), Failed> {
    let controls = fault_controls()?;
    assert!(
        controls.iter().all(|control| control.found),
        "{controls:#?}"
    );
    for class in FaultClass::ALL {
        let of_class = |c: &photoncube_testbench::Control| c.planted.starts_with(class.name());
        assert_eq!(controls.iter().filter(|c| of_class(c)).count(), 1);
    }
    Ok(())
}
