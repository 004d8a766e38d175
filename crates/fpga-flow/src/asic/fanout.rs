//! Divides nets with many readers among buffers, as a tree.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use super::gating;
use super::library::{Cell, Library};
use crate::error::{Result, unexpected};
use crate::netlist::{Netlist, connections};

/// The most readers of a net. On two machines and one library 12 gave a shorter period than 8 or 16 or was within 2 % of it.
const MOST_READERS: usize = 12;

/// A pin of a cell that reads a net.
type Pin = (String, String);

/// Gives each net of the top module, but the clocks, at most [`MOST_READERS`] readers, of which outputs of the module do not count.
/// Returns the number of buffers.
pub(super) fn divide(netlist: &mut Netlist, top: &str, library: &Library) -> Result<u64> {
    let module = &mut netlist.json_mut()["modules"][top];
    if !module["cells"].is_object() {
        return Err(unexpected(format!(
            "found no cells of {top} in the netlist"
        )));
    }
    gating::divide(module, library)?;
    let clocks = gating::clocks(module, library)?;
    let mut tree = Tree {
        next_net: last_net(module) + 1,
        buffers: 0,
        buffer: library.buffer(),
        cells: &mut module["cells"],
    };
    for (net, pins) in readers(tree.cells) {
        if !clocks.contains(&net) {
            tree.divide(net, pins);
        }
    }
    Ok(tree.buffers)
}

struct Tree<'a> {
    next_net: u64,
    buffers: u64,
    buffer: &'a Cell,
    cells: &'a mut Value,
}

impl Tree<'_> {
    fn divide(&mut self, net: u64, pins: Vec<Pin>) {
        if pins.len() <= MOST_READERS {
            return;
        }
        let parts = pins.chunks(MOST_READERS);
        let buffers = parts.map(|part| self.add_buffer(net, part)).collect();
        self.divide(net, buffers);
    }

    /// Adds a buffer from the net to these pins. Returns the buffer's own pin.
    fn add_buffer(&mut self, net: u64, pins: &[Pin]) -> Pin {
        let name = format!("fanout_{}", self.buffers);
        let Cell {
            cell,
            input,
            output,
        } = self.buffer;
        for (reader, pin) in pins {
            self.cells[reader]["connections"][pin] = json!([self.next_net]);
        }
        self.cells[&name] = json!({
            "hide_name": 0, "type": cell, "parameters": {}, "attributes": {},
            "port_directions": {input: "input", output: "output"},
            "connections": {input: [net], output: [self.next_net]}
        });
        self.next_net += 1;
        self.buffers += 1;
        (name, input.clone())
    }
}

/// The pins that read each net. All pins of mapped cells are one bit wide.
pub(super) fn readers(cells: &Value) -> BTreeMap<u64, Vec<Pin>> {
    let mut readers: BTreeMap<u64, Vec<Pin>> = BTreeMap::new();
    for (name, cell) in cells.as_object().into_iter().flatten() {
        for (pin, is_output, bits) in connections(cell) {
            if let (false, [bit]) = (is_output, bits)
                && let Some(net) = bit.as_u64()
            {
                let pin = (name.clone(), pin.to_owned());
                readers.entry(net).or_default().push(pin);
            }
        }
    }
    readers
}

/// The largest number of a net in the module.
pub(super) fn last_net(module: &Value) -> u64 {
    let nets = module["netnames"].as_object().into_iter().flatten();
    let named = nets.flat_map(|(_, net)| net["bits"].as_array().into_iter().flatten());
    let cells = module["cells"].as_object().into_iter().flatten();
    let on_cells = cells.flat_map(|(_, cell)| connections(cell).flat_map(|(_, _, bits)| bits));
    named
        .chain(on_cells)
        .filter_map(Value::as_u64)
        .max()
        .unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A register that drives `readers` inverters, all with one clock.
    fn netlist(readers: usize) -> Netlist {
        let mut cells = json!({});
        cells["register"] = json!({"type": "DFF", "port_directions": {"CLK": "input", "D": "input", "Q": "output"},
            "connections": {"CLK": [2], "D": ["0"], "Q": [3]}});
        for reader in 0..readers {
            cells[format!("reader_{reader:03}")] = json!({"type": "LATCH",
                "port_directions": {"CLK": "input", "D": "input", "Q": "output"},
                "connections": {"CLK": [2], "D": [3], "Q": [4 + reader]}});
        }
        Netlist::from(json!({"modules": {"top": {
            "ports": {"clock": {"direction": "input", "bits": [2]}},
            "cells": cells,
            "netnames": {"all": {"bits": (2..4 + readers).collect::<Vec<_>>()}}}}}))
    }

    fn library() -> Library {
        let [cell, input, output] = ["BUF", "A", "Y"].map(str::to_owned);
        Library::small().with_buffer(Cell {
            cell,
            input,
            output,
        })
    }

    /// The net that a pin reads in the end, through all buffers.
    fn source(cells: &Value, mut net: u64) -> u64 {
        let drivers: BTreeMap<u64, u64> = (cells.as_object().unwrap().values())
            .filter(|cell| cell["type"] == "BUF")
            .map(|cell| &cell["connections"])
            .map(|on| (on["Y"][0].as_u64().unwrap(), on["A"][0].as_u64().unwrap()))
            .collect();
        while let Some(&from) = drivers.get(&net) {
            net = from;
        }
        net
    }

    #[test]
    fn no_net_has_too_many_readers_and_all_read_the_old_net() {
        for (count, buffers) in [(12, 0), (13, 2), (144, 12), (145, 15), (1000, 91)] {
            let mut netlist = netlist(count);
            assert_eq!(divide(&mut netlist, "top", &library()).unwrap(), buffers);
            let cells = &netlist.json()["modules"]["top"]["cells"];
            let readers = readers(cells);
            assert_eq!(readers[&2].len(), count + 1, "the clock is not divided");
            let most = readers.iter().filter(|(net, _)| **net != 2);
            assert!(most.map(|(_, pins)| pins.len()).max() <= Some(MOST_READERS));
            for reader in 0..count {
                let cell = &cells[format!("reader_{reader:03}")]["connections"];
                assert_eq!(source(cells, cell["D"][0].as_u64().unwrap()), 3);
            }
        }
    }

    #[test]
    fn a_netlist_without_the_top_module_is_an_error() {
        assert!(divide(&mut netlist(1), "other", &library()).is_err());
    }
}
