//! The digest of a mapped netlist. It covers the cells and their connections, and not their names.
//!
//! Yosys names cells and nets after lines of the Verilog and writes them in the order of their names, so a
//! comment line changes both. The digest therefore distinguishes cells and nets only by their properties: a
//! cell by its type, its parameters and the nets on its pins, a net by the pins that it connects, beginning
//! with the ports of the module. These classes are refined until none can be split further. Members of one
//! class have equal surroundings, such as two flip-flops that store one net. The digest is that of the list
//! of all cells by class.

use std::collections::HashMap;
use std::fmt::Write;

use serde_json::Value;
use sha2::{Digest, Sha256};

use super::{cells, is_bookkeeping};
use crate::error::Result;

/// The attributes that record the origin of a cell.
const ORIGINS: [&str; 2] = ["src", "hdlname"];

/// The connection of a pin.
#[derive(Copy, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum End {
    Constant(char),
    Net(usize),
}

/// A cell: its properties, and the connections of its pins in order.
struct Cell {
    label: String,
    ends: Vec<End>,
}

/// Numbers of nets in the order in which they are met, with the ports on each net.
#[derive(Default)]
struct Nets {
    numbers: HashMap<u64, usize>,
    ports: Vec<Vec<String>>,
}

impl Nets {
    fn end(&mut self, bit: &Value) -> End {
        let Some(bit) = bit.as_u64() else {
            let constant = bit.as_str().and_then(|bit| bit.chars().next());
            return End::Constant(constant.unwrap_or('x'));
        };
        let next = self.ports.len();
        let number = *self.numbers.entry(bit).or_insert(next);
        if number == next {
            self.ports.push(Vec::new());
        }
        End::Net(number)
    }
}

/// The digest of a module, see [`Netlist::sha256`](super::Netlist::sha256).
pub(super) fn sha256(module: &Value) -> Result<String> {
    let mut nets = Nets::default();
    for (name, port) in module["ports"].as_object().into_iter().flatten() {
        let bits = port["bits"].as_array().into_iter().flatten();
        for (index, bit) in bits.enumerate() {
            if let End::Net(net) = nets.end(bit) {
                nets.ports[net].push(format!("{} {name} {index}", port["direction"]));
            }
        }
    }
    let cells = cells(module)?.values().filter(|cell| !is_bookkeeping(cell));
    let cells: Vec<_> = cells.map(|cell| read(cell, &mut nets)).collect();
    Ok(hexadecimal(&listing(&cells, nets.ports)))
}

fn read(cell: &Value, nets: &mut Nets) -> Cell {
    let mut label = cell["type"].as_str().unwrap_or_default().to_owned();
    for group in ["parameters", "attributes"] {
        for (name, value) in cell[group].as_object().into_iter().flatten() {
            if !ORIGINS.contains(&name.as_str()) {
                let _ = write!(label, " {name}={value}");
            }
        }
    }
    let mut ends = Vec::new();
    // A map of `serde_json` is sorted by its keys.
    for (name, bits) in cell["connections"].as_object().into_iter().flatten() {
        let bits = bits.as_array().into_iter().flatten();
        let before = ends.len();
        ends.extend(bits.map(|bit| nets.end(bit)));
        let _ = write!(label, " {name}[{}]", ends.len() - before);
    }
    Cell { label, ends }
}

/// A line for each cell, in the order of the classes.
fn listing(cells: &[Cell], ports: Vec<Vec<String>>) -> String {
    let mut pins = vec![Vec::new(); ports.len()];
    for (index, cell) in cells.iter().enumerate() {
        for (pin, end) in cell.ends.iter().enumerate() {
            if let End::Net(net) = end {
                pins[*net].push((index, pin));
            }
        }
    }
    let (mut of_net, mut nets) = classes(ports);
    let (mut of_cell, mut count) = classes(cells.iter().map(|cell| cell.label.as_str()).collect());
    loop {
        let before = (nets, count);
        let cell = |(class, cell): (&usize, &Cell)| (*class, by_class(cell, &of_net));
        (of_cell, count) = classes(of_cell.iter().zip(cells).map(cell).collect());
        let net = |(class, pins): (&usize, &Vec<(usize, usize)>)| {
            let mut pins: Vec<_> = pins
                .iter()
                .map(|&(cell, pin)| (of_cell[cell], pin))
                .collect();
            pins.sort_unstable();
            (*class, pins)
        };
        (of_net, nets) = classes(of_net.iter().zip(&pins).map(net).collect());
        if (nets, count) == before {
            break;
        }
    }
    let line = |cell: &Cell| {
        let ends = by_class(cell, &of_net).into_iter().map(|end| match end {
            End::Constant(constant) => format!(" {constant}"),
            End::Net(class) => format!(" n{class}"),
        });
        format!("{}:{}\n", cell.label, ends.collect::<String>())
    };
    let mut lines: Vec<_> = cells.iter().map(line).collect();
    lines.sort_unstable();
    lines.concat()
}

fn by_class(cell: &Cell, of_net: &[usize]) -> Vec<End> {
    let class = |end: &End| match *end {
        End::Net(net) => End::Net(of_net[net]),
        constant => constant,
    };
    cell.ends.iter().map(class).collect()
}

/// For each element, the rank of its value among all different values; and the number of different values.
fn classes<T: Ord>(of: Vec<T>) -> (Vec<usize>, usize) {
    let mut order: Vec<_> = (0..of.len()).collect();
    order.sort_by(|&a, &b| of[a].cmp(&of[b]));
    let (mut classes, mut count) = (vec![0; of.len()], 0);
    for (place, &index) in order.iter().enumerate() {
        if place > 0 && of[order[place - 1]] != of[index] {
            count += 1;
        }
        classes[index] = count;
    }
    (classes, count + usize::from(!of.is_empty()))
}

/// SHA-256 of a text in hexadecimal digits.
pub(crate) fn hexadecimal(text: &str) -> String {
    let digest = Sha256::digest(text);
    digest.iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::super::Netlist;
    use super::*;

    fn cell(kind: &str, init: &str, connections: Value) -> Value {
        json!({
            "type": kind,
            "parameters": { "INIT": init },
            "attributes": { "src": "top.v:7.1", "keep": "1" },
            "connections": connections,
        })
    }

    fn netlist(cells: Value) -> Value {
        json!({
            "creator": "any",
            "modules": {
                "LUT4": { "attributes": { "blackbox": "1" }, "ports": {}, "cells": {} },
                "serial": {
                    "attributes": { "top": "1" },
                    "ports": {
                        "a": { "direction": "input", "bits": [2, 3] },
                        "q": { "direction": "output", "bits": [4] },
                    },
                    "cells": cells,
                },
            },
        })
    }

    /// Two cells in a row: q = second(first(a[0], a[1]), 0).
    fn chain(net: u64, names: [&str; 2]) -> Value {
        let mut cells = json!({});
        cells[names[0]] = cell("LUT4", "0110", json!({ "A": [2], "B": [3], "Z": [net] }));
        cells[names[1]] = cell("LUT4", "1000", json!({ "A": [net], "B": ["0"], "Z": [4] }));
        netlist(cells)
    }

    fn of(netlist: &Value) -> String {
        Netlist::from(netlist.clone()).sha256().unwrap()
    }

    #[test]
    fn names_order_and_origins_do_not_count() {
        let first = chain(5, ["$a.v:9", "$a.v:10"]);
        let mut other = chain(77, ["z", "a"]);
        let serial = &mut other["modules"]["serial"];
        serial["cells"]["z"]["attributes"]["src"] = json!("top.v:8.1");
        serial["cells"]["z"]["attributes"]["hdlname"] = json!("top z");
        serial["cells"]["scope"] = json!({ "type": "$scopeinfo", "connections": {} });
        serial["netnames"] = json!({ "n": { "bits": [77] } });
        other["creator"] = json!("another");
        assert_eq!(of(&first), of(&other));
    }

    #[test]
    fn cells_and_connections_count() {
        let sound = chain(5, ["a", "b"]);
        let edits: [(&str, &str, Value); 6] = [
            ("/cells/a/parameters/INIT", "a bit of a LUT", json!("0111")),
            ("/cells/a/attributes/keep", "an attribute", json!("0")),
            ("/cells/a/type", "a type", json!("CCU2C")),
            ("/cells/b/connections/B/0", "a constant", json!("1")),
            ("/cells/b/connections/A/0", "a net", json!(2)),
            ("/ports/a/bits", "ports changed round", json!([3, 2])),
        ];
        for (place, what, value) in edits {
            let mut other = sound.clone();
            *other
                .pointer_mut(&format!("/modules/serial{place}"))
                .unwrap() = value;
            assert_ne!(of(&sound), of(&other), "{what}");
        }
    }

    #[test]
    fn what_only_its_surroundings_tell_apart_is_told_apart() {
        // Two rings of three flip-flops and one ring of six: each cell has equal neighbours.
        let ring = |nets: [(u64, u64); 6]| {
            let cells = nets.iter().enumerate().map(|(index, (d, q))| {
                let cell = cell("TRELLIS_FF", "0", json!({ "DI": [d], "Q": [q] }));
                (format!("ff{index}"), cell)
            });
            netlist(cells.collect::<serde_json::Map<_, _>>().into())
        };
        let tapped = [(9, 5), (5, 6), (6, 7), (7, 8), (8, 4), (4, 9)];
        let elsewhere = [(9, 5), (5, 4), (4, 9), (7, 8), (8, 6), (6, 7)];
        assert_ne!(of(&ring(tapped)), of(&ring(elsewhere)));
    }

    #[test]
    fn a_netlist_without_a_top_module_is_refused() {
        let error = Netlist::from(json!({ "modules": {} })).sha256();
        let error = error.unwrap_err().to_string();
        assert!(error.contains("top"), "{error}");
    }
}
