//! Tests of the placed netlist: small machines of each organisation equal the golden model in it, and planted
//! faults are found.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use photoncube_spec::find_machine;
use photoncube_testbench::Source;
use serde_json::{Value, json};

use super::super::tools::Purpose;
use super::*;

/// Enough iterations for every fault here; Icarus, which needs no compiler, simulates some hundred clocks in
/// a second.
const ITERATIONS: u64 = 60;

/// Yosys, as `scripts/setup.sh` installs it, and Icarus. `None` where one is missing, which fails with
/// `REQUIRE_EDA=1`.
fn tools() -> Option<Tools> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let said = Command::new(root.join("scripts/setup.sh"))
        .arg("--where")
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&said.stdout).trim().to_owned();
    let missing = match (said.is_empty(), DeviceKind::Icarus.missing_tool()) {
        (true, _) => "no Yosys of `scripts/setup.sh --where`".to_owned(),
        (_, Some(missing)) => missing.to_string(),
        _ => return Some(Tools::find(Some(Path::new(&said)), Purpose::Map).unwrap()),
    };
    assert!(std::env::var("REQUIRE_EDA").is_err(), "{missing}");
    eprintln!("not run: {missing}");
    None
}

fn simulated(placed: &Placed<'_>, netlist: &Value) -> Result<Verdict, VerifyError> {
    let options = VerifyOptions {
        iterations: ITERATIONS,
        seed: 1,
        source: Source::Random,
    };
    placed
        .verify(netlist, DeviceKind::Icarus, &options, &|_| ())
        .unwrap()
}

fn assert_differs(placed: &Placed<'_>, netlist: &Value, fault: &str) {
    let found = simulated(placed, netlist);
    assert!(
        matches!(found, Err(VerifyError::Diverged(_))),
        "{fault}: {found:?}"
    );
}

fn cells(netlist: &mut Value) -> &mut serde_json::Map<String, Value> {
    netlist["modules"]["serial"]["cells"]
        .as_object_mut()
        .unwrap()
}

/// Compares each different stage with the golden model and proves the passes; then requires that a wrong LUT
/// is found.
fn holds(machine: &str) {
    let Some(tools) = tools() else { return };
    let subject = Subject::of(find_machine(machine).unwrap()).unwrap();
    let placed = Placed::map(&tools, &subject).unwrap();
    let passes = placed.prove().unwrap();
    assert!(passes[0].cells_changed > 0, "{passes:#?}");
    assert!(
        passes
            .iter()
            .all(|pass| pass.proven && pass.control_refuted),
        "{passes:#?}"
    );
    let last = placed.stages().last().unwrap();
    let verdict = simulated(&placed, &last.netlist).unwrap();
    assert!(verdict.results_compared > 0);
    let mut wrong = last.netlist.clone();
    let lut = cells(&mut wrong)
        .iter_mut()
        .find(|(name, cell)| cell["type"] == "LUT4" && name.starts_with("machine."));
    let init = &mut lut.unwrap().1["parameters"]["INIT"];
    *init = inverted(init.as_str().unwrap()).into();
    assert_differs(&placed, &wrong, "a LUT that is wrong");
    assert_ne!(
        netlist::sha256(&wrong).unwrap(),
        placed.netlist_sha256().unwrap()
    );
    open_a_carry_that_is_read(&placed);
}

fn inverted(bits: &str) -> String {
    bits.chars()
        .map(|bit| if bit == '0' { '1' } else { '0' })
        .collect()
}

/// A pass that disconnects one end too many: its proof fails, and the simulation differs.
fn open_a_carry_that_is_read(placed: &Placed<'_>) {
    let mapped = &placed.stages()[0];
    let mut wrong = mapped.netlist.clone();
    let of_chain = |cell: &Value| cell["type"] == "CCU2C" && cell["connections"]["CIN"][0].is_u64();
    let read = cells(&mut wrong)
        .values()
        .find(|cell| of_chain(cell))
        .unwrap()["connections"]["CIN"]
        .clone();
    let driver = cells(&mut wrong)
        .values_mut()
        .find(|cell| cell["connections"]["COUT"] == read);
    driver.unwrap()["connections"]["COUT"] = json!(["x"]);
    let stage = |netlist: &Value| Stage {
        name: "open carry ends",
        netlist: netlist.clone(),
    };
    let stages = [stage(&mapped.netlist), stage(&wrong)];
    let passes = prove(placed.tools, placed.folder(), &placed.models, &stages).unwrap();
    assert!(!passes[0].proven, "{passes:#?}");
    assert_differs(placed, &wrong, "a carry end that is read and open");
}

#[test]
fn a_sequential_machine_is_the_golden_model_as_it_is_placed() {
    holds("fit-ring");
}

#[test]
fn an_overlapped_machine_is_the_golden_model_as_it_is_placed() {
    holds("overlap");
}

#[test]
fn a_spatial_machine_is_the_golden_model_as_it_is_placed() {
    holds("tile-4");
}

#[test]
fn a_second_text_that_is_wrong_is_found() {
    let Some(tools) = tools() else { return };
    let mut subject = Subject::of(find_machine("tile-4").unwrap()).unwrap();
    let text = subject.ecp5_verilog.take().unwrap();
    let (before, after) = text.split_once(".INIT1(16'h").unwrap();
    let (digits, rest) = after.split_at(4);
    let digits = u16::from_str_radix(digits, 16).unwrap() ^ 0xffff;
    subject.ecp5_verilog = Some(format!("{before}.INIT1(16'h{digits:04x}{rest}"));
    let placed = Placed::map(&tools, &subject).unwrap();
    assert_differs(
        &placed,
        &placed.stages()[0].netlist,
        "a second text that is wrong",
    );
}

/// A block RAM of 9 bits with two outputs that feed flip-flops with these parameters, and the block with
/// these flip-flops moved inside.
fn block(register: &Value) -> [Value; 2] {
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

fn netlist_of(cells: &[(&str, Value)]) -> Value {
    let cells = cells
        .iter()
        .map(|(name, cell)| ((*name).to_owned(), cell.clone()));
    json!({ "modules": { "serial": {
        "attributes": { "top": "1" },
        "ports": { "out": { "direction": "output", "bits": [20, 21] } },
        "cells": cells.collect::<serde_json::Map<_, _>>(),
    } } })
}

/// Moving a flip-flop into a block RAM is proven where it is allowed, and refuted where it is not.
#[test]
fn a_flip_flop_that_a_block_ram_does_not_have_is_found() {
    let Some(tools) = tools() else { return };
    let folder = tempfile::tempdir().unwrap();
    let models = models(&tools, folder.path()).unwrap();
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
        let passes = prove(&tools, folder.path(), &models, &stages).unwrap();
        assert_eq!(passes[0].proven, expected, "{what}: {passes:#?}");
        assert!(passes[0].control_refuted, "{what}: {passes:#?}");
        // Flip-flops that the pass itself does not move are not examined.
        let moved = netlist::stages(&stages[0].netlist.to_string())
            .unwrap()
            .remove(2);
        assert_eq!(moved.netlist == stages[1].netlist, expected, "{what}");
    }
}

/// A block in a mode that the model lacks stops the run.
#[test]
fn a_parameter_without_a_model_is_refused() {
    let Some(tools) = tools() else { return };
    let folder = tempfile::tempdir().unwrap();
    let models = models(&tools, folder.path()).unwrap();
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
            cells(&mut netlist)["block"]["parameters"][parameter] = json!(value);
            Stage {
                name: "block RAM registers",
                netlist,
            }
        });
        let error = prove(&tools, folder.path(), &models, &stages)
            .unwrap_err()
            .to_string();
        assert!(
            error.contains("not_modelled") || error.contains("MADE_UP"),
            "{error}"
        );
    }
}

/// The modules of a text by name, without the machine's name in them, and without comments.
fn modules(text: &str, top: &str) -> BTreeMap<String, String> {
    let lines = text
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"));
    let text = lines.collect::<Vec<_>>().join("\n").replace(top, "the");
    let modules = text.split("\nendmodule").filter_map(|module| {
        let module = &module[module.find("module ")?..];
        let name = module["module ".len()..].split(['(', ' ']).next()?;
        Some((name.to_owned(), module.to_owned()))
    });
    modules.collect()
}

/// The names of the modules of a machine that is too large to simulate, which are not modules of the
/// simulated machines.
fn others(machine: &str, simulated: &[Subject]) -> [Vec<String>; 2] {
    let texts = |subject: &Subject| {
        let ecp5 = subject.ecp5_verilog.clone().unwrap_or_default();
        [subject.verilog.clone(), ecp5].map(|text| modules(&text, &subject.top))
    };
    let known: Vec<_> = simulated.iter().map(texts).collect();
    let subject = Subject::of(find_machine(machine).unwrap()).unwrap();
    let own = texts(&subject);
    [0, 1].map(|which| {
        let is_known = |text: &String| {
            known
                .iter()
                .any(|known| known[which].values().any(|known| known == text))
        };
        assert!(!own[which].is_empty());
        let others = own[which].iter().filter(|(_, text)| !is_known(text));
        others.map(|(name, _)| name.clone()).collect()
    })
}

#[test]
fn chips_are_made_of_modules_of_machines_that_are_simulated() {
    let simulated =
        ["tile-6", "tile-6-mixed"].map(|name| Subject::of(find_machine(name).unwrap()).unwrap());
    let sizes = ["the", "the_admission", "the_queue"];
    assert_eq!(
        others("chip-lut", &simulated),
        [sizes.map(str::to_owned).to_vec(), vec![]]
    );
    let [portable, second] = others("chip-mixed", &simulated);
    assert_eq!(second, [""; 0]);
    let is_expected = |name: &String| {
        sizes.contains(&name.as_str())
            || name.starts_with("the_lane")
            || name.starts_with("the_square_pair")
    };
    let unexpected: Vec<_> = portable.iter().filter(|name| !is_expected(name)).collect();
    assert!(unexpected.is_empty(), "{unexpected:?}");
}
