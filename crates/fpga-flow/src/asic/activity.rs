//! The activity of each net, counted in a simulation, and what OpenSTA is told of it.
//!
//! OpenSTA of [`Sta::VERSION`](super::Sta::VERSION) computes activities of its own in all logic behind an input of the design, also
//! where a pin has been given one. So a register is put between each input and its readers; its power is subtracted.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use serde_json::{Value, json};

use super::CLOCK;
use super::fanout::{last_net, readers};
use super::gating;
use super::library::{Library, Register};
use crate::error::{Result, ensure, unexpected};
use crate::netlist::{Netlist, connections};

/// The names of the registers behind the inputs begin with this. No other cell is named so: Yosys has numbered them.
pub(super) const SOURCE: &str = "source_";

/// What one bit of a net did in a number of clock cycles.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Toggles {
    /// The number of cycles at whose end the bit had another value than at the end of the cycle before.
    pub transitions: u64,
    /// The number of cycles at whose end the bit was 1.
    pub ones: u64,
}

/// What the nets of a mapped netlist did in a simulation.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Activities {
    /// The number of clock cycles; not 0.
    pub clocks: u64,
    /// By the name of a net, its bits from the lowest.
    pub nets: BTreeMap<String, Vec<Toggles>>,
}

/// The activity of a pin: transitions in a clock cycle, and the part of the time at 1.
#[derive(Copy, Clone, Debug, PartialEq)]
struct Activity {
    transitions: f64,
    duty: f64,
}

/// A netlist with its activities, for OpenSTA.
#[derive(Debug)]
pub(super) struct Told {
    /// The netlist with a register behind each input.
    pub netlist: Netlist,
    /// Tcl that gives each pin its activity.
    pub script: String,
    /// Where there are clock gates, Tcl after which only the clocks of the registers behind them change, the list `stopped` has each of
    /// these registers with the part of the clock's edges that do not reach it, and `stopped_nets` each clock gate.
    pub gated: Option<String>,
    /// The mean transitions of a net in a clock cycle, without the clock.
    pub mean: f64,
}

impl Activity {
    fn at_rest(self) -> Self {
        Self {
            transitions: 0.0,
            ..self
        }
    }

    fn inverse(self) -> Self {
        Self {
            duty: 1.0 - self.duty,
            ..self
        }
    }
}

/// Prepares the netlist `mapped` of the module `top` for OpenSTA.
///
/// # Errors
/// The netlist is no such module, or the simulation lacks a net of it.
pub(super) fn told(
    mut netlist: Netlist,
    top: &str,
    library: &Library,
    activities: &Activities,
) -> Result<Told> {
    ensure(activities.clocks > 0, || {
        "found activities of no clock cycle, expected at least one".to_owned()
    })?;
    let module = &mut netlist.json_mut()["modules"][top];
    let bits = of_bits(module, activities)?;
    let gated = gating::gated_nets(module, library)?;
    let clocks = gating::clocks(module, library)?;
    let without_clock = bits.iter().filter(|(bit, _)| !clocks.contains(bit));
    let transitions: Vec<f64> = without_clock.map(|(_, of)| of.transitions).collect();
    let mean = transitions.iter().sum::<f64>() / transitions.len().max(1) as f64;
    let register = library.register();
    let sources = add_sources(module, register)?;
    let [mut script, mut at_rest, mut stopped, mut stopped_nets] = [const { String::new() }; 4];
    for (name, cell) in module["cells"].as_object().into_iter().flatten() {
        let mut pins = Vec::new();
        for (pin, _, on) in connections(cell) {
            let [bit] = on else {
                return Err(unexpected(format!(
                    "found pin {pin} of {name} with {} bits",
                    on.len()
                )));
            };
            let bit = bit.as_u64().map(|bit| *sources.get(&bit).unwrap_or(&bit));
            if bit.is_some_and(|bit| clocks.contains(&bit)) {
                continue;
            }
            let activity = match (bit, on[0].as_str()) {
                (Some(bit), _) => *bits.get(&bit).ok_or_else(|| {
                    unexpected(format!(
                        "found no activity of the net on pin {pin} of {name}"
                    ))
                })?,
                (None, level) => Activity {
                    transitions: 0.0,
                    duty: f64::from(u8::from(level == Some("1"))),
                },
            };
            pins.push((pin, activity));
            // The other output of a register takes its power whether it is connected or not.
            if cell["type"] == *register.cell.cell && pin == register.cell.output {
                let others = register.inverse_outputs.iter();
                pins.extend(others.map(|other| (other.as_str(), activity.inverse())));
            }
        }
        for (pin, activity) in &pins {
            tell(&mut script, name, pin, *activity);
        }
        let stopped_part = |net: &Value| {
            let enable = net.as_u64().and_then(|net| gated.get(&net))?;
            Some(1.0 - bits.get(enable)?.duty)
        };
        let on = &cell["connections"];
        if let Some(part) = stopped_part(&on[&register.clock][0]) {
            for (pin, activity) in &pins {
                tell(&mut at_rest, name, pin, activity.at_rest());
            }
            let _ = writeln!(stopped, "  {name} {part:.9}");
        }
        let gate = library
            .clock_gate()
            .filter(|gate| cell["type"] == *gate.cell);
        if let Some(part) = gate.and_then(|gate| stopped_part(&on[&gate.output][0])) {
            let _ = writeln!(stopped_nets, "  {name} {part:.9}");
        }
    }
    let gated = (!gated.is_empty()).then(|| {
        format!("{at_rest}set stopped {{\n{stopped}}}\nset stopped_nets {{\n{stopped_nets}}}\n")
    });
    Ok(Told {
        netlist,
        script,
        gated,
        mean,
    })
}

fn tell(script: &mut String, cell: &str, pin: &str, activity: Activity) {
    let Activity { transitions, duty } = activity;
    let _ = writeln!(
        script,
        "sta::set_power_pin_activity [get_pins {cell}/{pin}] {transitions:.9} {duty:.9}"
    );
}

/// The activity of each bit of a module.
fn of_bits(module: &Value, activities: &Activities) -> Result<BTreeMap<u64, Activity>> {
    let clocks = activities.clocks as f64;
    let mut found = BTreeMap::new();
    for (name, net) in module["netnames"].as_object().into_iter().flatten() {
        let bits = net["bits"].as_array().map_or(&[][..], Vec::as_slice);
        let Some(toggles) = activities.nets.get(name) else {
            continue;
        };
        ensure(toggles.len() == bits.len(), || {
            format!(
                "found {} bits of net {name} in the simulation, expected {}",
                toggles.len(),
                bits.len()
            )
        })?;
        for (bit, toggles) in bits.iter().zip(toggles) {
            if let Some(bit) = bit.as_u64() {
                let activity = Activity {
                    transitions: toggles.transitions as f64 / clocks,
                    duty: toggles.ones as f64 / clocks,
                };
                found.insert(bit, activity);
            }
        }
    }
    Ok(found)
}

/// Connects the inputs of cells that read a bit to the bit that takes its place.
fn read_instead(module: &mut Value, replaced: &BTreeMap<u64, u64>) -> Result<()> {
    let cells = module["cells"].as_object_mut();
    let cells = cells.ok_or_else(|| unexpected("found no cells in the netlist"))?;
    for cell in cells.values_mut() {
        let directions = cell["port_directions"].clone();
        for (pin, bits) in cell["connections"].as_object_mut().into_iter().flatten() {
            let bits = bits.as_array_mut().into_iter().flatten();
            for bit in bits.filter(|_| directions[pin] != "output") {
                if let Some(new) = bit.as_u64().and_then(|bit| replaced.get(&bit)) {
                    *bit = json!(new);
                }
            }
        }
    }
    Ok(())
}

/// Puts a register between each input of the module and the cells that read it. Returns the bit of the input by the bit that took its
/// place. An input that only an output of the module reads gets none: Yosys would remove it again.
fn add_sources(module: &mut Value, register: &Register) -> Result<BTreeMap<u64, u64>> {
    let clock = module["ports"][CLOCK]["bits"][0].clone();
    ensure(clock.is_u64(), || {
        "found no port `clock` of the netlist".to_owned()
    })?;
    let ports = module["ports"].as_object().into_iter().flatten();
    let inputs = ports.filter(|(name, port)| *name != CLOCK && port["direction"] == "input");
    let bits = inputs.flat_map(|(_, port)| port["bits"].as_array().into_iter().flatten());
    let read = readers(&module["cells"]);
    let bits = bits.filter_map(Value::as_u64);
    let inputs: Vec<u64> = bits.filter(|bit| read.contains_key(bit)).collect();
    let first = last_net(module) + 1;
    let replaced: BTreeMap<u64, u64> = inputs.iter().copied().zip(first..).collect();
    read_instead(module, &replaced)?;
    let Register {
        cell, clock: pin, ..
    } = register;
    for (index, (bit, new)) in replaced.iter().enumerate() {
        let source = json!({
            "hide_name": 0, "type": cell.cell, "parameters": {}, "attributes": {},
            "port_directions": {&cell.input: "input", pin: "input", &cell.output: "output"},
            "connections": {&cell.input: [bit], pin: [clock], &cell.output: [new]}
        });
        module["cells"][format!("{SOURCE}{index}")] = source;
        module["netnames"][format!("behind_{SOURCE}{index}")] =
            json!({"hide_name": 0, "bits": [new], "attributes": {}});
    }
    Ok(replaced.into_iter().map(|(bit, new)| (new, bit)).collect())
}

#[cfg(test)]
mod tests {
    use super::super::gating::ClockGate;
    use super::*;

    /// An inverter between an input `d` of two bits, of which one is read, and an output.
    fn netlist() -> Netlist {
        Netlist::from(json!({"modules": {"top": {
            "ports": {
                "clock": {"direction": "input", "bits": [2]}, "d": {"direction": "input", "bits": [3, 4]},
                "q": {"direction": "output", "bits": [5]}},
            "cells": {
                "_1_": {"type": "INV", "port_directions": {"A": "input", "Y": "output"}, "connections": {"A": [4], "Y": [6]}},
                "_2_": {"type": "DFF", "port_directions": {"CK": "input", "D": "input", "Q": "output"},
                    "connections": {"CK": [2], "D": [6], "Q": [5]}}},
            "netnames": {"clock": {"bits": [2]}, "d": {"bits": [3, 4]}, "q": {"bits": [5]}, "_3_": {"bits": [6]}}}}}))
    }

    fn activities() -> Activities {
        let toggles = |transitions, ones| Toggles { transitions, ones };
        let nets = [
            ("clock", vec![toggles(0, 0)]),
            ("d", vec![toggles(0, 10), toggles(4, 3)]),
            ("q", vec![toggles(4, 6)]),
            ("_3_", vec![toggles(4, 7)]),
        ];
        Activities {
            clocks: 10,
            nets: nets.map(|(name, bits)| (name.to_owned(), bits)).into(),
        }
    }

    #[test]
    fn each_pin_but_the_clocks_is_told_and_inputs_come_from_registers() {
        let told = told(netlist(), "top", &Library::small(), &activities()).unwrap();
        let pins: Vec<_> = told
            .script
            .lines()
            .map(|line| line.replace("sta::set_power_pin_activity ", ""))
            .collect();
        let expected = [
            "[get_pins _1_/A] 0.400000000 0.300000000",
            "[get_pins _1_/Y] 0.400000000 0.700000000",
            "[get_pins _2_/D] 0.400000000 0.700000000",
            "[get_pins _2_/Q] 0.400000000 0.600000000",
            "[get_pins _2_/QN] 0.400000000 0.400000000",
            "[get_pins source_0/D] 0.400000000 0.300000000",
            "[get_pins source_0/Q] 0.400000000 0.300000000",
            "[get_pins source_0/QN] 0.400000000 0.700000000",
        ];
        assert_eq!(pins, expected);
        // Bits 3, 4, 5 and 6, without the clock.
        assert!((told.mean - 0.3).abs() < 1e-12);
        let cells = &told.netlist.json()["modules"]["top"]["cells"];
        assert_eq!(
            cells["_1_"]["connections"]["A"],
            cells["source_0"]["connections"]["Q"]
        );
    }

    /// As the word of a RAM that is a result: it goes from a port to a port.
    #[test]
    fn an_input_that_no_cell_reads_has_no_register() {
        let mut netlist = netlist();
        let module = &mut netlist.json_mut()["modules"]["top"];
        module["ports"]["word"] = json!({"direction": "input", "bits": [7]});
        module["ports"]["result"] = json!({"direction": "output", "bits": [7]});
        let told = told(netlist, "top", &Library::small(), &activities()).unwrap();
        let cells = told.netlist.json()["modules"]["top"]["cells"].clone();
        let sources: Vec<_> = (cells.as_object().unwrap().iter())
            .filter(|(name, _)| name.starts_with(SOURCE))
            .map(|(_, cell)| &cell["connections"]["D"])
            .collect();
        assert_eq!(sources, [&json!([4])]);
    }

    /// A register behind a clock gate whose enable is at 1 in 3 of 10 cycles.
    #[test]
    fn a_gated_register_is_listed_with_the_edges_that_do_not_reach_it() {
        let mut netlist = netlist();
        let module = &mut netlist.json_mut()["modules"]["top"];
        module["cells"]["_4_"] = json!({"type": "GATE",
            "port_directions": {"CK": "input", "E": "input", "GCK": "output"},
            "connections": {"CK": [2], "E": [4], "GCK": [7]}});
        module["cells"]["_2_"]["connections"]["CK"] = json!([7]);
        module["netnames"]["_5_"] = json!({"bits": [7]});
        let [cell, clock, enable, output] = ["GATE", "CK", "E", "GCK"].map(str::to_owned);
        let library = Library::small().with_clock_gate(ClockGate {
            cell,
            clock,
            enable,
            output,
        });
        let told = told(netlist, "top", &library, &activities()).unwrap();
        assert!(!told.script.contains("/CK]") && !told.script.contains("/GCK]"));
        let gated = told.gated.unwrap();
        let expected = [
            "sta::set_power_pin_activity [get_pins _2_/D] 0.000000000 0.700000000",
            "sta::set_power_pin_activity [get_pins _2_/Q] 0.000000000 0.600000000",
            "sta::set_power_pin_activity [get_pins _2_/QN] 0.000000000 0.400000000",
            "set stopped {",
            "  _2_ 0.700000000",
            "}",
            "set stopped_nets {",
            "  _4_ 0.700000000",
            "}",
        ];
        assert_eq!(gated.lines().collect::<Vec<_>>(), expected);
        assert!((told.mean - 0.3).abs() < 1e-12);
    }

    #[test]
    fn a_net_that_was_not_simulated_is_an_error() {
        let told = |change: fn(&mut Activities)| {
            let mut activities = activities();
            change(&mut activities);
            let told = told(netlist(), "top", &Library::small(), &activities);
            told.unwrap_err().to_string()
        };
        let error = told(|activities| drop(activities.nets.remove("_3_")));
        assert!(error.contains("pin Y of _1_"), "{error}");
        let error = told(|activities| drop(activities.nets.insert("d".to_owned(), Vec::new())));
        assert!(
            error.contains("0 bits of net d") && error.contains("expected 2"),
            "{error}"
        );
        let error = told(|activities| activities.clocks = 0);
        assert!(error.contains("no clock cycle"), "{error}");
    }
}
