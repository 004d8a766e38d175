//! A planted fault of each class in the text of the smallest machine, by which a run shows that it finds faults.

use rayon::prelude::*;

use super::{FaultClass, verify_fault_text};
use crate::controls::{Control, PlantedFault};
use crate::device::DeviceKind;
use crate::verify::VerifyError;

/// A fault that its class shows, and the signal that must differ first.
pub type FaultOfClass = (FaultClass, PlantedFault, &'static str);

/// A planted fault of each class.
pub const PLANTED_FAULTS: [FaultOfClass; FaultClass::ALL.len()] = [
    (
        FaultClass::Stalls,
        PlantedFault {
            what: "a step does not wait for its group",
            machine: "paper",
            module: "control",
            edits: &[("runs = group_valid", "runs = 1'b1")],
        },
        "control_address",
    ),
    (
        FaultClass::Holds,
        PlantedFault {
            what: "a result that waits for 200 clocks is dropped",
            machine: "paper",
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
        },
        "control_done",
    ),
    (
        FaultClass::Patterns,
        PlantedFault {
            what: "the query is not waited for",
            machine: "paper",
            module: "control",
            edits: &[("runs = query_valid", "runs = 1'b1")],
        },
        "control_address",
    ),
    (
        FaultClass::Resets,
        PlantedFault {
            what: "a reset forgets that the last group was taken",
            machine: "paper",
            module: "control",
            edits: &[(
                "address_d = 32'h0;\n            last_d = 1'b0;",
                "address_d = 32'h0;",
            )],
        },
        "control_last",
    ),
    (
        FaultClass::IdleUnknown,
        PlantedFault {
            what: "cells load a query that is not valid",
            machine: "paper",
            module: "control",
            edits: &[("decoder_write_query & runs", "decoder_write_query")],
        },
        "cell_0_query",
    ),
    (
        FaultClass::NoReset,
        PlantedFault {
            what: "the address has no initial value",
            machine: "paper",
            module: "register_4",
            edits: &[("initial begin\n       q = 4'h0;\n    end", "")],
        },
        "control_address",
    ),
    (
        FaultClass::UnknownPowerUp,
        PlantedFault {
            what: "a reset forgets the address",
            machine: "paper",
            module: "control",
            edits: &[(
                "address_d = 32'h0;\n            last_d = 1'b0;",
                "last_d = 1'b0;",
            )],
        },
        "query_ready",
    ),
];

/// Plants a fault of each class in the text of a small machine, in the built-in evaluator or, where only that
/// shows it, in Icarus.
///
/// # Errors
/// A device does not run.
pub fn fault_controls() -> Result<Vec<Control>, VerifyError> {
    let control = |(class, fault, _): &FaultOfClass| {
        let (machine, design) = fault.plant()?;
        let ended = verify_fault_text(machine, *class, DeviceKind::Text, &design, 1);
        Control::of(format!("{}: {}", class.name(), fault.told()), ended)
    };
    PLANTED_FAULTS.par_iter().map(control).collect()
}
