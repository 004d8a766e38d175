//! The output registers of block RAMs in a mapped netlist.
//!
//! A block RAM of an ECP5 has a register for the word that was read and, behind it, one at its
//! output. Yosys uses the first alone, and leaves the second to flip-flops, to which the way is long: a
//! word takes most of a clock to come out of the block. Where all that a port shows goes to
//! flip-flops that do nothing but take it over, they are the block's own register.

use std::collections::HashMap;

use anyhow::{Context, Result};
use serde_json::{Map, Value, json};

/// What reads a net: a cell and its port, or a port of the module.
type Readers = HashMap<u64, Vec<(String, String)>>;

/// The netlist that Yosys's `write_json` wrote, with such flip-flops in their blocks.
pub fn fill(netlist: &str) -> Result<String> {
    let mut netlist: Value = serde_json::from_str(netlist).context("what `write_json` writes")?;
    let modules = netlist["modules"].as_object_mut();
    for module in modules.context("a netlist has modules")?.values_mut() {
        let readers = readers(module);
        let Some(cells) = module["cells"].as_object_mut() else {
            continue;
        };
        let blocks = cells.iter().filter(|(_, cell)| cell["type"] == "DP16KD");
        let blocks: Vec<_> = blocks.map(|(name, _)| name.clone()).collect();
        for block in blocks {
            for port in ['A', 'B'] {
                if let Some(taken_over) = taken_over(cells, &readers, &block, port) {
                    fill_port(cells, &block, port, &taken_over);
                }
            }
        }
    }
    Ok(netlist.to_string())
}

fn readers(module: &Value) -> Readers {
    let mut readers = Readers::new();
    for (name, cell) in module["cells"].as_object().into_iter().flatten() {
        for (port, bits) in cell["connections"].as_object().into_iter().flatten() {
            if cell["port_directions"][port] != "output" {
                for bit in numbers(bits) {
                    readers
                        .entry(bit)
                        .or_default()
                        .push((name.clone(), port.clone()));
                }
            }
        }
    }
    for (name, port) in module["ports"].as_object().into_iter().flatten() {
        for bit in numbers(&port["bits"]) {
            readers
                .entry(bit)
                .or_default()
                .push((String::new(), name.clone()));
        }
    }
    readers
}

fn numbers(bits: &Value) -> impl Iterator<Item = u64> {
    let bits = bits.as_array().into_iter().flatten();
    bits.filter_map(Value::as_u64)
}

/// The output pins of a port that are read, each with the flip-flop that takes it over; none where
/// anything else reads one, or where nothing is read.
fn taken_over(
    cells: &Map<String, Value>,
    readers: &Readers,
    block: &str,
    port: char,
) -> Option<Vec<(String, String)>> {
    let block = &cells[block];
    let ends = &block["connections"];
    let end = |name: &str| &ends[&format!("{name}{port}")][0];
    let is_free = block["parameters"][&format!("REGMODE_{port}")] == "NOREG"
        && end("OCE") == "1"
        && end("RST") == "0";
    if !is_free {
        return None;
    }
    let mut taken_over = Vec::new();
    for pin in (0..18).map(|bit| format!("DO{port}{bit}")) {
        let of_pin = ends[&pin][0].as_u64().and_then(|bit| readers.get(&bit));
        match of_pin.map_or(&[][..], Vec::as_slice) {
            [] => {}
            [(name, read)] if read == "DI" && is_plain(&cells[name], end("CLK")) => {
                taken_over.push((pin, name.clone()));
            }
            _ => return None,
        }
    }
    (!taken_over.is_empty()).then_some(taken_over)
}

/// A flip-flop without enable and reset that starts as 0, on that clock.
fn is_plain(cell: &Value, clock: &Value) -> bool {
    let parameters = &cell["parameters"];
    let is =
        |name: &str, expected: &str| parameters[name].as_str().map(str::trim) == Some(expected);
    cell["type"] == "TRELLIS_FF"
        && is("CEMUX", "1")
        && is("CLKMUX", "CLK")
        && is("REGSET", "RESET")
        && cell["connections"]["LSR"][0] == "0"
        && cell["connections"]["CLK"][0] == *clock
}

fn fill_port(
    cells: &mut Map<String, Value>,
    block: &str,
    port: char,
    taken_over: &[(String, String)],
) {
    let mut shown = Vec::new();
    for (pin, register) in taken_over {
        if let Some(register) = cells.remove(register) {
            shown.push((pin, register["connections"]["Q"].clone()));
        }
    }
    let block = &mut cells[block];
    for (pin, bits) in shown {
        block["connections"][pin] = bits;
    }
    block["parameters"][format!("REGMODE_{port}")] = json!("OUTREG");
}

#[cfg(test)]
mod tests {
    use super::*;

    fn register(d: u64, q: u64, enable: &str) -> Value {
        json!({
            "type": "TRELLIS_FF",
            "parameters": { "CEMUX": enable, "CLKMUX": "CLK", "REGSET": "RESET" },
            "port_directions": { "CLK": "input", "DI": "input", "LSR": "input", "Q": "output" },
            "connections": { "CLK": [1], "DI": [d], "LSR": ["0"], "Q": [q] },
        })
    }

    fn reader(bit: u64) -> Value {
        json!({
            "type": "LUT4",
            "port_directions": { "A": "input" },
            "connections": { "A": [bit] },
        })
    }

    /// A block whose port B shows nets 10 and 11; what else there is, and what becomes of it.
    fn filled(others: &[(&str, Value)]) -> Value {
        let output = json!("output");
        let mut cells = json!({ "block": {
            "type": "DP16KD",
            "parameters": { "REGMODE_A": "NOREG", "REGMODE_B": "NOREG" },
            "port_directions": { "DOB0": output, "DOB1": output, "DOB2": output },
            "connections": {
                "CLKA": [1], "CLKB": [1], "OCEA": ["1"], "OCEB": ["1"], "RSTA": ["0"], "RSTB": ["0"],
                "DOB0": [10], "DOB1": [11], "DOB2": [12],
            },
        } });
        for (name, cell) in others {
            cells[*name] = cell.clone();
        }
        let netlist = json!({ "modules": { "top": { "ports": {}, "cells": cells } } });
        let netlist = fill(&netlist.to_string()).unwrap();
        let mut netlist: Value = serde_json::from_str(&netlist).unwrap();
        netlist["modules"]["top"]["cells"].take()
    }

    #[test]
    fn flip_flops_that_only_take_over_are_the_blocks_own() {
        let cells = filled(&[
            ("low", register(10, 20, "1 ")),
            ("high", register(11, 21, "1 ")),
            ("reader", reader(20)),
        ]);
        assert_eq!(cells["block"]["parameters"]["REGMODE_B"], "OUTREG");
        // Nothing is read from the other port.
        assert_eq!(cells["block"]["parameters"]["REGMODE_A"], "NOREG");
        assert_eq!(cells["block"]["connections"]["DOB0"], json!([20]));
        assert_eq!(cells["block"]["connections"]["DOB1"], json!([21]));
        assert_eq!(cells.as_object().unwrap().len(), 2);
    }

    #[test]
    fn a_word_that_anything_else_looks_at_stays_as_it_is() {
        let low = ("low", register(10, 20, "1 "));
        for other in [
            reader(11),
            reader(10),
            register(11, 21, "CE"),
            register(10, 21, "1 "),
        ] {
            let before = [low.clone(), ("other", other)];
            let cells = filled(&before);
            assert_eq!(cells["block"]["parameters"]["REGMODE_B"], "NOREG");
            assert_eq!(cells["low"], before[0].1);
        }
    }
}
