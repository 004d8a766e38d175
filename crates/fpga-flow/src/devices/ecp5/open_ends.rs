//! The pass that disconnects unused ends of carry chains.
//!
//! nextpnr adds a cell to lead the last carry of a chain out where it has a net, and another cell to lead a
//! constant first carry in. The first net often has no reader, and in some chains the first LUT overrides the
//! constant. With tens of chains of ten bits in an engine, that is a third more cells. Disconnected ends need
//! no cells, and the logic is unchanged.

use serde_json::{Value, json};

use crate::netlist::{Cells, Readers};

/// Disconnects these ends in all cells.
pub(super) fn open(cells: &mut Cells, readers: &Readers) {
    for cell in cells.values_mut().filter(|cell| cell["type"] == "CCU2C") {
        open_cell(cell, readers);
    }
}

/// Disconnects a carry cell's output without readers. Disconnects its constant input where its first LUT is
/// 0, so that the second LUT gets the carry with which the first overrides it, and where the first sum has no
/// readers.
fn open_cell(cell: &mut Value, readers: &Readers) {
    let overrides = overrides(cell);
    let Some(ends) = cell["connections"].as_object_mut() else {
        return;
    };
    let is_unread = |end: Option<&Value>| {
        let net = end.and_then(|end| end[0].as_u64());
        net.is_none_or(|net| !readers.contains_key(&net))
    };
    if ends.contains_key("COUT") && is_unread(ends.get("COUT")) {
        ends.insert("COUT".to_owned(), json!(["x"]));
    }
    let is_constant = ends.get("CIN").is_some_and(|end| end[0].is_string());
    if overrides && is_constant && is_unread(ends.get("S0")) {
        ends.insert("CIN".to_owned(), json!(["x"]));
    }
}

/// Whether a carry cell's first LUT is 0 for all A and B, by its bits where C or D is 1.
fn overrides(cell: &Value) -> bool {
    let bits = cell["parameters"]["INIT0"].as_str();
    let is_zero =
        bits.is_some_and(|bits| bits.len() == 16 && bits[..12].bytes().all(|bit| bit == b'0'));
    is_zero
        && ["C0", "D0"]
            .iter()
            .any(|pin| cell["connections"][*pin][0] == "1")
}

#[cfg(test)]
mod tests {
    use super::super::PASSES;
    use super::*;
    use crate::netlist::{Netlist, stages};

    fn carry_cell(first_lut: &str, cin: Value, cout: u64) -> Value {
        json!({
            "type": "CCU2C",
            "parameters": { "INIT0": first_lut },
            "port_directions": { "C0": "input", "CIN": "input", "COUT": "output", "S0": "output" },
            "connections": { "C0": ["1"], "CIN": [cin], "COUT": [cout], "S0": [20] },
        })
    }

    fn opened(cells: &[(&str, Value)]) -> Value {
        let cells = cells
            .iter()
            .map(|(name, cell)| ((*name).to_owned(), cell.clone()));
        let netlist = json!({ "modules": { "top": {
            "ports": { "out": { "direction": "output", "bits": [9] } },
            "cells": cells.collect::<Cells>(),
        } } });
        let mut stages = stages(Netlist::from(netlist), &PASSES);
        stages[2].netlist.json_mut()["modules"]["top"]["cells"].take()
    }

    /// The constant is needed where the first sum is read, or where C and D do not make the LUT 0.
    #[test]
    fn a_constant_that_is_looked_at_stays() {
        let first = || carry_cell("0000000000000010", json!("0"), 5);
        let mut unsure = first();
        unsure["connections"]["C0"] = json!(["0"]);
        assert_eq!(
            opened(&[("first", unsure)])["first"]["connections"]["CIN"],
            json!(["0"])
        );
        let mut read = first();
        read["connections"]["S0"] = json!([9]);
        assert_eq!(
            opened(&[("first", read)])["first"]["connections"]["CIN"],
            json!(["0"])
        );
        assert_eq!(
            opened(&[("first", first())])["first"]["connections"]["CIN"],
            json!(["x"])
        );
    }

    #[test]
    fn only_ends_that_say_nothing_are_opened() {
        let opened = opened(&[
            ("first", carry_cell("0000000000000010", json!("0"), 5)),
            ("next", carry_cell("0110000000000110", json!(5), 6)),
            ("plain", carry_cell("0110000000000110", json!("0"), 9)),
        ]);
        let ends = |cell: &str| {
            let ends = &opened[cell]["connections"];
            (ends["CIN"][0].clone(), ends["COUT"][0].clone())
        };
        assert_eq!(ends("first"), (json!("x"), json!(5)));
        assert_eq!(ends("next"), (json!(5), json!("x")));
        assert_eq!(ends("plain"), (json!("0"), json!(9)));
    }
}
