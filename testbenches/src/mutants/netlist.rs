//! Reads a module in Yosys's JSON: its ports, and the input ports that an output depends on.

use std::collections::{BTreeMap, BTreeSet};

use serde::Deserialize;

use crate::device::DeviceError;

/// A bit of the netlist: the number of a wire, or a constant's digit.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
#[serde(untagged)]
enum Bit {
    Wire(u64),
    Constant(String),
}

#[derive(Clone, Debug, Deserialize)]
pub(super) struct Port {
    pub direction: String,
    bits: Vec<Bit>,
}

impl Port {
    /// The width of the port in bits.
    pub fn width(&self) -> usize {
        self.bits.len()
    }
}

#[derive(Clone, Debug, Deserialize)]
struct Cell {
    port_directions: BTreeMap<String, String>,
    connections: BTreeMap<String, Vec<Bit>>,
}

/// A module.
#[derive(Clone, Debug, Deserialize)]
pub(super) struct Netlist {
    pub ports: BTreeMap<String, Port>,
    cells: BTreeMap<String, Cell>,
}

impl Netlist {
    /// # Errors
    /// The text is not Yosys's JSON, or has no such module.
    pub fn parse(json: &str, module: &str) -> Result<Self, DeviceError> {
        #[derive(Deserialize)]
        struct Design {
            modules: BTreeMap<String, Netlist>,
        }
        let design: Result<Design, _> = serde_json::from_str(json);
        let found = design.ok().and_then(|mut d| d.modules.remove(module));
        let found = found.map(|mut netlist| {
            // A table that was removed has write ports of no bits.
            netlist.ports.retain(|_, port| port.width() > 0);
            netlist
        });
        found.ok_or_else(|| DeviceError::BrokeOff {
            device: "yosys".to_owned(),
            message: format!("its netlist has no module `{module}`"),
        })
    }

    /// The input ports that an output port depends on.
    pub fn fan_in(&self, output: &str) -> BTreeSet<&str> {
        let mut drivers: BTreeMap<&Bit, &Cell> = BTreeMap::new();
        for cell in self.cells.values() {
            for bit in cell.bits("output") {
                drivers.insert(bit, cell);
            }
        }
        let mut inputs: BTreeMap<&Bit, &str> = BTreeMap::new();
        for (name, port) in self.ports.iter().filter(|(_, p)| p.direction == "input") {
            inputs.extend(port.bits.iter().map(|bit| (bit, name.as_str())));
        }
        let mut seen = BTreeSet::new();
        let mut open: Vec<&Bit> = self
            .ports
            .get(output)
            .map_or(Vec::new(), |port| port.bits.iter().collect());
        let mut found = BTreeSet::new();
        while let Some(bit) = open.pop() {
            if !seen.insert(bit) {
                continue;
            }
            if let Some(name) = inputs.get(bit) {
                found.insert(*name);
            } else if let Some(cell) = drivers.get(bit) {
                open.extend(cell.bits("input"));
            }
        }
        found
    }
}

impl Cell {
    /// The bits of all ports of a direction.
    fn bits<'a>(&'a self, direction: &'a str) -> impl Iterator<Item = &'a Bit> {
        let ports = self.connections.iter();
        let of_direction = ports.filter(move |(port, _)| self.port_directions[*port] == direction);
        of_direction.flat_map(|(_, bits)| bits)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_port_depends_on_what_drives_it_through_cells() {
        let text = r#"{"modules": {"gold": {
            "ports": {"a": {"direction": "input", "bits": [2]}, "b": {"direction": "input", "bits": [3]},
                "none": {"direction": "output", "bits": []},
                "y": {"direction": "output", "bits": [4]}, "z": {"direction": "output", "bits": ["0"]}},
            "cells": {"n": {"port_directions": {"A": "input", "Y": "output"},
                "connections": {"A": [2], "Y": [5]}},
                "m": {"port_directions": {"A": "input", "Y": "output"},
                "connections": {"A": [5], "Y": [4]}}}}}}"#;
        let netlist = Netlist::parse(text, "gold").unwrap();
        assert_eq!(netlist.fan_in("y"), BTreeSet::from(["a"]));
        assert!(netlist.fan_in("z").is_empty());
        assert!(!netlist.ports.contains_key("none"));
        assert!(Netlist::parse(text, "gate").is_err());
    }
}
