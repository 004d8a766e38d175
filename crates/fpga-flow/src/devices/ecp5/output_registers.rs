//! The pass that moves flip-flops into the output registers of block RAMs.
//!
//! A block RAM of an ECP5 has a register for the word that was read and a second one at its output. Yosys
//! uses only the first and implements the second as flip-flops, at the end of a long net: the word takes most
//! of a clock to leave the block. Where all outputs of a port feed flip-flops that only store them, these
//! flip-flops become the block's own register.

use serde_json::{Value, json};

use crate::netlist::{Cells, Readers};

/// Moves such flip-flops into their blocks.
pub(super) fn fill(cells: &mut Cells, readers: &Readers) {
    let blocks = cells.iter().filter(|(_, cell)| cell["type"] == "DP16KD");
    let blocks: Vec<_> = blocks.map(|(name, _)| name.clone()).collect();
    for block in blocks {
        for &word in words(&cells[&block]) {
            if let Some(taken_over) = taken_over(cells, readers, &block, word) {
                fill_word(cells, &block, word, &taken_over);
            }
        }
    }
}

/// A word that is read from a block RAM.
#[derive(Copy, Clone)]
struct Word {
    /// The ports that have the word on their pins.
    pins: &'static [char],
    /// The port whose clock and enables control its registers.
    control: char,
}

/// The words of a block. A word of 36 bits is read by port B on the pins of both ports; other words are on
/// the pins of their port.
fn words(block: &Value) -> &'static [Word] {
    const BOTH: &[Word] = &[Word {
        pins: &['A', 'B'],
        control: 'B',
    }];
    const EACH: &[Word] = &[
        Word {
            pins: &['A'],
            control: 'A',
        },
        Word {
            pins: &['B'],
            control: 'B',
        },
    ];
    let width = block["parameters"]["DATA_WIDTH_B"].as_str();
    match width.map(|bits| u32::from_str_radix(bits, 2)) {
        Some(Ok(36)) => BOTH,
        _ => EACH,
    }
}

/// The output pins of a word that are read, each with the flip-flop that stores it. `None` where another cell
/// reads one, or where none is read.
fn taken_over(
    cells: &Cells,
    readers: &Readers,
    block: &str,
    word: Word,
) -> Option<Vec<(String, String)>> {
    let block = &cells[block];
    let ends = &block["connections"];
    let end = |name: &str| &ends[&format!("{name}{}", word.control)][0];
    let has_no_register = |port: &char| block["parameters"][&format!("REGMODE_{port}")] == "NOREG";
    if !word.pins.iter().all(has_no_register) || end("OCE") != "1" || end("RST") != "0" {
        return None;
    }
    let mut taken_over = Vec::new();
    let pins = word.pins.iter();
    for pin in pins.flat_map(|port| (0..18).map(move |bit| format!("DO{port}{bit}"))) {
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

/// Whether a cell is a flip-flop on that clock, without enable and reset, that starts as 0.
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

fn fill_word(cells: &mut Cells, block: &str, word: Word, taken_over: &[(String, String)]) {
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
    for port in word.pins {
        block["parameters"][format!("REGMODE_{port}")] = json!("OUTREG");
    }
}

#[cfg(test)]
mod tests {
    use super::super::PASSES;
    use super::*;
    use crate::netlist::{Netlist, stages};

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

    /// A block whose port B drives nets 10 and 11, and port A net 9. Takes its width and the other cells, and
    /// returns the result of the pass.
    fn filled(width: u32, others: &[(&str, Value)]) -> Value {
        let output = json!("output");
        let mut cells = json!({ "block": {
            "type": "DP16KD",
            "parameters": {
                "REGMODE_A": "NOREG", "REGMODE_B": "NOREG", "DATA_WIDTH_B": format!("{width:032b}"),
            },
            "port_directions": { "DOA0": output, "DOB0": output, "DOB1": output, "DOB2": output },
            "connections": {
                "CLKA": [1], "CLKB": [1], "OCEA": ["0"], "OCEB": ["1"], "RSTA": ["0"], "RSTB": ["0"],
                "DOA0": [9], "DOB0": [10], "DOB1": [11], "DOB2": [12],
            },
        } });
        for (name, cell) in others {
            cells[*name] = cell.clone();
        }
        let netlist = json!({ "modules": { "top": { "ports": {}, "cells": cells } } });
        let mut stages = stages(Netlist::from(netlist), &PASSES);
        stages[2].netlist.json_mut()["modules"]["top"]["cells"].take()
    }

    #[test]
    fn flip_flops_that_only_take_over_are_the_blocks_own() {
        let cells = filled(
            18,
            &[
                ("low", register(10, 20, "1 ")),
                ("high", register(11, 21, "1 ")),
                ("reader", reader(20)),
            ],
        );
        assert_eq!(cells["block"]["parameters"]["REGMODE_B"], "OUTREG");
        // The other port is not read.
        assert_eq!(cells["block"]["parameters"]["REGMODE_A"], "NOREG");
        assert_eq!(cells["block"]["connections"]["DOB0"], json!([20]));
        assert_eq!(cells["block"]["connections"]["DOB1"], json!([21]));
        assert_eq!(cells.as_object().unwrap().len(), 2);
    }

    #[test]
    fn a_wide_word_has_all_its_registers_or_none() {
        let half = [
            ("low", register(10, 20, "1 ")),
            ("high", register(11, 21, "1 ")),
        ];
        for (top, expected) in [(register(9, 19, "1 "), "OUTREG"), (reader(9), "NOREG")] {
            let cells = filled(36, &[half.as_slice(), &[("top", top)]].concat());
            for port in ["REGMODE_A", "REGMODE_B"] {
                assert_eq!(cells["block"]["parameters"][port], expected, "{port}");
            }
        }
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
            let cells = filled(18, &before);
            assert_eq!(cells["block"]["parameters"]["REGMODE_B"], "NOREG");
            assert_eq!(cells["low"], before[0].1);
        }
    }
}
