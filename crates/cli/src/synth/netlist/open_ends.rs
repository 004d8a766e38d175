//! Open ends of carry chains in a mapped netlist.
//!
//! nextpnr leads the last carry of a chain out through a cell of its own where a net hangs on it, and
//! a constant first carry in through another, though nobody reads the one, and the first LUT of
//! some chains overrides the other. With tens of chains of ten bits in an engine that is a third
//! more cells. Said to be unconnected, such ends cost nothing, and the logic is the same.

use serde_json::{Value, json};

use super::{Cells, Readers};

/// Opens these ends.
pub(super) fn open(cells: &mut Cells, readers: &Readers) {
    for cell in cells.values_mut().filter(|cell| cell["type"] == "CCU2C") {
        open_cell(cell, readers);
    }
}

/// Opens a carry cell's output that nobody reads, and its constant input where its first LUT is 0
/// for every C and D but the lowest, which are then the carry.
fn open_cell(cell: &mut Value, readers: &Readers) {
    let first_lut = cell["parameters"]["INIT0"].as_str().map(str::to_owned);
    let overrides =
        first_lut.is_some_and(|bits| bits.len() == 16 && bits[..12].bytes().all(|bit| bit == b'0'));
    let Some(ends) = cell["connections"].as_object_mut() else {
        return;
    };
    let unread = |end: &Value| {
        end[0]
            .as_u64()
            .is_some_and(|bit| !readers.contains_key(&bit))
    };
    if ends.get("COUT").is_some_and(unread) {
        ends.insert("COUT".to_owned(), json!(["x"]));
    }
    if overrides && ends.get("CIN").is_some_and(|end| end[0].is_string()) {
        ends.insert("CIN".to_owned(), json!(["x"]));
    }
}

#[cfg(test)]
mod tests {
    use super::super::finish;
    use super::*;

    fn carry_cell(first_lut: &str, cin: Value, cout: u64) -> Value {
        json!({
            "type": "CCU2C",
            "parameters": { "INIT0": first_lut },
            "port_directions": { "CIN": "input", "COUT": "output" },
            "connections": { "CIN": [cin], "COUT": [cout] },
        })
    }

    #[test]
    fn only_ends_that_say_nothing_are_opened() {
        let netlist = json!({ "modules": { "top": {
            "ports": { "out": { "direction": "output", "bits": [9] } },
            "cells": {
                "first": carry_cell("0000000000000010", json!("0"), 5),
                "next": carry_cell("0110000000000110", json!(5), 6),
                "plain": carry_cell("0110000000000110", json!("0"), 9),
            },
        } } });
        let opened: Value = serde_json::from_str(&finish(&netlist.to_string()).unwrap()).unwrap();
        let ends = |cell: &str| {
            let ends = &opened["modules"]["top"]["cells"][cell]["connections"];
            (ends["CIN"][0].clone(), ends["COUT"][0].clone())
        };
        assert_eq!(ends("first"), (json!("x"), json!(5)));
        assert_eq!(ends("next"), (json!(5), json!("x")));
        assert_eq!(ends("plain"), (json!("0"), json!(9)));
    }
}
