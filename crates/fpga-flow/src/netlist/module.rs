//! A module of a netlist: its ports, its nets, and the input ports that an output depends on.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::Value;

use super::connections;

/// A module of a netlist.
#[derive(Copy, Clone, Debug)]
pub struct Module<'a> {
    json: &'a Value,
}

/// A bit of a port or of a net.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Bit {
    /// The number of a net.
    Net(u64),
    /// A constant: `0`, `1`, `x` or `z`.
    Constant(String),
}

/// A port of a module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Port {
    /// The name of the port.
    pub name: String,
    /// The direction: `input`, `output` or `inout`.
    pub direction: String,
    /// The bits, the lowest first.
    pub bits: Vec<Bit>,
}

impl Port {
    /// Whether the port is an input.
    pub fn is_input(&self) -> bool {
        self.direction == "input"
    }

    /// The width in bits.
    pub fn width(&self) -> usize {
        self.bits.len()
    }
}

impl Bit {
    fn of(json: &Value) -> Self {
        match json.as_u64() {
            Some(net) => Self::Net(net),
            None => Self::Constant(json.as_str().unwrap_or("x").to_owned()),
        }
    }
}

fn bits(json: &Value) -> Vec<Bit> {
    json.as_array().into_iter().flatten().map(Bit::of).collect()
}

impl<'a> Module<'a> {
    pub(super) fn of(json: &'a Value) -> Self {
        Self { json }
    }

    /// The ports in the order of the Verilog text, in which Yosys numbers their bits. Ports of no bits, such as
    /// those of a table that was removed, are left out.
    pub fn ports(self) -> Vec<Port> {
        let ports = self.json["ports"].as_object().into_iter().flatten();
        let port = |(name, port): (&String, &Value)| Port {
            name: name.clone(),
            direction: port["direction"].as_str().unwrap_or_default().to_owned(),
            bits: bits(&port["bits"]),
        };
        let mut ports: Vec<_> = ports.map(port).filter(|port| port.width() > 0).collect();
        ports.sort_by_key(|port| match port.bits[0] {
            Bit::Net(net) => Some(net),
            Bit::Constant(_) => None,
        });
        ports
    }

    /// The named nets with their bits, the lowest first.
    pub fn nets(self) -> impl Iterator<Item = (&'a str, Vec<Bit>)> {
        let nets = self.json["netnames"].as_object().into_iter().flatten();
        nets.map(|(name, net)| (name.as_str(), bits(&net["bits"])))
    }

    /// The names of the input ports that an output port depends on, through the cells of this module.
    pub fn fan_in(self, output: &str) -> BTreeSet<String> {
        let mut drivers: BTreeMap<u64, &Value> = BTreeMap::new();
        for (_, cell) in self.json["cells"].as_object().into_iter().flatten() {
            drivers.extend(ends(cell, true).map(|net| (net, cell)));
        }
        let ports = self.ports();
        let nets = |port: &Port| {
            let bits = port.bits.iter();
            let nets = bits.filter_map(|bit| match bit {
                Bit::Net(net) => Some(*net),
                Bit::Constant(_) => None,
            });
            nets.collect::<Vec<_>>()
        };
        let inputs = ports.iter().filter(|port| port.is_input());
        let inputs: BTreeMap<u64, &str> = inputs
            .flat_map(|port| nets(port).into_iter().map(|net| (net, port.name.as_str())))
            .collect();
        let mut open: Vec<u64> = ports
            .iter()
            .filter(|port| port.name == output)
            .flat_map(nets)
            .collect();
        let (mut seen, mut found) = (BTreeSet::new(), BTreeSet::new());
        while let Some(net) = open.pop() {
            if !seen.insert(net) {
                continue;
            }
            match inputs.get(&net) {
                Some(name) => {
                    found.insert((*name).to_owned());
                }
                None => {
                    let driver = drivers.get(&net).into_iter();
                    open.extend(driver.flat_map(|cell| ends(cell, false)));
                }
            }
        }
        found
    }
}

/// The nets on a cell's outputs, or on its other pins.
fn ends(cell: &Value, outputs: bool) -> impl Iterator<Item = u64> {
    let ends = connections(cell).filter(move |(_, is_output, _)| *is_output == outputs);
    ends.flat_map(|(_, _, bits)| bits).filter_map(Value::as_u64)
}

#[cfg(test)]
mod tests {
    use super::super::Netlist;
    use super::*;

    #[test]
    fn a_port_depends_on_what_drives_it_through_cells() {
        let text = r#"{"modules": {"gold": {
            "ports": {"a": {"direction": "input", "bits": [2]}, "b": {"direction": "input", "bits": [3]},
                "none": {"direction": "output", "bits": []},
                "y": {"direction": "output", "bits": [4]}, "z": {"direction": "output", "bits": ["0"]}},
            "netnames": {"a.q": {"bits": [4, "0", "1", "x"]}},
            "cells": {"n": {"port_directions": {"A": "input", "Y": "output"},
                "connections": {"A": [2], "Y": [5]}},
                "m": {"port_directions": {"A": "input", "Y": "output"},
                "connections": {"A": [5], "Y": [4]}}}}}}"#;
        let netlist = Netlist::parse(text).unwrap();
        let module = netlist.module("gold").unwrap();
        assert_eq!(module.fan_in("y"), BTreeSet::from(["a".to_owned()]));
        assert!(module.fan_in("z").is_empty());
        assert!(module.ports().iter().all(|port| port.name != "none"));
        let nets: Vec<_> = module.nets().collect();
        let constant = |bit: &str| Bit::Constant(bit.to_owned());
        let bits = vec![Bit::Net(4), constant("0"), constant("1"), constant("x")];
        assert_eq!(nets, [("a.q", bits)]);
        assert!(netlist.module("gate").is_err());
    }
}
