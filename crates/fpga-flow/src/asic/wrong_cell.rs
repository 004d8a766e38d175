//! A planted fault: one cell of a mapped netlist that gives the inverse of what it should.

use std::collections::HashMap;

use serde_json::Value;

use super::library::{Library, Register};
use crate::error::{Result, ensure, unexpected};
use crate::netlist::{Netlist, connections};

/// The name of the wrong cell's module.
const WRONG: &str = "wrong_cell";

/// A netlist with a wrong cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WrongCell {
    /// The Verilog of the netlist with the models of its cells.
    pub text: String,
    /// The fault, for people.
    pub what: String,
}

/// Plants a wrong cell in `text`, which is the Verilog of the netlist's module `top` with models. The cell is a gate whose output is
/// stored by a register that an output of the module shows.
///
/// # Errors
/// There is no such gate, or it does not occur once in the text.
pub(super) fn plant(
    netlist: &Netlist,
    top: &str,
    library: &Library,
    text: &str,
) -> Result<WrongCell> {
    let module = &netlist.json()["modules"][top];
    let gate = gate_before_output(module, library.register());
    let (name, cell) = gate.ok_or_else(|| {
        unexpected(format!(
            "found no gate before the register of an output of {top}"
        ))
    })?;
    let kind = cell["type"].as_str().unwrap_or_default();
    let [right, wrong] = [kind, WRONG].map(|kind| format!("  {kind} {name} ("));
    let times = text.matches(&right).count();
    ensure(times == 1, || {
        format!("found `{right}` {times} times in the netlist of {top}, expected once")
    })?;
    Ok(WrongCell {
        text: text.replacen(&right, &wrong, 1) + &inverted(kind, cell),
        what: format!("the cell {name} ({kind}) gives the inverse"),
    })
}

/// A cell that drives the input of a register that drives an output, and is no register.
fn gate_before_output<'a>(module: &'a Value, register: &Register) -> Option<(&'a str, &'a Value)> {
    let mut drivers: HashMap<u64, (&str, &Value)> = HashMap::new();
    for (name, cell) in module["cells"].as_object()? {
        let outputs = connections(cell).filter(|(_, is_output, _)| *is_output);
        let bits = outputs.filter_map(|(_, _, bits)| bits.first()?.as_u64());
        drivers.extend(bits.map(|bit| (bit, (name.as_str(), cell))));
    }
    let is_register = |cell: &Value| cell["type"] == *register.cell.cell;
    let ports = module["ports"].as_object()?.values();
    let outputs = ports.filter(|port| port["direction"] == "output");
    let mut bits = outputs.flat_map(|port| port["bits"].as_array().into_iter().flatten());
    bits.find_map(|bit| {
        let (_, shown) = drivers.get(&bit.as_u64()?)?;
        let stored = is_register(shown).then(|| &shown["connections"][&register.cell.input][0])?;
        let gate = *drivers.get(&stored.as_u64()?)?;
        (!is_register(gate.1)).then_some(gate)
    })
}

/// A module with the pins of a cell, whose outputs are the inverse.
fn inverted(kind: &str, cell: &Value) -> String {
    let (mut ports, mut inside, mut pins) = (Vec::new(), String::new(), Vec::new());
    for (pin, is_output, _) in connections(cell) {
        let (direction, net) = match is_output {
            true => ("output", format!("right_{pin}")),
            false => ("input", pin.to_owned()),
        };
        ports.push(format!("{direction} {pin}"));
        pins.push(format!(".{pin}({net})"));
        if is_output {
            inside += &format!("  wire {net};\n  assign {pin} = ~{net};\n");
        }
    }
    format!(
        "\nmodule {WRONG}({});\n{inside}  {kind} right({});\nendmodule\n",
        ports.join(", "),
        pins.join(", ")
    )
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    /// A register on an output, behind an inverter if `gate`.
    fn netlist(gate: bool) -> Netlist {
        let mut cells = json!({"_2_": {"type": "DFF", "port_directions": {"D": "input", "Q": "output"},
            "connections": {"D": [4], "Q": [5]}}});
        if gate {
            cells["_1_"] = json!({"type": "INV", "port_directions": {"A": "input", "Y": "output"},
                "connections": {"A": [3], "Y": [4]}});
        }
        let ports = json!({"q": {"direction": "output", "bits": [5]}});
        Netlist::from(json!({"modules": {"top": {"ports": ports, "cells": cells}}}))
    }

    #[test]
    fn the_gate_before_an_output_is_made_wrong() {
        let text = "module top;\n  INV _1_ (\n    .A(a), .Y(y)\n  );\nendmodule\n";
        let planted = plant(&netlist(true), "top", &Library::small(), text).unwrap();
        assert_eq!(planted.what, "the cell _1_ (INV) gives the inverse");
        let expected = text.replace("INV _1_", "wrong_cell _1_")
            + "\nmodule wrong_cell(input A, output Y);\n  wire right_Y;\n  assign Y = ~right_Y;\n  INV right(.A(A), .Y(right_Y));\nendmodule\n";
        assert_eq!(planted.text, expected);
    }

    #[test]
    fn a_netlist_without_such_a_gate_is_refused() {
        let error = |gate, text| {
            plant(&netlist(gate), "top", &Library::small(), text)
                .unwrap_err()
                .to_string()
        };
        assert!(error(false, "").contains("no gate before"));
        assert!(error(true, "").contains("0 times"));
    }
}
