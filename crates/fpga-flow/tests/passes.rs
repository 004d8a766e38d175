//! The passes over netlists of an ECP5 are proven by Yosys, with the models of its cells, and refuted where they
//! are wrong. Yosys is that of `scripts/setup.sh --where`, or one on the PATH.

use fpga_flow::devices::ecp5;
use fpga_flow::{Netlist, Stage, prove};
use serde_json::{Value, json};

mod tools;

/// A block RAM of 9 bits with two outputs that feed flip-flops with these parameters, and the block with
/// these flip-flops moved inside.
fn block(register: &Value) -> [Netlist; 2] {
    let mut block = json!({
        "type": "DP16KD",
        "parameters": {
            "DATA_WIDTH_A": "00000000000000000000000000001001",
            "DATA_WIDTH_B": "00000000000000000000000000001001",
            "REGMODE_A": "NOREG", "REGMODE_B": "NOREG", "GSR": "DISABLED",
        },
        "port_directions": { "DOB0": "output", "DOB1": "output" },
        "connections": {
            "CLKA": [2], "CEA": [3], "OCEA": ["1"], "WEA": ["1"], "RSTA": ["0"], "DIA0": [4], "ADA5": [5],
            "CSA0": ["0"], "CSA1": ["0"], "CSA2": ["0"], "CSB0": ["0"], "CSB1": ["0"], "CSB2": ["0"],
            "CLKB": [2], "CEB": [6], "OCEB": ["1"], "WEB": ["0"], "RSTB": ["0"], "DIB0": ["x"], "ADB5": [7],
            "DOB0": [10], "DOB1": [11],
        },
    });
    for name in (0..14).flat_map(|pin| ["A", "B"].map(|port| format!("AD{port}{pin}"))) {
        let ends = &mut block["connections"];
        if ends[&name].is_null() {
            ends[&name] = json!(["0"]);
        }
    }
    let mut register = register.clone();
    register["connections"]["DI"] = json!([11]);
    register["connections"]["Q"] = json!([21]);
    let plain = json!({
        "type": "TRELLIS_FF",
        "parameters": { "CEMUX": "1 ", "CLKMUX": "CLK", "LSRMUX": "LSR", "REGSET": "RESET" },
        "port_directions": { "CLK": "input", "DI": "input", "LSR": "input", "Q": "output" },
        "connections": { "CLK": [2], "LSR": ["0"], "DI": [10], "Q": [20] },
    });
    let mut filled = block.clone();
    filled["parameters"]["REGMODE_B"] = json!("OUTREG");
    filled["connections"]["DOB0"] = json!([20]);
    filled["connections"]["DOB1"] = json!([21]);
    [
        netlist_of(&[("block", block), ("one", plain), ("other", register)]),
        netlist_of(&[("block", filled)]),
    ]
}

fn netlist_of(cells: &[(&str, Value)]) -> Netlist {
    let cells = cells
        .iter()
        .map(|(name, cell)| ((*name).to_owned(), cell.clone()));
    Netlist::from(json!({ "modules": { "serial": {
        "attributes": { "top": "1" },
        "ports": { "out": { "direction": "output", "bits": [20, 21] } },
        "cells": cells.collect::<serde_json::Map<_, _>>(),
    } } }))
}

/// Moving a flip-flop into a block RAM is proven where it is allowed, and refuted where it is not.
#[test]
#[ignore = "needs Yosys: scripts/setup.sh installs it"]
fn a_flip_flop_that_a_block_ram_does_not_have_is_found() {
    let yosys = tools::yosys();
    let folder = tempfile::tempdir().unwrap();
    let models = ecp5::models(&yosys, folder.path()).unwrap();
    let register = |parameter: &str, value: &str, reset: Value| {
        let mut register = json!({
            "type": "TRELLIS_FF",
            "parameters": { "CEMUX": "1 ", "CLKMUX": "CLK", "LSRMUX": "LSR", "REGSET": "RESET" },
            "port_directions": { "CE": "input", "CLK": "input", "DI": "input", "LSR": "input", "Q": "output" },
            "connections": { "CE": [8], "CLK": [2], "LSR": [reset] },
        });
        register["parameters"][parameter] = json!(value);
        register
    };
    let cases = [
        ("a plain one", register("REGSET", "RESET", json!("0")), true),
        (
            "one that starts as 1",
            register("REGSET", "SET", json!("0")),
            false,
        ),
        (
            "one with a reset",
            register("SRMODE", "LSR_OVER_CE", json!(9)),
            false,
        ),
        (
            "one with an enable",
            register("CEMUX", "CE", json!("0")),
            false,
        ),
    ];
    for (what, register, expected) in cases {
        let stages = block(&register).map(|netlist| Stage {
            name: "block RAM registers",
            netlist,
        });
        let passes = prove(&yosys, folder.path(), &models, &stages).unwrap();
        assert_eq!(passes[0].proven, expected, "{what}: {passes:#?}");
        assert!(passes[0].control_refuted, "{what}: {passes:#?}");
        // Flip-flops that the pass itself does not move are not examined.
        let moved = ecp5::FAMILY.stages(stages[0].netlist.clone());
        assert_eq!(moved[2].netlist == stages[1].netlist, expected, "{what}");
    }
}

/// A block in a mode that the model lacks stops the run.
#[test]
#[ignore = "needs Yosys: scripts/setup.sh installs it"]
fn a_parameter_without_a_model_is_refused() {
    let yosys = tools::yosys();
    let folder = tempfile::tempdir().unwrap();
    let models = ecp5::models(&yosys, folder.path()).unwrap();
    let register = json!({
        "type": "TRELLIS_FF",
        "parameters": { "CEMUX": "1 " },
        "port_directions": { "CLK": "input", "DI": "input", "LSR": "input", "Q": "output" },
        "connections": { "CLK": [2], "LSR": ["0"] },
    });
    for (parameter, value) in [
        ("WRITEMODE_A", "WRITETHROUGH"),
        ("DATA_WIDTH_A", "00000000000000000000000000000100"),
        ("MADE_UP", "1 "),
    ] {
        let stages = block(&register).map(|mut netlist| {
            netlist.json_mut()["modules"]["serial"]["cells"]["block"]["parameters"][parameter] =
                json!(value);
            Stage {
                name: "block RAM registers",
                netlist,
            }
        });
        let error = prove(&yosys, folder.path(), &models, &stages)
            .unwrap_err()
            .to_string();
        assert!(
            error.contains("not_modelled") || error.contains("MADE_UP"),
            "{error}"
        );
    }
}
